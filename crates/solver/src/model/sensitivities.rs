//! How friction changes with the parameters of a case.

/// Derivatives dF/d ln θ of friction forces over N a₀/R with respect to the logarithms of five parameters θ, in the order
/// of [`Sensitivities::PARAMETERS`] (T49).
///
/// Each body has its own α and f. α stands for all modes of the body: their rates change together, as they do with the
/// body's speed and times. f is the body's part of f, f_i = Σ_j f_ij (T59), with fixed shares of its modes. Those of
/// the case move both bodies together: [`Sensitivities::of_case`]. Where a parameter means nothing (α and f of a body
/// that is relaxed, α = 0) the derivative is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivities {
    /// Derivatives of F_v,2, the flat's part of F_v (T53).
    pub viscoelastic_flat: [f64; 5],
    /// Derivatives of F_v,1, the roller's part of it.
    pub viscoelastic_roller: [f64; 5],
    /// Derivatives of F_h, the cavity included.
    pub hydrodynamic: [f64; 5],
    /// Derivatives of P (T53).
    pub pressure: [f64; 5],
}

impl Sensitivities {
    /// The parameters of the derivatives: α and f of the flat, β, α and f of the roller.
    pub const PARAMETERS: [&'static str; 5] = ["alpha", "beta", "f", "roller_alpha", "roller_f"];

    /// The names of the derivatives of a case, in the order of [`Sensitivities::named`]: `dmu_v_dln_alpha` is
    /// dF_v/d ln α.
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

    /// The derivatives with respect to α, β and f of the case, which move those of both bodies.
    pub fn of_case([alpha, beta, f, roller_alpha, roller_f]: [f64; 5]) -> [f64; 3] {
        [alpha + roller_alpha, beta, f + roller_f]
    }

    /// The derivatives in the order of [`Sensitivities::NAMES`].
    pub fn named(&self) -> [f64; 9] {
        let forces = [self.viscoelastic(), self.hydrodynamic, self.pressure].map(Self::of_case);
        std::array::from_fn(|i| forces[i / 3][i % 3])
    }

    /// All numbers: first those that a rigid roller leaves, F_v,2, F_h and P by α, β and f of the flat; then by α and f
    /// of the roller; then F_v,1.
    pub fn row(&self) -> [f64; 20] {
        let forces = [self.viscoelastic_flat, self.hydrodynamic, self.pressure];
        std::array::from_fn(|i| match i {
            ..Self::OF_FLAT => forces[i / 3][i % 3],
            Self::OF_FLAT..15 => forces[(i - 9) / 2][3 + (i - 9) % 2],
            _ => self.viscoelastic_roller[i - 15],
        })
    }

    /// How many numbers of a row there are under a rigid roller; the others are 0.
    pub const OF_FLAT: usize = 9;

    /// The sensitivities from the values of a row; `None` if one of them is NaN, as in a row without sensitivities.
    pub fn from_row(row: [f64; 20]) -> Option<Self> {
        let force = |i: usize| [row[3 * i], row[3 * i + 1], row[3 * i + 2], row[9 + 2 * i], row[10 + 2 * i]];
        let sensitivities = Self {
            viscoelastic_flat: force(0),
            viscoelastic_roller: std::array::from_fn(|i| row[15 + i]),
            hydrodynamic: force(1),
            pressure: force(2),
        };
        row.iter().all(|value| !value.is_nan()).then_some(sensitivities)
    }

    /// Those with respect to a number with a power of which both parts of f change; α and β stay.
    pub fn with_power_of_strength(&self, power: f64) -> Self {
        let changed = |[alpha, beta, f, roller_alpha, roller_f]: [f64; 5]| {
            [alpha, beta, power * f, roller_alpha, power * roller_f]
        };
        Self {
            viscoelastic_flat: changed(self.viscoelastic_flat),
            viscoelastic_roller: changed(self.viscoelastic_roller),
            hydrodynamic: changed(self.hydrodynamic),
            pressure: changed(self.pressure),
        }
    }

    /// Estimated errors, from less accurate ones and what both lack: for each derivative a half of the difference, a
    /// tenth of the largest difference of the same friction, as one may be small by accident, and what is lacking.
    pub(crate) fn errors_beside(&self, rough: &Self, lacking: &Self) -> Self {
        const OWN: f64 = 0.5;
        const SHARED: f64 = 0.1;
        let apart = |a: [f64; 5], b: [f64; 5], lacking: [f64; 5]| {
            let difference: [f64; 5] = std::array::from_fn(|i| (a[i] - b[i]).abs());
            let largest = difference.into_iter().fold(0.0, f64::max);
            let mut errors = std::array::from_fn(|i| OWN * difference[i] + SHARED * largest + lacking[i]);
            // those of a body that is not there are 0 for certain
            for (flat, roller) in [(0, 3), (2, 4)] {
                if a[roller] == 0.0 {
                    errors[roller] = 0.0;
                } else if a[flat] == 0.0 {
                    errors[flat] = 0.0;
                }
            }
            errors
        };
        Self {
            viscoelastic_flat: apart(self.viscoelastic_flat, rough.viscoelastic_flat, lacking.viscoelastic_flat),
            viscoelastic_roller: apart(
                self.viscoelastic_roller,
                rough.viscoelastic_roller,
                lacking.viscoelastic_roller,
            ),
            hydrodynamic: apart(self.hydrodynamic, rough.hydrodynamic, lacking.hydrodynamic),
            pressure: apart(self.pressure, rough.pressure, lacking.pressure),
        }
    }

    /// Derivatives of F_v, of both bodies.
    pub fn viscoelastic(&self) -> [f64; 5] {
        std::array::from_fn(|i| self.viscoelastic_flat[i] + self.viscoelastic_roller[i])
    }

    /// Derivatives of F_v + P + S C at the slide-to-roll ratio S, which is F_tot for S = 1.
    pub fn total_at(&self, slide_roll: f64) -> [f64; 5] {
        std::array::from_fn(|i| self.viscoelastic()[i] + self.hydrodynamic_at(slide_roll)[i])
    }

    /// Derivatives of C = F_h − P (T53).
    pub fn shear(&self) -> [f64; 5] {
        std::array::from_fn(|i| self.hydrodynamic[i] - self.pressure[i])
    }

    /// Derivatives of the shear on the roller, P + S C, at the slide-to-roll ratio S.
    pub fn hydrodynamic_at(&self, slide_roll: f64) -> [f64; 5] {
        std::array::from_fn(|i| self.hydrodynamic[i] - (1.0 - slide_roll) * self.shear()[i])
    }

    /// Derivatives of the drag D = F_v,2 − P + S C at the slide-to-roll ratio S (T54).
    pub fn drag_at(&self, slide_roll: f64) -> [f64; 5] {
        std::array::from_fn(|i| self.viscoelastic_flat[i] - self.pressure[i] + slide_roll * self.shear()[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SENSITIVITIES: Sensitivities = Sensitivities {
        viscoelastic_flat: [1.0, 2.0, 3.0, 10.0, 11.0],
        viscoelastic_roller: [16.0, 17.0, 18.0, 19.0, 20.0],
        hydrodynamic: [4.0, 5.0, 6.0, 12.0, 13.0],
        pressure: [7.0, 8.0, 9.0, 14.0, 15.0],
    };

    #[test]
    fn a_row_comes_back() {
        let row: [f64; 20] = std::array::from_fn(|place| 1.0 + place as f64);
        assert_eq!(SENSITIVITIES.row(), row);
        assert_eq!(Sensitivities::from_row(row), Some(SENSITIVITIES));
        assert_eq!(Sensitivities::from_row([f64::NAN; 20]), None);
    }

    /// α and f of a case are those of both bodies, and its F_v is that of both.
    #[test]
    fn a_case_has_the_derivatives_of_both_bodies() {
        let expected = [46.0, 19.0, 52.0, 16.0, 5.0, 19.0, 21.0, 8.0, 24.0];
        assert_eq!(SENSITIVITIES.named(), expected);
        for (place, name) in Sensitivities::NAMES.iter().enumerate() {
            let (mu, theta) = (["mu_v", "mu_h", "mu_pressure"][place / 3], Sensitivities::PARAMETERS[place % 3]);
            assert_eq!(*name, format!("d{mu}_dln_{theta}"));
        }
    }

    /// D = F_v,2 + F_h − 2P for a roller that does not turn, and each C more or less for S.
    #[test]
    fn drag_is_made_of_its_parts() {
        for i in 0..5 {
            let [v, h, p] =
                [SENSITIVITIES.viscoelastic_flat, SENSITIVITIES.hydrodynamic, SENSITIVITIES.pressure].map(|row| row[i]);
            assert_eq!(SENSITIVITIES.drag_at(1.0)[i], v + h - 2.0 * p);
            assert_eq!(SENSITIVITIES.drag_at(1.0)[i] - SENSITIVITIES.drag_at(-1.0)[i], 2.0 * SENSITIVITIES.shear()[i]);
            assert_eq!(SENSITIVITIES.hydrodynamic_at(0.0)[i], p);
        }
    }

    /// A body that is not there has no errors, whatever the others have.
    #[test]
    fn what_is_not_there_has_no_error() {
        let rough = Sensitivities { hydrodynamic: [4.5, 5.0, 6.0, 12.5, 13.0], ..SENSITIVITIES };
        let lacking = Sensitivities { hydrodynamic: [1e-3; 5], ..SENSITIVITIES };
        let errors = |hydrodynamic: [f64; 5]| {
            let rough = Sensitivities { hydrodynamic: hydrodynamic.map(|it| 1.1 * it), ..rough };
            Sensitivities { hydrodynamic, ..SENSITIVITIES }.errors_beside(&rough, &lacking).hydrodynamic
        };
        assert!(errors([1.0; 5]).iter().all(|error| *error > 0.0));
        assert_eq!(errors([1.0, 1.0, 1.0, 0.0, 0.0])[3..], [0.0; 2]);
        let of_roller = errors([0.0, 1.0, 0.0, 1.0, 1.0]);
        assert!([of_roller[0], of_roller[2]] == [0.0; 2] && of_roller[3] > 0.0);
    }
}
