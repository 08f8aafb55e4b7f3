//! Materials: relaxation and retardation spectra, one made of the other, and fits to measured moduli.
//!
//! A sweep knows a substrate by its creep (f, retardation times and shares). Measurements and tables of materials give
//! moduli and relaxation times. The step from one to the other is exact.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `relaxation` | [`Relaxation`]: E(t) = E∞ + Σ E_i e^{−t/τ_i}, in pascals and seconds |
//! | `creep` | [`Material`]: the same material by its creep, as a case needs it |
//! | `conversion` | from one to the other |
//! | `modulus_kind` | [`ModulusKind`]: Young's modulus or shear modulus |
//! | `measurements` | [`Measurements`]: storage and loss modulus over frequency |
//! | `relaxation_fit` | [`RelaxationFit`]: the relaxation spectrum that fits the measurements |

mod conversion;
mod creep;
mod measurements;
mod modulus_kind;
mod relaxation;
mod relaxation_fit;

pub use creep::Material;
pub use measurements::{Measurement, Measurements};
pub use modulus_kind::ModulusKind;
pub use relaxation::{MaterialError, Relaxation, RelaxationTerm};
pub use relaxation_fit::{RelaxationFit, RelaxationFitError};
