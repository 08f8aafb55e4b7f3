//! The pool of threads over chains, and the one writer behind it.

use std::any::Any;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{SyncSender, sync_channel};

use crate::continuation::{Interrupt, Interrupted, SolvedCase};

/// A pool of threads that solves chains.
#[derive(Debug)]
pub struct Engine {
    pool: rayon::ThreadPool,
}

/// The threads of an [`Engine`] could not be started.
#[derive(Debug, thiserror::Error)]
#[error("cannot start {threads} solver threads: {source}; ask for fewer with `--threads`")]
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

/// A finished chain on its way to the writer.
struct Finished<'a, C> {
    chain: &'a C,
    cases: Vec<SolvedCase>,
    panicked: bool,
}

impl Engine {
    /// An engine with `threads` solver threads.
    ///
    /// # Errors
    /// [`ThreadsError`] if the system does not give that many.
    pub fn new(threads: NonZeroUsize) -> Result<Self, ThreadsError> {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads.get())
            .thread_name(|index| format!("solver-{index}"))
            .build()
            .map(|pool| Self { pool })
            .map_err(|source| ThreadsError { threads, source })
    }

    /// Number of chains that may wait for the writer in its queue.
    ///
    /// Besides these, each solver thread may hold one that does not fit, and the writer the one it commits: that is all
    /// that is ever finished and not committed, however many chains there are.
    pub fn queue_length(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Solves `chains`, started in their order, and commits each as it finishes.
    ///
    /// - `solve` is called once for each chain, on a solver thread. It gives up with [`Interrupted`] soon after
    ///   `interrupt` is requested; what it finished nevertheless is committed.
    /// - `panicked` makes failed cases of a chain whose solver panicked, from the message of the panic. They are committed
    ///   like any others, and the other chains go on.
    /// - `commit` is called on the calling thread only, so it needs no lock.
    ///
    /// # Errors
    /// The first error of `commit`. It ends the run: `interrupt` is requested so that solvers at work give up, and no
    /// chain is started or committed after it.
    pub fn run<C: Sync, E>(
        &self,
        chains: &[C],
        interrupt: &Interrupt,
        solve: impl Fn(&C, &Interrupt) -> Result<Vec<SolvedCase>, Interrupted> + Sync,
        panicked: impl Fn(&C, &str) -> Vec<SolvedCase> + Sync,
        mut commit: impl FnMut(&C, Vec<SolvedCase>) -> Result<(), E>,
    ) -> Result<Report, E> {
        // Rayon gives no order among its jobs and lets a waiting job steal another. So its jobs are not the chains but one
        // loop for each thread, and the loops share a counter.
        let next = AtomicUsize::new(0);
        let solver_loop = |finished: SyncSender<_>| {
            while !interrupt.requested() {
                let Some(chain) = chains.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
                let Ok(result) = solve_one(chain, interrupt, &solve, &panicked) else { continue };
                if finished.send(result).is_err() {
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
            for Finished { chain, cases, panicked } in receiver {
                let converged = cases.iter().filter(|case| case.outcome.is_ok()).count();
                let failed = cases.len() - converged;
                commit(chain, cases).inspect_err(|_| interrupt.request())?;
                report.converged += converged;
                report.failed += failed;
                report.panicked_chains += usize::from(panicked);
                chains_left -= 1;
            }
            report.interrupted = chains_left > 0;
            Ok(report)
        })
    }
}

/// Solves one chain and turns a panic of its solver into failed cases.
fn solve_one<'a, C>(
    chain: &'a C,
    interrupt: &Interrupt,
    solve: impl Fn(&C, &Interrupt) -> Result<Vec<SolvedCase>, Interrupted>,
    panicked: impl Fn(&C, &str) -> Vec<SolvedCase>,
) -> Result<Finished<'a, C>, Interrupted> {
    // Nothing of a solver outlives its chain, so nothing half-changed is seen after the panic.
    match catch_unwind(AssertUnwindSafe(|| solve(chain, interrupt))) {
        Ok(cases) => Ok(Finished { chain, cases: cases?, panicked: false }),
        Err(payload) => {
            let cases = panicked(chain, panic_message(payload.as_ref()));
            Ok(Finished { chain, cases, panicked: true })
        }
    }
}

/// The text that was given to `panic!`.
fn panic_message(payload: &(dyn Any + Send)) -> &str {
    if let Some(text) = payload.downcast_ref::<&'static str>() {
        text
    } else if let Some(text) = payload.downcast_ref::<String>() {
        text
    } else {
        "a panic without a message"
    }
}
