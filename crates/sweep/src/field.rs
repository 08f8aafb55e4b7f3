//! The fields of a case: what is stored along x.

use stribeck_solver::{FieldSelection, Fields};

/// A field of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Field {
    /// p(x).
    Pressure,
    /// u(x).
    FilmThickness,
    /// w(x).
    Displacement,
    /// Shear on the roller's surface.
    ShearTraction,
    /// (2/π) p w′.
    HysteresisTraction,
}

impl Field {
    /// What x is, over which fields stand, in words.
    pub const X_LONG_NAME: &'static str = "position along the surface; the inlet is at x > 0";
    /// The unit of x, in laboratory units too.
    pub const X_UNITS: &'static str = "a0";

    /// Every field in the order in which results have them.
    pub const ALL: [Self; 5] =
        [Self::Pressure, Self::FilmThickness, Self::Displacement, Self::ShearTraction, Self::HysteresisTraction];

    /// The name of the field in sweep files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pressure => "pressure",
            Self::FilmThickness => "film_thickness",
            Self::Displacement => "displacement",
            Self::ShearTraction => "shear_traction",
            Self::HysteresisTraction => "hysteresis_traction",
        }
    }

    /// The unit of dimensionless results.
    pub const fn units(self) -> &'static str {
        match self {
            Self::Pressure => "2N/(pi a0)",
            Self::FilmThickness | Self::Displacement => "a0^2/R",
            Self::ShearTraction | Self::HysteresisTraction => "N/R",
        }
    }

    /// What the field is called; behind it stands its [symbol](Self::symbol).
    pub const fn words(self) -> &'static str {
        self.declared().0
    }

    /// The symbol of the field; empty where words do.
    pub const fn symbol(self) -> &'static str {
        self.declared().1
    }

    /// The words with what else is to be said of the field, in ASCII.
    pub const fn long_name(self) -> &'static str {
        self.declared().2
    }

    /// Words, symbol and long name.
    const fn declared(self) -> (&'static str, &'static str, &'static str) {
        macro_rules! declared {
            ($words:literal $symbol:literal $rest:literal) => {
                ($words, $symbol, concat!($words, $rest))
            };
        }
        match self {
            Self::Pressure => declared!("pressure" "p" " in the film"),
            Self::FilmThickness => declared!("film thickness" "u" ""),
            Self::Displacement => declared!("displacement of the surface" "w" ", normal to it"),
            Self::ShearTraction => declared!("shear on the roller" "" "; its integral over x is mu_h"),
            Self::HysteresisTraction => {
                declared!("hysteresis" "(2/π) p w′" ", pressure times slope of the displacement; its integral over x is mu_v")
            }
        }
    }

    /// The field of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.name() == name)
    }

    /// The selected fields, in their order.
    pub fn selected(selection: FieldSelection) -> impl Iterator<Item = Self> + Clone {
        let FieldSelection { pressure, film_thickness, displacement, shear_traction, hysteresis_traction } = selection;
        Self::ALL
            .into_iter()
            .zip([pressure, film_thickness, displacement, shear_traction, hysteresis_traction])
            .filter_map(|(it, chosen)| chosen.then_some(it))
    }

    /// The selection of some fields.
    pub fn selection(fields: impl IntoIterator<Item = Self>) -> FieldSelection {
        let mut selection = FieldSelection::default();
        for field in fields {
            match field {
                Self::Pressure => selection.pressure = true,
                Self::FilmThickness => selection.film_thickness = true,
                Self::Displacement => selection.displacement = true,
                Self::ShearTraction => selection.shear_traction = true,
                Self::HysteresisTraction => selection.hysteresis_traction = true,
            }
        }
        selection
    }

    /// The values of this field of a case; `None` if it has none.
    pub fn of(self, fields: &Fields) -> Option<&[f64]> {
        match self {
            Self::Pressure => fields.pressure.as_deref(),
            Self::FilmThickness => fields.film_thickness.as_deref(),
            Self::Displacement => fields.displacement.as_deref(),
            Self::ShearTraction => fields.shear_traction.as_deref(),
            Self::HysteresisTraction => fields.hysteresis_traction.as_deref(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_selection_comes_back() {
        for bits in 0..32 {
            let selection = FieldSelection {
                pressure: bits & 1 != 0,
                film_thickness: bits & 2 != 0,
                displacement: bits & 4 != 0,
                shear_traction: bits & 8 != 0,
                hysteresis_traction: bits & 16 != 0,
            };
            assert_eq!(Field::selection(Field::selected(selection)), selection);
        }
        assert!(Field::ALL.into_iter().all(|field| Field::named(field.name()) == Some(field)));
    }
}
