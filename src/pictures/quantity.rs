//! What a column of the data set is called in a picture.

use stribeck_lab::si_units;
use stribeck_solver::COLUMNS;

/// A column or a field as pictures show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Name of the column or field.
    pub column: &'static str,
    /// In words, with its symbol.
    pub words: &'static str,
    /// Its unit in dimensionless results, as [`COLUMNS`] has it.
    pub units: &'static str,
}

const fn quantity(column: &'static str, words: &'static str, units: &'static str) -> Quantity {
    Quantity { column, words, units }
}

const FRICTION: &str = "a0/R";
const LENGTH: &str = "a0";
const HEIGHT: &str = "a0^2/R";
const PRESSURE: &str = "2N/(pi a0)";
const NUMBER: &str = "1";

/// Every column, in the order of [`COLUMNS`].
const QUANTITIES: [Quantity; COLUMNS.len()] = [
    quantity("mu_v", "viscoelastic friction μᵥ", FRICTION),
    quantity("mu_h", "hydrodynamic friction μₕ", FRICTION),
    quantity("mu_tot", "total friction μₜₒₜ", FRICTION),
    quantity("mu_drag", "drag of the cylinder", FRICTION),
    quantity("mu_h_cavity", "part of μₕ behind the outlet", FRICTION),
    quantity("c", "film thickness c where p′ = 0", HEIGHT),
    quantity("film_min", "smallest film thickness uₘᵢₙ", HEIGHT),
    quantity("p_max", "largest pressure pₘₐₓ", PRESSURE),
    quantity("x_outlet", "outlet xₒᵤₜ", LENGTH),
    quantity("error_mu_v", "estimated relative error of μᵥ", NUMBER),
    quantity("error_mu_h", "estimated relative error of μₕ", NUMBER),
    quantity("error_c", "estimated relative error of c", NUMBER),
    quantity("load_residual", "residual of the load, |load/(π/2) − 1|", NUMBER),
    quantity("dry_mu_v", "dry friction", FRICTION),
    quantity("approx_mu_h", "large-β approximation of μₕ", FRICTION),
    quantity("x_p_max", "place of the largest pressure", LENGTH),
    quantity("centroid", "centroid of the pressure", LENGTH),
    quantity("separation", "separation h₀", HEIGHT),
    quantity("mu_h_film", "part of μₕ in the film", FRICTION),
];

/// The fields.
const FIELDS: [Quantity; 3] = [
    quantity("pressure", "pressure p", PRESSURE),
    quantity("film_thickness", "film thickness u", HEIGHT),
    quantity("displacement", "height of the surface w", HEIGHT),
];

impl Quantity {
    /// The quantity of a column; `None` if there is none of this name.
    pub fn of_column(name: &str) -> Option<Self> {
        QUANTITIES.into_iter().find(|quantity| quantity.column == name)
    }

    /// The quantity of a field; `None` if there is none of this name.
    pub fn of_field(name: &str) -> Option<Self> {
        FIELDS.into_iter().find(|quantity| quantity.column == name)
    }

    /// Names of all columns.
    pub fn columns() -> impl Iterator<Item = &'static str> {
        QUANTITIES.iter().map(|quantity| quantity.column)
    }

    /// Two of these columns that cannot share an axis.
    pub fn of_different_units<'a>(columns: &[&'a str]) -> Option<(&'a str, &'a str)> {
        let unit = |column: &str| Self::of_column(column).map(|quantity| quantity.units);
        columns.iter().find(|other| unit(other) != unit(columns[0])).map(|other| (columns[0], *other))
    }

    /// What an axis that these columns share is called.
    pub fn common_label(columns: &[&str], si: bool) -> String {
        let first = Self::of_column(columns[0]).expect("names were checked");
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_is_a_quantity() {
        assert!(Quantity::columns().eq(COLUMNS.iter().map(|column| column.name)));
        assert!(QUANTITIES.iter().zip(&COLUMNS).all(|(quantity, column)| quantity.units == column.units));
    }
}
