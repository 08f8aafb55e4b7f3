//! How a table is written: what separates its cells, and the decimal mark of its numbers.

use std::borrow::Cow;

use super::text::lines;

/// What stands between two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// A tabulator.
    Tab,
    /// `;`
    Semicolon,
    /// `,`
    Comma,
    /// Blanks or tabulators, any number of them.
    Blanks,
}

/// The decimal mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// `0.5`
    Point,
    /// `0,5`
    Comma,
}

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// What stands between two cells.
    pub separator: Separator,
    /// The decimal mark of the numbers.
    pub decimal: Decimal,
}

/// What a text behind a quote is.
enum Quoted<'t> {
    /// A quoted cell, and what follows the separator behind it.
    Cell(Cow<'t, str>, Option<&'t str>),
    /// No quote ends the cell.
    Open,
    /// No quoted cell: the quote is part of a text.
    None,
}

/// The most cells of a line; what follows is not looked at.
pub(super) const MOST_CELLS: usize = 2000;
/// The most bytes of a quoted cell.
const LONGEST_CELL: usize = 1024;
/// Lines that are looked at; of longer texts every second one, every third one and so on.
const LOOKED_AT: usize = 20_000;
/// By how much a way of writing must explain more than those before it in the order of [`Layout::ALL`].
const MARGIN: f64 = 1.05;

impl Separator {
    /// Its name, in the plural.
    pub fn words(self) -> &'static str {
        match self {
            Self::Tab => "tabs",
            Self::Semicolon => "semicolons",
            Self::Comma => "commas",
            Self::Blanks => "blanks",
        }
    }

    fn is(self, c: char) -> bool {
        match self {
            Self::Tab => c == '\t',
            Self::Semicolon => c == ';',
            Self::Comma => c == ',',
            Self::Blanks => c.is_whitespace(),
        }
    }

    /// True for white space around a cell.
    fn is_around(self, c: char) -> bool {
        c.is_whitespace() && (self == Self::Blanks || !self.is(c))
    }

    /// The cells of a line, without the blanks and quotes around them; of a line of more than 2000 the first ones.
    pub fn split(self, line: &str) -> Vec<Cow<'_, str>> {
        let mut cells = Vec::new();
        let mut rest = if self == Self::Blanks { line.trim() } else { line };
        loop {
            let (cell, after) = self.first(rest);
            cells.push(cell);
            match after {
                Some(after) if cells.len() <= MOST_CELLS => rest = after,
                _ => return cells,
            }
        }
    }

    /// True for a line that ends within a quoted cell.
    pub(super) fn is_open_at_end_of(self, line: &str) -> bool {
        let mut rest = Some(line);
        while let Some(text) = rest {
            let inner = text.trim_start_matches(|c| self.is_around(c)).strip_prefix('"');
            if inner.is_some_and(|inner| matches!(self.quoted(inner), Quoted::Open)) {
                return true;
            }
            rest = self.first(text).1;
        }
        false
    }

    /// The first cell of a text and what follows the separator behind it.
    fn first(self, text: &str) -> (Cow<'_, str>, Option<&str>) {
        let begin = text.trim_start_matches(|c| self.is_around(c));
        if let Some(Quoted::Cell(cell, after)) = begin.strip_prefix('"').map(|inner| self.quoted(inner)) {
            return (cell, after);
        }
        let Some(end) = begin.find(|c| self.is(c)) else { return (begin.trim_end().into(), None) };
        let after = &begin[end..];
        (begin[..end].trim_end().into(), Some(self.beyond(after)))
    }

    /// What follows a separator, with which the text begins.
    fn beyond(self, text: &str) -> &str {
        match self {
            Self::Blanks => text.trim_start(),
            _ => &text[1..],
        }
    }

    /// The quoted cell whose text follows the quote.
    fn quoted(self, inner: &str) -> Quoted<'_> {
        let length = inner.char_indices().map(|(place, _)| place).take_while(|place| *place <= LONGEST_CELL).last();
        let near = if inner.len() > LONGEST_CELL { &inner[..length.unwrap_or(0)] } else { inner };
        let mut from = 0;
        loop {
            let Some(end) = near[from..].find('"').map(|place| from + place) else {
                return if near.len() < inner.len() { Quoted::None } else { Quoted::Open };
            };
            let after = &inner[end + 1..];
            if after.starts_with('"') {
                from = end + 2;
                if from > near.len() {
                    return Quoted::None;
                }
                continue;
            }
            let cell = inner[..end].trim();
            let cell = if cell.contains("\"\"") { cell.replace("\"\"", "\"").into() } else { Cow::from(cell) };
            let behind = after.trim_start_matches(|c| self.is_around(c) && !self.is(c));
            return match behind.chars().next() {
                None => Quoted::Cell(cell, None),
                Some(c) if self.is(c) => Quoted::Cell(cell, Some(self.beyond(behind))),
                Some(_) => Quoted::None,
            };
        }
    }
}

impl Decimal {
    /// Its name, in the plural.
    pub fn words(self) -> &'static str {
        match self {
            Self::Point => "decimal points",
            Self::Comma => "decimal commas",
        }
    }

    /// The number that a cell holds, which may be infinite or none (NaN).
    pub fn number(self, cell: &str) -> Option<f64> {
        let cell = cell.trim().replace('−', "-");
        match self {
            Self::Point => cell.parse().ok(),
            Self::Comma if cell.contains('.') || cell.ends_with(',') => None,
            Self::Comma => cell.replacen(',', ".", 1).parse().ok(),
        }
    }
}

impl Layout {
    /// All that there are; of those that explain a text equally well the first one is taken.
    const ALL: [Self; 8] = {
        const fn with(separator: Separator, decimal: Decimal) -> Layout {
            Layout { separator, decimal }
        }
        [
            with(Separator::Tab, Decimal::Point),
            with(Separator::Tab, Decimal::Comma),
            with(Separator::Semicolon, Decimal::Point),
            with(Separator::Semicolon, Decimal::Comma),
            with(Separator::Comma, Decimal::Point),
            with(Separator::Comma, Decimal::Comma),
            with(Separator::Blanks, Decimal::Point),
            with(Separator::Blanks, Decimal::Comma),
        ]
    };

    /// The way of writing in which a text holds most numbers, and least beside them: n²/(n + t) for each line of n
    /// numbers and t other cells. All lines count, so that no single one decides what a comma is.
    pub fn of(text: &str) -> Self {
        let count = lines(text).count();
        let sample: Vec<&str> = lines(text)
            .map(|line| line.text)
            .step_by(count.div_ceil(LOOKED_AT).max(1))
            .filter(|line| !line.starts_with('#') && line.contains(|c: char| c.is_ascii_digit()))
            .collect();
        let best = |most: bool| {
            let mut best = (Self { separator: Separator::Comma, decimal: Decimal::Point }, 0.0);
            for layout in Self::ALL {
                let score: f64 = sample.iter().map(|line| layout.explains(line, most)).sum();
                if score > MARGIN * best.1 {
                    best = (layout, score);
                }
            }
            best
        };
        // Lines with more words than numbers count only where there are no others: they are mostly no rows.
        let (layout, score) = best(true);
        if score > 0.0 { layout } else { best(false).0 }
    }

    /// How well a line is one of numbers; 0 where they are not `most` of its cells but should be.
    fn explains(self, line: &str, most: bool) -> f64 {
        let (numbers, others) = self.count(&self.separator.split(line));
        if numbers + others < 2 || numbers == 0 || (most && (numbers < 2 || numbers < others)) {
            return 0.0;
        }
        (numbers * numbers) as f64 / (numbers + others) as f64
    }

    /// How many cells are numbers, and how many are something else.
    pub(super) fn count<T: AsRef<str>>(self, cells: &[T]) -> (usize, usize) {
        let filled = || cells.iter().map(AsRef::as_ref).filter(|cell| !cell.is_empty());
        let numbers = filled().filter(|cell| self.decimal.number(cell).is_some()).count();
        (numbers, filled().count() - numbers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_end_at_separators_outside_of_quotes() {
        let split = |separator: Separator, line: &'static str| separator.split(line);
        assert_eq!(split(Separator::Comma, " a , \"b, \"\"c\"\"\" ,,d"), ["a", "b, \"c\"", "", "d"]);
        assert_eq!(split(Separator::Comma, "3/4\" ball,\"open,x"), ["3/4\" ball", "\"open", "x"]);
        assert_eq!(split(Separator::Tab, "a b\t\t\"c\td\"\t"), ["a b", "", "c\td", ""]);
        assert_eq!(split(Separator::Blanks, "  1 \t 2  \"a b\" "), ["1", "2", "a b"]);
        assert_eq!(split(Separator::Semicolon, ""), [""]);
    }

    #[test]
    fn a_layout_is_that_of_most_numbers() {
        let layout = |text: &str| {
            let Layout { separator, decimal } = Layout::of(text);
            (separator, decimal)
        };
        for (text, expected) in [
            ("speed (mm/s);mu\n10;0,05\n20;0,06\n", (Separator::Semicolon, Decimal::Comma)),
            ("a;b\n1;2\n", (Separator::Semicolon, Decimal::Point)),
            ("a\tb\n1,5\t2\n", (Separator::Tab, Decimal::Comma)),
            ("a\tb\n1.5\t2\n", (Separator::Tab, Decimal::Point)),
            ("a, b\n1, 2.5\n", (Separator::Comma, Decimal::Point)),
            ("\"1,5\",\"2,5\"\n", (Separator::Comma, Decimal::Comma)),
            ("a b\n1,5   2,5\n", (Separator::Blanks, Decimal::Comma)),
            ("load = 3.1 of 5 N\n\n1\t2\n", (Separator::Tab, Decimal::Point)),
            ("2018-03-23 10:00:01,1.5,2.5\n", (Separator::Comma, Decimal::Point)),
            // the first line alone could be either
            ("1,234;5,678\n1.5;2.5\n3.5;4.5\n", (Separator::Semicolon, Decimal::Point)),
        ] {
            assert_eq!(layout(text), expected, "{text}");
        }
    }
}
