//! What a column of the data set is called in a picture.

use super::engineering::ShownUnit;
use stribeck_lab::si_units;
use stribeck_sweep::store::{AVERAGES, Average, DataSet, StoreError};
use stribeck_sweep::{Column, Field};

/// A column or a field as pictures show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Name of the column, and of the variable of the data set.
    pub name: &'static str,
    /// What it is.
    words: &'static str,
    /// Its symbol, the one of its column; empty where words do.
    symbol: &'static str,
    /// Its unit in dimensionless results.
    pub units: &'static str,
    /// The column, if each sweep has it.
    pub column: Option<Column>,
}

const FRICTION: &str = "a0/R";
const LENGTH: &str = "a0";
const HEIGHT: &str = "a0^2/R";
const PRESSURE: &str = "2N/(pi a0)";

impl From<Column> for Quantity {
    fn from(column: Column) -> Self {
        let (words, symbol) = (column.words(), column.symbol());
        Self { name: column.name(), words, symbol, units: column.units(), column: Some(column) }
    }
}

impl From<Field> for Quantity {
    fn from(field: Field) -> Self {
        let (words, symbol) = (field.words(), field.symbol());
        Self { name: field.name(), words, symbol, units: field.units(), column: None }
    }
}

impl From<Average> for Quantity {
    fn from(Average { name, words, symbol, .. }: Average) -> Self {
        Self { name, words, symbol, units: FRICTION, column: None }
    }
}

impl Quantity {
    /// The columns of a data set.
    pub fn all(data: &DataSet) -> impl Iterator<Item = Self> {
        let averages = AVERAGES.into_iter().filter(|_| data.is_swapped).map(Self::from);
        Column::ALL.into_iter().map(Self::from).chain(averages)
    }

    /// Its values at all places.
    ///
    /// # Errors
    /// [`StoreError`] if they cannot be read.
    pub fn values(&self, data: &DataSet) -> Result<Vec<f64>, StoreError> {
        match self.column {
            Some(column) => data.column(column),
            None => data.variable(self.name),
        }
    }

    /// Its symbol; empty where there is none.
    pub fn symbol(&self) -> &'static str {
        self.symbol
    }

    /// Words and symbol.
    pub fn title(&self) -> String {
        format!("{} {}", self.words, self.symbol).trim_end().to_owned()
    }

    /// The same as plain text, where no subscript can be set: "drag μ_drag".
    pub fn plain(&self) -> String {
        self.title().replace("_{", "_").replace('}', "")
    }

    /// Words and the name of the column, where no symbol can be written.
    pub fn plain_title(&self) -> String {
        format!("{} ({})", self.words, self.name)
    }

    /// Two of these columns that cannot share an axis.
    pub fn of_different_units(columns: &[Self]) -> Option<(Self, Self)> {
        columns.iter().find(|other| other.units != columns[0].units).map(|other| (columns[0], *other))
    }

    /// What an axis that these columns share is called, without its unit.
    pub fn common_title(columns: &[Self]) -> String {
        let words = match (columns, columns[0].units) {
            ([only], _) => return only.title(),
            (_, FRICTION) => "friction coefficient μ",
            (_, HEIGHT) => "height",
            (_, LENGTH) => "position x",
            (_, PRESSURE) => "pressure",
            _ => "relative error",
        };
        words.to_owned()
    }

    /// The unit of numbers up to the largest: in SI data sets with a prefix, else the scale.
    pub fn unit(&self, si: bool, largest: f64) -> ShownUnit {
        match self.units {
            units if si => ShownUnit::of(si_units(units), largest),
            FRICTION => ShownUnit::scale("a₀/R"),
            LENGTH => ShownUnit::scale("a₀"),
            HEIGHT => ShownUnit::scale("a₀²/R"),
            PRESSURE => ShownUnit::scale("2N/(πa₀)"),
            "1" => ShownUnit::scale(""),
            other => ShownUnit::scale(other),
        }
    }
}
