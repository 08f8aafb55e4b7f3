//! Sweeps of the lubricated sliding problem: sweep files, plan, parallel runs that resume, published data sets.

#[cfg(not(any(feature = "static-hdf5", feature = "system-hdf5")))]
compile_error!("choose where HDF5 comes from: feature `static-hdf5` (the default) or `system-hdf5`");

pub mod campaign;
mod case_id;
mod dimension;
pub mod engine;
pub mod store;
mod sweep;

pub use case_id::{CaseId, NotACaseId};
pub use dimension::Dimension;
pub use sweep::*;
