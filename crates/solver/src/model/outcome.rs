//! The numbers of a solved case: friction, film and their estimated errors.

/// Friction forces over N a₀/R, that is friction coefficients over a₀/R (section "Friction" of `docs/theory.md`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// F_v, viscoelastic (hysteresis) friction (Eq. 22, sign corrected).
    pub viscoelastic: f64,
    /// F_h,film, shear on the cylinder where the film carries pressure (Eq. 20).
    pub hydrodynamic_film: f64,
    /// F_h,cavity, shear on the cylinder behind the outlet.
    pub hydrodynamic_cavity: f64,
    /// F_drag, all that holds the cylinder back: shear and the horizontal part of the pressure on it.
    pub drag: f64,
}

impl Friction {
    /// F_h = F_h,film + F_h,cavity.
    pub fn hydrodynamic(&self) -> f64 {
        self.hydrodynamic_film + self.hydrodynamic_cavity
    }

    /// F_tot = F_v + F_h (Eq. 50).
    pub fn total(&self) -> f64 {
        self.viscoelastic + self.hydrodynamic()
    }

    /// The scale of the relative error of F_v; see [`viscoelastic_error_scale`].
    pub fn viscoelastic_error_scale(&self) -> f64 {
        viscoelastic_error_scale(self.viscoelastic, self.total())
    }
}

/// The scale of the relative error of μ_v: max(|μ_v|, μ_tot/1000).
///
/// μ_v vanishes on an elastic substrate, where an error relative to μ_v itself would mean nothing.
pub fn viscoelastic_error_scale(mu_v: f64, mu_tot: f64) -> f64 {
    mu_v.abs().max(1e-3 * mu_tot)
}

/// Every number of a case but its fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantities {
    /// Friction forces.
    pub friction: Friction,
    /// c, the film thickness where p′ = 0; the flow under the cylinder.
    pub c: f64,
    /// Smallest film thickness.
    pub film_min: f64,
    /// Largest pressure.
    pub p_max: f64,
    /// Where the pressure is largest.
    pub x_p_max: f64,
    /// Outlet x_out, where the film cavitates (the trailing edge of the pressure).
    pub x_outlet: f64,
    /// Load-weighted centroid of the pressure, (2/π) ∫ p x dx.
    pub centroid: f64,
    /// h₀ of (T3), with the displacement as (T10) defines it.
    pub separation: f64,
    /// |load/(π/2) − 1| that is left.
    pub load_residual: f64,
}

/// Estimated relative errors; NaN where there is no estimate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeErrors {
    /// Error of μ_v, relative to [`viscoelastic_error_scale`].
    pub mu_v: f64,
    /// Error of μ_h.
    pub mu_h: f64,
    /// Error of c.
    pub c: f64,
}

impl RelativeErrors {
    /// No estimate.
    pub const UNKNOWN: Self = Self { mu_v: f64::NAN, mu_h: f64::NAN, c: f64::NAN };

    /// The largest of them; `None` if one is not known.
    pub fn largest(&self) -> Option<f64> {
        let all = [self.mu_v, self.mu_h, self.c];
        all.iter().all(|error| !error.is_nan()).then(|| all.into_iter().fold(0.0, f64::max))
    }
}

/// Fields at the positions [`Output::x`](super::Output::x); a field that was not asked for is `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// p(x), over 2N/(πa₀).
    pub pressure: Option<Vec<f64>>,
    /// u(x), over a₀²/R.
    pub film_thickness: Option<Vec<f64>>,
    /// w(x) of (T10), over a₀²/R.
    pub displacement: Option<Vec<f64>>,
}

/// The limits beside a solution; NaN where not asked for, or where it is not known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// F_v of dry sliding.
    pub dry_mu_v: f64,
    /// F_h of the large-β approximation.
    pub approx_mu_h: f64,
}

impl Limits {
    /// No limit computed.
    pub const UNKNOWN: Self = Self { dry_mu_v: f64::NAN, approx_mu_h: f64::NAN };
}
