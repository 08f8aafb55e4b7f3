//! The columns that only some sweeps have: sensitivities, and averages of runs with swapped bodies.

use super::Point;
use super::sensitivity_columns;
use crate::{Column, Values};
use stribeck_solver::Output;

/// A published column of pure numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct FurtherColumn {
    /// Its name.
    pub name: String,
    /// What it is, in words.
    pub long_name: String,
}

/// The further columns of results whose first place is given.
pub fn columns(first: Option<&Point>, output: &Output) -> Vec<FurtherColumn> {
    let mut columns = match output.sensitivities {
        true => sensitivity_columns::columns(first.and_then(|first| first.experiment.as_ref())),
        false => Vec::new(),
    };
    if first.is_some_and(|first| first.swapped.is_some()) {
        columns.extend(averages());
    }
    columns
}

/// An average over both runs of an instrument that swaps the faster body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Average {
    /// Its name.
    pub name: &'static str,
    /// What it is called; behind it stands its symbol.
    pub words: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// What else is to be said of it.
    rest: &'static str,
}

/// The averages over both runs of an instrument that swaps the faster body.
pub const AVERAGES: [Average; 2] = [
    Average {
        name: "mu_sliding",
        words: "friction by sliding, of both runs",
        symbol: "μ_{sliding}",
        rest: ": half the difference of mu_drag with the flat and with the roller faster",
    },
    Average {
        name: "mu_rolling",
        words: "friction by rolling, of both runs",
        symbol: "μ_{rolling}",
        rest: ": the mean of mu_drag with the flat and with the roller faster",
    },
];

impl Average {
    /// The words with what else is to be said of it.
    pub fn long_name(&self) -> String {
        format!("{}{}", self.words, self.rest)
    }
}

fn averages() -> [FurtherColumn; 2] {
    AVERAGES.map(|average| FurtherColumn { name: average.name.to_owned(), long_name: average.long_name() })
}

/// [D(S) − D(−S)]/2 with S ≥ 0 and [D(S) + D(−S)]/2, in this order, from the values of both runs.
pub(super) fn averages_of(slide_roll: f64, own: &Values, swapped: &Values) -> [f64; 2] {
    let (own, other) = (own[Column::MuDrag], swapped[Column::MuDrag]);
    let (faster, slower) = if slide_roll < 0.0 { (other, own) } else { (own, other) };
    [0.5 * (faster - slower), 0.5 * (faster + slower)]
}
