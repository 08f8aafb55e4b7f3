//! What was understood of a table, for people.

use std::collections::BTreeMap;
use std::fmt;

use super::{Columns, Table, TableFile};
use crate::Dimension;
use stribeck_input::{printable, shown};

/// The most lines of rows left out that are named for one reason.
const MOST_LINES: usize = 5;

/// What was understood of a table: where its numbers come from, and what was left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Understood {
    source: String,
    rows: usize,
    columns: Vec<String>,
    left_out: Vec<(String, String)>,
    rows_left_out: BTreeMap<String, Vec<u64>>,
    notes: Vec<String>,
}

impl Understood {
    /// What was understood of a table and its columns.
    pub fn new(file: &TableFile, table: &Table, columns: &Columns) -> Self {
        let mut understood = Self {
            source: format!("{}: {}", shown(&file.path), file.source(table)),
            rows: 0,
            columns: columns.taken.iter().map(describe).collect(),
            left_out: columns.left_out.iter().map(|it| (it.heading.clone(), it.why.clone())).collect(),
            rows_left_out: BTreeMap::new(),
            notes: Vec::new(),
        };
        understood.add(table);
        if !file.unread.is_empty() {
            let names = file.unread.join(", ");
            understood
                .note(format!("not read: {names}; of a workbook the first sheet with a table is, so move yours there"));
        }
        understood
    }

    /// Counts the rows of a table, and those that the reader left out.
    pub fn add(&mut self, table: &Table) {
        self.rows += table.len();
        table.left_out.iter().for_each(|(line, why)| self.rows_left_out.entry(why.clone()).or_default().push(*line));
    }

    /// Leaves a row out.
    pub fn leave_out(&mut self, line: u64, why: impl Into<String>) {
        self.rows -= 1;
        self.rows_left_out.entry(why.into()).or_default().push(line);
    }

    /// Why rows were left out, in one line; empty if none was.
    pub fn reasons(&self) -> String {
        let reason = |(why, lines): (&String, &Vec<u64>)| format!("{} left out, {why}", lines.len());
        self.rows_left_out.iter().map(reason).collect::<Vec<_>>().join("; ")
    }

    /// Adds a sentence.
    pub fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }
}

/// A column and what it was taken for.
fn describe(column: &super::Column) -> String {
    let heading = printable(&column.heading);
    let unit = match (column.unit.text.as_str(), column.unit.is_given) {
        ("", _) => String::new(),
        (unit, true) => format!(", in {}", printable(unit)),
        (unit, false) => format!(", in {unit} as no unit is given"),
    };
    let kind = match column.dimension {
        Some(Dimension::Frequency) if column.field != "frequency" => " (a frequency)",
        _ => "",
    };
    if heading == column.field {
        format!("`{heading}`{unit}{kind}")
    } else {
        format!("`{heading}` as {}{unit}{kind}", column.field)
    }
}

impl fmt::Display for Understood {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = if self.rows == 1 { "1 row".to_owned() } else { format!("{} rows", self.rows) };
        writeln!(formatter, "{}; {rows}", self.source)?;
        if !self.columns.is_empty() {
            writeln!(formatter, "  columns: {}", self.columns.join("; "))?;
        }
        let mut reasons: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for (heading, why) in &self.left_out {
            reasons.entry(why).or_default().push(format!("`{}`", printable(heading)));
        }
        for (why, headings) in reasons {
            writeln!(formatter, "  left out: {} ({why})", headings.join(", "))?;
        }
        for (why, lines) in &self.rows_left_out {
            let named: Vec<String> = lines.iter().take(MOST_LINES).map(u64::to_string).collect();
            let more = if lines.len() > MOST_LINES { " …" } else { "" };
            let count = if lines.len() == 1 { "line" } else { "lines" };
            writeln!(formatter, "  {} {count} left out ({}{more}): {why}", lines.len(), named.join(", "))?;
        }
        for note in &self.notes {
            writeln!(formatter, "  note: {note}")?;
        }
        Ok(())
    }
}
