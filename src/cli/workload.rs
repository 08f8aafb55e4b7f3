//! What of a plan is left to do.

use crate::model::CaseId;
use crate::store::Status;
use crate::sweep::Plan;

/// What of a plan is done, and what is left. Counts are of distinct cases.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Workload {
    /// Chains that lack a case, by their place in [`Plan::chains`].
    pub pending: Vec<u32>,
    /// Cases of these chains, those that are held already included: they seed the others.
    pub pending_cases: u64,
    /// Cases that are not held.
    pub new: u64,
    /// Cases that are held and converged.
    pub converged: u64,
    /// Cases that are held and failed; they are not tried again.
    pub failed: u64,
}

impl Workload {
    /// Asks for each case of the plan what became of it.
    pub fn survey(plan: &Plan, held: impl Fn(CaseId) -> Option<Status>) -> Self {
        let mut workload = Self::default();
        for (index, chain) in (0..).zip(plan.chains()) {
            let before = workload.new;
            for id in plan.ids(&chain) {
                match held(id) {
                    None => workload.new += 1,
                    Some(Status::Converged) => workload.converged += 1,
                    Some(Status::Failed) => workload.failed += 1,
                }
            }
            if workload.new > before {
                workload.pending.push(index);
                workload.pending_cases += chain.beta.len() as u64;
            }
        }
        workload
    }

    /// Cases that are held.
    pub fn reused(&self) -> u64 {
        self.converged + self.failed
    }
}
