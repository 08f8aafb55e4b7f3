//! Opening a results directory for writing.

use std::path::Path;

use super::{Event, Observer};
use crate::store::{Store, StoreError};
use crate::{Plan, Sweep};

/// Opens the results directory of a plan for writing, and tells what in it is damaged.
pub(crate) fn open_store(
    directory: &Path,
    sweep: &Sweep,
    plan: &Plan,
    observe: &mut Observer<'_>,
) -> Result<Store, StoreError> {
    let recipe = serde_json::to_value(plan.recipe()).expect("a recipe is made of words and finite numbers");
    let store = Store::open(directory, &sweep.text, sweep)?.solving_with(recipe);
    store.warnings().iter().for_each(|warning| observe(Event::Damaged(warning)));
    Ok(store)
}
