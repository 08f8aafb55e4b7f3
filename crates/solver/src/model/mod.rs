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
mod setting_out_of_range;
mod traction;

pub use displacement::{DisplacementKernel, retarded_mode, retarded_mode_derivative};
pub use number::shortest;
pub use outcome::{Fields, Friction, Limits, Quantities, RelativeErrors, viscoelastic_error_scale};
pub use output::{CavityShear, FieldSelection, Output};
pub use parameters::{OutOfRange, Parameters, Retardation, RetardationMode, Substrate, SubstrateError};
pub use sensitivities::Sensitivities;
pub use setting_out_of_range::SettingOutOfRange;
pub use traction::{Lubricant, shear_traction};
