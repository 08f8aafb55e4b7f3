//! The work of a run: solving what is pending, then publishing.

use std::num::NonZeroUsize;
use std::time::Duration;

use super::CliError;
use super::entry::{case_entry, panicked};
use super::workload::Workload;
use stribeck_solver::{Interrupt, Output, Parameters, Solver};
use stribeck_sweep::engine::{Engine, Finished, Progress, ProgressStyle, Report};
use stribeck_sweep::store::{Ending, Point, Publication, Published, Store, StoreError};
use stribeck_sweep::{Field, GridIndex, MAX_CHAIN, Part, Plan, Sweep};

/// Finished chains that may wait to be written, for each thread: some tenths of a second where chains are quick.
const WAITING_CHAINS: usize = 8;

/// The same for a part of a sweep, whatever its threads.
const PART_CHAINS: usize = 64;

/// Time between the commits of all parts, and the longest between those of one.
const COMMIT_INTERVAL: Duration = Duration::from_millis(100);
const LONGEST_WAIT: Duration = Duration::from_secs(10);

/// Values of fields that may wait to be written: 32 MB.
const WAITING_FIELD_VALUES: usize = 1 << 22;

/// What a run has to do, and with what.
pub struct Job<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Its plan.
    pub plan: &'a Plan,
    /// What of it is left.
    pub workload: &'a Workload,
    /// Threads.
    pub threads: NonZeroUsize,
    /// Whether the user asks to stop.
    pub interrupt: &'a Interrupt,
    /// How progress is shown.
    pub progress: ProgressStyle,
}

impl Job<'_> {
    /// Solves the pending chains, and says so in the log; nothing if there are none.
    ///
    /// # Errors
    /// [`CliError`] of the disk or the system. What was committed before stays.
    pub fn solve(&self, engine: &Engine, store: &mut Store) -> Result<Ending, CliError> {
        if self.workload.pending.is_empty() {
            return Ok(Ending::Completed);
        }
        let ending =
            if self.solve_pending(engine, store)?.interrupted { Ending::Interrupted } else { Ending::Completed };
        store.end(ending)?;
        Ok(ending)
    }

    /// Solves the pending chains and commits them soon after they finish.
    fn solve_pending(&self, engine: &Engine, store: &mut Store) -> Result<Report, CliError> {
        let Self { sweep, plan, workload, interrupt, .. } = *self;
        store.begin(&sweep.name, workload.to_do(), self.threads.get() as u64)?;
        let solver = Solver::new(&sweep.solver_settings());
        let output = &sweep.output;
        let cases = |&index: &u32| -> Vec<Parameters> {
            let chain = plan.parameters(&plan.chain(index as usize));
            workload.places(plan, index).into_iter().map(|place| chain[place].clone()).collect()
        };
        let progress = Progress::start(workload.to_do(), "cases", self.progress)
            .map_err(|source| CliError::System { action: "start the thread that shows progress", source })?;
        let report = engine.run(
            &workload.pending,
            interrupt,
            |index, interrupt| solver.solve_chain(&cases(index), interrupt),
            |index, message| panicked(&cases(index), output, message),
            |group| -> Result<(), StoreError> {
                let mut entries = Vec::new();
                for Finished { chain: &index, cases: solved, .. } in group {
                    let chain = plan.parameters(&plan.chain(index as usize));
                    for (place, case) in workload.places(plan, index).into_iter().zip(solved) {
                        // Cases that are held seeded the others; they keep the bytes they have.
                        if workload.is_missing(index, place) {
                            progress.count_case(case.outcome.is_ok());
                            entries.push(case_entry(plan, &chain[place], case));
                        }
                    }
                }
                store.commit(&entries)
            },
        )?;
        Ok(report)
    }
}

/// Finished chains that may wait for a slow disk: some for each thread, of a part as many as make a large commit, fewer where
/// their fields would take much memory.
pub fn queue_length(threads: usize, part: Option<Part>, output: &Output) -> usize {
    let field_values = MAX_CHAIN * Field::selected(output.fields).count() * output.x.len();
    let chains = WAITING_CHAINS * threads;
    let chains = if part.is_some() { chains.max(PART_CHAINS) } else { chains };
    chains.min(WAITING_FIELD_VALUES / field_values.max(1))
}

/// How long finished chains of a part wait to be committed together: so long that all parts make about ten commits a second for
/// the file system they share, but no longer than it may be a pity to lose.
pub fn group_wait(part: Part) -> Duration {
    (COMMIT_INTERVAL * part.of()).min(LONGEST_WAIT)
}

/// Publishes a sweep whose cases are all stored.
pub fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    let point = |place: GridIndex| Point {
        case: plan.case_at(place),
        numbers: sweep.grid.numbers(place),
        experiment: sweep.grid.experiment(place),
    };
    let row = |row: usize| sweep.grid.shape().row(row).map(point).collect();
    let dimensions = sweep.grid.dimensions();
    store.publish(&Publication { title: &sweep.title, sweep_text: &sweep.text, dimensions: &dimensions, row: &row })
}
