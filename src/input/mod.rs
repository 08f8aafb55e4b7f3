//! Files that users write (TOML): typed access to keys and values, axes, and errors that show the place and the remedy.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `file` | from a path to a TOML document |
//! | `entry` | keys and values by type, that remember where they stand |
//! | `extent` | how much a file may hold |
//! | `axis` | lists and ranges of numbers |
//! | `units` | values with units |
//! | `error` | [`InputError`], a miette diagnostic |

mod axis;
mod entry;
mod error;
mod extent;
mod file;
mod units;

pub(crate) use axis::{Quantity, Varying, read as read_axis, read_varying};
pub(crate) use entry::{Entry, Section};
pub(crate) use error::Fault;
pub use error::{InputError, Invalid};
pub(crate) use file::{Kind, document, parse, read};
pub(crate) use units::{Dimension, product};
