//! Sweep files.
//!
//! [`Sweep::read`] turns a sweep file (TOML, `docs/reference/sweep-file.md`) into a validated [`Sweep`]. Every key is
//! known, and every value has the right type and range. Otherwise an [`InputError`](stribeck_input::InputError) shows
//! the place in the file and the remedy.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `specification` | [`Sweep`] and its parts |
//! | `sections` | the sections of a sweep file and their keys |
//! | `spelling` | keys that no section has |
//! | `laboratory`, `solver`, `output` | a reader for each section of these names |
//! | `bodies`, `substrate` | the readers of `[flat]` and `[roller]`, and of their spectra |
//! | `modulus` | a modulus of a section: relaxed or instantaneous, Young's or shear |
//! | `named_series` | Prony series in files that a sweep file names |
//! | `temperature` | the readers of laws of temperature |
//! | `schema` | the JSON schema of sweep files |
//! | `surface` | the section `[surface]`, and a sweep file whose ranges are the domain of a surface |
//! | `file` | the reader of the whole file, and of `[axes]` |

mod bodies;
mod file;
mod laboratory;
mod modulus;
mod named_series;
mod output;
mod schema;
mod sections;
mod solver;
mod specification;
mod spelling;
mod substrate;
mod surface;
mod temperature;

pub use file::{read_axes, read_title};
pub use schema::{schema, section_schema};
pub use sections::keys as section_keys;
pub use solver::{read_error, read_points};
pub use specification::{Method, SolverSettings, Sweep};
pub use spelling::{Keys, Spelt};
pub use substrate::read as read_substrate;
pub use surface::{RangeAxis, SurfaceSweep};
