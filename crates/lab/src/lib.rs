//! Experiments on lubricated soft contacts: quantities with units, materials, measured friction and fits.
//!
//! An [`Experiment`] is a cylinder, a fluid and a substrate in SI units. It knows its dimensionless case and the
//! [`Scales`] that lead back. A [`Material`] is a substrate from measured moduli, [`Measured`] is friction from a CSV
//! file, and [`FrictionFit`] finds quantities of the experiment from it.
//!
//! ```
//! use stribeck_lab::{Experiment, Material, Modulus, Motion, Relaxation, RelaxationTerm, Roller};
//! use stribeck_solver::{Settings, solve};
//!
//! let material = Relaxation::new(1e5, vec![RelaxationTerm { modulus: 1e6, time: 2e-3 }]).unwrap().material();
//! let (radius, load, modulus) = (2e-3, 119.0, Modulus::Relaxed(material.relaxed_modulus));
//! let (viscosity, motion) = (5.1, Motion::Sliding { speed: 1e-3 });
//! let Material { retardation_time, f, ref substrate, .. } = material;
//! let (poisson_ratio, roller, temperature) = (0.5, Roller::RIGID, None);
//! let experiment = Experiment {
//!     radius, load, modulus, poisson_ratio, viscosity, retardation_time, motion, f, roller, temperature,
//! };
//! let solution = solve(&experiment.parameters(substrate), &Settings::default()).expect("a solution");
//! let friction = experiment.scales().friction * solution.quantities.friction.drag;
//! assert!((0.02..0.1).contains(&friction), "{friction}");
//! ```
//!
//! | file | what it holds |
//! | --- | --- |
//! | `quantity`, `units`, `temperature_unit`, `notation` | quantities of the laboratory; values with units; numbers and units as people write them |
//! | `turning` | speeds of the cylinder given as turns |
//! | `motion` | speeds of both surfaces |
//! | `roller` | what the roller is made of |
//! | `temperature`, `viscosity_law` | how times and viscosity change with temperature |
//! | `experiment`, `scales` | an experiment and its dimensionless case; results in SI units |
//! | `material` | relaxation and creep of a substrate; fits to measured moduli |
//! | [`table`] | tables of numbers as laboratories have them |
//! | `measured` | measured friction |
//! | `friction_fit` | fits to measured friction |

mod experiment;
mod friction_fit;
mod material;
mod measured;
mod motion;
mod notation;
mod quantity;
mod roller;
mod scales;
pub mod table;
mod temperature;
mod temperature_unit;
mod turning;
mod units;
mod viscosity_law;

pub use experiment::{Experiment, Modulus, Powers, Temperature, TemperatureLaws};
pub use friction_fit::{
    Bounds, Estimate, FittedCurve, FittedPoint, FrictionFit, FrictionFitError, FrictionTask, Inseparable, Unknown,
    Watch, best_beginning,
};
pub use material::{
    AtOneTemperature, Doubt, Isotherm, Isotherms, IsothermsError, Laid, MasterCurve, MasterCurveError, Material,
    MaterialData, MaterialError, MaterialFile, MaterialFileError, MaterialOptions, Measurement, Measurements,
    ModulusKind, PronyError, PronyFile, PronyParts, PronySeries, Relaxation, RelaxationFit, RelaxationFitError,
    RelaxationTerm, Shift, ShiftFactors, ShiftFactorsError, Shifting, TermChoice, VerticalShift,
};
pub use measured::Measured;
pub use motion::Motion;
pub use quantity::LaboratoryQuantity;
pub use roller::{Roller, RollerQuantity};
pub use scales::{Scales, si_units};
pub use table::{ColumnChoice, TableError, Understood};
pub use temperature::{GAS_CONSTANT, ShiftLaw, ShiftLawFit};
pub use temperature_unit::parse_temperature;
pub use turning::Turning;
pub use units::{Conversion, Dimension};
pub use viscosity_law::{ViscosityLaw, ViscosityTable};
