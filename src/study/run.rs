//! A study from its first case to its last.

use std::num::NonZeroUsize;
use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use super::reference::{references, settings};
use super::row::{Cost, Row, Stability};
use super::stability::{Examined, examine};
use super::timing::time;
use super::{Meter, Study};
use stribeck_solver::continuation::{Interrupt, Interrupted};
use stribeck_solver::{FieldSelection, Output};
use stribeck_sweep::engine::{ThreadsError, solver_threads};

/// What came of a study.
#[derive(Clone, Debug)]
pub struct Findings {
    /// A row for each case and variant, in this order; those of cases that were not finished are missing.
    pub rows: Vec<Row>,
    /// True if cases are missing because the user asked to stop.
    pub interrupted: bool,
}

/// Solves every case by every variant on so many threads. `observe` is told after each case of each variant whether it
/// converged.
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
    // Groups are taken one by one: the costs of neighbours are alike, and those of distant ones are not.
    let found: Vec<Result<Vec<Row>, Interrupted>> = pool.install(|| {
        let groups = groups.par_iter().with_max_len(1);
        groups.map(|group| rows(study, group, meter, interrupt, &observe)).collect()
    });
    let interrupted = found.iter().any(Result::is_err);
    Ok(Findings { rows: found.into_iter().flatten().flatten().collect(), interrupted })
}

/// The rows of the cases of a group.
fn rows(
    study: &Study,
    group: &Range<usize>,
    meter: Meter<'_>,
    interrupt: &Interrupt,
    observe: &(impl Fn(bool) + Sync),
) -> Result<Vec<Row>, Interrupted> {
    if interrupt.requested() {
        return Err(Interrupted);
    }
    // friction, flow and film are what is compared: nothing else is computed
    let output = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    let cases = &study.cases[group.clone()];
    let variants = &study.variants;
    let references = references(cases, settings(variants), &output, interrupt)?;

    let mut rows: Vec<Row> = Vec::with_capacity(cases.len() * variants.len());
    let timed = match study.measure.error {
        true => time(variants, cases, study.repeats, meter, &output, interrupt)?,
        false => Vec::new(),
    };
    for (j, timed) in timed.iter().enumerate() {
        for (i, timed) in timed.iter().enumerate() {
            let mut row = Row::of(group.start + i, (j, &variants[j]), &timed.solved, &references[i]);
            row.cost = Some(Cost::of(timed));
            rows.push(row);
            if !study.measure.stability {
                observe(timed.solved.outcome.is_ok());
            }
        }
    }
    if study.measure.stability {
        for (j, variant) in variants.iter().enumerate() {
            let examined: Vec<Examined> = examine(variant, cases, &output, interrupt)?;
            for (i, examined) in examined.iter().enumerate() {
                let stability = Some(Stability::of(examined));
                match rows.get_mut(j * cases.len() + i).filter(|_| study.measure.error) {
                    Some(row) => row.stability = stability,
                    None => {
                        let row = Row::of(group.start + i, (j, variant), &examined.solved, &references[i]);
                        rows.push(Row { stability, ..row });
                    }
                }
                observe(examined.solved.outcome.is_ok());
            }
        }
    }
    rows.sort_by_key(|row| (row.case, row.variant));
    Ok(rows)
}
