//! Lubricated sliding of a cylinder on a viscoelastic half space: the equations, known limits and two solvers.

pub mod collocation;
pub mod continuation;
pub mod exact;
mod model;
mod points;
pub mod relaxation;
mod solve;

pub use continuation::{Failure, FailureKind, Interrupt, Interrupted, Solution, SolvedCase};
pub use model::*;
pub use points::solve_points;
pub use solve::{Method, Settings, Solver, solve};
