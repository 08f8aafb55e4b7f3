//! The large-β approximation (Sec. 4.3, Eqs. 34–36 and 45–51): a film on top of dry sliding, without any iteration.

use std::f64::consts::PI;

use super::carried_shear::carried_shear;
use super::dry::DryContact;
use super::dry_gradient::DryGradient;
use super::position::Position;
use crate::model::Parameters;

/// c of the elastic film at large β, 0.197/√β + 0.951/β (Eq. 34).
///
/// A fit to solutions, good to about 0.1 % at β = 100 to 1000. It is no asymptote: elastic films fall as β^{−3/5}, so
/// that the fit is 3.5 % too thick at β = 2000 and 16 % at 10⁴.
pub fn approx_elastic_c(beta: f64) -> f64 {
    0.197 / beta.sqrt() + 0.951 / beta
}

/// u of the elastic film at large β, c (1 + 0.197² x + 3·0.197⁴ x²) for |x| < 1 (Eq. 36): the cubic (T2) with the
/// Hertzian gradient near the middle, to second order.
pub fn approx_elastic_film(beta: f64, x: f64) -> f64 {
    let slope = 0.197 * 0.197;
    approx_elastic_c(beta) * (1.0 + slope * x + 3.0 * slope * slope * x * x)
}

/// The large-β approximation for one retardation time: pressure and F_v of dry sliding, c from a fit, the film from
/// (T2).
///
/// # The root of the cubic
/// β p′u³ + u − c = 0 with the dry p′ at x. Where p′ ≥ 0 there is one real root, 0 < u ≤ c; it falls to 0 at the
/// trailing edge, where p′ is infinite. Where p′ < 0 there are two positive roots as long as β|p′| ≤ 4/(27c²). The
/// smaller one, c ≤ u ≤ 3c/2, continues the film from p′ = 0 and is taken. Close to the leading edge p′ is steeper than
/// any film can carry, and there is no positive root: there u = 3c/2 is kept, the film at the steepest gradient that
/// can be carried. Its shear (1/(πβu))(c/u − ⅔) is zero, so what is chosen for that strip does not enter F_h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargeBeta {
    contact: DryContact,
    beta: f64,
    c: f64,
}

impl LargeBeta {
    /// The approximation of a case; `None` for several retardation times, for which dry sliding has no closed form.
    pub fn new(parameters: &Parameters) -> Option<Self> {
        Self::on(DryContact::of(parameters)?, parameters)
    }

    /// The approximation of a case whose dry contact is known.
    pub(super) fn on(contact: DryContact, parameters: &Parameters) -> Option<Self> {
        let &[mode] = parameters.substrate.modes() else { return None };
        let decay = (-1.41 * parameters.alpha / mode.time).exp();
        let c = approx_elastic_c(parameters.beta * (1.0 + parameters.f * decay));
        Some(Self { contact, beta: parameters.beta, c })
    }

    /// The dry contact below the film.
    pub fn contact(&self) -> &DryContact {
        &self.contact
    }

    /// c = 0.197/√β* + 0.951/β*, β* = β(1 + f e^{−1.41α}) (Eq. 49); a fit, see [`approx_elastic_c`].
    pub fn approx_c(&self) -> f64 {
        self.c
    }

    /// F_v, that of dry sliding.
    pub fn approx_mu_v(&self) -> f64 {
        self.contact.friction()
    }

    /// u at x, from the cubic (T2) with the dry p′; `None` outside the dry contact.
    pub fn approx_film(&self, x: f64) -> Option<f64> {
        let here = self.contact.position(x);
        let inside = here.to_leading >= 0.0 && here.to_trailing >= 0.0;
        inside.then(|| self.c * film_ratio(self.steepness(here)))
    }

    /// F_h, the shear ∫ [p′u/π + 1/(3πβu)] dx over the dry contact (Eq. 20).
    ///
    /// With p′ from (T2) the integrand is (1/(πβu))(c/u − ⅔). Most of the work is in p′, which does not depend on β:
    /// use [`ChainLimits`](super::ChainLimits) for many β.
    pub fn approx_mu_h(&self) -> f64 {
        self.shear(&DryGradient::new(&self.contact))
    }

    /// F_h, from the tabulated gradient of its dry contact.
    pub(super) fn shear(&self, gradient: &DryGradient) -> f64 {
        let unit = 4.0 * self.contact.half_width() / (PI * self.beta * self.c);
        unit * carried_shear(gradient, self.beta * self.c * self.c)
    }

    /// β c² p′, the one number in the cubic for u/c.
    fn steepness(&self, here: Position) -> f64 {
        self.beta * self.c * self.c * self.contact.pressure_gradient(here)
    }
}

/// Largest −βc²p′ that a film can carry.
pub(super) const STEEPEST: f64 = 4.0 / 27.0;

/// The root v = u/c of s v³ + v − 1 = 0 that is 1 at s = 0, by the trisection of an angle; 3/2 below s = −4/27, where
/// it has ended; 0 for s = +∞.
pub(super) fn film_ratio(steepness: f64) -> f64 {
    if steepness <= -STEEPEST {
        return 1.5;
    }
    let sine = (6.75 * steepness.abs()).sqrt();
    if sine < 1e-4 {
        1.0 - steepness
    } else if steepness < 0.0 {
        3.0 / sine * (sine.asin() / 3.0).sin()
    } else if sine == f64::INFINITY {
        0.0
    } else {
        3.0 / sine * (sine.asinh() / 3.0).sinh()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn film_ratio_solves_the_cubic() {
        let steep = (-16..=12).flat_map(|i| [10_f64.powi(i), -10_f64.powi(i)]);
        for s in steep.filter(|&s| s > -STEEPEST).chain([0.0, -0.148, -0.1481481]) {
            let v = film_ratio(s);
            let residual = s * v * v * v + v - 1.0;
            assert!(residual.abs() < 4e-15, "{s}: {residual}");
            assert!(v > 0.0 && if s > 0.0 { v <= 1.0 } else { (1.0..=1.5).contains(&v) });
        }
        assert_eq!((film_ratio(f64::NEG_INFINITY), film_ratio(f64::INFINITY)), (1.5, 0.0));
    }

    /// The gradient against differences of the pressure.
    #[test]
    fn gradient_is_that_of_the_pressure() {
        for (alpha, f) in [(1.0, 1.0), (1e-3, 1e3), (1.0, 1e6), (30.0, 10.0), (0.0, 4.0), (1e6, 1e6)] {
            let contact = DryContact::new(alpha, f);
            for i in 1..=30 {
                let xi = (0.1 * f64::from(i)).cos();
                let x = contact.centre() + contact.half_width() * xi;
                let step = 1e-4 * contact.half_width() * (1.0 - xi.abs());
                let p = contact.pressure_on(&[x - 2.0 * step, x - step, x + step, x + 2.0 * step]);
                let difference = (8.0 * (p[2] - p[1]) - (p[3] - p[0])) / (12.0 * step);
                let gradient = contact.pressure_gradient(contact.position(x));
                let scale = contact.max_pressure() / contact.half_width();
                assert!((gradient - difference).abs() < 1e-7 * scale.max(gradient.abs()), "{alpha} {f} {xi}");
            }
        }
    }
}
