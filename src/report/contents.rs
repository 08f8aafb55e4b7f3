//! The numbers of a page, as its script reads them.

use std::collections::BTreeMap;

use serde::Serialize;

use super::encoding::{floats, integers};
use super::failures::FailurePart;
use super::fields::{CasePlace, FieldsPart, fields};
use super::thinning::Grid;
use crate::pictures::AxisWords;
use stribeck_lab::Measured;
use stribeck_lab::si_units;
use stribeck_sweep::Column;
use stribeck_sweep::store::{Cost, DataSet, StoreError};

/// All that the page shows. Lists of numbers are base64 (`encoding`).
#[derive(Debug, Serialize)]
pub(super) struct Contents {
    title: String,
    version: String,
    outdated: bool,
    /// Numbers of values on the three axes of the data set.
    shape: [usize; 3],
    /// Values shown on the three axes; ∞ is the word `inf`, which JSON has no number for.
    axes: [Vec<AxisValue>; 3],
    /// What the axes are called.
    axis_words: [AxisPart; 3],
    /// True if numbers are in SI units.
    laboratory: bool,
    /// Quantities of the laboratory that are one number.
    fixed: BTreeMap<String, f64>,
    /// Measured points.
    measured: Option<MeasuredPart>,
    /// For each place shown the index of its case.
    case_of: String,
    /// Ids of the cases shown.
    cases: Vec<String>,
    /// For each place shown 0 (converged) or 1 (failed).
    status: String,
    /// The columns of `summary.csv` in their order, with units; one number for each place shown.
    columns: Vec<ColumnPart>,
    /// What each place cost; none without timings.csv.
    costs: Option<CostPart>,
    fields: Option<FieldsPart>,
    failures: FailurePart,
    /// What was left out, a sentence each.
    pub(super) notes: Vec<String>,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum AxisValue {
    Number(f64),
    Word(&'static str),
}

/// What an axis is called.
#[derive(Debug, Serialize)]
struct AxisPart {
    name: String,
    symbol: String,
    label: String,
    unit: String,
    /// What each value shown stands for, where several quantities are taken together.
    combinations: Vec<String>,
    /// The same as names and values.
    members: Vec<Vec<(String, f64)>>,
}

/// Measured points of a quantity.
#[derive(Debug, Serialize)]
struct MeasuredPart {
    column: &'static str,
    friction: Vec<f64>,
    errors: Option<Vec<f64>>,
    /// Values of each coordinate by its name.
    coordinates: BTreeMap<&'static str, Vec<f64>>,
}

#[derive(Debug, Serialize)]
struct ColumnPart {
    name: &'static str,
    long_name: &'static str,
    units: &'static str,
    values: String,
}

#[derive(Debug, Serialize)]
struct CostPart {
    seconds: String,
    iterations: String,
    factorisations: String,
    seeds: Vec<String>,
    /// For each place the index of its seed.
    seed: String,
}

impl From<f64> for AxisValue {
    fn from(value: f64) -> Self {
        if value == f64::INFINITY { AxisValue::Word("inf") } else { AxisValue::Number(value) }
    }
}

/// Different texts, each once, in the order in which they come.
#[derive(Default)]
pub(super) struct Words {
    pub(super) words: Vec<String>,
    indices: BTreeMap<String, usize>,
}

impl Words {
    pub(super) fn index(&mut self, word: &str) -> usize {
        if let Some(index) = self.indices.get(word) {
            return *index;
        }
        self.indices.insert(word.to_owned(), self.words.len());
        self.words.push(word.to_owned());
        self.words.len() - 1
    }

    /// True if the word is among them.
    pub(super) fn has(&self, word: &str) -> bool {
        self.indices.contains_key(word)
    }
}

impl Contents {
    /// The contents of the page of a data set.
    ///
    /// # Errors
    /// [`StoreError`] if the data set cannot be read.
    pub(super) fn of(data: &DataSet, measured: Option<&Measured>) -> Result<Self, StoreError> {
        let mut notes =
            vec!["Numbers are shown to at most seven digits; summary.csv and results.h5 have all.".to_owned()];
        let (grid, axis_words) = (Grid::of(data), AxisWords::of(data));
        if grid.is_thinned(data) {
            let named = |words: [String; 3]| {
                let kept = words.into_iter().zip(&axis_words).filter(|(_, axis)| !axis.symbol.is_empty());
                kept.map(|(word, _)| word).collect::<Vec<_>>().join(" × ")
            };
            let words = |shape: [usize; 3]| named(shape.map(|length| length.to_string()));
            notes.push(format!(
                "Of the {} places of the sweep ({}) {} are shown, spread evenly with both ends of each axis.",
                words(data.shape().lengths()),
                named(axis_words.each_ref().map(|axis| axis.symbol.clone())),
                words(std::array::from_fn(|axis| grid.0[axis].len()))
            ));
        }
        let (ids, statuses, reasons) = (data.cases()?, data.statuses()?, data.reasons()?);
        let places: Vec<usize> = grid.places().map(|indices| data.place(indices)).collect();

        let mut words = Words::default();
        let (mut case_of, mut cases) = (Vec::with_capacity(places.len()), Vec::new());
        for (indices, place) in grid.places().zip(&places) {
            let index = words.index(&ids[*place]);
            if index == cases.len() {
                cases.push(CasePlace { indices, status: statuses[*place] });
            }
            case_of.push(i32::try_from(index).expect("a page has fewer cases than 2³¹"));
        }
        let part = |name, long_name, units: &'static str| {
            let values = data.variable(name)?;
            let units = if data.laboratory { si_units(units) } else { units };
            Ok(ColumnPart { name, long_name, units, values: floats(places.iter().map(|place| values[*place])) })
        };
        let mut columns = Column::summary()
            .map(|column| part(column.name(), column.long_name(), column.units()))
            .collect::<Result<Vec<_>, StoreError>>()?;
        if data.laboratory {
            columns.push(part("alpha", "slide time over a contact length / retardation time", "1")?);
            columns.push(part("beta", "inverse Hersey number", "1")?);
        }
        let costs = data.costs()?.map(|costs| CostPart::of(&costs, &places));
        if costs.is_none() {
            notes.push("There is no timings.csv, so nothing is known of what cases cost.".to_owned());
        }
        let fields = fields(data, &cases, &mut notes)?;
        if fields.is_none() {
            notes.push("The sweep has no fields: `fields` below [output] of the sweep file asks for them.".to_owned());
        }
        if let Some(measured) = measured {
            let is_along = |axis: &AxisWords| axis.values.len() > 1 && measured.coordinate(&axis.name).is_some();
            if !axis_words[1..].iter().any(is_along) {
                notes.push(
                    "No measured points are shown: their file has no column of an axis that curves run along here."
                        .to_owned(),
                );
            }
        }
        let failures = FailurePart::of(data, &places, &statuses, &reasons, &mut notes);
        let axis = |axis: usize| grid.0[axis].iter().map(|i| axis_words[axis].values[*i].into()).collect();
        Ok(Self {
            title: data.title.clone(),
            version: data.version.clone(),
            outdated: data.outdated,
            shape: data.shape().lengths(),
            axes: [axis(0), axis(1), axis(2)],
            laboratory: data.laboratory,
            fixed: data.fixed.iter().cloned().collect(),
            measured: measured.map(MeasuredPart::of),
            case_of: integers(case_of),
            cases: words.words,
            status: integers(places.iter().map(|place| i32::from(statuses[*place].code()))),
            columns,
            costs,
            fields,
            failures,
            notes,
            axis_words: std::array::from_fn(|axis| {
                let AxisWords { name, symbol, label, unit, combinations, members, .. } = &axis_words[axis];
                let combinations = grid.0[axis].iter().filter_map(|i| combinations.get(*i).cloned()).collect();
                let members = grid.0[axis].iter().filter_map(|i| members.get(*i).cloned()).collect();
                let [name, symbol, label, unit] = [name, symbol, label, unit].map(Clone::clone);
                AxisPart { name, symbol, label, unit, combinations, members }
            }),
        })
    }
}

impl MeasuredPart {
    fn of(measured: &Measured) -> Self {
        Self {
            column: measured.column,
            friction: measured.friction.clone(),
            errors: measured.errors.clone(),
            coordinates: measured.coordinates.iter().cloned().collect(),
        }
    }
}

impl CostPart {
    fn of(costs: &[Cost], places: &[usize]) -> Self {
        let whole = |number: u64| number as f64;
        let mut seeds = Words::default();
        let seed: Vec<i32> = places
            .iter()
            .map(|place| i32::try_from(seeds.index(&costs[*place].seed)).expect("fewer seeds than 2³¹"))
            .collect();
        Self {
            seconds: floats(places.iter().map(|place| costs[*place].seconds)),
            iterations: floats(places.iter().map(|place| whole(costs[*place].iterations))),
            factorisations: floats(places.iter().map(|place| whole(costs[*place].factorisations))),
            seeds: seeds.words,
            seed: integers(seed),
        }
    }
}
