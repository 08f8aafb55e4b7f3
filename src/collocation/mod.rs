//! The collocation method: fitted to the cavitation boundary, of high order, with its own error estimate.
#![allow(missing_docs, dead_code)]

mod adaptation;
mod discretisation;
mod displacement;
mod estimate;
mod exponential_moments;
mod factorisation;
mod fields;
mod inlet;
mod legendre;
mod log_moments;
mod matrix;
mod mesh;
mod newton;
mod quantities;
mod reference;
mod retardation;
mod scaling;
mod settings;
mod solver;
mod state;
mod system;
mod thick_film;
mod transfer;
#[cfg(test)]
mod trial;
mod workspace;

pub use settings::Settings;
pub use solver::CollocationSolver;

/// Version of this solver's numbers, a part of every case id. Raise it when a change makes the solver give other numbers for
/// the same case and settings: cases of older results are then solved again instead of being reused.
pub const RESULTS_VERSION: u32 = 1;
