//! Tables of numbers as laboratories have them: bytes in, tables out, and what was understood of them.
//!
//! [`TableFile`] finds the encoding, the separator, the decimal mark and the tables of a file. A [`Field`] is a
//! quantity that a column may hold, with its names and units. [`Table::columns`] finds the columns of fields, and
//! [`Understood`] says what was found.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `file` | [`TableFile`]: from a path to tables |
//! | `text` | from bytes to text, whatever the encoding |
//! | `workbook` | from a workbook to text |
//! | `layout` | separator and decimal mark |
//! | `rows` | [`Table`]: names of columns, and rows of cells |
//! | `blocks` | the tables in a text: names, units, rows, and lines between them |
//! | `heading` | from the name of a column to a field and a unit |
//! | `columns` | the columns of fields; [`ColumnChoice`] |
//! | `understood` | what was understood, for people |

mod blocks;
mod columns;
mod file;
mod heading;
mod layout;
mod rows;
mod text;
mod understood;
mod workbook;

pub use columns::{Column, ColumnChoice, Columns, LeftOutColumn};
pub(crate) use file::bytes;
pub use file::{TableError, TableFile};
pub use heading::{Field, Measures};
pub use layout::{Decimal, Layout, Separator};
pub use rows::{Heading, Row, Table};
pub use text::{Decoded, decode};
pub use understood::Understood;
