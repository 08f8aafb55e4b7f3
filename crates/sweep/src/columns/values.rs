//! The numbers of one case, one for each column: of a solution, of a failed case, at another slide-to-roll ratio.

use std::ops::{Index, IndexMut};

use stribeck_solver::{Friction, Limits, Quantities, RelativeErrors};

use super::Column;
use super::Source::{Error, Limit, Quantity};

/// The numbers of a case, one for each [`Column`]; NaN where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values(pub [f64; Column::ALL.len()]);

impl Values {
    /// No number is known.
    pub const UNKNOWN: Self = Self([f64::NAN; Column::ALL.len()]);

    /// The numbers of a case that converged, at the slide-to-roll ratio S = 1.
    pub fn converged(quantities: &Quantities, errors: &RelativeErrors, limits: &Limits) -> Self {
        Self(Column::DECLARATIONS.map(|column| match column.source {
            Quantity(of) => of(quantities, 1.0),
            Error(of) => of(errors),
            Limit(of) => of(limits),
        }))
    }

    /// No numbers at all.
    pub const NONE: Self = Self([f64::NAN; Column::ALL.len()]);

    /// The numbers of a case that failed: its limits alone.
    pub fn failed(limits: &Limits) -> Self {
        Self(Column::DECLARATIONS.map(|column| match column.source {
            Limit(of) => of(limits),
            Quantity(_) | Error(_) => f64::NAN,
        }))
    }

    /// The same case at another slide-to-roll ratio S (T52): pressure, film, P and C stay, and what is made of them
    /// follows. What is known for S = 1 alone, the approximation of μ_h, is left out.
    pub fn at_slide_roll(&self, slide_roll: f64) -> Self {
        if slide_roll == 1.0 {
            return *self;
        }
        let quantities = self.quantities();
        let mut values = *self;
        for column in Column::ALL {
            if let Quantity(of) = column.declaration().source {
                values[column] = of(&quantities, slide_roll);
            }
        }
        // The errors of the parts, at worst, over the new sums.
        let of_pressure = self[Column::ErrorMuPressure] * self[Column::MuPressure].abs();
        let of_shear = of_pressure + self[Column::ErrorMuShear] * (slide_roll * self[Column::MuShear]).abs();
        let of_hysteresis = self[Column::ErrorMuV] * quantities.friction.viscoelastic_error_scale();
        values[Column::ErrorMuH] = of_shear / values[Column::MuH].abs();
        values[Column::ErrorMuDrag] = (of_shear + of_hysteresis) / values[Column::MuDrag].abs();
        values[Column::ApproxMuH] = f64::NAN;
        values
    }

    /// The numbers of the solution, from the values at S = 1.
    fn quantities(&self) -> Quantities {
        let friction = Friction {
            viscoelastic: self[Column::MuV],
            viscoelastic_roller: self[Column::MuVRoller],
            hydrodynamic_film: self[Column::MuHFilm],
            hydrodynamic_cavity: self[Column::MuHCavity],
            pressure: self[Column::MuPressure],
            drag: self[Column::MuDrag],
        };
        Quantities {
            friction,
            c: self[Column::C],
            film_min: self[Column::FilmMin],
            p_max: self[Column::PMax],
            x_p_max: self[Column::XPMax],
            x_outlet: self[Column::XOutlet],
            centroid: self[Column::Centroid],
            dissipation: self[Column::Dissipation],
            separation: self[Column::Separation],
            load_residual: self[Column::LoadResidual],
        }
    }

    /// The number in a column; `None` if there is none.
    pub fn known(&self, column: Column) -> Option<f64> {
        Some(self[column]).filter(|value| !value.is_nan())
    }

    /// Every column with its number.
    pub fn iter(&self) -> impl Iterator<Item = (Column, f64)> {
        Column::ALL.into_iter().zip(self.0)
    }
}

impl Index<Column> for Values {
    type Output = f64;

    fn index(&self, column: Column) -> &f64 {
        &self.0[column as usize]
    }
}

impl IndexMut<Column> for Values {
    fn index_mut(&mut self, column: Column) -> &mut f64 {
        &mut self.0[column as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quantities() -> Quantities {
        let friction = Friction {
            viscoelastic: 1.0,
            viscoelastic_roller: 0.25,
            hydrodynamic_film: 2.0,
            hydrodynamic_cavity: 3.0,
            pressure: -0.5,
            drag: 6.75,
        };
        Quantities {
            friction,
            c: 5.5,
            film_min: 6.5,
            p_max: 7.0,
            x_p_max: 8.0,
            x_outlet: 9.0,
            centroid: 10.0,
            dissipation: 0.5,
            separation: 11.0,
            load_residual: 12.0,
        }
    }

    const ERRORS: RelativeErrors = RelativeErrors {
        mu_v: 13.0,
        mu_h: 14.0,
        c: 15.0,
        drag: 18.0,
        pressure: 19.0,
        shear: 20.0,
        film_min: 21.0,
        p_max: 22.0,
    };

    /// Each number stands under its name, and a failed case has those of the limits alone.
    #[test]
    fn every_number_is_in_its_column() {
        let limits = Limits { dry_mu_v: 16.0, approx_mu_h: 17.0 };
        let expected = [
            ("mu_v", 1.0),
            ("mu_h", 5.0),
            ("mu_tot", 6.0),
            ("mu_drag", 6.75),
            ("mu_h_cavity", 3.0),
            ("mu_h_film", 2.0),
            ("mu_pressure", -0.5),
            ("mu_shear", 5.5),
            ("mu_v_flat", 0.75),
            ("mu_v_roller", 0.25),
            ("mu_torque", 4.75),
            ("energy_residual", 0.0),
            ("dissipation", 0.5),
            ("c", 5.5),
            ("film_min", 6.5),
            ("p_max", 7.0),
            ("x_p_max", 8.0),
            ("x_outlet", 9.0),
            ("centroid", 10.0),
            ("separation", 11.0),
            ("load_residual", 12.0),
            ("error_mu_v", 13.0),
            ("error_mu_h", 14.0),
            ("error_c", 15.0),
            ("error_mu_drag", 18.0),
            ("error_mu_pressure", 19.0),
            ("error_mu_shear", 20.0),
            ("error_film_min", 21.0),
            ("error_p_max", 22.0),
            ("dry_mu_v", 16.0),
            ("approx_mu_h", 17.0),
        ];
        let (converged, failed) = (Values::converged(&quantities(), &ERRORS, &limits), Values::failed(&limits));
        assert_eq!(expected.len(), Column::ALL.len());
        for (name, number) in expected {
            let column = Column::named(name).expect(name);
            assert_eq!(converged[column], number, "{name}");
            assert_eq!(failed.known(column), column.is_limit().then_some(number), "{name}");
        }
    }

    /// Rolling takes C away from what it stands in, and nothing else changes.
    #[test]
    fn another_ratio_changes_what_it_must() {
        let limits = Limits { dry_mu_v: 16.0, approx_mu_h: 17.0 };
        let sliding = Values::converged(&quantities(), &ERRORS, &limits);
        assert_eq!(sliding.at_slide_roll(1.0), sliding);
        let rolling = sliding.at_slide_roll(0.0);
        let changed = [
            (Column::MuH, -0.5),
            (Column::MuTot, 0.5),
            (Column::MuDrag, 1.25),
            (Column::MuHCavity, 0.0),
            (Column::MuHFilm, -0.5),
            (Column::MuTorque, -0.75),
            (Column::ErrorMuH, 19.0),
            (Column::ErrorMuDrag, (9.5 + 13.0) / 1.25),
        ];
        for (column, value) in changed {
            assert_eq!(rolling[column], value, "{}", column.name());
        }
        assert!(rolling[Column::ApproxMuH].is_nan() && rolling[Column::EnergyResidual].is_finite());
        let others = Column::ALL.into_iter().filter(|column| {
            !changed.iter().any(|(known, _)| known == column)
                && ![Column::ApproxMuH, Column::EnergyResidual].contains(column)
        });
        for column in others {
            assert_eq!(rolling[column], sliding[column], "{}", column.name());
        }
    }
}
