//! How far the parts of a sweep are.

use std::collections::BTreeSet;

use super::{MergedCatalog, SweepDirectory};
use crate::store::StoreError;
use crate::{Part, Plan};

/// How far a part is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartState {
    /// The part.
    pub part: Part,
    /// The number of its cases.
    pub cases: u64,
    /// The number of its cases that are stored nowhere.
    pub missing: u64,
    /// Whether someone works on it.
    pub activity: PartActivity,
}

/// Whether someone works on a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartActivity {
    /// It has no directory yet.
    NotStarted,
    /// A process works there, on this machine or another: its name, as in `process 4711`.
    Running(String),
    /// It has a directory, and no one works there.
    Stopped,
}

/// The states of all parts of those splits that have a directory, in their order.
pub(super) fn part_states(
    plan: &Plan,
    directory: &SweepDirectory,
    stored: &MergedCatalog<'_>,
) -> Result<Vec<PartState>, StoreError> {
    let splits: BTreeSet<u32> = directory.parts.iter().map(|(part, _)| part.of()).collect();
    let mut states = Vec::new();
    for of in splits {
        let first = states.len();
        for part in Part::all(of) {
            let activity = match directory.parts.binary_search_by_key(&part, |(started, _)| *started) {
                Err(_) => PartActivity::NotStarted,
                Ok(place) => directory.parts[place].1.owner()?.map_or(PartActivity::Stopped, PartActivity::Running),
            };
            states.push(PartState { part, cases: 0, missing: 0, activity });
        }
        for (chain, part) in plan.chains().zip(plan.split(of)) {
            let state = &mut states[first + part.number() as usize - 1];
            for id in plan.ids(&chain) {
                state.cases += 1;
                state.missing += u64::from(stored.holds(id).is_none());
            }
        }
    }
    Ok(states)
}
