//! From the stored cases of a sweep to the files for the user.

use crate::store::{Point, Publication, Published, Store, StoreError};
use crate::{Plan, Sweep};

/// Publishes a sweep whose cases are all stored.
pub(super) fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    let [_, rows, length] = sweep.grid.shape();
    let point = |place @ [i_f, i_row, along]: [usize; 3]| Point {
        case: plan.case_at(i_f, i_row, along),
        numbers: sweep.grid.numbers(place),
        experiment: sweep.grid.experiment(place),
    };
    let row = |row: usize| (0..length).map(|along| point([row / rows, row % rows, along])).collect();
    let dimensions = sweep.grid.dimensions();
    store.publish(&Publication { title: &sweep.title, sweep_text: &sweep.text, dimensions: &dimensions, row: &row })
}
