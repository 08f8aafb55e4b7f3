//! The shear that the film exerts on the roller, place by place.

use std::f64::consts::PI;

use super::CavityShear;

/// What the film at a place needs to know of its case to have a shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lubricant {
    /// β.
    pub beta: f64,
    /// c, the film thickness where p′ = 0.
    pub c: f64,
    /// x_out, where the film cavitates.
    pub outlet: f64,
    /// What fills the gap behind the outlet.
    pub cavity_shear: CavityShear,
}

/// The shear on the roller's surface at x, where the film is u, over N/R: p′u/π + S/(3πβu) with the slide-to-roll ratio
/// S (T52) and p′ of Reynolds' equation (T2), βu³p′ = c − u.
///
/// Behind the outlet there is no p′, and the second part has the share θ of the gap that the fluid fills.
pub fn shear_traction(lubricant: &Lubricant, x: f64, u: f64, slide_roll: f64) -> f64 {
    let Lubricant { beta, c, outlet, cavity_shear } = *lubricant;
    let couette = slide_roll / (3.0 * PI * beta * u);
    if x > outlet {
        return (c - u) / (PI * beta * u * u) + couette;
    }
    match cavity_shear {
        CavityShear::Full => couette,
        CavityShear::Streamers => couette * c / u,
        CavityShear::None => 0.0,
    }
}
