//! Lubricated sliding of a cylinder on a viscoelastic half space: the equations, known limits and two solvers.

pub mod collocation;
pub mod continuation;
pub mod exact;
mod model;
pub mod relaxation;

pub use model::*;
