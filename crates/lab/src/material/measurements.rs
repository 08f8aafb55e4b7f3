//! A table of measured moduli: CSV with a line of names.

use std::f64::consts::TAU;
use std::ops::Range;
use std::path::Path;

use super::measurement::{Measurement, Measurements};
use stribeck_input::{Fault, InputError, read};

/// What kind of file it is.
const KIND: &str = "table of measurements";
/// The names that columns may have.
const NAMES: [&str; 4] = ["omega", "frequency", "storage", "loss"];
const UNITS: &str = "the first line names three columns: omega (rad/s) or frequency (Hz), storage (Pa) and loss \
                     (Pa), in any order and with commas between them";

/// A cell: its text without blanks, and where that stands.
#[derive(Clone)]
struct Cell<'t> {
    text: &'t str,
    span: Range<usize>,
}

impl Measurements {
    /// Reads a CSV file with columns `omega` (rad/s) or `frequency` (Hz), `storage` and `loss` (Pa); rows in any order.
    ///
    /// # Errors
    /// [`InputError`] with line and column if the file cannot be read, a column is missing or unknown, or a value is
    /// none.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        read(KIND, path, |_, text| Self::interpret(text))
    }

    pub(super) fn interpret(text: &str) -> Result<Self, Fault> {
        let mut lines = lines(text);
        let (header, span) = lines
            .next()
            .ok_or_else(|| Fault::new(0..text.len(), "the table is empty", "nothing here", UNITS).unquoted())?;
        let columns = Columns::new(&header, span)?;
        let rows = lines.map(|(cells, span)| columns.measurement(&cells, span)).collect::<Result<Vec<_>, _>>()?;
        Self::new(rows).ok_or_else(|| {
            let end = text.trim_end().len();
            let what = "the table must have rows at two frequencies or more";
            let help = "times can be told from how the moduli change with frequency only; add rows at other ones";
            Fault::new(end..end, what, "the table ends here", help).unquoted()
        })
    }
}

/// Where the columns are.
struct Columns {
    names: Vec<String>,
    omega: (usize, f64),
    storage: usize,
    loss: usize,
}

impl Columns {
    fn new(header: &[Cell], span: Range<usize>) -> Result<Self, Fault> {
        for (i, cell) in header.iter().enumerate() {
            if !NAMES.contains(&cell.text) {
                let what = "a column must be called omega, frequency, storage or loss";
                return Err(Fault::new(cell.span.clone(), what, "unknown column", UNITS));
            }
            if header[..i].iter().any(|other| other.text == cell.text) {
                let what = "a column must be there once";
                return Err(Fault::new(cell.span.clone(), what, "again", "remove one of the two"));
            }
        }
        let find = |name: &str| header.iter().position(|cell| cell.text == name);
        let missing = |name: &str| {
            Fault::new(span.clone(), format!("the column {name} is missing"), "the names of columns", UNITS).unquoted()
        };
        let omega = match (find("omega"), find("frequency")) {
            (Some(column), None) => (column, 1.0),
            (None, Some(column)) => (column, TAU),
            (None, None) => return Err(missing("omega (or frequency)")),
            (Some(_), Some(second)) => {
                let what = "a table must have omega (rad/s) or frequency (Hz), not both";
                return Err(
                    Fault::new(header[second].span.clone(), what, "the same again", "remove one of the two").unquoted()
                );
            }
        };
        Ok(Self {
            names: header.iter().map(|cell| cell.text.to_owned()).collect(),
            omega,
            storage: find("storage").ok_or_else(|| missing("storage"))?,
            loss: find("loss").ok_or_else(|| missing("loss"))?,
        })
    }

    fn measurement(&self, cells: &[Cell], span: Range<usize>) -> Result<Measurement, Fault> {
        if cells.len() != self.names.len() {
            let what = format!("a row must have {} values, not {}", self.names.len(), cells.len());
            let help = format!("one for each of {}, with commas between them", self.names.join(", "));
            return Err(Fault::new(span, what, "this row", help).unquoted());
        }
        let number = |column: usize, least: &str, fits: fn(f64) -> bool| {
            let cell = &cells[column];
            cell.text.parse().ok().filter(|value: &f64| value.is_finite() && fits(*value)).ok_or_else(|| {
                let what = format!("{} must be a number {least}", self.names[column]);
                let help = "numbers are written as in 1200, 0.5 or 1.2e3; leave out rows that were not measured";
                Fault::new(cell.span.clone(), what, "not allowed", help)
            })
        };
        Ok(Measurement::Oscillation {
            omega: self.omega.1 * number(self.omega.0, "above 0", |value| value > 0.0)?,
            storage: number(self.storage, "above 0", |value| value > 0.0)?,
            loss: number(self.loss, "from 0", |value| value >= 0.0)?,
        })
    }
}

/// The lines that are not blank, as cells, each with its place.
fn lines(text: &str) -> impl Iterator<Item = (Vec<Cell<'_>>, Range<usize>)> {
    // Spreadsheets begin a file of UTF-8 with a mark that says so.
    let begin = text.len() - text.trim_start_matches('\u{feff}').len();
    text[begin..]
        .split('\n')
        .scan(begin, |start, line| {
            let place = *start;
            *start += line.len() + 1;
            Some((place, line))
        })
        .filter(|(_, line)| !line.trim().is_empty())
        .map(|(start, line)| {
            let cells = line.split(',').scan(start, |start, piece| {
                let cell = trimmed(piece, *start);
                *start += piece.len() + 1;
                Some(cell)
            });
            (cells.collect(), trimmed(line, start).span)
        })
}

/// A piece of the text without the blanks around it.
fn trimmed(piece: &str, start: usize) -> Cell<'_> {
    let start = start + (piece.len() - piece.trim_start().len());
    let text = piece.trim();
    Cell { text, span: start..start + text.len() }
}
