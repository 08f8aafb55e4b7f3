//! Files that users write (TOML): typed access to keys and values, axes, and errors that show the place and the remedy.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `file` | from a path to a TOML document |
//! | `entry` | keys and values by type, that remember where they stand |
//! | `extent` | how much a file may hold |
//! | `axis` | lists and ranges of numbers |
//! | `error` | [`InputError`], a miette diagnostic |

mod axis;
mod entry;
mod error;
mod extent;
mod file;

pub(crate) use axis::{Quantity, read as read_axis};
pub(crate) use entry::{Entry, Section};
pub(crate) use error::Fault;
pub use error::{InputError, Invalid};
pub(crate) use file::{Kind, document, parse, read};
