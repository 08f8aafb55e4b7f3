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

/// A number that is stored for each case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name of the data set and of the column.
    pub name: &'static str,
    /// What it is, in words.
    pub long_name: &'static str,
    /// Unit: `1` for dimensionless numbers, else the scale.
    pub units: &'static str,
    /// True if `summary.csv` shows it.
    pub in_summary: bool,
}

pub(super) const fn column(
    name: &'static str,
    units: &'static str,
    in_summary: bool,
    long_name: &'static str,
) -> Column {
    Column { name, long_name, units, in_summary }
}

/// The numbers stored for each case, in the order of [`Quantities::row`]; those in the summary come first.
pub const COLUMNS: [Column; 19] = [
    column("mu_v", "a0/R", true, "viscoelastic friction coefficient"),
    column("mu_h", "a0/R", true, "hydrodynamic friction coefficient, cavity included"),
    column("mu_tot", "a0/R", true, "total friction coefficient mu_v + mu_h"),
    column("mu_drag", "a0/R", true, "drag coefficient of the cylinder, by force balance"),
    column("mu_h_cavity", "a0/R", true, "part of mu_h behind the outlet"),
    column("c", "a0^2/R", true, "film thickness where the pressure gradient is zero"),
    column("film_min", "a0^2/R", true, "smallest film thickness"),
    column("p_max", "2N/(pi a0)", true, "largest pressure"),
    column("x_outlet", "a0", true, "outlet, where the film cavitates"),
    column("error_mu_v", "1", true, "estimated relative error of mu_v"),
    column("error_mu_h", "1", true, "estimated relative error of mu_h"),
    column("error_c", "1", true, "estimated relative error of c"),
    column("load_residual", "1", true, "relative residual of the load balance"),
    column("dry_mu_v", "a0/R", true, "friction coefficient of dry sliding, the limit of mu_v for large beta"),
    column("approx_mu_h", "a0/R", true, "hydrodynamic friction coefficient of the large-beta approximation"),
    column("x_p_max", "a0", false, "position of the largest pressure"),
    column("centroid", "a0", false, "load-weighted centroid of the pressure"),
    column("separation", "a0^2/R", false, "separation h0 that goes with the displacement"),
    column("mu_h_film", "a0/R", false, "part of mu_h in the pressurised film"),
];

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

    /// Names of their columns.
    pub const COLUMNS: [&'static str; 2] = ["dry_mu_v", "approx_mu_h"];

    /// The row of a case that failed: the limits are known, all else is NaN.
    pub fn failed_row(&self) -> [f64; COLUMNS.len()] {
        COLUMNS.map(|column| match column.name {
            "dry_mu_v" => self.dry_mu_v,
            "approx_mu_h" => self.approx_mu_h,
            _ => f64::NAN,
        })
    }
}

impl Quantities {
    /// The values of [`COLUMNS`], in their order.
    pub fn row(&self, errors: &RelativeErrors, limits: &Limits) -> [f64; COLUMNS.len()] {
        let friction = &self.friction;
        [
            friction.viscoelastic,
            friction.hydrodynamic(),
            friction.total(),
            friction.drag,
            friction.hydrodynamic_cavity,
            self.c,
            self.film_min,
            self.p_max,
            self.x_outlet,
            errors.mu_v,
            errors.mu_h,
            errors.c,
            self.load_residual,
            limits.dry_mu_v,
            limits.approx_mu_h,
            self.x_p_max,
            self.centroid,
            self.separation,
            friction.hydrodynamic_film,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each number stands under its name: the rows of converged and failed cases agree on where the limits are.
    #[test]
    fn the_row_is_in_the_order_of_the_columns() {
        let friction = Friction { viscoelastic: 1.0, hydrodynamic_film: 2.0, hydrodynamic_cavity: 3.0, drag: 4.0 };
        let quantities = Quantities {
            friction,
            c: 5.0,
            film_min: 6.0,
            p_max: 7.0,
            x_p_max: 8.0,
            x_outlet: 9.0,
            centroid: 10.0,
            separation: 11.0,
            load_residual: 12.0,
        };
        let errors = RelativeErrors { mu_v: 13.0, mu_h: 14.0, c: 15.0 };
        let limits = Limits { dry_mu_v: 16.0, approx_mu_h: 17.0 };
        let row = quantities.row(&errors, &limits);
        let value = |name| row[COLUMNS.iter().position(|column| column.name == name).expect(name)];
        let expected = [
            ("mu_v", 1.0),
            ("mu_h", 5.0),
            ("mu_tot", 6.0),
            ("mu_drag", 4.0),
            ("mu_h_cavity", 3.0),
            ("mu_h_film", 2.0),
            ("c", 5.0),
            ("film_min", 6.0),
            ("p_max", 7.0),
            ("x_p_max", 8.0),
            ("x_outlet", 9.0),
            ("centroid", 10.0),
            ("separation", 11.0),
            ("load_residual", 12.0),
            ("error_mu_v", 13.0),
            ("error_mu_h", 14.0),
            ("error_c", 15.0),
            ("dry_mu_v", 16.0),
            ("approx_mu_h", 17.0),
        ];
        assert_eq!(expected.len(), COLUMNS.len());
        for (name, number) in expected {
            assert_eq!(value(name), number, "{name}");
        }
        for (column, (failed, converged)) in COLUMNS.iter().zip(limits.failed_row().iter().zip(row)) {
            assert!(failed.is_nan() || *failed == converged, "{}", column.name);
        }
    }
}
