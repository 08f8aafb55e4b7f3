//! Dry sliding with one retardation time (β → ∞): the closed form of Hunter (J. Appl. Mech. 28, 611, 1961), Eqs. 24–32.

use super::bessel_ratio::{excess, i2_over_i1, k0_over_k1};
use super::root::bracketed_root;
use crate::model::Parameters;

/// The dry contact of a rigid cylinder that slides to +x on a half space with one retardation time (Eqs. 24–32 with the
/// misprints corrected, see `docs/explanation/theory.md`).
///
/// With K = (1+f)α, k = Kā, Q = K₀(αā)/K₁(αā), T = I₂(k)/I₁(k) and m = k(Q + T), the printed formulas become
///
/// ```text
/// ā² = (2 + m)/(2(1 + f) + m)          half width                        (T14)
/// Γ₂ = f/(2 + m)                                                         (T14)
/// b  = ā f Q/(2 + m)                   centre, towards the leading edge  (T14)
/// F_v = ā f (Q + ā² T)/(2 + m)         friction                          (T15)
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
    pub(super) k: f64,
    gamma2: f64,
    /// −kΓ₁ = 1 + Γ₂(2 + kT), finite for k → 0.
    pub(super) slope: f64,
    /// −k(Γ₁ + Γ₂) = 1 + Γ₂ k(I₀/I₁ − 1), which cancels if formed from the Γ.
    pub(super) trailing_slope: f64,
    pub(super) elastic: bool,
}

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
        // The half width (T14) in ln ā. It is not positive at the instantaneous half width and not negative at the
        // relaxed one.
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

    /// Γ₁ (T14); negative, −∞ at α = 0.
    pub fn gamma1(&self) -> f64 {
        -self.slope / self.k
    }

    /// Γ₂ (T14), ½(1/ā² − 1).
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

    /// F_v, the friction force over N a₀/R (T15); 0 in the elastic limits, positive elsewhere.
    pub fn friction(&self) -> f64 {
        self.friction
    }
}
