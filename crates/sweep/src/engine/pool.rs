//! The pool of threads over chains, and the one writer behind it.

use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use crate::MAX_CHAIN;
use stribeck_solver::continuation::{Interrupt, Interrupted, SolvedCase, panic_message};

/// Cases at which a group of finished chains is committed without looking for more.
pub(crate) const GROUP_CASES: usize = 4096;

/// How long a finished chain waits for others to be committed with, unless [`Engine::with_group_wait`] says otherwise.
/// A commit waits for the disk several times, however little it brings there; this is the time in which a kill loses
/// more than the chains at work.
pub(crate) const GROUP_WAIT: Duration = Duration::from_millis(100);

/// A pool of threads that solves chains.
#[derive(Debug)]
pub struct Engine {
    pool: rayon::ThreadPool,
    queue_length: usize,
    group_wait: Duration,
}

/// The threads of an [`Engine`] could not be started.
#[derive(Debug, thiserror::Error)]
#[error("cannot start {threads} solver threads: {source}; ask for fewer threads")]
pub struct ThreadsError {
    /// How many were wanted.
    pub threads: NonZeroUsize,
    source: rayon::ThreadPoolBuildError,
}

/// What became of a run. All counts are of what was committed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Cases that converged.
    pub converged: usize,
    /// Cases that failed, those of chains whose solver panicked included.
    pub failed: usize,
    /// Chains whose solver panicked.
    pub panicked_chains: usize,
    /// True if chains are left undone because of an interruption.
    pub interrupted: bool,
}

/// What comes of a case.
pub trait Solved: Send {
    /// True if it converged.
    fn is_converged(&self) -> bool;
}

impl Solved for SolvedCase {
    fn is_converged(&self) -> bool {
        self.outcome.is_ok()
    }
}

/// A finished chain.
#[derive(Debug)]
pub struct Finished<'a, C, S> {
    /// The chain.
    pub chain: &'a C,
    /// What came of its cases.
    pub cases: Vec<S>,
    /// Its place among the chains.
    place: usize,
    panicked: bool,
}

impl Engine {
    /// An engine with `threads` solver threads and room for as many finished chains in its queue.
    ///
    /// # Errors
    /// [`ThreadsError`] if the system does not give that many.
    pub fn new(threads: NonZeroUsize) -> Result<Self, ThreadsError> {
        Ok(Self { pool: solver_threads(threads)?, queue_length: threads.get(), group_wait: GROUP_WAIT })
    }

    /// The engine with room for at least `chains` finished chains in its queue: a longer one keeps the solver threads
    /// at work through longer pauses of the disk.
    #[must_use]
    pub fn with_queue(self, chains: usize) -> Self {
        Self { queue_length: self.queue_length.max(chains), ..self }
    }

    /// The engine with another time that a finished chain may wait for others to be committed with. An interruption,
    /// and the end of the run, end the waiting.
    #[must_use]
    pub fn with_group_wait(self, group_wait: Duration) -> Self {
        Self { group_wait, ..self }
    }

    /// Does work on the threads of the engine, between runs.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// Number of finished chains that may wait for the writer in its queue.
    ///
    /// Besides these, each solver thread may hold one that does not fit, and the writer in the group it commits as many
    /// cases as a queue of long chains has: that is all that is ever finished and not committed, however many chains
    /// there are.
    pub fn queue_length(&self) -> usize {
        self.queue_length
    }

    /// Solves `chains`, started in their order, and commits them soon after they finish, in groups.
    ///
    /// - `solve` is called once for each chain, on a solver thread. What else is to be done with its cases before they
    ///   are written, it does there. It gives up with [`Interrupted`] soon after `interrupt` is requested; what it
    ///   finished nevertheless is committed.
    /// - `panicked` makes failed cases of a chain whose solver panicked, from the message of the panic. They are
    ///   committed like any others, and the other chains go on.
    /// - `commit` is called on the calling thread only, so it needs no lock. It gets the chains that finished since it
    ///   was called last, in the order of `chains`: at least one, and what is there a tenth of a second (or as long as
    ///   the engine is told to wait) after the first. Which chains are in one group depends on timing.
    ///
    /// # Errors
    /// The first error of `commit`. It ends the run: `interrupt` is requested so that solvers at work give up, and no
    /// chain is started or committed after it.
    pub fn run<C: Sync, S: Solved, E>(
        &self,
        chains: &[C],
        interrupt: &Interrupt,
        solve: impl Fn(&C, &Interrupt) -> Result<Vec<S>, Interrupted> + Sync,
        panicked: impl Fn(&C, &str) -> Vec<S> + Sync,
        mut commit: impl FnMut(Vec<Finished<'_, C, S>>) -> Result<(), E>,
    ) -> Result<Report, E> {
        // Rayon gives no order among its jobs and lets a waiting job steal another. So its jobs are not the chains but
        // one loop for each thread, and the loops share a counter.
        let next = AtomicUsize::new(0);
        let solver_loop = |finished: SyncSender<_>| {
            while !interrupt.requested() {
                let place = next.fetch_add(1, Ordering::Relaxed);
                let Some(chain) = chains.get(place) else { return };
                let Ok((cases, panicked)) = solve_one(chain, interrupt, &solve, &panicked) else { continue };
                if finished.send(Finished { chain, cases, place, panicked }).is_err() {
                    return; // The writer has stopped; its error is on the way to the caller.
                }
            }
        };
        let solver_loop = &solver_loop;
        let (sender, receiver) = sync_channel(self.queue_length());
        self.pool.in_place_scope(move |scope| {
            for _ in 0..self.pool.current_num_threads() {
                let sender = sender.clone();
                scope.spawn(move |_| solver_loop(sender));
            }
            drop(sender);

            let mut report = Report::default();
            let mut chains_left = chains.len();
            while let Some(group) = next_group(&receiver, self.queue_length, self.group_wait) {
                let mut after = report;
                for Finished { cases, panicked, .. } in &group {
                    let converged = cases.iter().filter(|case| case.is_converged()).count();
                    after.converged += converged;
                    after.failed += cases.len() - converged;
                    after.panicked_chains += usize::from(*panicked);
                }
                chains_left -= group.len();
                commit(group).inspect_err(|_| interrupt.request())?;
                report = after;
            }
            report.interrupted = chains_left > 0;
            Ok(report)
        })
    }
}

/// Starts a pool of this many solver threads.
pub fn solver_threads(threads: NonZeroUsize) -> Result<rayon::ThreadPool, ThreadsError> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.get())
        .thread_name(|index| format!("solver-{index}"))
        .build()
        .map_err(|source| ThreadsError { threads, source })
}

/// The chains to commit next, in their order; `None` when all solver threads have ended and nothing is left.
fn next_group<'a, C, S>(
    finished: &Receiver<Finished<'a, C, S>>,
    most: usize,
    wait: Duration,
) -> Option<Vec<Finished<'a, C, S>>> {
    let first = finished.recv().ok()?;
    let end = Instant::now() + wait;
    let mut cases = first.cases.len();
    let mut group = vec![first];
    // Short chains are many: what matters is how many cases wait.
    while cases < GROUP_CASES.min(most * MAX_CHAIN) {
        let Ok(next) = finished.recv_timeout(end.saturating_duration_since(Instant::now())) else { break };
        cases += next.cases.len();
        group.push(next);
    }
    group.sort_unstable_by_key(|finished| finished.place);
    Some(group)
}

/// Solves one chain and turns a panic of its solver into failed cases; true if there was one.
fn solve_one<C, S>(
    chain: &C,
    interrupt: &Interrupt,
    solve: impl Fn(&C, &Interrupt) -> Result<Vec<S>, Interrupted>,
    panicked: impl Fn(&C, &str) -> Vec<S>,
) -> Result<(Vec<S>, bool), Interrupted> {
    // Nothing of a solver outlives its chain, so nothing half-changed is seen after the panic.
    match catch_unwind(AssertUnwindSafe(|| solve(chain, interrupt))) {
        Ok(cases) => Ok((cases?, false)),
        Err(payload) => Ok((panicked(chain, &panic_message(payload.as_ref())), true)),
    }
}
