//! From a path to the tables of a file.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::blocks::tables;
use super::layout::Layout;
use super::rows::Table;
use super::text::{Decoded, decode};
use super::workbook;
use stribeck_input::{printable, shown};

/// Most bytes of a file that are read.
const MOST_BYTES: u64 = 64 << 20;

/// The tables of a file.
#[derive(Clone, Debug)]
pub struct TableFile {
    /// The file, for messages.
    pub path: PathBuf,
    /// Its encoding, or the sheet of a workbook, in words.
    pub encoding: String,
    /// Its tables, in its order; at least one.
    pub tables: Vec<Table>,
    /// The sheets of a workbook that were not read, as they stand behind the one that was.
    pub unread: Vec<String>,
}

/// The reason why a file of tables is refused.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// The file cannot be read.
    #[error("cannot read the {kind} {}: {source}; check the path", shown(path))]
    Unreadable {
        /// What the file holds.
        kind: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        #[source]
        source: io::Error,
    },
    /// The file is not a table of what it should hold.
    #[error("{}: {what}", shown(path))]
    NotATable {
        /// The file.
        path: PathBuf,
        /// What is wrong, and what to do.
        what: String,
    },
    /// A value is not allowed.
    #[error("{}:{line}: {} = {:?} is not allowed: {allowed}", shown(path), printable(column), printable(value))]
    Value {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The text found.
        value: String,
        /// What is allowed.
        allowed: String,
    },
}

impl TableError {
    /// True if the disk or the system did not give the file; false if the path or the file is wrong.
    pub fn is_of_disk(&self) -> bool {
        matches!(self, Self::Unreadable { source, .. } if stribeck_input::is_of_disk(source))
    }
}

impl TableFile {
    /// Reads a file of tables; `kind` says what it holds, for messages.
    ///
    /// # Errors
    /// [`TableError`] if the file cannot be read, or is no text and no workbook.
    pub fn read(kind: &'static str, path: &Path) -> Result<Self, TableError> {
        Self::of(path, &bytes(kind, path)?)
    }

    /// The tables in the bytes of a file.
    ///
    /// # Errors
    /// [`TableError`] if they are no text and no workbook.
    pub fn of(path: &Path, bytes: &[u8]) -> Result<Self, TableError> {
        let refuse = |what| TableError::NotATable { path: path.to_owned(), what };
        if workbook::is_one(bytes) {
            let sheet = workbook::first_sheet(bytes).map_err(refuse)?;
            let (encoding, tables, unread) = (sheet.words, sheet.tables, sheet.unread);
            return Ok(Self { path: path.to_owned(), encoding, tables, unread });
        }
        let Decoded { text, encoding } = decode(bytes).map_err(refuse)?;
        let text: Arc<str> = text.into();
        let tables = tables(&text, Layout::of(&text)).map_err(|(_, what)| refuse(format!("it is no table: {what}")))?;
        if tables.is_empty() {
            return Err(refuse("it holds no table: names of columns, and rows of numbers below".to_owned()));
        }
        Ok(Self { path: path.to_owned(), encoding: encoding.to_owned(), tables, unread: Vec::new() })
    }

    /// How a table of the file is written, in words.
    pub(super) fn source(&self, table: &Table) -> String {
        if table.layout == workbook::LAYOUT && self.encoding.starts_with(workbook::SHEET) {
            return self.encoding.clone();
        }
        let Layout { separator, decimal } = table.layout;
        format!("{}, separated by {}, {}", self.encoding, separator.words(), decimal.words())
    }
}

/// The bytes of a file of `kind`, 64 MiB at most.
///
/// # Errors
/// [`TableError`] if it cannot be read or is larger.
pub(crate) fn bytes(kind: &'static str, path: &Path) -> Result<Vec<u8>, TableError> {
    let unreadable = |source| TableError::Unreadable { kind, path: path.to_owned(), source };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(unreadable)?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > MOST_BYTES {
        let what = format!("it is larger than {} MiB, the most that is read", MOST_BYTES >> 20);
        return Err(TableError::NotATable { path: path.to_owned(), what });
    }
    Ok(bytes)
}
