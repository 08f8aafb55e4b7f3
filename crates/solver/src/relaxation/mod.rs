//! The paper's solver (Sec. 3, Eqs. 37–44): Gauss–Seidel relaxation of Reynolds' equation on a uniform grid.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `reynolds.rs` | Reynolds' equation on the grid, and the Gauss–Seidel pass |
//! | `grid.rs`, `state.rs` | the grid, and a solution on it |
//! | `deformation.rs`, `far_field.rs` | the displacement on the grid, and beyond it |
//! | `iteration.rs` | a round of passes, and the load balance |
//! | `convergence.rs`, `anderson.rs`, `stiffness.rs` | when to stop, how to accelerate, how large steps may be |
//! | `acceptance.rs` | which films a grid can hold and resolve |
//! | `quantities.rs`, `fields.rs`, `jacobian.rs` | the numbers, the fields, and the derivatives of the equations |
//! | `solver.rs`, `settings.rs`, `cost.rs` | the method as a [`CaseSolver`](crate::continuation::CaseSolver) |

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
pub const RESULTS_VERSION: u32 = 4;
