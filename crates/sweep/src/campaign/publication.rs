//! From the stored cases of a sweep to the files for the user.

use crate::store::{Point, Publication, Published, Store, StoreError};
use crate::{Grid, GridIndex, Plan, Sweep};

/// A place of the grid of a sweep as it is published.
pub fn published_point(sweep: &Sweep, plan: &Plan, place: GridIndex) -> Point {
    let laboratory = match &sweep.grid {
        Grid::Dimensionless(_) => None,
        Grid::Laboratory(axes) => Some(axes),
    };
    Point {
        case: plan.case_at(place),
        slide_roll: sweep.grid.slide_roll(place),
        swapped: laboratory.and_then(|axes| axes.swapped(place)).map(|place| plan.case_at(place)),
        limits: laboratory.map(|axes| axes.limits).unwrap_or_default(),
        numbers: sweep.grid.numbers(place),
        experiment: sweep.grid.experiment(place),
    }
}

/// Publishes a sweep whose cases are all stored.
pub(super) fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    let row = |row: usize| sweep.grid.shape().row(row).map(|place| published_point(sweep, plan, place)).collect();
    let dimensions = sweep.grid.dimensions();
    let (method, tolerance) = (sweep.solver.method.to_string(), sweep.solver.tolerance);
    store.publish(&Publication {
        title: &sweep.title,
        sweep_text: &sweep.text,
        method: &method,
        tolerance,
        dimensions: &dimensions,
        row: &row,
    })
}
