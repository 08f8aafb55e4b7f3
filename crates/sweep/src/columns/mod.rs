//! The columns of results: every number that is stored of a case, declared once.
//!
//! A line of the table below gives a column its name, its words with their symbol and what else is to be said of it, its
//! unit, its place in `summary.csv`, and the number itself. Stored rows, tables, `results.h5`, pictures, the page and
//! `docs/reference/columns.md` all follow this declaration.

use stribeck_solver::{Limits, Quantities, RelativeErrors};

mod values;

pub use values::Values;

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
    words: &'static str,
    symbol: &'static str,
    long_name: &'static str,
    units: &'static str,
    in_summary: bool,
    source: Source,
}

/// Makes the enum of columns from its declaration.
macro_rules! columns {
    ($($column:ident, $name:literal, $words:literal $symbol:literal $rest:literal, $units:ident, $in_summary:literal,
        $source:expr;)*) => {
        /// A number that is stored of each case.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Column {
            $(#[doc = concat!("`", $name, "`: ", $words, $rest, ".")] $column,)*
        }

        impl Column {
            /// Every column in the order in which results have them.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$column),*];

            const DECLARATIONS: [Declaration; Self::ALL.len()] = [$(Declaration {
                name: $name,
                words: $words,
                symbol: $symbol,
                long_name: concat!($words, $rest),
                units: $units,
                in_summary: $in_summary,
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
    MuV, "mu_v", "viscoelastic friction" "μᵥ" "", FRICTION, true, Quantity(|it, _| it.friction.viscoelastic);
    MuH, "mu_h", "hydrodynamic friction" "μₕ" ", cavity included", FRICTION, true,
        Quantity(|it, s| it.friction.hydrodynamic_at(s));
    MuTot, "mu_tot", "total friction" "μₜₒₜ" " mu_v + mu_h", FRICTION, true, Quantity(|it, s| it.friction.total_at(s));
    MuDrag, "mu_drag", "drag" "μ_{drag}" " of the cylinder, by force balance", FRICTION, true,
        Quantity(|it, s| it.friction.drag_at(s));
    MuHCavity, "mu_h_cavity", "hydrodynamic friction behind the outlet" "μ_{h,cavity}" "", FRICTION, true,
        Quantity(|it, s| it.friction.hydrodynamic_cavity * s);
    C, "c", "film thickness at zero pressure gradient" "c" "", HEIGHT, true, Quantity(|it, _| it.c);
    FilmMin, "film_min", "smallest film thickness" "uₘᵢₙ" "", HEIGHT, true, Quantity(|it, _| it.film_min);
    PMax, "p_max", "largest pressure" "pₘₐₓ" "", PRESSURE, true, Quantity(|it, _| it.p_max);
    XOutlet, "x_outlet", "outlet" "xₒᵤₜ" ", where the film cavitates", LENGTH, true, Quantity(|it, _| it.x_outlet);
    ErrorMuV, "error_mu_v", "estimated relative error of" "μᵥ" " mu_v", NUMBER, true, Error(|it| it.mu_v);
    ErrorMuH, "error_mu_h", "estimated relative error of" "μₕ" " mu_h", NUMBER, true, Error(|it| it.mu_h);
    ErrorC, "error_c", "estimated relative error of" "c" " c", NUMBER, true, Error(|it| it.c);
    LoadResidual, "load_residual", "relative residual of the load balance" "" "", NUMBER, true,
        Quantity(|it, _| it.load_residual);
    DryMuV, "dry_mu_v", "dry friction" "" ", the limit of mu_v for large beta", FRICTION, true, Limit(|it| it.dry_mu_v);
    ApproxMuH, "approx_mu_h", "large-beta approximation of" "μₕ" " mu_h", FRICTION, true, Limit(|it| it.approx_mu_h);
    XPMax, "x_p_max", "position of the largest pressure" "" "", LENGTH, false, Quantity(|it, _| it.x_p_max);
    Centroid, "centroid", "centroid of the pressure" "" "", LENGTH, false, Quantity(|it, _| it.centroid);
    Separation, "separation", "separation" "h₀" " h0 that goes with the displacement", HEIGHT, false,
        Quantity(|it, _| it.separation);
    MuHFilm, "mu_h_film", "hydrodynamic friction in the film" "μ_{h,film}" "", FRICTION, false, Quantity(film_shear);
    MuPressure, "mu_pressure", "friction by pressure flow" "μ_{pressure}" ", a part of mu_h", FRICTION, true,
        Quantity(|it, _| it.friction.pressure);
    MuShear, "mu_shear", "friction by sliding shear" "μ_{shear}" ", a part of mu_h, for pure sliding", FRICTION, true,
        Quantity(|it, _| it.friction.shear());
    MuVFlat, "mu_v_flat", "viscoelastic friction of the flat" "μ_{v,flat}" "", FRICTION, true,
        Quantity(|it, _| it.friction.viscoelastic_flat());
    MuVRoller, "mu_v_roller", "viscoelastic friction of the roller" "μ_{v,roller}" "", FRICTION, true,
        Quantity(|it, _| it.friction.viscoelastic_roller);
    MuTorque, "mu_torque", "torque on the roller over N R" "μ_{torque}" ", load times radius", FRICTION, true,
        Quantity(|it, s| it.friction.torque_at(s));
    EnergyResidual, "energy_residual", "residual of the balance of power" "" " over the power dissipated", NUMBER, true,
        Quantity(Quantities::energy_residual);
    ErrorMuDrag, "error_mu_drag", "estimated relative error of" "μ_{drag}" " mu_drag", NUMBER, true,
        Error(|it| it.drag);
    ErrorMuPressure, "error_mu_pressure", "estimated relative error of" "μ_{pressure}" " mu_pressure", NUMBER, false,
        Error(|it| it.pressure);
    ErrorMuShear, "error_mu_shear", "estimated relative error of" "μ_{shear}" " mu_shear", NUMBER, false,
        Error(|it| it.shear);
    Dissipation, "dissipation", "dissipation of the pressure-driven flow" "" ", a power over load and speed", FRICTION, false,
        Quantity(|it, _| it.dissipation);
    ErrorFilmMin, "error_film_min", "estimated relative error of" "uₘᵢₙ" " film_min", NUMBER, false,
        Error(|it| it.film_min);
    ErrorPMax, "error_p_max", "estimated relative error of" "pₘₐₓ" " p_max", NUMBER, false, Error(|it| it.p_max);
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

    /// What the number is called; behind it stands its [symbol](Self::symbol).
    pub const fn words(self) -> &'static str {
        self.declaration().words
    }

    /// The symbol of the number, of an estimated error that of its column; empty where words do. Subscripts that Unicode
    /// lacks stand in `_{…}`.
    pub const fn symbol(self) -> &'static str {
        self.declaration().symbol
    }

    /// The words with what else is to be said of the number, in ASCII.
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

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use stribeck_lab::{Experiment, Modulus, Motion, Roller};

    /// What results say of a number begins with what pictures call it, and any terminal can write it.
    #[test]
    fn a_number_has_one_name_everywhere() {
        for column in Column::ALL {
            assert!(column.long_name().is_ascii() && column.long_name().starts_with(column.words()), "{column:?}");
        }
        for field in crate::Field::ALL {
            assert!(field.long_name().is_ascii() && field.long_name().starts_with(field.words()), "{field:?}");
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
