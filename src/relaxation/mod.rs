//! The paper's solver (Sec. 3, Eqs. 37–44): Gauss–Seidel relaxation of Reynolds' equation on a uniform grid.

mod settings;

pub use settings::{Acceleration, Domain, Settings};

/// Version of this solver's numbers, a part of every case id. Raise it when a change makes the solver give other
/// numbers for the same case and settings: cases of older results are then solved again instead of being reused.
pub const RESULTS_VERSION: u32 = 1;
