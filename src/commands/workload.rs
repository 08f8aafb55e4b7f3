//! What of a plan is left to do, and why.

use std::collections::{BTreeMap, HashMap};

use super::collection::Held;
use stribeck_solver::{Parameters, shortest};
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{Inspection, Status};
use stribeck_sweep::{Fingerprint, Method, Part, Plan, Recipe, Sweep};

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
    /// Asks for each case of the plan, or of a part of it, what became of it in all that is held. Where nothing is held there
    /// is nothing to ask, which makes the plan of a billion cases quick.
    pub fn survey(sweep: &Sweep, plan: &Plan, part: Option<Part>, held: &Held<'_>) -> Self {
        let chains = plan.chains_of(part);
        if held.known() == 0 {
            return Self::all(plan, chains);
        }
        let survey = Survey::new(sweep, plan, held);
        let mut workload = Self::default();
        let mut in_place = 0;
        for index in chains {
            let chain = plan.chain(index as usize);
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
                if missing.count_ones() as usize != chain.cases.len() {
                    workload.partly.insert(index, missing);
                }
                workload.solved += workload.places(plan, index).len() as u64;
            }
        }
        workload.others = held.known() - in_place;
        workload
    }

    /// All of these chains.
    fn all(plan: &Plan, chains: Vec<u32>) -> Self {
        let cases = chains.iter().map(|&index| plan.chain(index as usize).cases.len() as u64).sum();
        Self { pending: chains, solved: cases, new: cases, ..Self::default() }
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
        let length = plan.chain(index as usize).cases.len();
        let mut missing = (0..length).filter(|&place| self.is_missing(index, place));
        match plan.recipe().solver.method() {
            Method::Collocation => missing.collect(),
            Method::Relaxation => (0..=missing.next_back().unwrap_or(0)).collect(),
        }
    }
}

/// Why a case that is stored is of no use to a sweep; `None` if it is, or is not stored at all.
pub fn stale_reason(sweep: &Sweep, plan: &Plan, held: &Held<'_>, parameters: &Parameters) -> Option<String> {
    match Survey::new(sweep, plan, held).state(plan.id(parameters), parameters) {
        State::Stale(why) => Some(why),
        State::Done(_) | State::New => None,
    }
}

/// What is asked of each case.
struct Survey<'a> {
    held: &'a Held<'a>,
    time_limit: f64,
    /// The other recipes that cases here were solved with: in which way they differ, and the ids they give.
    others: Vec<(String, Fingerprint)>,
}

impl<'a> Survey<'a> {
    fn new(sweep: &Sweep, plan: &Plan, held: &'a Held<'a>) -> Self {
        // A recipe that does not read is one of a method or setting that this version does not know: its cases are of no use,
        // and no case here can be told to be one of them.
        let all = held.all().iter().flat_map(|held| held.recipes());
        let mut recipes: Vec<Recipe> = Vec::new();
        for recipe in all.filter_map(|recipe| serde_json::from_value(recipe.clone()).ok()) {
            if recipe != *plan.recipe() && !recipes.contains(&recipe) {
                recipes.push(recipe);
            }
        }
        let others =
            recipes.iter().map(|recipe| (recipe.differences(plan.recipe()), Fingerprint::new(recipe))).collect();
        Self { held, time_limit: sweep.solver.time_limit, others }
    }

    fn state(&self, id: CaseId, parameters: &Parameters) -> State {
        let holder = self.held.holder(id);
        match holder.map_or((None, None), |held| (held.holds(id), held.time_limit(id))) {
            (Some(Status::Failed), Some(limit)) if limit < self.time_limit => {
                let (then, now) = (shortest(limit), shortest(self.time_limit));
                return State::Stale(format!("given up at the time limit of {then} s, now {now}"));
            }
            (Some(status), _) => return State::Done(status),
            (None, _) => {}
        }
        if let Some(held) = holder {
            return State::Stale(format!("stored without {}", held.lacks(id).join(", ")));
        }
        let known = |fingerprint: &Fingerprint| self.held.holder(fingerprint.id(parameters)).is_some();
        let solved_otherwise = self.others.iter().find(|(_, fingerprint)| known(fingerprint));
        match solved_otherwise {
            Some((differences, _)) => State::Stale(format!("solved with {differences}")),
            None => State::New,
        }
    }

    /// In how many forms a problem is stored.
    fn stored(&self, id: CaseId, parameters: &Parameters) -> u64 {
        let known = |id| u64::from(self.held.holder(id).is_some());
        known(id) + self.others.iter().map(|(_, fingerprint)| known(fingerprint.id(parameters))).sum::<u64>()
    }
}
