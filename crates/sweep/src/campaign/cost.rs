//! The time and the bytes that a sweep is expected to take.

use std::num::NonZeroUsize;

use super::{MergedCatalog, Pending};
use crate::engine::{GROUP_CASES, GROUP_WAIT};
use crate::store::Catalog;
use crate::{Field, FieldPrecision, Method, Plan, Sweep};
use stribeck_solver::{Interrupt, Solver, relaxation};

/// Bytes of a value after shuffling and deflating, measured; the pressure has many zeros.
const PRESSURE_VALUE: f64 = 4.4;
const FIELD_VALUE: f64 = 6.3;
/// Bytes beside the values for a field of a case in a shard: index of chunks and the like.
const FIELD: f64 = 350.0;
/// Bytes of a value of single precision, over those of one of double precision.
const SINGLE_VALUE: f64 = 0.53;
/// Bytes of a shard without fields.
const SHARD: f64 = 8_200.0;
/// Bytes of a case in the log, and of its numbers in a shard.
const LOGGED_CASE: f64 = 395.0;
/// Bytes of `results.h5` for a place of the sweep, without fields, and of its frame.
const PLACE: f64 = 324.0;
const FRAME: f64 = 25_000.0;
/// Bytes of a place in the two tables.
const TABLE_ROW: f64 = 605.0;

/// What a sweep is expected to take until it is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Seconds of a case on one thread.
    pub case: CaseSeconds,
    /// Seconds of the run.
    pub seconds: f64,
    /// Bytes on the disk.
    pub size: Size,
}

impl Cost {
    /// Estimates the cost of what is left. Some cases are solved to see how long they take, where the logs do not tell.
    pub(super) fn expected(
        sweep: &Sweep,
        plan: &Plan,
        pending: &Pending,
        stored: &MergedCatalog<'_>,
        threads: NonZeroUsize,
    ) -> Self {
        let chains = pending.chains.len();
        let case = CaseSeconds::expected(sweep, plan, pending, stored);
        let seconds = case.seconds() * pending.to_compute as f64 / threads.get().min(chains) as f64;
        // Finished chains wait for each other, and are committed together.
        let commits = (seconds / GROUP_WAIT.as_secs_f64()).max(pending.to_do() as f64 / GROUP_CASES as f64);
        Self { case, seconds, size: Size::of(sweep, plan, pending.to_do(), commits.min(chains as f64)) }
    }
}

/// Bytes that a finished sweep takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Log and shards, for the cases given.
    pub stored: u64,
    /// The published files.
    pub published: u64,
}

/// Bytes that the fields of a sweep take, stored and published.
pub fn field_bytes(sweep: &Sweep, plan: &Plan) -> u64 {
    let of_case = fields_of_case(sweep);
    (of_case * (plan.problems() as f64 + field_published(sweep.field_precision) * plan.cases() as f64)) as u64
}

/// Bytes of the fields of a case in a shard.
fn fields_of_case(sweep: &Sweep) -> f64 {
    let of_field = |field| if field == Field::Pressure { PRESSURE_VALUE } else { FIELD_VALUE };
    let rounded = if sweep.field_precision == FieldPrecision::Single { SINGLE_VALUE } else { 1.0 };
    let values = |field| FIELD + rounded * of_field(field) * sweep.output.x.len() as f64;
    Field::selected(sweep.output.fields).map(values).sum()
}

/// What a field of many cases takes in `results.h5`, over what it takes in a shard, where each is compressed by itself.
fn field_published(precision: FieldPrecision) -> f64 {
    match precision {
        FieldPrecision::Double => 0.87,
        FieldPrecision::Single => 0.65,
    }
}

impl Size {
    /// The size of `cases` stored cases in so many shards, and of the whole sweep published.
    fn of(sweep: &Sweep, plan: &Plan, cases: u64, shards: f64) -> Self {
        let fields = fields_of_case(sweep);
        let stored = cases as f64 * (LOGGED_CASE + fields) + shards.ceil() * SHARD;
        let published =
            FRAME + plan.cases() as f64 * (PLACE + TABLE_ROW + field_published(sweep.field_precision) * fields);
        Self { stored: stored as u64, published: published as u64 }
    }
}

/// Chains that are tried, and neighbouring cases of each, to see how long a case of a quick method takes.
const TRIED_CHAINS: usize = 3;
const TRIED_CASES: usize = 4;

/// Seconds that a thread needs for a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CaseSeconds {
    /// The mean of the cases solved so far, from the log.
    Logged(f64),
    /// An estimate from the speed of this machine.
    Estimated(f64),
}

impl CaseSeconds {
    /// From the log if cases of this sweep were solved there, else measured here and now: relaxation takes long, so
    /// that only its passes are timed, while a collocation case is solved in about the time that a guess would take.
    fn expected(sweep: &Sweep, plan: &Plan, pending: &Pending, stored: &MergedCatalog<'_>) -> Self {
        let logged = if pending.reused() > 0 { mean_seconds(stored.catalogs()) } else { None };
        logged.map(Self::Logged).unwrap_or_else(|| {
            Self::Estimated(match sweep.solver.method {
                Method::Collocation => tried_seconds(sweep, plan, pending),
                Method::Relaxation => relaxation::expected_seconds(&sweep.solver.relaxation),
            })
        })
    }

    /// The seconds.
    pub fn seconds(self) -> f64 {
        match self {
            Self::Logged(seconds) | Self::Estimated(seconds) => seconds,
        }
    }
}

/// Seconds of a case, from some cases of the sweep that are left to do, with the output it asks for. Of each chain
/// tried the first case is dearer, as it has no neighbour to start from; it counts once for the whole chain.
fn tried_seconds(sweep: &Sweep, plan: &Plan, pending: &Pending) -> f64 {
    let solver = Solver::new(&sweep.solver_settings());
    let tried = TRIED_CHAINS.min(pending.chains.len());
    let of_chain = |place: usize| {
        // spread over the rows: the middles of as many equal parts
        let index = pending.chains[(2 * place + 1) * pending.chains.len() / (2 * tried)];
        let chain = plan.parameters(&plan.chain(index as usize));
        let cases: Vec<_> = pending.places(plan, index).into_iter().map(|place| &chain[place]).collect();
        let start = (cases.len() - TRIED_CASES.min(cases.len())) / 2;
        let sample: Vec<_> = cases.iter().skip(start).take(TRIED_CASES).copied().cloned().collect();
        let solved = solver.solve_chain(&sample, &Interrupt::new()).expect("no one asks it to stop");
        let mut seconds = solved.iter().map(|case| case.effort.seconds);
        let first = seconds.next().expect("a chain has cases");
        let others = seconds.sum::<f64>() / (sample.len() - 1).max(1) as f64;
        (first + (cases.len() - 1) as f64 * others) / cases.len() as f64
    };
    (0..tried).map(of_chain).sum::<f64>() / tried as f64
}

fn mean_seconds(catalogs: &[&Catalog]) -> Option<f64> {
    let starts = catalogs.iter().flat_map(|catalog| catalog.history().starts()).map(|(_, start)| start);
    let (cases, seconds) = starts.fold((0, 0.0), |(cases, seconds), start| {
        (cases + start.converged + start.failed, seconds + start.case_seconds)
    });
    (cases > 0).then(|| seconds / cases as f64)
}
