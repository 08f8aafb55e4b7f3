//! Sweeps of the lubricated sliding problem: sweep files, plan, parallel runs that resume, published data sets.

#[cfg(not(any(feature = "static-hdf5", feature = "system-hdf5")))]
compile_error!("choose where HDF5 comes from: feature `static-hdf5` (the default) or `system-hdf5`");

mod axes;
pub mod campaign;
mod case_id;
mod columns;
mod dimension;
pub mod engine;
mod field;
mod grid;
mod grid_index;
mod plan;
pub mod store;
mod sweep_file;

pub use axes::{Axes, Given, LaboratoryAxes};
pub use case_id::{CaseId, NotACaseId};
pub use columns::{Column, Values};
pub use dimension::Dimension;
pub use field::Field;
pub use grid::Grid;
pub use grid_index::{GridIndex, GridShape};
pub use plan::{Chain, Fingerprint, MAX_CHAIN, NotAPart, Part, Plan, Recipe, SolverRecipe};
pub use sweep_file::{Method, SolverSettings, Sweep, read_axes, read_error, read_points, read_substrate, read_title};
