//! Limits with known answers (section "Limits" of `docs/theory.md`).
//!
//! | limit | what is known | type |
//! | --- | --- | --- |
//! | β → ∞ | dry sliding, closed form for one retardation time | [`DryContact`] |
//! | β → ∞, elastic | Hertz | [`HertzContact`] |
//! | β large | film and shear on top of dry sliding; an approximation | [`LargeBeta`] |
//! | β → 0 | a rigid cylinder on a rigid plane | [`RigidFilm`] |

mod bessel_ratio;
mod bounds;
mod dry;
mod dry_pressure;
mod hertz;
mod large_beta;
mod position;
mod rigid;
mod root;

pub use bounds::contact_bounds;
pub use dry::DryContact;
pub use hertz::HertzContact;
pub use large_beta::{LargeBeta, approx_elastic_c, approx_elastic_film};
pub use rigid::RigidFilm;

use crate::model::{Limits, Parameters};

/// The limits published beside a solution; NaN for several retardation times, where there is no closed form.
pub fn limits(parameters: &Parameters) -> Limits {
    LargeBeta::new(parameters).map_or(Limits::UNKNOWN, |approximation| Limits {
        dry_mu_v: approximation.approx_mu_v(),
        approx_mu_h: approximation.approx_mu_h(),
    })
}
