//! Experiments on lubricated soft contacts: quantities with units, materials, measured friction and fits.

mod experiment;
pub mod fit;
pub mod material;
mod measured;
mod units;

pub use experiment::{Experiment, LaboratoryQuantity, Modulus, Powers, Scales, si_units};
pub use measured::{Measured, MeasuredError};
pub use units::{dimension, in_si, unit_factor};
