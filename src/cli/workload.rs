//! What of a plan is left to do, and why.

use std::collections::{BTreeMap, HashMap};

use crate::model::{CaseId, Parameters, shortest};
use crate::store::{Counts, Holdings, Inspection, Status};
use crate::sweep::{Fingerprint, Method, Plan, Recipe, Sweep};

/// How closely a command looks at what is stored: as closely as a run does, unless it is to be quick.
pub fn inspection(quick: bool) -> Inspection {
    if quick { Inspection::Size } else { Inspection::Bytes }
}

/// What of a plan is done, and what is left. Counts are of distinct cases.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Workload {
    /// Chains that lack a case, by their place in [`Plan::chains`].
    pub pending: Vec<u32>,
    /// Of the pending chains that have other cases, which ones are missing: a bit for each.
    partly: HashMap<u32, u64>,
    /// Cases that are solved, those that only seed others included.
    pub solved: u64,
    /// Cases that were never solved.
    pub new: u64,
    /// Cases that are stored and of no use, by the reason: they are solved again.
    pub stale: BTreeMap<String, u64>,
    /// Cases that are held and converged.
    pub converged: u64,
    /// Cases that are held and failed; they are not tried again.
    pub failed: u64,
    /// Cases stored that have no place in the sweep.
    pub others: u64,
}

/// What a case is to the sweep.
enum State {
    Done(Status),
    Stale(String),
    New,
}

impl Workload {
    /// Asks for each case of the plan what became of it. Where nothing is held there is nothing to ask, which makes the
    /// plan of a billion cases quick.
    pub fn survey(sweep: &Sweep, plan: &Plan, held: Option<&Holdings>) -> Self {
        let Some(held) = held.filter(|held| held.counts() != Counts::default()) else { return Self::all(plan) };
        let survey = Survey::new(sweep, plan, held);
        let mut workload = Self::default();
        let mut in_place = 0;
        for (index, chain) in (0..).zip(plan.chains()) {
            let mut missing = 0_u64;
            for (place, parameters) in plan.parameters(&chain).iter().enumerate() {
                let id = plan.id(parameters);
                in_place += survey.stored(id, parameters);
                let state = survey.state(id, parameters);
                missing |= u64::from(!matches!(state, State::Done(_))) << place;
                match state {
                    State::Done(Status::Converged) => workload.converged += 1,
                    State::Done(Status::Failed) => workload.failed += 1,
                    State::New => workload.new += 1,
                    State::Stale(why) => *workload.stale.entry(why).or_default() += 1,
                }
            }
            if missing != 0 {
                workload.pending.push(index);
                if missing.count_ones() as usize != chain.beta.len() {
                    workload.partly.insert(index, missing);
                }
                workload.solved += workload.places(plan, index).len() as u64;
            }
        }
        workload.others = held.known().saturating_sub(in_place);
        workload
    }

    /// All of the plan.
    fn all(plan: &Plan) -> Self {
        let chains = u32::try_from(plan.chain_count()).expect("a sweep has at most 10^9 cases");
        let cases = plan.problems() as u64;
        Self { pending: (0..chains).collect(), solved: cases, new: cases, ..Self::default() }
    }

    /// Cases that are held.
    pub fn reused(&self) -> u64 {
        self.converged + self.failed
    }

    /// Cases that are stored and solved again.
    pub fn stale(&self) -> u64 {
        self.stale.values().sum()
    }

    /// Cases to be solved and stored.
    pub fn to_do(&self) -> u64 {
        self.new + self.stale()
    }

    /// True if a case of a pending chain is to be stored.
    pub fn is_missing(&self, index: u32, place: usize) -> bool {
        self.partly.get(&index).is_none_or(|missing| missing >> place & 1 == 1)
    }

    /// The cases of a pending chain that are solved, by their places in it and in their order.
    ///
    /// These are the missing ones and, where a method is slow to start anew, those before them, which seed them. They keep
    /// what is stored of them.
    pub fn places(&self, plan: &Plan, index: u32) -> Vec<usize> {
        let length = plan.chain(index as usize).beta.len();
        let mut missing = (0..length).filter(|&place| self.is_missing(index, place));
        match plan.recipe().solver.method() {
            Method::Collocation => missing.collect(),
            Method::Relaxation => (0..=missing.next_back().unwrap_or(0)).collect(),
        }
    }
}

/// Why a case that is stored is of no use to a sweep; `None` if it is, or is not stored at all.
pub fn stale_reason(sweep: &Sweep, plan: &Plan, held: &Holdings, parameters: &Parameters) -> Option<String> {
    match Survey::new(sweep, plan, held).state(plan.id(parameters), parameters) {
        State::Stale(why) => Some(why),
        State::Done(_) | State::New => None,
    }
}

/// What is asked of each case.
struct Survey<'a> {
    held: &'a Holdings,
    time_limit: f64,
    /// The other recipes that cases here were solved with: in which way they differ, and the ids they give.
    others: Vec<(String, Fingerprint)>,
}

impl<'a> Survey<'a> {
    fn new(sweep: &Sweep, plan: &Plan, held: &'a Holdings) -> Self {
        // A recipe that does not read is one of a method or setting that this version does not know: its cases are of no use,
        // and no case here can be told to be one of them.
        let recipes = held.recipes().iter().filter_map(|recipe| serde_json::from_value::<Recipe>(recipe.clone()).ok());
        let others = recipes
            .filter(|recipe| recipe != plan.recipe())
            .map(|recipe| (recipe.differences(plan.recipe()), Fingerprint::new(&recipe)))
            .collect();
        Self { held, time_limit: sweep.solver.time_limit, others }
    }

    fn state(&self, id: CaseId, parameters: &Parameters) -> State {
        let held = self.held;
        match (held.holds(id), held.time_limit(id)) {
            (Some(Status::Failed), Some(limit)) if limit < self.time_limit => {
                let (then, now) = (shortest(limit), shortest(self.time_limit));
                return State::Stale(format!("given up at the time limit of {then} s, now {now}"));
            }
            (Some(status), _) => return State::Done(status),
            (None, _) => {}
        }
        if held.knows(id) {
            return State::Stale(format!("stored without {}", held.lacks(id).join(", ")));
        }
        let solved_otherwise = self.others.iter().find(|(_, fingerprint)| held.knows(fingerprint.id(parameters)));
        match solved_otherwise {
            Some((differences, _)) => State::Stale(format!("solved with {differences}")),
            None => State::New,
        }
    }

    /// In how many forms a problem is stored.
    fn stored(&self, id: CaseId, parameters: &Parameters) -> u64 {
        let otherwise = self.others.iter().filter(|(_, fingerprint)| self.held.knows(fingerprint.id(parameters)));
        u64::from(self.held.knows(id)) + otherwise.count() as u64
    }
}
