//! A study from its first case to its last.

use std::num::NonZeroUsize;
use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::row::{Cost, Row, Stability};
use super::{Meter, Study};
use stribeck_solver::{Interrupt, Interrupted, Output, SolvedCase};
use stribeck_sweep::engine::{ThreadsError, solver_threads};

/// The results of a study.
#[derive(Clone, Debug)]
pub struct Findings {
    /// A row for each case and variant, in this order; those of cases that were not finished are missing.
    pub rows: Vec<Row>,
    /// True if cases are missing because the user asked to stop.
    pub interrupted: bool,
}

/// The settings that all groups of cases share.
pub(super) struct Session<'a> {
    pub study: &'a Study,
    pub meter: Meter<'a>,
    pub interrupt: &'a Interrupt,
    /// What is computed of a solution: what is compared, and nothing else.
    pub output: Output,
}

/// Solves every case by every variant on the given number of threads. `observe` is told after each case of each variant
/// whether it converged.
///
/// On more than one thread times are those of a busy machine.
///
/// # Errors
/// [`ThreadsError`] if the system does not give the threads.
pub fn run(
    study: &Study,
    threads: NonZeroUsize,
    meter: Meter<'_>,
    interrupt: &Interrupt,
    observe: impl Fn(bool) + Sync,
) -> Result<Findings, ThreadsError> {
    let pool = solver_threads(threads)?;
    let groups = study.groups();
    let session = Session { study, meter, interrupt, output: Output::numbers() };
    // Groups are taken one by one: the costs of neighbours are alike, and those of distant ones are not.
    let found: Vec<Result<Vec<Row>, Interrupted>> = pool.install(|| {
        let groups = groups.par_iter().with_max_len(1);
        groups.map(|group| session.rows(group, &observe)).collect()
    });
    let interrupted = found.iter().any(Result::is_err);
    Ok(Findings { rows: found.into_iter().flatten().flatten().collect(), interrupted })
}

impl Session<'_> {
    /// The rows of the cases of a group.
    fn rows(&self, group: &Range<usize>, observe: &impl Fn(bool)) -> Result<Vec<Row>, Interrupted> {
        if self.interrupt.requested() {
            return Err(Interrupted);
        }
        let Study { variants, measure, .. } = self.study;
        let cases = &self.study.cases[group.clone()];
        let references = self.references(cases)?;
        let row = |i: usize, j: usize, solved: &SolvedCase| {
            Row::of(group.start + i, (j, &variants[j]), solved, &references[i])
        };
        let mut rows: Vec<Row> = Vec::with_capacity(cases.len() * variants.len());
        if measure.error {
            for (j, timed) in self.time(cases)?.iter().enumerate() {
                for (i, timed) in timed.iter().enumerate() {
                    rows.push(Row { cost: Some(Cost::of(timed)), ..row(i, j, &timed.solved) });
                    if !measure.stability {
                        observe(timed.solved.outcome.is_ok());
                    }
                }
            }
        }
        if measure.stability {
            for (j, variant) in variants.iter().enumerate() {
                for (i, examined) in self.examine(variant, cases)?.iter().enumerate() {
                    let stability = Some(Stability::of(examined));
                    if measure.error {
                        rows[j * cases.len() + i].stability = stability;
                    } else {
                        rows.push(Row { stability, ..row(i, j, &examined.solved) });
                    }
                    observe(examined.solved.outcome.is_ok());
                }
            }
        }
        rows.sort_by_key(|row| (row.case, row.variant));
        Ok(rows)
    }
}
