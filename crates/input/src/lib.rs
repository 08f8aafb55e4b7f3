//! Files that users write (TOML): typed access to keys and values, axes, and errors that show the place and the remedy.
//!
//! A reader asks for keys by type. What it refuses is a [`Fault`]; with the file it becomes an [`InputError`], a
//! [`miette::Diagnostic`] that draws the line and says how to mend it. Readings that do not need each other are read
//! [all](Readings::all), so that a file's mistakes are told in one go.
//!
//! ```
//! use stribeck_input::{Fault, Quantity, Section, document, parse, read_axis};
//!
//! let axis = |_name: &str, text: &str| -> Result<Vec<f64>, Fault> {
//!     let document = document(text)?;
//!     let root = Section::new("", 0..0, document.get_ref(), &["beta"], |_| None)?;
//!     read_axis(&root.require("beta", "add beta = [10.0, 100.0]")?, Quantity::InverseHersey)
//! };
//! let range = "beta = { from = 1.0, to = 100.0, points = 3, scale = \"log\" }";
//! assert_eq!(parse("my", range, axis)?, [1.0, 10.0, 100.0]);
//! let error = parse("my", "beta = [-1.0]", axis).unwrap_err();
//! assert_eq!(error.to_string(), "my.toml:1:9: a value of `beta` must be finite and above 0, found `-1.0`");
//! # Ok::<(), stribeck_input::InputError>(())
//! ```
//!
//! | file | what it holds |
//! | --- | --- |
//! | `file` | from a path to a TOML document |
//! | `entry` | keys and values by type, with their places |
//! | `extent` | how much a file may hold |
//! | `axis` | lists and ranges of numbers |
//! | `sanitize` | foreign text in messages, made safe |
//! | `error` | [`InputError`] |

mod axis;
mod entry;
mod error;
mod extent;
mod file;
mod sanitize;

pub use axis::{Quantity, RANGE_KEYS, RANGE_SCALES, Values, Varying, range_values, read as read_axis, read_varying};
pub use entry::{Entry, Section, nearest, unknown_key};
pub use error::{Fault, InputError, Invalid, Mistake, Readings, each, is_of_disk};
pub use file::{Kind, document, parse, read};
pub use sanitize::{is_printable, printable, shown};
