//! Materials as they are measured: relaxation and retardation spectra, one made of the other, and fits to measured moduli.
//!
//! A sweep knows a substrate by its creep (f, retardation times and shares); measurements and tables of materials give moduli and
//! relaxation times. The step from one to the other is exact.
//!
//! | file | what it holds |
//! | --- | --- |
//! | [`Relaxation`] | E(t) = E∞ + Σ E_i e^{−t/τ_i}, in pascals and seconds |
//! | [`Material`] | the same material by its creep, as a case needs it |
//! | [`Measurements`] | a table of storage and loss modulus over frequency |
//! | [`Fit`] | the relaxation spectrum that a table of measurements asks for |

mod error;
mod fit;
mod measurements;
mod relaxation;
mod retardation;

pub use error::{FitError, MaterialError};
pub use fit::{Fit, MOST_TERMS};
pub use measurements::{Measurement, Measurements};
pub use relaxation::{Relaxation, RelaxationTerm};
pub use retardation::Material;
