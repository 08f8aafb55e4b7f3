//! The large-β approximation (Sec. 4.3, Eqs. 34–36 and 45–51): a film on top of dry sliding, without any iteration.

use std::f64::consts::{FRAC_PI_2, PI};

use super::dry::DryContact;
use super::position::Position;
use super::root::bracketed_root;
use crate::model::Parameters;
use crate::model::gauss::integrate;

/// c of the elastic film at large β, 0.197/√β + 0.951/β (Eq. 34).
///
/// A fit to solutions, good to about 0.1 % at β = 100 to 1000. It is no asymptote: elastic films fall as β^{−3/5}, so that the
/// fit is 3.5 % too thick at β = 2000 and 16 % at 10⁴.
pub fn approx_elastic_c(beta: f64) -> f64 {
    0.197 / beta.sqrt() + 0.951 / beta
}

/// u of the elastic film at large β, c (1 + 0.197² x + 3·0.197⁴ x²) for |x| < 1 (Eq. 36): the cubic (T2) with the Hertzian
/// gradient near the middle, to second order.
pub fn approx_elastic_film(beta: f64, x: f64) -> f64 {
    let slope = 0.197 * 0.197;
    approx_elastic_c(beta) * (1.0 + slope * x + 3.0 * slope * slope * x * x)
}

/// The large-β approximation for one retardation time: pressure and F_v of dry sliding, c from a fit, the film from (T2).
///
/// # The root of the cubic
/// β p′u³ + u − c = 0 with the dry p′ at x. Where p′ ≥ 0 there is one real root, 0 < u ≤ c; it falls to 0 at the trailing
/// edge, where p′ is infinite. Where p′ < 0 there are two positive roots as long as β|p′| ≤ 4/(27c²). The smaller one, c ≤ u
/// ≤ 3c/2, continues the film from p′ = 0 and is taken. Close to the leading edge p′ is steeper than any film can carry,
/// and there is no positive root: there u = 3c/2 is kept, the film at the steepest gradient that can be carried. Its shear
/// (1/(πβu))(c/u − ⅔) is zero, so what is chosen for that strip does not enter F_h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargeBeta {
    contact: DryContact,
    beta: f64,
    c: f64,
}

/// Step in ln tan(θ/2) in which changes between "a film carries p′" and "none does" are looked for.
const SCAN: f64 = 0.25;
/// Where the quadrature ends at the trailing edge: what is left falls as e^{−4η/3}.
const TRAILING_END: f64 = 15.0;

impl LargeBeta {
    /// The approximation of a case; `None` for several retardation times, for which dry sliding has no closed form.
    pub fn new(parameters: &Parameters) -> Option<Self> {
        let contact = DryContact::of(parameters)?;
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
    /// With p′ from (T2) the integrand is (1/(πβu))(c/u − ⅔). The parts of the contact that carry a film are found first,
    /// because u has a square-root end there; the coordinates of the quadrature take care of these ends and of the edges.
    pub fn approx_mu_h(&self) -> f64 {
        let carried = |ln_tan: f64| self.steepness(Position::at(ln_tan)) + STEEPEST;
        let start = -0.5 * (1e6 * (1.0 + self.contact.k.min(1e15))).ln();
        let mut sum = 0.0;
        let (mut end, mut carries) = (TRAILING_END, carried(TRAILING_END) > 0.0);
        let mut right = TRAILING_END;
        while right > start {
            let left = right - SCAN;
            let still = carried(left) > 0.0;
            if carries && !still {
                sum += self.shear_between(bracketed_root(carried, left, right), end);
            } else if still && !carries {
                end = bracketed_root(|ln_tan| -carried(ln_tan), left, right);
            }
            (right, carries) = (left, still);
        }
        if carries { sum + self.shear_between(right, end) } else { sum }
    }

    /// The part of F_h between two places with a film, by ln tan(θ/2).
    fn shear_between(&self, start: f64, end: f64) -> f64 {
        let unit = 4.0 * self.contact.half_width() / (PI * self.beta * self.c);
        let length = end - start;
        let shear = |t: f64| {
            let here = Position::at(start + length * t.sin().powi(2));
            let film = film_ratio(self.steepness(here));
            let dx = here.to_leading * here.to_trailing * length * (2.0 * t).sin();
            unit * dx * (1.0 / film - 2.0 / 3.0) / film
        };
        let panels = (length.ceil() as u32).clamp(2, 24);
        let panel = FRAC_PI_2 / f64::from(panels);
        (0..panels).map(|i| integrate(f64::from(i) * panel, f64::from(i + 1) * panel, shear)).sum()
    }

    /// β c² p′, the one number in the cubic for u/c.
    fn steepness(&self, here: Position) -> f64 {
        self.beta * self.c * self.c * self.contact.pressure_gradient(here)
    }
}

/// Largest −βc²p′ that a film can carry.
const STEEPEST: f64 = 4.0 / 27.0;

/// The root v = u/c of s v³ + v − 1 = 0 that is 1 at s = 0, by the trisection of an angle; 3/2 below s = −4/27, where it
/// has ended; 0 for s = +∞.
fn film_ratio(steepness: f64) -> f64 {
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
