//! The paper's solver (Sec. 3, Eqs. 37–44): Gauss–Seidel relaxation of Reynolds' equation on a uniform grid.
//!
//! `reynolds.rs` holds the discrete equation and the pass, `deformation.rs` the displacement, `far_field.rs` what lies
//! beyond the grid, `iteration.rs` one round of passes and the load balance, `convergence.rs` when to stop and what to do
//! when it does not converge, `acceptance.rs` what a grid can hold, `solver.rs` the seeds, `quantities.rs` and `fields.rs` what comes out, `jacobian.rs` the derivatives of the equations.

mod acceptance;
mod anderson;
mod convergence;
mod cost;
mod deformation;
mod far_field;
mod fields;
mod grid;
mod inner_product;
mod iteration;
mod jacobian;
mod parabola;
mod quantities;
mod reynolds;
mod settings;
mod solver;
mod state;
mod stiffness;

pub use cost::expected_seconds;
pub use grid::Grid;
pub use settings::{Acceleration, Domain, Settings};
pub use solver::{RelaxationSolver, Workspace};
pub use state::State;

/// Version of this solver's numbers, a part of every case id. Raise it when a change makes the solver give other
/// numbers for the same case and settings: cases of older results are then solved again instead of being reused.
pub const RESULTS_VERSION: u32 = 3;
