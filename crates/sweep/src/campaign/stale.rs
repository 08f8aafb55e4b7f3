//! What a case of a plan is to the cases that are stored.

use std::fmt;

use super::MergedCatalog;
use crate::CaseId;
use crate::store::Status;
use crate::{Fingerprint, Plan, Recipe, Sweep};
use stribeck_solver::{Parameters, shortest};

/// Why a case that is stored is of no use to a sweep, so that it is solved again.
#[derive(Clone, Debug, PartialEq)]
pub enum StaleReason {
    /// It was given up at a shorter time limit than that of the sweep.
    TimeLimit {
        /// The limit at which it was given up, in seconds.
        then: f64,
        /// The limit of the sweep, in seconds.
        now: f64,
    },
    /// It is stored without something that the sweep asks for.
    Lacks(Vec<&'static str>),
    /// It was solved with another recipe.
    OtherRecipe {
        /// The recipe it was solved with.
        then: Box<Recipe>,
        /// The recipe of the sweep.
        now: Box<Recipe>,
    },
}

impl fmt::Display for StaleReason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TimeLimit { then, now } => {
                write!(formatter, "given up at the time limit of {} s, now {}", shortest(*then), shortest(*now))
            }
            Self::Lacks(what) => write!(formatter, "stored without {}", what.join(", ")),
            Self::OtherRecipe { then, now } => write!(formatter, "solved with {}", then.differences(now)),
        }
    }
}

/// What a case is to a sweep.
pub(super) enum CaseState {
    /// It is stored, and used.
    Done(Status),
    /// It is stored, and solved again.
    Stale(StaleReason),
    /// It was never solved.
    New,
}

/// Compares cases of a plan with those that are stored.
pub(super) struct Survey<'a> {
    stored: &'a MergedCatalog<'a>,
    recipe: Recipe,
    time_limit: f64,
    /// The other recipes that stored cases were solved with, and the ids they give.
    others: Vec<(Recipe, Fingerprint)>,
}

impl<'a> Survey<'a> {
    pub(super) fn new(sweep: &Sweep, plan: &Plan, stored: &'a MergedCatalog<'a>) -> Self {
        // A recipe that does not read is one of a method or setting that this version does not know: its cases are of
        // no use, and no case here can be told to be one of them.
        let all = stored.catalogs().iter().flat_map(|catalog| catalog.recipes());
        let mut recipes: Vec<Recipe> = Vec::new();
        for recipe in all.filter_map(|recipe| serde_json::from_value(recipe.clone()).ok()) {
            if recipe != *plan.recipe() && !recipes.contains(&recipe) {
                recipes.push(recipe);
            }
        }
        let others = recipes.into_iter().map(|recipe| (recipe, Fingerprint::new(&recipe))).collect();
        Self { stored, recipe: *plan.recipe(), time_limit: sweep.solver.time_limit, others }
    }

    pub(super) fn state(&self, id: CaseId, parameters: &Parameters) -> CaseState {
        let holder = self.stored.holder(id);
        match holder.map_or((None, None), |catalog| (catalog.holds(id), catalog.time_limit(id))) {
            (Some(Status::Failed), Some(then)) if then < self.time_limit => {
                return CaseState::Stale(StaleReason::TimeLimit { then, now: self.time_limit });
            }
            (Some(status), _) => return CaseState::Done(status),
            (None, _) => {}
        }
        if let Some(catalog) = holder {
            return CaseState::Stale(StaleReason::Lacks(catalog.lacks(id)));
        }
        let known = |fingerprint: &Fingerprint| self.stored.holder(fingerprint.id(parameters)).is_some();
        match self.others.iter().find(|(_, fingerprint)| known(fingerprint)) {
            Some((then, _)) => {
                let (then, now) = (Box::new(*then), Box::new(self.recipe));
                CaseState::Stale(StaleReason::OtherRecipe { then, now })
            }
            None => CaseState::New,
        }
    }

    /// In how many forms a problem is stored: solved with this recipe, and with others.
    pub(super) fn forms(&self, id: CaseId, parameters: &Parameters) -> u64 {
        let known = |id| u64::from(self.stored.holder(id).is_some());
        known(id) + self.others.iter().map(|(_, fingerprint)| known(fingerprint.id(parameters))).sum::<u64>()
    }
}
