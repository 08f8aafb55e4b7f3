//! Measured points beside the numbers of a page.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::pictures::AxisWords;
use stribeck_lab::Measured;
use stribeck_sweep::store::DataSet;

/// Measured points of a quantity.
#[derive(Debug, Serialize)]
pub(super) struct MeasuredPart {
    column: &'static str,
    friction: Vec<f64>,
    errors: Option<Vec<f64>>,
    /// Values of each coordinate by its name.
    coordinates: BTreeMap<&'static str, Vec<f64>>,
}

impl MeasuredPart {
    /// The points of a file. A note says how many no curve of the page can show, and why.
    pub(super) fn of(measured: &Measured, data: &DataSet, axes: &[AxisWords; 3], notes: &mut Vec<String>) -> Self {
        let is_along = |axis: &&AxisWords| axis.values.len() > 1 && measured.coordinate(&axis.name).is_some();
        let along: Vec<&str> = axes[1..].iter().filter(is_along).map(|axis| axis.name.as_str()).collect();
        notes.extend(match along[..] {
            [] => Some(
                "No measured points are shown: their file has no column of an axis that curves run along here."
                    .to_owned(),
            ),
            _ => strangers(measured, data, &along),
        });
        Self {
            column: measured.column,
            friction: measured.friction.clone(),
            errors: measured.errors.clone(),
            coordinates: measured.coordinates.iter().cloned().collect(),
        }
    }
}

/// What is to be said of points that belong to no curve along these axes: some quantity of theirs has another value than
/// all places of the sweep.
fn strangers(measured: &Measured, data: &DataSet, along: &[&str]) -> Option<String> {
    let fixed = data.fixed.iter().map(|(name, value)| (name.as_str(), std::slice::from_ref(value)));
    let known = data.dimensions.iter().map(|dimension| (dimension.name.as_str(), &dimension.values[..]));
    let known: Vec<(&str, &[f64])> = known.chain(fixed).filter(|(name, _)| !along.contains(name)).collect();
    let other = |row: usize| {
        known.iter().find(|(name, values)| {
            let of_point = measured.coordinate(name).map(|all| all[row]);
            of_point.is_some_and(|found| !values.iter().any(|value| Measured::is_same(found, *value)))
        })
    };
    let all = measured.friction.len();
    let names: Vec<&str> = (0..all).filter_map(other).map(|(name, _)| *name).collect();
    let name = names.first()?;
    let count = if names.len() == all { "no point".to_owned() } else { format!("only {} of {all}", all - names.len()) };
    Some(format!("Of the measured points {count} belongs to a curve here: {name} has other values in the sweep."))
}
