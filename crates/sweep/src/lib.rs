//! Sweeps of the lubricated sliding problem: sweep files, plan, parallel runs that resume, published data sets.
//!
//! # Run a sweep
//!
//! [`campaign`] runs a sweep into a results directory, or resumes it, and publishes what is solved. It also plans a
//! sweep, tells how far it is, merges its parts, and explains a case. [`store::DataSet`] reads the published data back.
//!
//! ```
//! use stribeck_sweep::campaign::{RunOptions, run};
//! use stribeck_sweep::{Column, Sweep, store::DataSet};
//!
//! let sweep = Sweep::parse("small", "[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 100.0]")?;
//! # let temporary = tempfile::tempdir()?;
//! # let directory = temporary.path();
//! let report = run(&sweep, directory, &RunOptions::default(), &mut |event| println!("{event:?}"))?;
//! assert_eq!(report.pending.to_do(), 2);
//! let friction = DataSet::open(directory)?.column(Column::MuTot)?;
//! assert!(friction.iter().all(|friction| *friction > 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(not(any(feature = "static-hdf5", feature = "system-hdf5")))]
compile_error!("choose where HDF5 comes from: feature `static-hdf5` (the default) or `system-hdf5`");

mod axes;
pub mod campaign;
mod case_id;
mod columns;
mod dimension;
pub mod engine;
mod extent;
mod field;
mod field_precision;
mod friction_task;
mod grid;
mod grid_index;
mod notes;
mod plan;
pub mod store;
pub mod surface;
mod sweep_file;
mod unit;

pub use axes::{Axes, Given, LaboratoryAxes, ModelLimits};
pub use case_id::{CaseId, NotACaseId};
pub use columns::{Column, Values};
pub use dimension::Dimension;
pub use extent::{Extent, range};
pub use field::Field;
pub use field_precision::FieldPrecision;
pub use friction_task::{friction_task, points_to_fit};
pub use grid::Grid;
pub use grid_index::{GridIndex, GridShape};
pub use notes::{Note, NoteCounts};
pub use plan::{Chain, Fingerprint, MAX_CHAIN, NotAPart, Part, Plan, Recipe, SolverRecipe};
pub use sweep_file::{
    Keys, Method, RangeAxis, SolverSettings, Spelt, SurfaceSweep, Sweep, read_axes, read_error, read_points,
    read_substrate, read_title, schema, section_keys, section_schema,
};
pub use unit::Unit;
