//! Error against run time, and how stable each method is: `stribeck study`.
//!
//! A study file (TOML, `docs/reference/study-file.md`) names cases, methods with settings to vary, and the things to
//! measure. Each method at each setting, a [`Variant`], solves each case. Errors are relative to a collocation solution
//! that is two orders tighter than the tightest setting.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `specification`, `file` | [`Study`], and reading one |
//! | `schema` | the keys of study files, and their JSON schema |
//! | `variant` | a method at a setting, as something that solves chains |
//! | `reference` | what errors are measured against |
//! | `timing` | seconds and memory |
//! | `stability`, `examination`, `condition` | solutions from the inside, and from other seeds |
//! | `run` | all of it, case by case |
//! | `row`, `tables`, `pictures` | what comes out: CSV, Markdown, pictures |

mod condition;
mod examination;
mod file;
mod pictures;
mod reference;
mod row;
mod run;
mod schema;
mod specification;
mod stability;
mod tables;
mod timing;
mod variant;

pub use examination::{Examination, MOST_EQUATIONS};
pub use pictures::{Picture, is_picture_name, pictures};
pub use reference::{Errors, Reference};
pub use row::{Cost, Row, Stability, csv};
pub use run::{Findings, run};
pub use schema::schema;
pub use specification::{Measure, Start, Study};
pub use tables::markdown;
pub use variant::{Setting, Variant};

/// Does a piece of work and tells the most bytes of memory that were in use for it at once.
pub type Meter<'a> = &'a (dyn Fn(&mut dyn FnMut()) -> u64 + Sync);
