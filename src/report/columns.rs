//! The numbers of each place shown: the columns of `summary.csv`, and what the cases cost.

use serde::Serialize;

use super::encoding::{floats, integers};
use super::texts::Texts;
use crate::pictures::Quantity;
use stribeck_lab::si_units;
use stribeck_sweep::store::{Cost, DataSet, StoreError};
use stribeck_sweep::{Column, Dimension};

/// One number for each place.
#[derive(Debug, Serialize)]
pub(super) struct ColumnPart {
    name: &'static str,
    /// What pictures call it.
    words: String,
    units: &'static str,
    /// The column of its estimated relative error.
    error: Option<&'static str>,
    values: String,
}

/// What each place cost.
#[derive(Debug, Serialize)]
pub(super) struct CostPart {
    seconds: String,
    iterations: String,
    seeds: Vec<String>,
    /// For each place the index of its seed.
    seed: String,
}

/// Columns of `summary.csv` that a page has no room for: each follows from others here, or is for those who check.
const LEFT_OUT: [Column; 3] = [Column::MuVRoller, Column::MuTorque, Column::EnergyResidual];

/// Reads the columns of `summary.csv` in their order but those [left out](LEFT_OUT), the other estimated errors behind
/// them, and for a laboratory α and β. The friction of the flat is there if the roller has some too.
pub(super) fn columns(data: &DataSet, places: &[usize]) -> Result<Vec<ColumnPart>, StoreError> {
    let part = |name, words: String, units: &'static str, error: Option<Column>| {
        let values = data.variable(name)?;
        let units = if data.laboratory { si_units(units) } else { units };
        let values = floats(places.iter().map(|place| values[*place]));
        Ok(ColumnPart { name, words, units, error: error.map(Column::name), values })
    };
    let of_roller = data.has_hysteresis_of_roller()?;
    let further_errors = Column::ALL.into_iter().filter(|column| column.is_error() && !column.in_summary());
    let mut columns = Column::summary()
        .filter(|column| !LEFT_OUT.contains(column) && (of_roller || *column != Column::MuVFlat))
        .chain(further_errors)
        .map(|column| part(column.name(), Quantity::from(column).plain(), column.units(), column.error()))
        .collect::<Result<Vec<_>, StoreError>>()?;
    if data.laboratory {
        columns.push(part("alpha", Dimension::ALPHA.to_owned(), "1", None)?);
        columns.push(part("beta", Dimension::BETA.to_owned(), "1", None)?);
    }
    Ok(columns)
}

impl CostPart {
    /// The costs of these places, given the costs of all.
    pub(super) fn of(costs: &[Cost], places: &[usize]) -> Self {
        let mut seeds = Texts::default();
        let seed: Vec<i32> = places
            .iter()
            .map(|place| i32::try_from(seeds.index(&costs[*place].seed)).expect("fewer seeds than 2³¹"))
            .collect();
        Self {
            seconds: floats(places.iter().map(|place| costs[*place].seconds)),
            iterations: floats(places.iter().map(|place| costs[*place].iterations as f64)),
            seeds: seeds.texts,
            seed: integers(seed),
        }
    }
}
