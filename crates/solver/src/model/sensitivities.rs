//! How friction changes with the parameters of a case.

/// Derivatives dF/d ln θ of friction forces over N a₀/R with respect to the logarithms of θ = α, β and f, in this order
/// (T49).
///
/// α stands for all modes: their rates change together. f changes at fixed shares. Where a parameter means nothing (α
/// and f of a relaxed elastic substrate, α = 0) the derivative is 0. They are known where one body at most is
/// viscoelastic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// Derivatives of F_v.
    pub viscoelastic: [f64; 3],
    /// Derivatives of F_h, the cavity included.
    pub hydrodynamic: [f64; 3],
    /// Derivatives of P (T53).
    pub pressure: [f64; 3],
}

impl Sensitivities {
    /// The names of the derivatives in the order of [`Sensitivities::row`]: `dmu_v_dln_alpha` is dF_v/d ln α.
    pub const NAMES: [&'static str; 9] = [
        "dmu_v_dln_alpha",
        "dmu_v_dln_beta",
        "dmu_v_dln_f",
        "dmu_h_dln_alpha",
        "dmu_h_dln_beta",
        "dmu_h_dln_f",
        "dmu_pressure_dln_alpha",
        "dmu_pressure_dln_beta",
        "dmu_pressure_dln_f",
    ];

    /// The derivatives in the order of [`Sensitivities::NAMES`].
    pub fn row(&self) -> [f64; 9] {
        let ([a, b, c], [d, e, f], [g, h, i]) = (self.viscoelastic, self.hydrodynamic, self.pressure);
        [a, b, c, d, e, f, g, h, i]
    }

    /// The sensitivities from the values of a row; `None` if one of them is NaN, as in a row without sensitivities.
    pub fn from_row([a, b, c, d, e, f, g, h, i]: [f64; 9]) -> Option<Self> {
        let sensitivities = Self { viscoelastic: [a, b, c], hydrodynamic: [d, e, f], pressure: [g, h, i] };
        sensitivities.row().iter().all(|value| !value.is_nan()).then_some(sensitivities)
    }

    /// Estimated errors, from less accurate ones and what both lack: for each derivative a half of the difference, a
    /// tenth of the largest difference of the same friction, as one may be small by accident, and what is lacking.
    pub(crate) fn errors_beside(&self, rough: &Self, lacking: &Self) -> Self {
        const OWN: f64 = 0.5;
        const SHARED: f64 = 0.1;
        let apart = |a: [f64; 3], b: [f64; 3], lacking: [f64; 3]| {
            let difference: [f64; 3] = std::array::from_fn(|i| (a[i] - b[i]).abs());
            let largest = difference.into_iter().fold(0.0, f64::max);
            std::array::from_fn(|i| OWN * difference[i] + SHARED * largest + lacking[i])
        };
        Self {
            viscoelastic: apart(self.viscoelastic, rough.viscoelastic, lacking.viscoelastic),
            hydrodynamic: apart(self.hydrodynamic, rough.hydrodynamic, lacking.hydrodynamic),
            pressure: apart(self.pressure, rough.pressure, lacking.pressure),
        }
    }

    /// Derivatives of F_v + P + S C at the slide-to-roll ratio S, which is F_tot for S = 1.
    pub fn total_at(&self, slide_roll: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.viscoelastic[i] + self.hydrodynamic_at(slide_roll)[i])
    }

    /// Derivatives of C = F_h − P (T53).
    pub fn shear(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.hydrodynamic[i] - self.pressure[i])
    }

    /// Derivatives of the shear on the roller, P + S C, at the slide-to-roll ratio S.
    pub fn hydrodynamic_at(&self, slide_roll: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.hydrodynamic[i] - (1.0 - slide_roll) * self.shear()[i])
    }

    /// Derivatives of the drag D = F_v − P + S C at the slide-to-roll ratio S, the flat being the soft body (T54).
    pub fn drag_at(&self, slide_roll: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.viscoelastic[i] - self.pressure[i] + slide_roll * self.shear()[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SENSITIVITIES: Sensitivities =
        Sensitivities { viscoelastic: [1.0, 2.0, 3.0], hydrodynamic: [4.0, 5.0, 6.0], pressure: [7.0, 8.0, 9.0] };

    #[test]
    fn a_row_comes_back() {
        assert_eq!(Sensitivities::from_row(SENSITIVITIES.row()), Some(SENSITIVITIES));
        assert_eq!(Sensitivities::from_row([f64::NAN; 9]), None);
        for (place, (name, value)) in Sensitivities::NAMES.iter().zip(SENSITIVITIES.row()).enumerate() {
            let (mu, theta) = (["mu_v", "mu_h", "mu_pressure"][place / 3], ["alpha", "beta", "f"][place % 3]);
            assert_eq!(*name, format!("d{mu}_dln_{theta}"));
            assert_eq!(value, 1.0 + place as f64);
        }
    }

    /// D = F_v + F_h − 2P for a roller that does not turn, and each C more or less for S.
    #[test]
    fn drag_is_made_of_its_parts() {
        for i in 0..3 {
            let [v, h, p] =
                [SENSITIVITIES.viscoelastic, SENSITIVITIES.hydrodynamic, SENSITIVITIES.pressure].map(|row| row[i]);
            assert_eq!(SENSITIVITIES.drag_at(1.0)[i], v + h - 2.0 * p);
            assert_eq!(SENSITIVITIES.drag_at(1.0)[i] - SENSITIVITIES.drag_at(-1.0)[i], 2.0 * SENSITIVITIES.shear()[i]);
            assert_eq!(SENSITIVITIES.hydrodynamic_at(0.0)[i], p);
        }
    }
}
