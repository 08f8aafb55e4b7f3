//! Whole sweeps as functions: [`run`] and resume one, [`plan`] it, ask for its [`status`], [`merge`] its parts,
//! [`explain`] a case, [`verify`] what is stored.
//!
//! Each function takes plain options and returns a typed result. It prints nothing: what happens in between is told to
//! a callback as an [`Event`], when it happens. A run may be stopped at any moment through [`RunOptions::interrupt`],
//! or be killed: run the same sweep into the same directory again, and it goes on with what is missing. The published
//! bytes are the same.
//!
//! ```no_run
//! use std::path::Path;
//! use stribeck_sweep::campaign::{RunOptions, RunOutcome, run};
//! use stribeck_sweep::{Column, Sweep, store::DataSet};
//!
//! let sweep = Sweep::read("sweeps/quick.toml")?;
//! let directory = Path::new("results/quick");
//! let report = run(&sweep, directory, &RunOptions::default(), &mut |_| {})?;
//! if let RunOutcome::Published(published) = report.outcome {
//!     println!("{} converged, {} failed", published.converged, published.failed);
//!     println!("friction: {:?}", DataSet::open(directory)?.column(Column::MuTot)?);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | file | what it holds |
//! | --- | --- |
//! | `run`, `plan`, `status`, `merge`, `explain` | the functions of these names, with their options and results |
//! | `event`, `error` | what a callback is told; what ends a campaign |
//! | `sweep_directory`, `merged_catalog` | what a results directory and its parts hold, apart and together |
//! | `pending`, `stale` | which cases of a plan are left to be solved; why a stored case is of no use |
//! | `parts` | how far the parts of a sweep are |
//! | `solving`, `entry` | the work of a run; from a solved case to what is stored |
//! | `publication` | from stored cases to the files for the user |
//! | `cost` | the time and the bytes that a sweep is expected to take |
//! | `failures` | failed cases, listed and by region |
//! | `solve_command` | the command that solves a case again |

mod cost;
mod entry;
mod error;
mod event;
mod explain;
mod failures;
mod free_space;
mod merge;
mod merged_catalog;
mod open_store;
mod parts;
mod pending;
mod plan;
mod publication;
mod refinement;
mod run;
mod solve_command;
mod solving;
mod stale;
mod status;
mod sweep_directory;

pub use crate::store::{VerifyReport, verify};
pub use cost::{CaseSeconds, Cost, Size, field_bytes};
pub use entry::case_entry;
pub use error::CampaignError;
pub use event::{Event, Observer};
pub use explain::{CaseName, CasePlace, CaseReport, CaseStorage, Comparison, SolvedAgain, explain};
pub use failures::{Decade, FailedCase, FailureGroup, FailureRegion};
pub use merge::{IncompletePart, MergeOutcome, MergeReport, Missing, merge};
pub use merged_catalog::MergedCatalog;
pub(crate) use open_store::open_store;
pub use parts::{PartActivity, PartState};
pub use pending::{Pending, StaleCases};
pub use plan::{DirectoryState, PlanOptions, PlanReport, plan};
pub use publication::{publish_solved, publish_stored, published_point};
pub use refinement::Refinement;
pub use run::{RunOptions, RunOutcome, RunReport, available_threads, run};
pub use solve_command::solve_command;
pub use solving::{InMemory, solve_in_memory};
pub use stale::StaleReason;
pub use status::{PlannedStatus, StatusReport, UnplannedStatus, notes, status};
pub use sweep_directory::{SweepDirectory, check_available, read_sweep, sweep_file};
