//! A table: names of columns, and rows of cells.

use std::borrow::Cow;
use std::sync::Arc;

use super::layout::{Decimal, Layout};

/// The name of a column, and its unit if a line of its own has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// The name, with a unit that stands beside it.
    pub text: String,
    /// The unit in the line below the names.
    pub unit: Option<String>,
}

/// A row: its line in the file, from 1, and its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Row<'t> {
    /// The line.
    pub line: u64,
    /// The cells, one for each column or fewer.
    pub cells: Vec<Cow<'t, str>>,
}

/// A table: names of columns, and rows of numbers.
#[derive(Clone, Debug)]
pub struct Table {
    /// The lines above it that belong to no table before, with their numbers: titles, settings, comments.
    pub above: Vec<(u64, String)>,
    /// The columns; empty where no line names them.
    pub headings: Vec<Heading>,
    /// Lines among the rows that are none.
    pub left_out: Vec<(u64, String)>,
    /// How it is written.
    pub layout: Layout,
    pub(super) text: Arc<str>,
    /// The number of cells of its first row.
    pub(super) width: usize,
    pub(super) rows: Vec<Place>,
}

/// Where a row stands in the text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) line: u64,
    pub(super) start: usize,
    pub(super) end: usize,
}

impl Table {
    /// The rows, in the order of the file.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|place| Row {
            line: place.line,
            cells: self.layout.separator.split(&self.text[place.start..place.end]),
        })
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True if it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// The number that a cell holds, by the decimal mark of the table: finite.
pub(super) fn finite(decimal: Decimal, cell: &str) -> Option<f64> {
    decimal.number(cell).filter(|value| value.is_finite())
}
