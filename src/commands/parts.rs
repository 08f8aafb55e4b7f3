//! How far the parts of a sweep are.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::collection::{Collection, Held};
use super::wording::count;
use stribeck_sweep::store::StoreError;
use stribeck_sweep::{Part, Plan};

/// Parts that are listed one by one.
const LISTED: usize = 10;

/// How far a part is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartState {
    /// The part.
    pub part: Part,
    /// Its cases.
    pub cases: u64,
    /// Those of them that are held nowhere.
    pub missing: u64,
    /// What its run is at.
    pub run: PartRun,
}

/// What the run of a part is at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartRun {
    /// It has no directory yet.
    NotStarted,
    /// A process works there, on this machine or another.
    Running(String),
    /// No one does.
    Stopped,
}

/// The states of all parts of the splits that there are directories of, in their order.
pub fn states(plan: &Plan, collection: &Collection, held: &Held<'_>) -> Result<Vec<PartState>, StoreError> {
    let splits: BTreeSet<u32> = collection.parts.iter().map(|(part, _)| part.of()).collect();
    let mut states = Vec::new();
    for of in splits {
        let first = states.len();
        for part in Part::all(of) {
            let run = match collection.parts.binary_search_by_key(&part, |(started, _)| *started) {
                Err(_) => PartRun::NotStarted,
                Ok(place) => collection.parts[place].1.owner()?.map_or(PartRun::Stopped, PartRun::Running),
            };
            states.push(PartState { part, cases: 0, missing: 0, run });
        }
        for (chain, part) in plan.chains().zip(plan.split(of)) {
            let state = &mut states[first + part.number() as usize - 1];
            for id in plan.ids(&chain) {
                state.cases += 1;
                state.missing += u64::from(held.holds(id).is_none());
            }
        }
    }
    Ok(states)
}

/// The states in words: a line of counts, and a line for each part that lacks something, the first ones.
pub fn in_words(states: &[PartState]) -> String {
    let incomplete: Vec<&PartState> = states.iter().filter(|state| state.missing > 0).collect();
    let number = |is: fn(&PartRun) -> bool| incomplete.iter().filter(|state| is(&state.run)).count();
    let mut text = format!(
        "{}: {} complete, {} running, {} stopped, {} not started\n",
        count(states.len() as u64, "part"),
        states.len() - incomplete.len(),
        number(|run| matches!(run, PartRun::Running(_))),
        number(|run| *run == PartRun::Stopped),
        number(|run| *run == PartRun::NotStarted),
    );
    let written = "writing to memory does not fail";
    for PartState { part, cases, missing, run } in incomplete.iter().take(LISTED) {
        let run = match run {
            PartRun::NotStarted => "not started".to_owned(),
            PartRun::Running(owner) => format!("running ({owner})"),
            PartRun::Stopped => "stopped".to_owned(),
        };
        let left = count(*missing, "case");
        writeln!(text, "  {:<9} {left} of {cases} missing, {run}", part.to_string()).expect(written);
    }
    if incomplete.len() > LISTED {
        writeln!(text, "  and {} more", incomplete.len() - LISTED).expect(written);
    }
    text
}
