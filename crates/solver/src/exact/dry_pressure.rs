//! The pressure of dry sliding (Eq. 24, T13) and its gradient.

use super::dry::DryContact;
use super::position::Position;
use crate::model::gauss::integrate;

/// The exponent over which one quadrature panel reaches, and the exponent beyond which e^{−…} is below rounding.
const PANEL_EXPONENT: f64 = 3.0;
const LAST_PANEL: u32 = 14;
/// Longest quadrature panel in the angle.
const PANEL_ANGLE: f64 = 0.5;

impl DryContact {
    /// p at x, over 2N/(πa₀); 0 outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        self.pressure_on(&[x])[0]
    }

    /// p at each of the ascending `x` (T13), at the cost of one exponential integrator over them.
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
    /// There may be two maxima, one of the body of the contact and one in the layer of width 1/k at the leading edge.
    /// In ln tan(θ/2) both are wide: the highest of a row of points there is refined by golden section.
    pub fn peak(&self) -> (f64, f64) {
        if self.elastic {
            return (self.centre(), self.half_width().recip());
        }
        let nearest = -0.5 * (1e3 * (1.0 + self.k)).min(f64::MAX).ln();
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
        (self.leading_edge() - 2.0 * self.half_width() * Position::at(middle).to_leading, pressure(middle))
    }

    /// Largest pressure, over 2N/(πa₀).
    pub fn max_pressure(&self) -> f64 {
        self.peak().1
    }

    /// dp/dx at `here`, in the contact; −∞ at the leading edge, +∞ at the trailing edge.
    ///
    /// The derivative of (T13), k(p/ā − G) with G = (sin²θ + Γ₂ − Γ₁ cos θ)/sin θ, cancels for large k. Written as
    ///
    /// ```text
    /// p′ = k [ ∫_0^θ k e^{−k(cos φ − cos θ)} (G(φ) − G(θ)) sin φ dφ − G(θ) e^{−k(1 − cos θ)} ]
    /// ```
    ///
    /// with the difference taken by trigonometric identities, it does not.
    pub(super) fn pressure_gradient(&self, here: Position) -> f64 {
        if here.to_leading <= 0.0 {
            return f64::NEG_INFINITY;
        }
        if here.to_trailing <= 0.0 {
            return f64::INFINITY;
        }
        let angle = here.angle();
        let sin = 2.0 * (here.to_leading * here.to_trailing).sqrt();
        if self.elastic {
            return -(here.to_trailing - here.to_leading) / (sin * self.half_width() * self.half_width());
        }
        let (gamma2, trailing) = (self.gamma2(), self.trailing_slope / self.k);
        let edge = (-2.0 * self.k * here.to_leading).exp() * self.strength(angle) / sin;
        let difference = |d: f64| {
            let (half, ahead) = (0.5 * d, angle - d);
            let tilt = 2.0 * gamma2 * (0.5 * angle).cos() * (0.5 * ahead).cos() + trailing * half.cos();
            2.0 * half.sin() * (tilt / sin - (angle - half).cos() * ahead.sin())
        };
        self.k * self.retarded(Position::LEADING_EDGE, here, |d| self.k * difference(d)) - edge
    }

    /// Where x lies in the contact; its distances are negative outside.
    pub(super) fn position(&self, x: f64) -> Position {
        let width = 2.0 * self.half_width();
        Position { to_leading: (self.leading_edge() - x) / width, to_trailing: (x - self.trailing_edge()) / width }
    }

    /// p at `here` from p at `right`, one step of the integral (T13) from right to left.
    fn pressure_from(&self, right: Position, right_pressure: f64, here: Position) -> f64 {
        if self.elastic {
            return 2.0 * (here.to_leading * here.to_trailing).max(0.0).sqrt() / self.half_width();
        }
        let reach = here.to_leading - right.to_leading;
        let kept = right_pressure * (-2.0 * self.k * reach).exp();
        // The pressure falls to zero at the trailing edge as a difference; rounding may leave it below.
        let angle = here.angle();
        let gained = self.retarded(right, here, |d| self.strength(angle - d));
        (kept + self.half_width() * gained).max(0.0)
    }

    /// k (sin²φ + Γ₂ − Γ₁ cos φ), in which nothing cancels at the trailing edge φ = π.
    fn strength(&self, angle: f64) -> f64 {
        let (sin, cos_half) = (angle.sin(), (0.5 * angle).cos());
        self.k * sin * sin + 2.0 * self.slope * cos_half * cos_half - self.trailing_slope
    }

    /// ∫ e^{−k(cos φ − cos θ)} g(θ − φ) dφ over φ from `right` to `here` (at angle θ), cut where the exponential is
    /// below rounding. In the distance d = θ − φ, so that a layer of width 1/k is resolved for any k.
    fn retarded(&self, right: Position, here: Position, g: impl Fn(f64) -> f64) -> f64 {
        let angle = here.angle();
        let integrand = |d: f64| {
            let exponent = 2.0 * self.k * (angle - 0.5 * d).sin() * (0.5 * d).sin();
            g(d) * (-exponent).exp()
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
