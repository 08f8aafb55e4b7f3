//! From the stored cases of a sweep to the files for the user.

use crate::store::{Point, Publication, Published, Store, StoreError};
use crate::{GridIndex, Plan, Sweep};

/// Publishes a sweep whose cases are all stored.
pub(super) fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    let point = |place: GridIndex| Point {
        case: plan.case_at(place),
        numbers: sweep.grid.numbers(place),
        experiment: sweep.grid.experiment(place),
    };
    let row = |row: usize| sweep.grid.shape().row(row).map(point).collect();
    let dimensions = sweep.grid.dimensions();
    store.publish(&Publication { title: &sweep.title, sweep_text: &sweep.text, dimensions: &dimensions, row: &row })
}
