//! Lines of cells with commas between them, each with its place.

use std::ops::Range;

use stribeck_input::Fault;

/// A cell: its text without blanks around it, and where that stands.
#[derive(Clone, Debug)]
pub(super) struct Cell<'t> {
    pub(super) text: &'t str,
    pub(super) span: Range<usize>,
}

impl Cell<'_> {
    /// True for this word in any case.
    pub(super) fn is(&self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word)
    }

    /// True for a word of which the first letters are given, in any case: commands may be shortened.
    pub(super) fn begins(&self, letters: &str) -> bool {
        self.text.get(..letters.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(letters))
    }

    /// A finite number as Fortran writes it too, `1.5D-3`; an empty cell is 0.
    pub(super) fn number(&self) -> Result<f64, Fault> {
        if self.text.is_empty() {
            return Ok(0.0);
        }
        let number = self.text.replace(['d', 'D'], "e").parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| {
            let help = "numbers are written as in 0.25 or 1.5e-3; parameters and expressions are not evaluated";
            self.fault("a cell of the series must be a number", "not a number", help)
        })
    }

    pub(super) fn fault(&self, what: impl Into<String>, label: &str, help: &str) -> Fault {
        Fault::new(self.span.clone(), what, label, help)
    }
}

/// A line as cells, and where it stands without blanks and line ends.
pub(super) struct Line<'t> {
    pub(super) cells: Vec<Cell<'t>>,
    pub(super) span: Range<usize>,
}

impl Line<'_> {
    /// A fault of the line as a whole.
    pub(super) fn fault(&self, what: impl Into<String>, label: &str, help: &str) -> Fault {
        Fault::new(self.span.clone(), what, label, help).unquoted()
    }
}

/// The lines that are not blank, up to a character that begins a comment.
pub(super) fn lines(text: &str, comment: Option<char>) -> impl Iterator<Item = Line<'_>> {
    let starts = text.split_inclusive('\n').scan(0, |start, line| {
        let place = *start;
        *start += line.len();
        Some((place, line))
    });
    starts.filter_map(move |(start, line)| {
        let line = comment.and_then(|sign| line.split(sign).next()).unwrap_or(line);
        let whole = cell(line, start);
        let cells = line.split(',').scan(start, |start, piece| {
            let cell = cell(piece, *start);
            *start += piece.len() + 1;
            Some(cell)
        });
        (!whole.text.is_empty()).then(|| Line { cells: cells.collect(), span: whole.span })
    })
}

/// A piece of the text without the blanks around it.
fn cell(piece: &str, start: usize) -> Cell<'_> {
    let text = piece.trim();
    let start = start + (piece.len() - piece.trim_start().len());
    Cell { text, span: start..start + text.len() }
}

/// A fraction from 0 and its time, which is above 0 unless the fraction is 0.
pub(super) fn term(fraction: &Cell<'_>, time: &Cell<'_>) -> Result<(f64, f64), Fault> {
    let pair = (fraction.number()?, time.number()?);
    if pair.0 < 0.0 {
        let help =
            "a term below 0 would give work away; fits without that condition make some. Fit again with terms from 0";
        return Err(fraction.fault("a fraction must be a number from 0", "not a fraction", help));
    }
    if pair.0 > 0.0 && pair.1 <= 0.0 {
        let help = "the order is fraction before time";
        return Err(time.fault("a relaxation time must be above 0", "not a time", help));
    }
    Ok(pair)
}
