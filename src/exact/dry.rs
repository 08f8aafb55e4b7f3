//! Dry sliding with one retardation time (β → ∞): the closed form of Hunter (J. Appl. Mech. 28, 611, 1961), Eqs. 24–32.

use super::bessel_ratio::{excess, i2_over_i1, k0_over_k1};
use super::gauss::integrate;
use super::root::bracketed_root;
use crate::model::Parameters;

/// The dry contact of a rigid cylinder that slides to +x on a half space with one retardation time (Eqs. 24–32 with the
/// misprints corrected, see `docs/theory.md`).
///
/// With K = (1+f)α, k = Kā, Q = K₀(αā)/K₁(αā), T = I₂(k)/I₁(k) and m = k(Q + T), the printed formulas become
///
/// ```text
/// ā² = (2 + m)/(2(1 + f) + m)          half width                                  (Eq. 28)
/// Γ₂ = f/(2 + m)                                                                   (Eq. 30)
/// b  = ā f Q/(2 + m)                   centre, towards the leading edge            (Eq. 29)
/// F_v = ā f (Q + ā² T)/(2 + m)         friction                                    (Eq. 32)
/// ```
///
/// in which nothing cancels: written as ½(1/ā² − 1), āΓ₁ + 1/α and b − 1/K − ā³Γ₁ they lose all digits for small and
/// large k. The elastic limits f = 0, α = 0, α = ∞ come out of the same formulas: Hertz, with the modulus that counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DryContact {
    half_width: f64,
    centre: f64,
    friction: f64,
    /// k = (1+f)αā.
    k: f64,
    gamma2: f64,
    /// −kΓ₁ = 1 + Γ₂(2 + kT), finite for k → 0.
    slope: f64,
    /// −k(Γ₁ + Γ₂) = 1 + Γ₂ k(I₀/I₁ − 1), which cancels if formed from the Γ.
    trailing_slope: f64,
    elastic: bool,
}

/// The exponent over which one quadrature panel reaches, and the exponent beyond which e^{−…} is below rounding.
const PANEL_EXPONENT: f64 = 2.0;
const LAST_PANEL: u32 = 20;
/// Longest quadrature panel in the angle.
const PANEL_ANGLE: f64 = 0.5;

impl DryContact {
    /// The dry contact for α in [0, ∞] and f ≥ 0. Hertzian for f = 0, α = 0 (half width 1/√(1+f)) and α = ∞ (1).
    ///
    /// # Panics
    /// If α or f is negative or NaN, or f is infinite.
    pub fn new(alpha: f64, f: f64) -> Self {
        assert!(alpha >= 0.0, "alpha must be in [0, inf], not {alpha}");
        assert!(f >= 0.0 && f.is_finite(), "f must be a finite number from 0, not {f}");
        let ratios = |half_width: f64| {
            let k = (1.0 + f) * alpha * half_width;
            (k, k0_over_k1(alpha * half_width), i2_over_i1(k))
        };
        // Eq. 28 in ln ā. It is not positive at the instantaneous half width and not negative at the relaxed one.
        let residual = |ln_half_width: f64| {
            let (k, q, t) = ratios(ln_half_width.exp());
            2.0 * ln_half_width + (2.0 * f / (2.0 + k * (q + t))).ln_1p()
        };
        let half_width = bracketed_root(residual, -0.5 * f.ln_1p(), 0.0).exp();
        let (k, q, t) = ratios(half_width);
        let gamma2 = f / (2.0 + k * (q + t));
        Self {
            half_width,
            centre: half_width * gamma2 * q,
            friction: half_width * gamma2 * (q + half_width * half_width * t),
            k,
            gamma2,
            slope: 1.0 + gamma2 * (2.0 + k * t),
            trailing_slope: 1.0 + gamma2 * excess(k),
            elastic: f == 0.0 || k == 0.0 || k == f64::INFINITY,
        }
    }

    /// The dry contact of a case; `None` for several retardation times, for which there is no closed form.
    pub fn of(parameters: &Parameters) -> Option<Self> {
        let &[mode] = parameters.substrate.modes() else { return None };
        Some(Self::new(parameters.alpha / mode.time, parameters.f))
    }

    /// ā, half the width of the contact, over a₀; from 1/√(1+f) to 1.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// b, the middle of the contact, over a₀; never behind the cylinder's axis.
    pub fn centre(&self) -> f64 {
        self.centre
    }

    /// Γ₁ of Eq. 31; negative, −∞ at α = 0.
    pub fn gamma1(&self) -> f64 {
        -self.slope / self.k
    }

    /// Γ₂ of Eq. 30, ½(1/ā² − 1).
    pub fn gamma2(&self) -> f64 {
        self.gamma2
    }

    /// x = b + ā, where the contact begins.
    pub fn leading_edge(&self) -> f64 {
        self.centre + self.half_width
    }

    /// x = b − ā, where the contact ends.
    pub fn trailing_edge(&self) -> f64 {
        self.centre - self.half_width
    }

    /// F_v, the friction force over N a₀/R (Eq. 32); 0 in the elastic limits, positive elsewhere.
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// p at x, over 2N/(πa₀); 0 outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        self.pressure_on(&[x])[0]
    }

    /// p at each of the ascending `x` (Eq. 24), at the cost of one exponential integrator over them.
    ///
    /// With ξ = (x − b)/ā = cos θ and s = cos φ,
    ///
    /// ```text
    /// p = ā ∫_0^θ k e^{−k(cos φ − cos θ)} (sin²φ + Γ₂ − Γ₁ cos φ) dφ
    /// ```
    ///
    /// has a smooth integrand, and p at one point follows from p at the next one to the right.
    ///
    /// # Panics
    /// If `x` is not ascending.
    pub fn pressure_on(&self, x: &[f64]) -> Vec<f64> {
        assert!(x.is_sorted(), "positions must be ascending");
        let mut right = Position::LEADING_EDGE;
        let mut right_pressure = 0.0;
        let mut pressure = vec![0.0; x.len()];
        for (p, &x) in pressure.iter_mut().zip(x).rev() {
            let here = self.position(x);
            if here.to_trailing <= 0.0 {
                break;
            }
            if here.to_leading > 0.0 {
                right_pressure = self.pressure_from(right, right_pressure, here);
                right = here;
                *p = right_pressure;
            }
        }
        pressure
    }

    /// Where the pressure is largest, and its value there.
    ///
    /// There may be two maxima, one of the body of the contact and one in the layer of width 1/k at the leading edge. In
    /// ln tan(θ/2) both are wide: the highest of a row of points there is refined by golden section.
    pub fn peak(&self) -> (f64, f64) {
        if self.elastic {
            return (self.centre, self.half_width.recip());
        }
        let nearest = -0.5 * (1e3 * (1.0 + self.k)).ln();
        let row = |i: u32| nearest + 0.1 * f64::from(i);
        let (mut right, mut right_pressure) = (Position::LEADING_EDGE, 0.0);
        let (mut best, mut highest) = (0, 0.0);
        for i in (0..).take_while(|&i| row(i) < 4.0) {
            let here = Position::at(row(i));
            right_pressure = self.pressure_from(right, right_pressure, here);
            right = here;
            if right_pressure > highest {
                (best, highest) = (i, right_pressure);
            }
        }
        let pressure = |ln_tan: f64| self.pressure_from(Position::LEADING_EDGE, 0.0, Position::at(ln_tan));
        let golden = 0.5 * (5_f64.sqrt() - 1.0);
        let (mut low, mut high) = (row(best) - 0.1, row(best) + 0.1);
        // The pressure is as exact as the square of the bracket that is left.
        while high - low > 1e-8 {
            let (lower, upper) = (high - golden * (high - low), low + golden * (high - low));
            if pressure(lower) > pressure(upper) { high = upper } else { low = lower }
        }
        let middle = 0.5 * (low + high);
        (self.leading_edge() - 2.0 * self.half_width * Position::at(middle).to_leading, pressure(middle))
    }

    /// Largest pressure, over 2N/(πa₀).
    pub fn max_pressure(&self) -> f64 {
        self.peak().1
    }

    fn position(&self, x: f64) -> Position {
        let width = 2.0 * self.half_width;
        Position { to_leading: (self.leading_edge() - x) / width, to_trailing: (x - self.trailing_edge()) / width }
    }

    /// p at `here` from p at `right`, one step of the integral of Eq. 24 from right to left.
    fn pressure_from(&self, right: Position, right_pressure: f64, here: Position) -> f64 {
        if self.elastic {
            return 2.0 * (here.to_leading * here.to_trailing).max(0.0).sqrt() / self.half_width;
        }
        let reach = here.to_leading - right.to_leading;
        let kept = right_pressure * (-2.0 * self.k * reach).exp();
        // The pressure falls to zero at the trailing edge as a difference; rounding may leave it below.
        (kept + self.half_width * self.gained(right, here)).max(0.0)
    }

    /// ∫ k e^{−k(cos φ − cos θ)} (sin²φ + Γ₂ − Γ₁ cos φ) dφ from `right` to `here` (at angle θ), cut where the
    /// exponential is below rounding.
    fn gained(&self, right: Position, here: Position) -> f64 {
        let angle = here.angle();
        // In the distance d = θ − φ, so that a layer of width 1/k is resolved for any k.
        let integrand = |d: f64| {
            let exponent = 2.0 * self.k * (angle - 0.5 * d).sin() * (0.5 * d).sin();
            let (sin, cos_half) = ((angle - d).sin(), (0.5 * (angle - d)).cos());
            let strength = self.k * sin * sin + 2.0 * self.slope * cos_half * cos_half - self.trailing_slope;
            strength * (-exponent).exp()
        };
        let reach = here.to_leading - right.to_leading;
        let (mut sum, mut near) = (0.0, 0.0);
        for panel in 1..=LAST_PANEL {
            let distance = 0.5 * PANEL_EXPONENT * f64::from(panel) / self.k;
            let last = distance >= reach;
            let far = if last { here.angle_to(right, reach) } else { here.angle_to(here.ahead(distance), distance) };
            let pieces = ((far - near) / PANEL_ANGLE).ceil().max(1.0);
            let piece = (far - near) / pieces;
            for i in 0..pieces as u32 {
                let start = near + f64::from(i) * piece;
                sum += integrate(start, start + piece, integrand);
            }
            if last {
                break;
            }
            near = far;
        }
        sum
    }
}

/// A place in the contact: its distances to the two edges over the width, sin²(θ/2) and cos²(θ/2).
#[derive(Clone, Copy)]
struct Position {
    to_leading: f64,
    to_trailing: f64,
}

impl Position {
    const LEADING_EDGE: Self = Self { to_leading: 0.0, to_trailing: 1.0 };

    /// The place where ln tan(θ/2) has the given value.
    fn at(ln_tan: f64) -> Self {
        let squared = (2.0 * ln_tan).exp();
        Self { to_leading: squared / (1.0 + squared), to_trailing: 1.0 / (1.0 + squared) }
    }

    /// θ, 0 at the leading edge and π at the trailing edge.
    fn angle(&self) -> f64 {
        2.0 * self.to_leading.sqrt().atan2(self.to_trailing.sqrt())
    }

    /// The place so many contact widths ahead.
    fn ahead(&self, distance: f64) -> Self {
        Self { to_leading: self.to_leading - distance, to_trailing: self.to_trailing + distance }
    }

    /// The angle between this place and one `distance` contact widths ahead, without loss if it is small.
    fn angle_to(&self, ahead: Self, distance: f64) -> f64 {
        let a = (self.to_leading * ahead.to_trailing).sqrt();
        let b = (self.to_trailing * ahead.to_leading).sqrt();
        let cos = (self.to_trailing * ahead.to_trailing).sqrt() + (self.to_leading * ahead.to_leading).sqrt();
        2.0 * (distance / (a + b)).atan2(cos)
    }
}
