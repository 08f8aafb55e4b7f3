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
//! | `measurement` | [`Measurements`]: moduli over frequency or time |
//! | `prony`, `prony_file` | [`PronySeries`]: terms as they are passed on, and files of Abaqus and Ansys with them |
//! | `relaxation_fit` | [`RelaxationFit`]: the relaxation spectrum that fits the measurements |
//! | `term_choice`, `doubt` | how many terms it needs; what the measurements do not tell of it |
//! | `material_file`, `material_table`, `table_fields` | [`MaterialFile`]: a file that describes a material, whatever wrote it |
//! | `isotherms` | [`Isotherms`]: measurements sorted by temperature |
//! | `master_curve`, `overlap` | [`MasterCurve`]: isotherms shifted to one temperature, by how neighbours lie on one another |
//! | `shift_factors`, `vertical_shift` | given shift factors; [`VerticalShift`]: moduli that change with temperature |
//! | `shift_factor_file` | the reader of these |
//! | `one_temperature` | [`Shifting`], [`AtOneTemperature`]: moduli as they are, or shifted |

mod conversion;
mod creep;
mod doubt;
mod isotherms;
mod master_curve;
mod material_file;
mod material_table;
mod measurement;
mod modulus_kind;
mod one_temperature;
mod overlap;
mod prony;
mod prony_file;
mod relaxation;
mod relaxation_fit;
mod shift_factor_file;
mod shift_factors;
mod table_fields;
mod term_choice;
mod vertical_shift;

pub use creep::Material;
pub use doubt::Doubt;
pub use isotherms::{Isotherm, Isotherms, IsothermsError};
pub use master_curve::{Laid, MasterCurve, MasterCurveError, Shift};
pub use material_file::{MaterialData, MaterialFile, MaterialFileError, MaterialOptions};
pub use measurement::{Measurement, Measurements};
pub use modulus_kind::ModulusKind;
pub use one_temperature::{AtOneTemperature, Shifting};
pub use prony::{PronyError, PronyParts, PronySeries};
pub use prony_file::PronyFile;
pub use relaxation::{MaterialError, Relaxation, RelaxationTerm};
pub use relaxation_fit::{RelaxationFit, RelaxationFitError};
pub use shift_factors::{ShiftFactors, ShiftFactorsError};
pub use term_choice::TermChoice;
pub use vertical_shift::VerticalShift;
