//! What of a plan is left to do.

use crate::store::{Counts, Holdings, Inspection, Status};
use crate::sweep::Plan;

/// How closely a command looks at what is stored: as closely as a run does, unless it is to be quick.
pub fn inspection(quick: bool) -> Inspection {
    if quick { Inspection::Size } else { Inspection::Bytes }
}

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
    /// Asks for each case of the plan what became of it. Where nothing is held there is nothing to ask, which makes the
    /// plan of a billion cases quick.
    pub fn survey(plan: &Plan, held: Option<&Holdings>) -> Self {
        let Some(held) = held.filter(|held| held.counts() != Counts::default()) else { return Self::all(plan) };
        let mut workload = Self::default();
        for (index, chain) in (0..).zip(plan.chains()) {
            let before = workload.new;
            for id in plan.ids(&chain) {
                match held.holds(id) {
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

    /// All of the plan.
    fn all(plan: &Plan) -> Self {
        let chains = u32::try_from(plan.chain_count()).expect("a sweep has at most 10^9 cases");
        let cases = plan.problems() as u64;
        Self { pending: (0..chains).collect(), pending_cases: cases, new: cases, ..Self::default() }
    }

    /// Cases that are held.
    pub fn reused(&self) -> u64 {
        self.converged + self.failed
    }
}
