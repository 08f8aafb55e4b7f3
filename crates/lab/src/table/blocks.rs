//! The tables in a text: lines of names, rows of numbers below them, and what stands between.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::sync::Arc;

use super::layout::{Layout, MOST_CELLS, Separator};
use super::rows::{Heading, Place, Table};
use super::text::{Line, lines};
use crate::Dimension;

/// Lines above a table that are kept.
const MOST_ABOVE: usize = 200;
/// The most lines that a quoted cell may have.
const MOST_LINES_OF_A_CELL: usize = 16;
/// Units of columns that no quantity here has.
const OTHER_UNITS: [&str; 12] = ["-", "%", "1", "N-m", "N·m", "Nm", "mN·m", "mN.m", "V", "A", "W", "Ohm"];

/// A line between the tables.
#[derive(Clone, Copy)]
struct Loose<'t> {
    line: Line<'t>,
    is_comment: bool,
    has_numbers: bool,
}

/// The tables of a text in the making.
struct Tables<'t> {
    text: &'t Arc<str>,
    layout: Layout,
    tables: Vec<Table>,
    /// True if the last of the tables takes rows.
    open: bool,
    loose: VecDeque<Loose<'t>>,
}

/// All tables of a text, in its order.
///
/// A table is a line of names, perhaps a line of units, and lines of as many cells with numbers among them. Without a
/// line of names its rows are all numbers.
///
/// # Errors
/// The line and what is wrong with it, where a row of numbers has another number of cells than there are names.
pub(super) fn tables(text: &Arc<str>, layout: Layout) -> Result<Vec<Table>, (u64, String)> {
    let mut found = Tables { text, layout, tables: Vec::new(), open: false, loose: VecDeque::new() };
    for line in records(text, layout.separator) {
        found.add(line)?;
    }
    Ok(found.end())
}

/// The lines of a text; those that a quoted cell goes over count as one.
fn records(text: &str, separator: Separator) -> impl Iterator<Item = Line<'_>> {
    let mut rest = lines(text);
    std::iter::from_fn(move || {
        let first = rest.next()?;
        if first.text.starts_with('#') || !separator.is_open_at_end_of(first.text) {
            return Some(first);
        }
        let mut ahead = rest.clone();
        for _ in 1..MOST_LINES_OF_A_CELL {
            let Some(last) = ahead.next() else { break };
            let whole = &text[first.start..last.start + last.text.len()];
            if !separator.is_open_at_end_of(whole) {
                rest = ahead;
                return Some(Line { text: whole, ..first });
            }
        }
        Some(first)
    })
}

impl<'t> Tables<'t> {
    fn add(&mut self, line: Line<'t>) -> Result<(), (u64, String)> {
        if line.text.trim().is_empty() {
            return Ok(());
        }
        if line.text.starts_with('#') {
            self.keep(Loose { line, is_comment: true, has_numbers: false });
            return Ok(());
        }
        let cells = self.layout.separator.split(line.text);
        if cells.len() > MOST_CELLS {
            return Err((line.number, format!("line {} has more than {MOST_CELLS} cells", line.number)));
        }
        let (numbers, others) = self.layout.count(&cells);
        let loose = Loose { line, is_comment: false, has_numbers: numbers > 0 };
        if numbers == 0 {
            self.keep(loose);
            return Ok(());
        }
        if self.open && self.words_since().next().is_none() {
            return match self.fits(&cells) {
                true => self.push(line),
                false if numbers >= 2 && numbers >= others => Err(self.misfit(line, cells.len())),
                false => {
                    self.keep(loose);
                    Ok(())
                }
            };
        }
        // a setting among words is no row
        let may_begin = numbers >= 2 || numbers >= others;
        if let Some((headings, above)) = self.headings(&cells).filter(|_| may_begin) {
            self.begin(headings, above, cells.len());
            return self.push(line);
        }
        if self.open && numbers > others && self.fits(&cells) {
            return self.push(line);
        }
        if !self.open && others == 0 && cells.len() > 1 {
            if let Some(names) = self.names_that_do_not_fit() {
                return Err((line.number, misfit(line.number, cells.len(), names)));
            }
            let above = self.loose.len();
            self.begin(vec![Heading { text: String::new(), unit: None }; cells.len()], above, cells.len());
            return self.push(line);
        }
        self.keep(loose);
        Ok(())
    }

    /// Lines since the last row that are no comments.
    fn words_since(&self) -> impl Iterator<Item = &Loose<'t>> {
        self.loose.iter().filter(|loose| !loose.is_comment)
    }

    fn keep(&mut self, loose: Loose<'t>) {
        self.loose.push_back(loose);
        if self.loose.len() > MOST_ABOVE {
            self.loose.pop_front();
        }
    }

    /// Adds a row to the last table; words since its last row are left out.
    fn push(&mut self, line: Line<'t>) -> Result<(), (u64, String)> {
        let left_out: Vec<u64> = self.words_since().map(|loose| loose.line.number).collect();
        let table = self.tables.last_mut().expect("a table is open");
        table.left_out.extend(left_out.into_iter().map(|line| (line, "no row of this table".to_owned())));
        table.rows.push(Place { line: line.number, start: line.start, end: line.start + line.text.len() });
        self.loose.clear();
        Ok(())
    }

    /// Begins a table below the first `above` of the loose lines.
    fn begin(&mut self, headings: Vec<Heading>, above: usize, width: usize) {
        let above = self.loose.drain(..).take(above).map(|it| (it.line.number, it.line.text.trim().to_owned()));
        self.tables.push(Table {
            above: above.collect(),
            headings,
            left_out: Vec::new(),
            layout: self.layout,
            text: Arc::clone(self.text),
            width,
            rows: Vec::new(),
        });
        self.open = true;
    }

    /// True if cells are as many as the last table has columns.
    fn fits(&self, cells: &[Cow<'_, str>]) -> bool {
        self.tables.last().is_some_and(|table| {
            cells.len() == table.width || fit(cells, table.headings.len(), filled(&table.headings, |it| &it.text))
        })
    }

    fn misfit(&self, line: Line<'_>, cells: usize) -> (u64, String) {
        let columns = self.tables.last().map_or(0, |table| table.headings.len());
        (line.number, misfit(line.number, cells, columns))
    }

    /// The names above a first row of these cells, and the number of loose lines above them.
    fn headings(&self, cells: &[Cow<'_, str>]) -> Option<(Vec<Heading>, usize)> {
        let comments = self.words_since().next().is_none();
        let has_letters = |loose: &Loose<'_>| loose.line.text.contains(char::is_alphabetic);
        let mut lines = (0..self.loose.len()).rev().filter(|place| {
            let loose = &self.loose[*place];
            loose.is_comment == comments && has_letters(loose)
        });
        let last = lines.next()?;
        let names = self.split(last, cells)?;
        let above = || lines.next().and_then(|place| Some((place, self.split(place, cells)?)));
        let are_units = names.iter().all(|name| name.is_empty() || is_unit(name));
        if let Some((place, above)) = are_units.then(above).flatten() {
            let heading = |(i, text): (usize, String)| Heading {
                text,
                unit: names.get(i).map(|unit| bare(unit).to_owned()).filter(|unit| !unit.is_empty()),
            };
            return Some((above.into_iter().enumerate().map(heading).collect(), place));
        }
        Some((names.into_iter().map(|text| Heading { text, unit: None }).collect(), last))
    }

    /// A loose line as names of columns with these cells in a row, whatever separates the names.
    fn split(&self, place: usize, cells: &[Cow<'_, str>]) -> Option<Vec<String>> {
        let loose = &self.loose[place];
        if loose.has_numbers || are_settings(loose.line.text) {
            return None;
        }
        let text = loose.line.text.trim_start_matches('#');
        let fits = |names: &Vec<String>| fit(cells, names.len(), filled(names, |it| it));
        let owned = |separator: Separator| separator.split(text).into_iter().map(Cow::into_owned).collect::<Vec<_>>();
        let own = self.layout.separator;
        if own != Separator::Blanks {
            return Some(owned(own)).filter(fits);
        }
        let ways = [owned(Separator::Tab), wide(text), owned(Separator::Blanks), together(text)];
        let found = ways.iter().cloned().chain([owned(Separator::Comma), owned(Separator::Semicolon)]).find(fits);
        // names between tabs are as many as they are, even if rows end before the last of them
        found.or_else(|| ways.into_iter().next().filter(|names| names.len() > cells.len()))
    }

    /// The number of names in the last line of words, if it seems to be one of names.
    fn names_that_do_not_fit(&self) -> Option<usize> {
        let last = self.words_since().last().filter(|it| !it.has_numbers && !are_settings(it.line.text))?;
        let names = self.layout.separator.split(last.line.text).len();
        (names > 1 || last.line.text.contains([',', ';', '\t'])).then_some(names)
    }

    /// All tables; names without rows are a table, too, if there is no other.
    fn end(mut self) -> Vec<Table> {
        if let Some(table) = self.tables.last_mut() {
            let below = self.loose.iter().filter(|loose| !loose.is_comment);
            table.left_out.extend(below.map(|loose| (loose.line.number, "no row of this table".to_owned())));
        } else if let Some(last) = self.loose.iter().rposition(|loose| !loose.is_comment) {
            let text = self.loose[last].line.text;
            let separators = [self.layout.separator, Separator::Tab, Separator::Semicolon, Separator::Comma];
            let best = separators.into_iter().max_by_key(|separator| separator.split(text).len());
            self.layout.separator = best.expect("there are four");
            let names = self.layout.separator.split(text).into_iter();
            let headings = names.map(|text| Heading { text: text.into_owned(), unit: None }).collect();
            self.begin(headings, last, 0);
        }
        self.tables
    }
}

/// True if a row of cells goes with names: as many, or fewer or more by empty ones at the ends.
fn fit(cells: &[Cow<'_, str>], names: usize, filled_names: usize) -> bool {
    let filled_cells = filled(cells, |cell| cell);
    cells.len() == names || (filled_cells <= filled_names && filled_names <= cells.len())
}

/// The number of cells without the empty ones at the end.
fn filled<T>(cells: &[T], text: impl Fn(&T) -> &str) -> usize {
    cells.iter().rposition(|cell| !text(cell).is_empty()).map_or(0, |last| last + 1)
}

fn misfit(line: u64, cells: usize, names: usize) -> String {
    format!(
        "line {line} has {cells} values for {names} columns; commas that are decimal marks need another separator, \
         semicolons or tabs"
    )
}

/// Names with two blanks or more between them.
fn wide(text: &str) -> Vec<String> {
    let names = text.split("  ").map(|name| name.trim().trim_matches('"'));
    names.filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

/// Names with blanks between them, each with a unit in brackets behind it.
fn together(text: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut depth = 0_usize;
    for word in text.split_whitespace() {
        match names.last_mut() {
            Some(name) if depth > 0 || word.starts_with(['(', '[']) => *name += &format!(" {word}"),
            _ => names.push(word.to_owned()),
        }
        depth = (depth + word.matches(['(', '[']).count()).saturating_sub(word.matches([')', ']']).count());
    }
    names
}

/// True for a line as `T=25;Mw=94.9;chem=PI;`.
fn are_settings(text: &str) -> bool {
    let mut pieces = text.split([';', '\t']).map(str::trim).filter(|piece| !piece.is_empty()).peekable();
    let is_one = |piece: &str| piece.split_once('=').is_some_and(|(name, _)| !name.trim().is_empty());
    pieces.peek().is_some() && pieces.all(is_one)
}

/// A unit without brackets.
fn bare(unit: &str) -> &str {
    unit.trim_matches(['(', ')', '[', ']']).trim()
}

/// True for what may stand in a line of units.
fn is_unit(text: &str) -> bool {
    let bare = bare(text);
    OTHER_UNITS.contains(&bare) || Dimension::of_unit(bare).is_some()
}
