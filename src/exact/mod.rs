//! Limits with known answers (section "Limits" of `docs/theory.md`).
//!
//! | limit | what is known | type |
//! | --- | --- | --- |
//! | β → ∞ | dry sliding, closed form for one retardation time | [`DryContact`] |
//! | β → 0 | a rigid cylinder on a rigid plane | `RigidFilm` |

mod bessel_ratio;
mod bounds;
mod dry;
mod gauss;
mod root;

pub use bounds::contact_bounds;
pub use dry::DryContact;
