//! Files that users write (TOML): typed access to keys and values, axes, and errors that show the place and the remedy.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `file` | from a path to a TOML document |
//! | `entry` | keys and values by type, that remember where they stand |
//! | `extent` | how much a file may hold |
//! | `axis` | lists and ranges of numbers |
//! | `units` | values with units |
//! | `sanitize` | foreign text in messages, made safe |
//! | `error` | [`InputError`], a miette diagnostic |

mod axis;
mod entry;
mod error;
mod extent;
mod file;
mod sanitize;
mod units;

pub use axis::{Quantity, Varying, read as read_axis, read_varying};
pub use entry::{Entry, Section};
pub use error::Fault;
pub use error::{InputError, Invalid};
pub use file::{Kind, document, parse, read};
pub use sanitize::{is_printable, printable, shown};
pub use units::{Dimension, product};
