//! The numbers of a solved case: friction, film and their estimated errors.

/// Friction forces over N a₀/R, that is friction coefficients over a₀/R (section "Friction" of
/// `docs/explanation/theory.md`).
///
/// They are those of a roller that slides without turning, S = 1 (T52). [`Friction::drag_at`] and its neighbours give
/// them for other slide-to-roll ratios: pressure, film, P and C do not depend on S.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// F_v, viscoelastic (hysteresis) friction (Eq. 22, sign corrected), of both bodies.
    pub viscoelastic: f64,
    /// F_v,1, the roller's part of it (T53); 0 unless the roller is viscoelastic.
    pub viscoelastic_roller: f64,
    /// F_h,film, shear on the cylinder where the film carries pressure (Eq. 20).
    pub hydrodynamic_film: f64,
    /// F_h,cavity, shear on the cylinder behind the outlet.
    pub hydrodynamic_cavity: f64,
    /// P, part of F_h by the pressure gradient (Poiseuille flow), (1/π) ∫ p′u dx (T53); negative.
    pub pressure: f64,
    /// F_drag, all that holds the cylinder back: shear and the horizontal part of the pressure on it. It is what a
    /// load cell reads, on the flat and on the roller's bearing (T54).
    pub drag: f64,
}

impl Friction {
    /// F_h = F_h,film + F_h,cavity.
    pub fn hydrodynamic(&self) -> f64 {
        self.hydrodynamic_film + self.hydrodynamic_cavity
    }

    /// C, part of F_h by the difference of the speeds (Couette flow), (1/(3πβ)) ∫ dx/u, the cavity included (T53);
    /// positive.
    pub fn shear(&self) -> f64 {
        self.hydrodynamic() - self.pressure
    }

    /// P + S C, shear on the roller's surface at the slide-to-roll ratio S.
    pub fn hydrodynamic_at(&self, slide_roll: f64) -> f64 {
        self.hydrodynamic() - (1.0 - slide_roll) * self.shear()
    }

    /// F_v,2, the flat's part of the viscoelastic friction (T53).
    pub fn viscoelastic_flat(&self) -> f64 {
        self.viscoelastic - self.viscoelastic_roller
    }

    /// M = P + S C − F_v,1, the torque on the roller about its axis over N a₀, at the slide-to-roll ratio S (T55).
    pub fn torque_at(&self, slide_roll: f64) -> f64 {
        self.hydrodynamic_at(slide_roll) - self.viscoelastic_roller
    }

    /// D, the drag at the slide-to-roll ratio S (T54).
    pub fn drag_at(&self, slide_roll: f64) -> f64 {
        self.drag - (1.0 - slide_roll) * self.shear()
    }

    /// F_v + P + S C, the hysteresis and the shear on the roller at the slide-to-roll ratio S.
    pub fn total_at(&self, slide_roll: f64) -> f64 {
        self.viscoelastic + self.hydrodynamic_at(slide_roll)
    }

    /// F_tot = F_v + F_h (Eq. 50): shear on the roller and pressure on the flat. It is the paper's quantity; no
    /// instrument reads it.
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
    /// (β/π) ∫ u³p′² dx, the power that the pressure-driven flow dissipates, over N a₀ V/R; −P in exact arithmetic
    /// (T56).
    pub dissipation: f64,
    /// h₀ of (T3), with the displacement as (T10) defines it.
    pub separation: f64,
    /// |load/(π/2) − 1| that is left.
    pub load_residual: f64,
}

impl Quantities {
    /// What is left of the balance of power (T56) at the slide-to-roll ratio S, over the power that is dissipated.
    ///
    /// Power comes in as drag on the flat and torque on the roller, both by the centroid of the pressure. It goes to
    /// hysteresis of each body, to the flow that pressure drives, and to shear by the difference of the speeds.
    pub fn energy_residual(&self, slide_roll: f64) -> f64 {
        let friction = &self.friction;
        let (roller, flat) = (0.5 * (1.0 - slide_roll), 0.5 * (1.0 + slide_roll));
        let drag = friction.drag_at(slide_roll);
        let put_in = drag * flat - (drag - self.centroid) * roller;
        let hysteresis = friction.viscoelastic_roller * roller + friction.viscoelastic_flat() * flat;
        let dissipated = hysteresis + self.dissipation + slide_roll * slide_roll * friction.shear();
        ((put_in - dissipated) / dissipated).abs()
    }
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
    /// Error of the drag at S = 1.
    pub drag: f64,
    /// Error of P.
    pub pressure: f64,
    /// Error of C.
    pub shear: f64,
    /// Error of the smallest film.
    pub film_min: f64,
    /// Error of the largest pressure.
    pub p_max: f64,
}

impl RelativeErrors {
    /// No estimate.
    pub const UNKNOWN: Self = Self {
        mu_v: f64::NAN,
        mu_h: f64::NAN,
        c: f64::NAN,
        drag: f64::NAN,
        pressure: f64::NAN,
        shear: f64::NAN,
        film_min: f64::NAN,
        p_max: f64::NAN,
    };

    /// The largest error of μ_v, μ_h and c, which a tolerance bounds; `None` if one is not known.
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
    /// Shear on the roller's surface, over N/R, at S = 1: see [`shear_traction`](crate::shear_traction). Its integral
    /// over x is F_h.
    pub shear_traction: Option<Vec<f64>>,
    /// (2/π) p w′, over N/R. Its integral over x is F_v.
    pub hysteresis_traction: Option<Vec<f64>>,
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
