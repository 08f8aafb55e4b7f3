//! What is published.

use super::{Status, StoreError};
use crate::{CaseId, Dimension, ModelLimits, Values};
use stribeck_lab::Experiment;

/// A publication: a grid, and the case at each of its places.
pub struct Publication<'a> {
    /// Title of the sweep.
    pub title: &'a str,
    /// The sweep file.
    pub sweep_text: &'a str,
    /// The method that solved it.
    pub method: &'a str,
    /// The tolerance that it was solved to.
    pub tolerance: f64,
    /// True if places without a case are published as such; else they are an error.
    pub partial: bool,
    /// The dimensions of the grid, at least two, the one along the rows last.
    pub dimensions: &'a [Dimension],
    /// The places of a row, one for each value of the last dimension. Rows are counted with the last dimension before
    /// it fastest. A case may stand at many places.
    pub row: &'a dyn Fn(usize) -> Vec<Point>,
}

/// A place of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The case.
    pub case: CaseId,
    /// The slide-to-roll ratio S there (T52).
    pub slide_roll: f64,
    /// Its f, α and β, as they belong to the place.
    pub numbers: [f64; 3],
    /// With which power of the f of the place that of the case changes, where no experiment is given.
    pub power_of_strength: f64,
    /// The case at −S, where bodies are swapped: at all places or at none.
    pub swapped: Option<CaseId>,
    /// The experiment, if quantities of the laboratory are given: results are in SI units then. At all places or at
    /// none.
    pub experiment: Option<Experiment>,
    /// What the surfaces and the layer there allow.
    pub limits: ModelLimits,
}

impl Point {
    /// A case of a dimensionless sweep, for a roller that slides without turning.
    pub fn new(case: CaseId, numbers: [f64; 3]) -> Self {
        let limits = ModelLimits::default();
        Self { case, slide_roll: 1.0, numbers, power_of_strength: 1.0, swapped: None, experiment: None, limits }
    }
}

impl Publication<'_> {
    /// Numbers of values along the dimensions.
    pub(super) fn shape(&self) -> Vec<usize> {
        self.dimensions.iter().map(|dimension| dimension.values.len()).collect()
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        let shape = self.shape();
        shape[..shape.len() - 1].iter().product()
    }

    /// True if the slide-to-roll ratio is a dimension of its own.
    pub(super) fn has_ratios(&self) -> bool {
        self.dimensions[0].name == Dimension::SLIDE_ROLL
    }

    /// The places of a row, which must be as many as the last dimension has values.
    pub(super) fn places(&self, row: usize) -> Result<Vec<Point>, StoreError> {
        let points = (self.row)(row);
        match self.dimensions.last() {
            Some(last) if points.len() != last.values.len() => {
                let what =
                    format!("row {row} has {} cases for {} values of {}", points.len(), last.values.len(), last.name);
                Err(StoreError::Publication { what })
            }
            _ => Ok(points),
        }
    }
}

/// What stands at a place of the grid.
pub(super) struct Place {
    pub point: Point,
    pub status: Status,
    pub reason: String,
    pub values: Values,
    /// Of the columns that only some sweeps have.
    pub more: Vec<f64>,
    /// The notes on it, by their masks.
    pub notes: i32,
}
