//! The results directory: what is done, and how it reaches the user. The only place that touches HDF5.
//!
//! ```text
//! sweep.toml      the sweep file as it was run
//! lock            held by the run that works here; the system lets go of it when the run dies
//! log/            one file per start, a record per line with a checksum
//! shards/         immutable HDF5 files, each with one or several chains
//! results.h5      published: one labelled data set
//! summary.csv     published: one row per place of the sweep
//! timings.csv     published: what each case cost
//! ```
//!
//! What is solved is in the log and the shards; publishing reads it there and never from an earlier publication. Chains
//! are committed in this order: their shard is written under a temporary name, brought to the disk, named by its bytes,
//! the directory brought to the disk, and only then a record is appended to the log and brought to the disk. Whatever
//! the moment at which a run is killed, all chains with a record are whole, and all others are solved again.
//!
//! The store knows no equations: it gets plain numbers in the order of [`Column::ALL`](crate::Column::ALL). Every file
//! and data set is described in `docs/reference/output.md`.

mod catalog;
mod chunks;
mod claims;
mod contents;
mod damage;
mod data_set;
mod dimension_scales;
mod directory;
mod entry;
mod error;
mod field_blocks;
mod files;
mod further_columns;
mod hdf5_environment;
mod hdf5_file;
mod history;
mod index;
mod joining;
mod log;
mod open_shards;
mod packed;
mod packed_case;
mod placed;
mod publication;
mod publish;
mod record;
mod replacement;
mod results;
mod sensitivity_columns;
mod shard;
mod stored_output;
mod tables;
mod verify;
mod warning;
mod writing;

use std::sync::OnceLock;

pub use catalog::{Catalog, Counts, Origin};
pub use claims::Inspection;
pub use contents::Contents;
pub use data_set::{Cost, DataSet};
pub use entry::{CaseEntry, Status, Timing};
pub use error::StoreError;
pub use files::{create_directory, holds_text, write_whole};
pub use further_columns::{AVERAGES, Average, FurtherColumn, columns as further_columns};
pub use hdf5_environment::initialise as initialise_hdf5;
pub use history::{Beginning, History, Start};
pub use joining::{Agreement, Joined};
pub use packed_case::PackedCase;
pub use placed::{PlacedNumbers, Placing};
pub use publication::{Point, Publication};
pub use publish::Published;
pub use record::Ending;
pub use sensitivity_columns::errors_of_derivatives;
pub use stored_output::StoredOutput;
pub use verify::{Problem, VerifyReport, verify};
pub use warning::Warning;
pub use writing::Store;

/// The version that log and published files are signed with, where it says more than that of this crate.
static VERSION: OnceLock<&str> = OnceLock::new();

/// Says which version of the program writes, for instance with its commit. The first call counts.
pub fn sign_as(version: &'static str) {
    VERSION.get_or_init(|| version);
}

/// The version that writes.
fn version() -> &'static str {
    VERSION.get().copied().unwrap_or(env!("CARGO_PKG_VERSION"))
}

/// The program that writes, as it signs log and published files.
pub(crate) fn program() -> String {
    format!("stribeck {}", version())
}

/// Seconds since 1970. A clock set before that counts as 1970: times are for people to read, nothing depends on them.
fn clock() -> u64 {
    std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |time| time.as_secs())
}
