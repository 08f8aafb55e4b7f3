//! Running a sweep, or a part of it: what is missing is solved and stored, and the whole is published.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::failures::first_failures;
use super::merge::join_all;
use super::open_store::open_store;
use super::publication::publish;
use super::refinement::refinements;
use super::solving::{Solving, group_wait, queue_length};
use super::sweep_directory::{had_other_sweep, part_directories, part_directory, previous_sweep};
use super::{CampaignError, Event, FailedCase, MergedCatalog, Observer, Pending, SweepDirectory, check_available};
use crate::engine::Engine;
use crate::store::{Catalog, Ending, Inspection, Published, Store, StoreError};
use crate::{Part, Plan, Sweep};
use stribeck_solver::Interrupt;

/// How a sweep is run. None of it changes a number or a published byte.
#[derive(Clone, Debug)]
pub struct RunOptions {
    /// Solver threads; by default one for each core.
    pub threads: NonZeroUsize,
    /// The part that is solved; `None`, the default, for the whole sweep, which is published.
    pub part: Option<Part>,
    /// The most failed cases that [`RunReport::failures`] lists; by default 5.
    pub listed_failures: usize,
    /// A request through it stops the run soon, and what is finished is stored.
    pub interrupt: Arc<Interrupt>,
}

impl Default for RunOptions {
    fn default() -> Self {
        Self { threads: available_threads(), part: None, listed_failures: 5, interrupt: Arc::default() }
    }
}

/// The number of cores that this process may use.
pub fn available_threads() -> NonZeroUsize {
    // Where the system does not tell its cores there is at least the one that runs this.
    std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN)
}

/// What a run did.
#[derive(Clone, Debug)]
pub struct RunReport {
    /// The directory of the results: the one that was given, or that of the part.
    pub directory: PathBuf,
    /// What was left when the run began.
    pub pending: Pending,
    /// How the run ended.
    pub outcome: RunOutcome,
    /// The first failed cases in the order of the plan, if the run was not interrupted.
    pub failures: Vec<FailedCase>,
}

/// How a run ended.
#[derive(Clone, Debug)]
pub enum RunOutcome {
    /// All cases of the sweep are solved and published.
    Published(Published),
    /// All cases of a part are solved; [`merge`](super::merge()) publishes the parts together.
    PartSolved {
        /// The part.
        part: Part,
        /// What is stored of it.
        done: Pending,
    },
    /// The run was asked to stop. The same call resumes it.
    Interrupted {
        /// What is stored, and what is left.
        left: Pending,
    },
}

/// Runs a sweep into a results directory, or resumes it: solves the cases that are not stored yet, then publishes.
///
/// Cases are stored soon after they are solved, so that nothing is solved twice after an interruption. The whole sweep
/// takes over what its parts have solved. A part works in a directory of its own below `directory`, and publishes
/// nothing.
///
/// # Errors
/// [`CampaignError::Stopped`] if the disk or a file ended the run while it worked, other variants if it could not
/// begin. Failed cases are no error: [`Published::failed`] counts them.
pub fn run(
    sweep: &Sweep,
    directory: &Path,
    options: &RunOptions,
    observe: &mut Observer<'_>,
) -> Result<RunReport, CampaignError> {
    let (part, plan) = (options.part, Plan::new(sweep));
    let engine = engine(sweep, options)?;
    // Before anything is made in it: what a part solves is to be merged there.
    check_available(directory)?;
    let home = part.map_or_else(|| directory.to_owned(), |part| part_directory(directory, part));
    let other_sweep = had_other_sweep(&home, sweep);
    let before = if other_sweep { previous_sweep(&home) } else { None };
    let mut store = open_store(&home, sweep, &plan, observe)?;
    let elsewhere = stored_elsewhere(directory, sweep, part, &mut store, observe)?;
    let elsewhere = elsewhere.catalogs();
    let survey = |store: &Store| Pending::survey(sweep, &plan, part, &with(store, &elsewhere));
    let pending = survey(&store);
    if other_sweep {
        let found = before.map_or_else(Vec::new, |before| refinements(&before, sweep, &with(&store, &elsewhere)));
        observe(Event::OtherSweep { directory: &home, pending: &pending, refinements: &found });
    }
    let (threads, interrupt) = (options.threads, &*options.interrupt);
    let solving = Solving { sweep, plan: &plan, pending: &pending, threads, interrupt };
    let ended = solving.solve(&engine, &mut store, observe).and_then(|ending| match (ending, part) {
        (Ending::Interrupted, _) => Ok(RunOutcome::Interrupted { left: survey(&store) }),
        (Ending::Completed, Some(part)) => Ok(RunOutcome::PartSolved { part, done: survey(&store) }),
        (Ending::Completed, None) => {
            observe(Event::Publishing);
            engine.install(|| publish(sweep, &plan, &mut store)).map(RunOutcome::Published)
        }
    });
    let outcome = match ended {
        Ok(outcome) => outcome,
        Err(source) => return Err(CampaignError::Stopped { source, directory: home, left: Box::new(survey(&store)) }),
    };
    let failures = failures(&outcome, &plan, &store, options.listed_failures)?;
    Ok(RunReport { directory: home, pending, outcome, failures })
}

/// The threads of a run, with the queue in which finished chains wait for the disk.
fn engine(sweep: &Sweep, options: &RunOptions) -> Result<Engine, CampaignError> {
    let engine = Engine::new(options.threads)?.with_queue(queue_length(options.threads, options.part, &sweep.output));
    Ok(match options.part {
        Some(part) => engine.with_group_wait(group_wait(part)),
        None => engine,
    })
}

/// What is stored beside the directory of a run. The whole takes it over from its parts, so that nothing is left
/// elsewhere. A part finds cases of the whole and of other splits; those of its own split are cases of other parts.
fn stored_elsewhere(
    directory: &Path,
    sweep: &Sweep,
    part: Option<Part>,
    store: &mut Store,
    observe: &mut Observer<'_>,
) -> Result<SweepDirectory, CampaignError> {
    if let Some(part) = part {
        let other_split = |other: Part| other.of() != part.of();
        return SweepDirectory::read_parts(directory, &sweep.into(), Inspection::Bytes, other_split);
    }
    // A part that has only just begun holds nothing yet.
    let parts = part_directories(directory)?.into_iter().filter(|part| part.join("log").is_dir());
    let joined = join_all(parts, sweep, store, observe)?;
    if joined.cases > 0 {
        observe(Event::TookOver(joined));
    }
    Ok(SweepDirectory::default())
}

/// A store and what is stored elsewhere, as one.
fn with<'a>(store: &'a Store, elsewhere: &[&'a Catalog]) -> MergedCatalog<'a> {
    MergedCatalog::new(std::iter::once(&**store).chain(elsewhere.iter().copied()).collect())
}

fn failures(outcome: &RunOutcome, plan: &Plan, store: &Store, most: usize) -> Result<Vec<FailedCase>, StoreError> {
    match outcome {
        RunOutcome::Published(published) if published.failed > 0 => first_failures(plan, None, store, most),
        RunOutcome::PartSolved { part, done } if done.failed > 0 => first_failures(plan, Some(*part), store, most),
        RunOutcome::Published(_) | RunOutcome::PartSolved { .. } | RunOutcome::Interrupted { .. } => Ok(Vec::new()),
    }
}
