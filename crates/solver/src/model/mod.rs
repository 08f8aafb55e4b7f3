//! The equations of the problem, without any iteration.

pub mod gauss;
pub mod kernel;
pub mod stress;

mod displacement;
mod number;
mod outcome;
mod output;
mod parameters;
mod sensitivities;

pub use displacement::{DisplacementKernel, retarded_mode, retarded_mode_rate};
pub use number::shortest;
pub use outcome::{Failure, Fields, Friction, Limits, Quantities, RelativeErrors};
pub use output::{CavityShear, FieldSelection, Output};
pub use parameters::{Parameters, Retardation, RetardationMode, Substrate, SubstrateError};
pub use sensitivities::Sensitivities;
