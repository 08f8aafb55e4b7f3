//! The columns of results: every number that is stored of a case, declared once.
//!
//! A line of the table below gives a column its name, its unit, its place in `summary.csv`, its description, and the
//! number itself. Stored rows, tables, `results.h5`, pictures, the page and `docs/output.md` all follow this
//! declaration.

use std::ops::{Index, IndexMut};

use stribeck_solver::{Limits, Quantities, RelativeErrors};

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
    /// The solution of a case that converged.
    Quantity(fn(&Quantities) -> f64),
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
columns! {
    MuV, "mu_v", FRICTION, true, "viscoelastic friction coefficient", Quantity(|it| it.friction.viscoelastic);
    MuH, "mu_h", FRICTION, true, "hydrodynamic friction coefficient, cavity included",
        Quantity(|it| it.friction.hydrodynamic());
    MuTot, "mu_tot", FRICTION, true, "total friction coefficient mu_v + mu_h", Quantity(|it| it.friction.total());
    MuDrag, "mu_drag", FRICTION, true, "drag coefficient of the cylinder, by force balance",
        Quantity(|it| it.friction.drag);
    MuHCavity, "mu_h_cavity", FRICTION, true, "part of mu_h behind the outlet",
        Quantity(|it| it.friction.hydrodynamic_cavity);
    C, "c", HEIGHT, true, "film thickness where the pressure gradient is zero", Quantity(|it| it.c);
    FilmMin, "film_min", HEIGHT, true, "smallest film thickness", Quantity(|it| it.film_min);
    PMax, "p_max", PRESSURE, true, "largest pressure", Quantity(|it| it.p_max);
    XOutlet, "x_outlet", LENGTH, true, "outlet, where the film cavitates", Quantity(|it| it.x_outlet);
    ErrorMuV, "error_mu_v", NUMBER, true, "estimated relative error of mu_v", Error(|it| it.mu_v);
    ErrorMuH, "error_mu_h", NUMBER, true, "estimated relative error of mu_h", Error(|it| it.mu_h);
    ErrorC, "error_c", NUMBER, true, "estimated relative error of c", Error(|it| it.c);
    LoadResidual, "load_residual", NUMBER, true, "relative residual of the load balance",
        Quantity(|it| it.load_residual);
    DryMuV, "dry_mu_v", FRICTION, true, "friction coefficient of dry sliding, the limit of mu_v for large beta",
        Limit(|it| it.dry_mu_v);
    ApproxMuH, "approx_mu_h", FRICTION, true, "hydrodynamic friction coefficient of the large-beta approximation",
        Limit(|it| it.approx_mu_h);
    XPMax, "x_p_max", LENGTH, false, "position of the largest pressure", Quantity(|it| it.x_p_max);
    Centroid, "centroid", LENGTH, false, "load-weighted centroid of the pressure", Quantity(|it| it.centroid);
    Separation, "separation", HEIGHT, false, "separation h0 that goes with the displacement",
        Quantity(|it| it.separation);
    MuHFilm, "mu_h_film", FRICTION, false, "part of mu_h in the pressurised film",
        Quantity(|it| it.friction.hydrodynamic_film);
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

    /// The numbers of a case that converged.
    pub fn converged(quantities: &Quantities, errors: &RelativeErrors, limits: &Limits) -> Self {
        Self(Column::DECLARATIONS.map(|column| match column.source {
            Quantity(of) => of(quantities),
            Error(of) => of(errors),
            Limit(of) => of(limits),
        }))
    }

    /// The numbers of a case that failed: its limits alone.
    pub fn failed(limits: &Limits) -> Self {
        Self(Column::DECLARATIONS.map(|column| match column.source {
            Limit(of) => of(limits),
            Quantity(_) | Error(_) => f64::NAN,
        }))
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
    use stribeck_lab::{Experiment, Modulus};
    use stribeck_solver::Friction;

    /// Each number stands under its name, and a failed case has those of the limits alone.
    #[test]
    fn every_number_is_in_its_column() {
        let friction = Friction { viscoelastic: 1.0, hydrodynamic_film: 2.0, hydrodynamic_cavity: 3.0, drag: 4.0 };
        let quantities = Quantities {
            friction,
            c: 5.5,
            film_min: 6.5,
            p_max: 7.0,
            x_p_max: 8.0,
            x_outlet: 9.0,
            centroid: 10.0,
            separation: 11.0,
            load_residual: 12.0,
        };
        let errors = RelativeErrors { mu_v: 13.0, mu_h: 14.0, c: 15.0 };
        let limits = Limits { dry_mu_v: 16.0, approx_mu_h: 17.0 };
        let expected = [
            ("mu_v", 1.0),
            ("mu_h", 5.0),
            ("mu_tot", 6.0),
            ("mu_drag", 4.0),
            ("mu_h_cavity", 3.0),
            ("mu_h_film", 2.0),
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
            ("dry_mu_v", 16.0),
            ("approx_mu_h", 17.0),
        ];
        let (converged, failed) = (Values::converged(&quantities, &errors, &limits), Values::failed(&limits));
        assert_eq!(expected.len(), Column::ALL.len());
        for (name, number) in expected {
            let column = Column::named(name).expect(name);
            assert_eq!(converged[column], number, "{name}");
            assert_eq!(failed.known(column), column.is_limit().then_some(number), "{name}");
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
        assert_eq!(Column::ALL.into_iter().filter_map(Column::error).count(), 3);
        assert_eq!(Column::ALL.into_iter().filter(|column| column.is_error()).count(), 3);
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
            speed: 1e-3,
            f: 10.0,
        };
        for column in Column::ALL {
            let factor = experiment.scales().factor(column.units());
            assert!(factor > 0.0, "{}", stribeck_lab::si_units(column.units()));
        }
    }
}
