//! The columns of results: every number that is stored of a case, declared once.
//!
//! A line of the table below gives a column its name, its unit, its place in `summary.csv`, its description, and the
//! number itself. Stored rows, tables, `results.h5`, pictures, the page and `docs/reference/columns.md` all follow this
//! declaration.

use std::ops::{Index, IndexMut};

use stribeck_solver::{Friction, Limits, Quantities, RelativeErrors};

/// The unit of friction coefficients.
const FRICTION: &str = "a0/R";
/// The unit of positions.
const LENGTH: &str = "a0";
/// The unit of film thickness and displacement.
const HEIGHT: &str = "a0^2/R";
/// The unit of pressures.
const PRESSURE: &str = "2N/(pi a0)";
/// The unit of pure numbers.
const NUMBER: &str = "1";

/// Where the number of a column comes from.
enum Source {
    /// The solution of a case that converged, at a slide-to-roll ratio.
    Quantity(fn(&Quantities, f64) -> f64),
    /// The estimated errors of that solution.
    Error(fn(&RelativeErrors) -> f64),
    /// The limits beside a solution, which are known of failed cases too.
    Limit(fn(&Limits) -> f64),
}

/// What is declared of a column.
struct Declaration {
    name: &'static str,
    units: &'static str,
    in_summary: bool,
    long_name: &'static str,
    source: Source,
}

/// Makes the enum of columns from its declaration.
macro_rules! columns {
    ($($column:ident, $name:literal, $units:ident, $in_summary:literal, $long_name:literal, $source:expr;)*) => {
        /// A number that is stored of each case.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Column {
            $(#[doc = concat!("`", $name, "`: ", $long_name, ".")] $column,)*
        }

        impl Column {
            /// Every column in the order in which results have them.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$column),*];

            const DECLARATIONS: [Declaration; Self::ALL.len()] = [$(Declaration {
                name: $name,
                units: $units,
                in_summary: $in_summary,
                long_name: $long_name,
                source: $source,
            }),*];
        }
    };
}

use Source::{Error, Limit, Quantity};
/// Shear on the roller in the pressurised film.
fn film_shear(quantities: &Quantities, slide_roll: f64) -> f64 {
    let friction = &quantities.friction;
    friction.hydrodynamic_film - (1.0 - slide_roll) * (friction.hydrodynamic_film - friction.pressure)
}

columns! {
    MuV, "mu_v", FRICTION, true, "viscoelastic friction coefficient", Quantity(|it, _| it.friction.viscoelastic);
    MuH, "mu_h", FRICTION, true, "hydrodynamic friction coefficient, cavity included",
        Quantity(|it, s| it.friction.hydrodynamic_at(s));
    MuTot, "mu_tot", FRICTION, true, "total friction coefficient mu_v + mu_h", Quantity(|it, s| it.friction.total_at(s));
    MuDrag, "mu_drag", FRICTION, true, "drag coefficient of the cylinder, by force balance",
        Quantity(|it, s| it.friction.drag_at(s));
    MuHCavity, "mu_h_cavity", FRICTION, true, "part of mu_h behind the outlet",
        Quantity(|it, s| it.friction.hydrodynamic_cavity * s);
    C, "c", HEIGHT, true, "film thickness where the pressure gradient is zero", Quantity(|it, _| it.c);
    FilmMin, "film_min", HEIGHT, true, "smallest film thickness", Quantity(|it, _| it.film_min);
    PMax, "p_max", PRESSURE, true, "largest pressure", Quantity(|it, _| it.p_max);
    XOutlet, "x_outlet", LENGTH, true, "outlet, where the film cavitates", Quantity(|it, _| it.x_outlet);
    ErrorMuV, "error_mu_v", NUMBER, true, "estimated relative error of mu_v", Error(|it| it.mu_v);
    ErrorMuH, "error_mu_h", NUMBER, true, "estimated relative error of mu_h", Error(|it| it.mu_h);
    ErrorC, "error_c", NUMBER, true, "estimated relative error of c", Error(|it| it.c);
    LoadResidual, "load_residual", NUMBER, true, "relative residual of the load balance",
        Quantity(|it, _| it.load_residual);
    DryMuV, "dry_mu_v", FRICTION, true, "friction coefficient of dry sliding, the limit of mu_v for large beta",
        Limit(|it| it.dry_mu_v);
    ApproxMuH, "approx_mu_h", FRICTION, true, "hydrodynamic friction coefficient of the large-beta approximation",
        Limit(|it| it.approx_mu_h);
    XPMax, "x_p_max", LENGTH, false, "position of the largest pressure", Quantity(|it, _| it.x_p_max);
    Centroid, "centroid", LENGTH, false, "load-weighted centroid of the pressure", Quantity(|it, _| it.centroid);
    Separation, "separation", HEIGHT, false, "separation h0 that goes with the displacement",
        Quantity(|it, _| it.separation);
    MuHFilm, "mu_h_film", FRICTION, false, "part of mu_h in the pressurised film", Quantity(film_shear);
    MuPressure, "mu_pressure", FRICTION, true, "part of mu_h by the pressure gradient",
        Quantity(|it, _| it.friction.pressure);
    MuShear, "mu_shear", FRICTION, true, "part of mu_h by the difference of the speeds, for pure sliding",
        Quantity(|it, _| it.friction.shear());
    MuVFlat, "mu_v_flat", FRICTION, true, "viscoelastic friction coefficient of the flat",
        Quantity(|it, _| it.friction.viscoelastic_flat());
    MuVRoller, "mu_v_roller", FRICTION, true, "viscoelastic friction coefficient of the roller",
        Quantity(|it, _| it.friction.viscoelastic_roller);
    MuTorque, "mu_torque", FRICTION, true, "torque on the roller about its axis, over load and radius",
        Quantity(|it, s| it.friction.torque_at(s));
    EnergyResidual, "energy_residual", NUMBER, true, "residual of the balance of power over the power dissipated",
        Quantity(Quantities::energy_residual);
    ErrorMuDrag, "error_mu_drag", NUMBER, true, "estimated relative error of mu_drag", Error(|it| it.drag);
    ErrorMuPressure, "error_mu_pressure", NUMBER, false, "estimated relative error of mu_pressure",
        Error(|it| it.pressure);
    ErrorMuShear, "error_mu_shear", NUMBER, false, "estimated relative error of mu_shear", Error(|it| it.shear);
    Dissipation, "dissipation", FRICTION, false, "power that the pressure-driven flow dissipates, over load and speed",
        Quantity(|it, _| it.dissipation);
    ErrorFilmMin, "error_film_min", NUMBER, false, "estimated relative error of film_min", Error(|it| it.film_min);
    ErrorPMax, "error_p_max", NUMBER, false, "estimated relative error of p_max", Error(|it| it.p_max);
}

impl Column {
    const fn declaration(self) -> &'static Declaration {
        &Self::DECLARATIONS[self as usize]
    }

    /// The name of the column, and of the variable of `results.h5`.
    pub const fn name(self) -> &'static str {
        self.declaration().name
    }

    /// The unit of dimensionless results: `1` for pure numbers, otherwise the scale that the number is over.
    pub const fn units(self) -> &'static str {
        self.declaration().units
    }

    /// What the number is, in words.
    pub const fn long_name(self) -> &'static str {
        self.declaration().long_name
    }

    /// True if `summary.csv` has the column.
    pub const fn in_summary(self) -> bool {
        self.declaration().in_summary
    }

    /// True for limits beside the solution, which a sweep may leave out.
    pub const fn is_limit(self) -> bool {
        matches!(self.declaration().source, Limit(_))
    }

    /// True for estimated errors of other columns.
    pub const fn is_error(self) -> bool {
        matches!(self.declaration().source, Error(_))
    }

    /// The estimated relative error of this column; `None` if no error is estimated for it.
    pub const fn error(self) -> Option<Self> {
        match self {
            Self::MuV => Some(Self::ErrorMuV),
            Self::MuH => Some(Self::ErrorMuH),
            Self::C => Some(Self::ErrorC),
            Self::MuDrag => Some(Self::ErrorMuDrag),
            Self::MuPressure => Some(Self::ErrorMuPressure),
            Self::MuShear => Some(Self::ErrorMuShear),
            Self::FilmMin => Some(Self::ErrorFilmMin),
            Self::PMax => Some(Self::ErrorPMax),
            _ => None,
        }
    }

    /// The limit for large β of this column; `None` if no limit is stored for it.
    pub const fn limit(self) -> Option<Self> {
        match self {
            Self::MuV => Some(Self::DryMuV),
            Self::MuH => Some(Self::ApproxMuH),
            _ => None,
        }
    }

    /// The column of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|column| column.name() == name)
    }

    /// The columns of `summary.csv`, in their order.
    pub fn summary() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|column| column.in_summary())
    }
}

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
    use std::collections::HashSet;

    use super::*;
    use stribeck_lab::{Experiment, Modulus, Motion, Roller};
    use stribeck_solver::Friction;

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

    #[test]
    fn names_are_different_and_errors_are_those_of_their_columns() {
        assert_eq!(Column::ALL.map(Column::name).into_iter().collect::<HashSet<_>>().len(), Column::ALL.len());
        assert!(Column::ALL.iter().enumerate().all(|(place, column)| *column as usize == place));
        for column in Column::ALL {
            if let Some(error) = column.error() {
                assert_eq!(error.name(), format!("error_{}", column.name()));
            }
            assert!(column.limit().is_none_or(Column::is_limit));
        }
        assert_eq!(Column::ALL.into_iter().filter_map(Column::error).count(), 8);
        assert_eq!(Column::ALL.into_iter().filter(|column| column.is_error()).count(), 8);
    }

    #[test]
    fn every_column_has_a_unit_in_si() {
        let experiment = Experiment {
            radius: 2e-3,
            load: 119.0,
            modulus: Modulus::Relaxed(1e5),
            poisson_ratio: 0.0,
            viscosity: 5.1,
            retardation_time: 0.1,
            motion: Motion::Sliding { speed: 1e-3 },
            f: 10.0,
            roller: Roller::RIGID,
            temperature: None,
        };
        for column in Column::ALL {
            let factor = experiment.scales().factor(column.units());
            assert!(factor > 0.0, "{}", stribeck_lab::si_units(column.units()));
        }
    }
}
