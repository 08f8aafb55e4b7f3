//! What a column of the data set is called in a picture.

use stribeck_lab::si_units;
use stribeck_sweep::{Column, Field};

/// A column or a field as pictures show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// In words, with its symbol.
    pub words: &'static str,
    /// Its unit in dimensionless results.
    pub units: &'static str,
}

const FRICTION: &str = "a0/R";
const LENGTH: &str = "a0";
const HEIGHT: &str = "a0^2/R";
const PRESSURE: &str = "2N/(pi a0)";
const NUMBER: &str = "1";

/// A column in words, with its symbol.
const fn words(column: Column) -> &'static str {
    match column {
        Column::MuV => "viscoelastic friction μᵥ",
        Column::MuH => "hydrodynamic friction μₕ",
        Column::MuTot => "total friction μₜₒₜ",
        Column::MuDrag => "drag",
        Column::MuHCavity => "part of μₕ behind the outlet",
        Column::C => "film thickness c where p′ = 0",
        Column::FilmMin => "smallest film thickness uₘᵢₙ",
        Column::PMax => "largest pressure pₘₐₓ",
        Column::XOutlet => "outlet xₒᵤₜ",
        Column::ErrorMuV => "estimated relative error of μᵥ",
        Column::ErrorMuH => "estimated relative error of μₕ",
        Column::ErrorC => "estimated relative error of c",
        Column::LoadResidual => "residual of the load, |load/(π/2) − 1|",
        Column::DryMuV => "dry friction",
        Column::ApproxMuH => "large-β approximation of μₕ",
        Column::XPMax => "place of the largest pressure",
        Column::Centroid => "centroid of the pressure",
        Column::Separation => "separation h₀",
        Column::MuHFilm => "part of μₕ in the film",
        Column::MuPressure => "friction by the pressure gradient, P",
        Column::MuShear => "shear by sliding, C",
        Column::MuVFlat => "viscoelastic friction of the flat",
        Column::MuVRoller => "viscoelastic friction of the roller",
        Column::MuTorque => "torque on the roller over N R",
        Column::EnergyResidual => "residual of the balance of power",
        Column::ErrorMuDrag => "estimated relative error of the drag",
        Column::ErrorMuPressure => "estimated relative error of P",
        Column::ErrorMuShear => "estimated relative error of C",
        Column::ErrorFilmMin => "estimated relative error of uₘᵢₙ",
        Column::ErrorPMax => "estimated relative error of pₘₐₓ",
        Column::Dissipation => "dissipation of the pressure-driven flow",
    }
}

impl From<Column> for Quantity {
    fn from(column: Column) -> Self {
        Self { words: words(column), units: column.units() }
    }
}

impl From<Field> for Quantity {
    fn from(field: Field) -> Self {
        let words = match field {
            Field::Pressure => "pressure p",
            Field::FilmThickness => "film thickness u",
            Field::Displacement => "height of the surface w",
            Field::ShearTraction => "shear on the roller",
            Field::HysteresisTraction => "hysteresis (2/π) p w′",
        };
        Self { words, units: field.units() }
    }
}

impl Quantity {
    /// Two of these columns that cannot share an axis.
    pub fn of_different_units(columns: &[Column]) -> Option<(Column, Column)> {
        columns.iter().find(|other| other.units() != columns[0].units()).map(|other| (columns[0], *other))
    }

    /// What an axis that these columns share is called.
    pub fn common_label(columns: &[Column], si: bool) -> String {
        let first = Self::from(columns[0]);
        let words = match (columns, first.units) {
            ([_], _) => return first.label(si),
            (_, FRICTION) => "friction coefficient",
            (_, HEIGHT) => "height",
            (_, LENGTH) => "position x",
            (_, PRESSURE) => "pressure",
            _ => "relative error",
        };
        Self { words, ..first }.label(si)
    }

    /// Words and unit, for an axis; in SI data sets the SI unit.
    pub fn label(&self, si: bool) -> String {
        let unit = if si { si_units(self.units) } else { self.units };
        let unit = match unit {
            FRICTION => "a₀/R",
            LENGTH => "a₀",
            HEIGHT => "a₀²/R",
            PRESSURE => "2N/(πa₀)",
            other => other,
        };
        if unit == NUMBER { self.words.to_owned() } else { format!("{}  ({unit})", self.words) }
    }
}
