//! Measured points beside the numbers of a page.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::pictures::AxisWords;
use stribeck_lab::Measured;

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
    /// The points of a file. A note says so if no curve of the page can show them.
    pub(super) fn of(measured: &Measured, axes: &[AxisWords; 3], notes: &mut Vec<String>) -> Self {
        let is_along = |axis: &AxisWords| axis.values.len() > 1 && measured.coordinate(&axis.name).is_some();
        if !axes[1..].iter().any(is_along) {
            notes.push(
                "No measured points are shown: their file has no column of an axis that curves run along here."
                    .to_owned(),
            );
        }
        Self {
            column: measured.column,
            friction: measured.friction.clone(),
            errors: measured.errors.clone(),
            coordinates: measured.coordinates.iter().cloned().collect(),
        }
    }
}
