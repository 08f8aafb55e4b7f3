//! Limits with known answers (section "Limits" of `docs/explanation/theory.md`).
//!
//! | limit | what is known | type |
//! | --- | --- | --- |
//! | β → ∞ | dry sliding, closed form for one retardation time | [`DryContact`] |
//! | β → ∞ | dry sliding, any number of retardation times | [`DrySliding`] |
//! | β → ∞, elastic | Hertz | [`HertzContact`] |
//! | β large | film and shear on top of dry sliding; an approximation | [`LargeBeta`] |
//! | any β | c from a formula fitted to solutions, no limit | [`fitted_c`] |
//! | β → 0 | a rigid cylinder on a rigid plane | [`RigidFilm`] |
//!
//! Dry sliding with several retardation times needs the relaxation spectrum that goes with them, which [`Spectrum`]
//! finds.

mod bessel_ratio;
mod bounds;
mod carried_shear;
mod dry;
mod dry_gradient;
mod dry_modes;
mod dry_pressure;
mod film_formula;
mod hertz;
mod large_beta;
mod limits;
mod lobatto;
mod position;
mod rigid;
mod root;
mod spectrum;

pub use bounds::contact_bounds;
pub use dry::DryContact;
pub use dry_modes::DrySliding;
pub use film_formula::fitted_c;
pub use hertz::HertzContact;
pub use large_beta::{LargeBeta, approx_elastic_c, approx_elastic_film};
pub use limits::{ChainLimits, limits};
pub use rigid::RigidFilm;
pub use spectrum::{Conjugate, Line, Spectrum};
