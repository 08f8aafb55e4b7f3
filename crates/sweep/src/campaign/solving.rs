//! The work of a run: solving the chains that are pending, and storing what comes of them.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::time::Duration;

use super::entry::{case_entry, panicked};
use super::{CampaignError, Event, Observer, Pending};
use crate::engine::{Engine, Finished, Report, Solved};
use crate::store::{CaseEntry, Contents, Ending, PackedCase, Status, Store, StoreError};
use crate::{CaseId, Field, MAX_CHAIN, Part, Plan, Sweep};
use stribeck_solver::{Interrupt, Output, Parameters, SolvedCase, Solver};

/// Finished chains that may wait to be written, for each thread: some tenths of a second where chains are quick.
const WAITING_CHAINS: usize = 8;

/// The same for a part of a sweep, whatever its threads.
const PART_CHAINS: usize = 64;

/// Time between the commits of all parts, and the longest between those of one.
const COMMIT_INTERVAL: Duration = Duration::from_millis(100);
const LONGEST_WAIT: Duration = Duration::from_secs(10);

/// Values of fields that may wait to be written, packed: 32 MB at most.
const WAITING_FIELD_VALUES: usize = 1 << 22;

/// What a run solves, and how.
pub(super) struct Solving<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Its plan.
    pub plan: &'a Plan,
    /// What of the plan is left.
    pub pending: &'a Pending,
    /// The solver threads, for the log.
    pub threads: NonZeroUsize,
    /// Whether the run is to stop.
    pub interrupt: &'a Interrupt,
}

impl Solving<'_> {
    /// Solves the pending chains, and says so in the log; does nothing if there are none.
    ///
    /// # Errors
    /// [`StoreError`] if the disk fails. What was committed before stays.
    pub(super) fn solve(
        &self,
        engine: &Engine,
        store: &mut Store,
        observe: &mut Observer<'_>,
    ) -> Result<Ending, StoreError> {
        if self.pending.chains.is_empty() {
            return Ok(Ending::Completed);
        }
        let cases = self.pending.to_do();
        store.begin(&self.sweep.name, cases, self.threads.get() as u64)?;
        observe(Event::Solving { cases });
        let report = self.solve_chains(engine, store, observe)?;
        let ending = if report.interrupted { Ending::Interrupted } else { Ending::Completed };
        store.end(ending)?;
        Ok(ending)
    }

    /// Solves the pending chains and commits them soon after they finish.
    fn solve_chains(
        &self,
        engine: &Engine,
        store: &mut Store,
        observe: &mut Observer<'_>,
    ) -> Result<Report, StoreError> {
        let solver = Solver::new(&self.sweep.solver_settings());
        let output = &self.sweep.output;
        let contents = Contents::of(self.sweep);
        let pack = |index, cases| self.packed_missing(index, cases, &contents);
        engine.run(
            &self.pending.chains,
            self.interrupt,
            |&index, interrupt| Ok(pack(index, solver.solve_chain(&self.cases(index), interrupt)?)),
            |&index, message| pack(index, panicked(&self.cases(index), output, message)),
            |group| {
                let cases: Vec<PackedCase> = group.into_iter().flat_map(|finished| finished.cases).collect();
                store.commit_packed(&cases)?;
                let converged = cases.iter().filter(|case| case.is_converged()).count() as u64;
                observe(Event::Committed { converged, failed: cases.len() as u64 - converged });
                Ok(())
            },
        )
    }

    /// The cases of a pending chain that have to be computed.
    fn cases(&self, index: u32) -> Vec<Parameters> {
        let chain = self.plan.parameters(&self.plan.chain(index as usize));
        self.pending.places(self.plan, index).into_iter().map(|place| chain[place].clone()).collect()
    }

    /// What is stored of a finished chain. Cases that are stored already seeded the others; they keep the bytes they
    /// have.
    fn packed_missing(&self, index: u32, cases: Vec<SolvedCase>, contents: &Contents) -> Vec<PackedCase> {
        let chain = self.plan.parameters(&self.plan.chain(index as usize));
        let solved = self.pending.places(self.plan, index).into_iter().zip(cases);
        let missing = solved.filter(|(place, _)| self.pending.is_missing(index, *place));
        missing.map(|(place, case)| PackedCase::new(case_entry(self.plan, &chain[place], case), contents)).collect()
    }
}

impl Solved for PackedCase {
    fn is_converged(&self) -> bool {
        self.entry().outcome == Status::Converged
    }
}

/// The number of finished chains that may wait for a slow disk: some for each thread, of a part as many as make a large
/// commit, fewer where their fields would take much memory.
pub(super) fn queue_length(threads: NonZeroUsize, part: Option<Part>, output: &Output) -> usize {
    let field_values = MAX_CHAIN * Field::selected(output.fields).count() * output.x.len();
    let chains = WAITING_CHAINS * threads.get();
    let chains = if part.is_some() { chains.max(PART_CHAINS) } else { chains };
    chains.min(WAITING_FIELD_VALUES / field_values.max(1))
}

/// The time for which finished chains of a part wait to be committed together: so long that all parts make about ten
/// commits a second for the file system they share, but no longer than it may be a pity to lose.
pub(super) fn group_wait(part: Part) -> Duration {
    (COMMIT_INTERVAL * part.of()).min(LONGEST_WAIT)
}

/// What came of a sweep that was solved in memory.
#[derive(Clone, Debug)]
pub enum InMemory {
    /// All cases.
    Solved(HashMap<CaseId, CaseEntry>),
    /// The run was asked to stop.
    Interrupted,
}

/// Solves every case of a sweep and stores nothing: all results are kept in memory. A request through `interrupt`
/// ends it soon.
///
/// # Errors
/// [`CampaignError::Threads`] if the system does not start so many threads.
pub fn solve_in_memory(sweep: &Sweep, threads: NonZeroUsize, interrupt: &Interrupt) -> Result<InMemory, CampaignError> {
    let (plan, solver, output) = (Plan::new(sweep), Solver::new(&sweep.solver_settings()), &sweep.output);
    let chains: Vec<_> = plan.chains().collect();
    let mut entries = HashMap::new();
    let report = Engine::new(threads)?.run(
        &chains,
        interrupt,
        |chain, interrupt| solver.solve_chain(&plan.parameters(chain), interrupt),
        |chain, message| panicked(&plan.parameters(chain), output, message),
        |group| -> Result<(), CampaignError> {
            for Finished { chain, cases, .. } in group {
                let parameters = plan.parameters(chain);
                let solved = parameters.iter().zip(cases).map(|(case, solved)| case_entry(&plan, case, solved));
                entries.extend(solved.map(|entry| (entry.id, entry)));
            }
            Ok(())
        },
    )?;
    Ok(if report.interrupted { InMemory::Interrupted } else { InMemory::Solved(entries) })
}
