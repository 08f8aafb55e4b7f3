//! How friction changes with the parameters of a case.

/// Derivatives dF/d ln θ of friction forces over N a₀/R with respect to the logarithms of θ = α, β and f, in this order
/// (T49).
///
/// α stands for all modes: their rates change together. f changes at fixed shares. Where a parameter means nothing (α
/// and f of a relaxed elastic substrate, α = 0) the derivative is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// Derivatives of F_v.
    pub viscoelastic: [f64; 3],
    /// Derivatives of F_h, the cavity included.
    pub hydrodynamic: [f64; 3],
}

impl Sensitivities {
    /// The names of the derivatives in the order of [`Sensitivities::row`]: `dmu_v_dln_alpha` is dF_v/d ln α.
    pub const NAMES: [&'static str; 6] =
        ["dmu_v_dln_alpha", "dmu_v_dln_beta", "dmu_v_dln_f", "dmu_h_dln_alpha", "dmu_h_dln_beta", "dmu_h_dln_f"];

    /// The derivatives in the order of [`Sensitivities::NAMES`].
    pub fn row(&self) -> [f64; 6] {
        let ([a, b, c], [d, e, f]) = (self.viscoelastic, self.hydrodynamic);
        [a, b, c, d, e, f]
    }

    /// The sensitivities from the values of a row; `None` if one of them is NaN, as in a row without sensitivities.
    pub fn from_row([a, b, c, d, e, f]: [f64; 6]) -> Option<Self> {
        let sensitivities = Self { viscoelastic: [a, b, c], hydrodynamic: [d, e, f] };
        sensitivities.row().iter().all(|value| !value.is_nan()).then_some(sensitivities)
    }

    /// Derivatives of F_tot = F_v + F_h.
    pub fn total(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.viscoelastic[i] + self.hydrodynamic[i])
    }

    /// d ln μ/d ln θ of μ_v, μ_h and μ_tot = μ_v + μ_h, one row each; NaN where μ = 0.
    pub fn logarithmic(&self, mu_v: f64, mu_h: f64) -> [[f64; 3]; 3] {
        let relative = |derivatives: [f64; 3], mu: f64| {
            derivatives.map(|derivative| if mu == 0.0 { f64::NAN } else { derivative / mu })
        };
        [relative(self.viscoelastic, mu_v), relative(self.hydrodynamic, mu_h), relative(self.total(), mu_v + mu_h)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_comes_back() {
        let sensitivities = Sensitivities { viscoelastic: [1.0, 2.0, 3.0], hydrodynamic: [4.0, 5.0, 6.0] };
        assert_eq!(Sensitivities::from_row(sensitivities.row()), Some(sensitivities));
        assert_eq!(Sensitivities::from_row([f64::NAN; 6]), None);
        for (place, (name, value)) in Sensitivities::NAMES.iter().zip(sensitivities.row()).enumerate() {
            let (mu, theta) = (["mu_v", "mu_h"][place / 3], ["alpha", "beta", "f"][place % 3]);
            assert_eq!(*name, format!("d{mu}_dln_{theta}"));
            assert_eq!(value, 1.0 + place as f64);
        }
    }

    #[test]
    fn there_is_no_relative_change_of_nothing() {
        let sensitivities = Sensitivities { viscoelastic: [0.0; 3], hydrodynamic: [2.0, 4.0, 0.0] };
        let [of_v, of_h, of_total] = sensitivities.logarithmic(0.0, 2.0);
        assert!(of_v.iter().all(|value| value.is_nan()));
        assert_eq!((of_h, of_total), ([1.0, 2.0, 0.0], [1.0, 2.0, 0.0]));
    }
}
