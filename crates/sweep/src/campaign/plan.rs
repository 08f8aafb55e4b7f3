//! What a run would do, without doing it.

use std::num::NonZeroUsize;
use std::path::Path;

use super::free_space::free_space;
use super::refinement::refinements;
use super::sweep_directory::{check_directory, had_other_sweep, previous_sweep};
use super::{CampaignError, Cost, Pending, Refinement, SweepDirectory, available_threads, check_available};
use crate::store::{Inspection, Warning};
use crate::{Plan, Sweep};

/// How a plan is made.
#[derive(Clone, Copy, Debug)]
pub struct PlanOptions {
    /// The solver threads that the time is told for; by default one for each core.
    pub threads: NonZeroUsize,
    /// How closely stored files are looked at; by default as closely as a run does.
    pub inspection: Inspection,
}

impl Default for PlanOptions {
    fn default() -> Self {
        Self { threads: available_threads(), inspection: Inspection::Bytes }
    }
}

/// What a run would do.
#[derive(Clone, Debug)]
pub struct PlanReport {
    /// The cases of the sweep, and the chains they are solved in.
    pub plan: Plan,
    /// What the results directory was used for before.
    pub directory: DirectoryState,
    /// What is done, and what is left.
    pub pending: Pending,
    /// Numbers of points that would keep what the sweep before has, if this one does not.
    pub refinements: Vec<Refinement>,
    /// What a run is expected to take; `None` if nothing is left to be solved.
    pub cost: Option<Cost>,
    /// Bytes that are free on the disk of the results directory; `None` where the system does not tell.
    pub free: Option<u64>,
    /// What is damaged and not used.
    pub warnings: Vec<Warning>,
}

/// What a results directory was used for before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectoryState {
    /// It has no results.
    Empty,
    /// It has results of this sweep.
    SameSweep,
    /// It was last run with another sweep file.
    OtherSweep,
}

/// Says what [`run`](super::run()) would do with a sweep and a results directory. Writes nothing.
///
/// A few cases are solved to estimate the time, where no log tells it.
///
/// # Errors
/// [`CampaignError`] if a run could not begin there, or if the directory cannot be read.
pub fn plan(sweep: &Sweep, directory: &Path, options: &PlanOptions) -> Result<PlanReport, CampaignError> {
    check_directory(directory)?;
    let plan = Plan::new(sweep);
    let found = SweepDirectory::read(directory, sweep, options.inspection)?;
    if found.whole.is_none() {
        check_available(directory)?;
    }
    let stored = found.merged();
    let pending = Pending::survey(sweep, &plan, None, &stored);
    let cost = (pending.to_do() > 0).then(|| Cost::expected(sweep, &plan, &pending, &stored, options.threads));
    let free = free_space(directory);
    let directory_state = match found.is_empty() {
        true => DirectoryState::Empty,
        false if had_other_sweep(directory, sweep) => DirectoryState::OtherSweep,
        false => DirectoryState::SameSweep,
    };
    let before = if directory_state == DirectoryState::OtherSweep { previous_sweep(directory) } else { None };
    let refinements = before.map_or_else(Vec::new, |before| refinements(&before, sweep, &stored));
    let warnings = stored.catalogs().iter().flat_map(|catalog| catalog.warnings()).cloned().collect();
    Ok(PlanReport { plan, directory: directory_state, pending, refinements, cost, free, warnings })
}
