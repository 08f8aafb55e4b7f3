//! Which cases of a plan are left to be solved, and why.

use std::collections::HashMap;

use super::stale::{CaseState, Survey};
use super::{MergedCatalog, StaleReason};
use crate::store::Status;
use crate::{Method, Part, Plan, Sweep};

/// What of a plan is done, and what is left. Counts are of distinct cases.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pending {
    /// Chains that lack a case, by their place in [`Plan::chains`].
    pub chains: Vec<u32>,
    /// Of the pending chains that have other cases, which ones are missing: a bit for each.
    partly: HashMap<u32, u64>,
    /// Cases that have to be computed: those that are stored then, and those that only seed them.
    pub to_compute: u64,
    /// Cases that were never solved.
    pub new: u64,
    /// Cases that are stored and of no use, by the reason: they are solved again.
    pub stale: Vec<StaleCases>,
    /// Cases that are stored and converged.
    pub converged: u64,
    /// Cases that are stored and failed; they are not tried again.
    pub failed: u64,
    /// Cases that are stored and have no place in the sweep.
    pub unplaced: u64,
}

/// Stored cases that are of no use for the same reason.
#[derive(Clone, Debug, PartialEq)]
pub struct StaleCases {
    /// The reason.
    pub reason: StaleReason,
    /// How many cases there are.
    pub cases: u64,
}

impl Pending {
    /// Asks for each case of the plan, or of a part of it, whether it is stored. Where nothing is stored there is
    /// nothing to ask, which makes the plan of a billion cases quick.
    pub fn survey(sweep: &Sweep, plan: &Plan, part: Option<Part>, stored: &MergedCatalog<'_>) -> Self {
        let chains = plan.chains_of(part);
        if stored.known() == 0 {
            return Self::all(plan, chains);
        }
        let survey = Survey::new(sweep, plan, stored);
        let mut pending = Self::default();
        let mut in_place = 0;
        for index in chains {
            let chain = plan.chain(index as usize);
            let mut missing = 0_u64;
            for (place, parameters) in plan.parameters(&chain).iter().enumerate() {
                let id = plan.id(parameters);
                in_place += survey.forms(id, parameters);
                let state = survey.state(id, parameters);
                missing |= u64::from(!matches!(state, CaseState::Done(_))) << place;
                pending.count(state);
            }
            if missing != 0 {
                pending.chains.push(index);
                if missing.count_ones() as usize != chain.cases.len() {
                    pending.partly.insert(index, missing);
                }
                pending.to_compute += pending.places(plan, index).len() as u64;
            }
        }
        pending.stale.sort_by_cached_key(|stale| stale.reason.to_string());
        pending.unplaced = stored.known() - in_place;
        pending
    }

    /// All cases of these chains.
    fn all(plan: &Plan, chains: Vec<u32>) -> Self {
        let cases = chains.iter().map(|&index| plan.chain(index as usize).cases.len() as u64).sum();
        Self { chains, to_compute: cases, new: cases, ..Self::default() }
    }

    fn count(&mut self, state: CaseState) {
        match state {
            CaseState::Done(Status::Converged) => self.converged += 1,
            CaseState::Done(Status::Failed) => self.failed += 1,
            CaseState::New => self.new += 1,
            CaseState::Stale(reason) => match self.stale.iter_mut().find(|stale| stale.reason == reason) {
                Some(stale) => stale.cases += 1,
                None => self.stale.push(StaleCases { reason, cases: 1 }),
            },
        }
    }

    /// The number of cases that are stored and used.
    pub fn reused(&self) -> u64 {
        self.converged + self.failed
    }

    /// The number of cases that are stored and solved again.
    pub fn stale_cases(&self) -> u64 {
        self.stale.iter().map(|stale| stale.cases).sum()
    }

    /// The number of cases that were given up at a shorter time limit: they failed, and are solved again.
    pub fn given_up(&self) -> u64 {
        let given_up = self.stale.iter().filter(|stale| matches!(stale.reason, StaleReason::TimeLimit { .. }));
        given_up.map(|stale| stale.cases).sum()
    }

    /// The number of cases to be solved and stored.
    pub fn to_do(&self) -> u64 {
        self.new + self.stale_cases()
    }

    /// True if a case of a pending chain is to be stored.
    pub fn is_missing(&self, index: u32, place: usize) -> bool {
        self.partly.get(&index).is_none_or(|missing| missing >> place & 1 == 1)
    }

    /// The cases of a pending chain that have to be computed, by their places in it and in their order.
    ///
    /// These are the missing ones and, where a method is slow to start anew, those before them, which seed them. They
    /// keep what is stored of them.
    pub fn places(&self, plan: &Plan, index: u32) -> Vec<usize> {
        let length = plan.chain(index as usize).cases.len();
        let mut missing = (0..length).filter(|&place| self.is_missing(index, place));
        match plan.recipe().solver.method() {
            Method::Collocation => missing.collect(),
            Method::Relaxation => (0..=missing.next_back().unwrap_or(0)).collect(),
        }
    }
}
