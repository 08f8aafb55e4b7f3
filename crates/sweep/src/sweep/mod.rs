//! Sweep files, and the plan made of them.
//!
//! [`Sweep::read`] turns a sweep file (TOML, `docs/sweep-file.md`) into a validated [`Sweep`]: every key known, every
//! value of the right type and range, or an [`InputError`](stribeck_input::InputError) that shows the place in the file and the remedy. [`Plan`]
//! turns a sweep into rows, chains and case ids by index arithmetic, so that a plan of a billion cases is as small as
//! its axes.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `specification` | [`Sweep`] and its parts |
//! | `file` | the sweep file as a whole, its keys, and `[axes]` |
//! | `laboratory`, `substrate`, `solver`, `output` | the sections of these names |
//! | `grid` | [`Grid`]: the places of a sweep |
//! | `recipe` | what cases are solved with: [`Recipe`] |
//! | `fingerprint` | what makes two cases the same: [`Fingerprint`] |
//! | `plan` | [`Plan`], [`Chain`] |
//! | `listing` | rows and chains where places have problems in common |
//! | `part` | [`Part`]: whole chains for one of several machines |

mod file;
mod fingerprint;
mod grid;
mod laboratory;
mod listing;
mod output;
mod part;
mod plan;
mod recipe;
mod solver;
mod specification;
mod substrate;

pub use file::{read_axes, read_title};
pub use fingerprint::Fingerprint;
pub use grid::Grid;
pub use laboratory::{Given, LaboratoryAxes};
pub use part::{NotAPart, Part};
pub use plan::{Chain, MAX_CHAIN, Plan};
pub use recipe::{Recipe, SolverRecipe};
pub use solver::{read_error, read_points};
pub use specification::{Axes, Method, SolverSettings, Sweep};
pub use substrate::read as read_substrate;
