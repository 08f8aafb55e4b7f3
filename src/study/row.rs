//! The table of a study: one row for each case and variant.

use super::reference::Reference;
use super::stability::Examined;
use super::timing::Timed;
use super::{Study, Variant};
use stribeck_solver::Parameters;
use stribeck_solver::continuation::SolvedCase;

/// One case solved by one variant.
#[derive(Clone, Debug)]
pub struct Row {
    /// The case, as a place in [`Study::cases`].
    pub case: usize,
    /// The variant, as a place in [`Study::variants`].
    pub variant: usize,
    /// Why it failed; `None` if it converged.
    pub failure: Option<String>,
    /// The seed that led to the outcome.
    pub seed: String,
    /// Iterations or passes, failed attempts included.
    pub iterations: u64,
    /// Unknowns, or points of the grid; `None` if it failed.
    pub unknowns: Option<usize>,
    /// Errors against the reference, in the order of [`Errors::QUANTITIES`](super::Errors::QUANTITIES); `None` if the case failed, or the reference is
    /// missing or no better.
    pub errors: [Option<f64>; 4],
    /// The reference of the case, or why there is none.
    pub reference: Result<Reference, String>,
    /// What it cost, if that was measured.
    pub cost: Option<Cost>,
    /// How stable it is, if that was examined.
    pub stability: Option<Stability>,
}

/// What a case cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// The median of the repeats.
    pub seconds: f64,
    /// The most bytes in use at once, for the chain that the case belongs to.
    pub peak_bytes: u64,
}

/// How stable a solution is; `None` where there is no solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// The smallest pressure over the largest.
    pub pressure_min: Option<f64>,
    /// |load/(π/2) − 1| that is left.
    pub load_residual: Option<f64>,
    /// Condition number of the linearised equations, equilibrated.
    pub condition: Option<f64>,
    /// The largest of the estimated errors of μ_v, μ_h and c.
    pub estimated_error: Option<f64>,
    /// The seed of the other solution.
    pub other_seed: String,
    /// Why there is no other solution.
    pub other_failure: Option<String>,
    /// The largest relative difference between both solutions.
    pub seed_difference: Option<f64>,
    /// Whether that is so small that they agree.
    pub seeds_agree: Option<bool>,
}

impl Stability {
    pub(super) fn of(examined: &Examined) -> Self {
        let solution = examined.solved.outcome.as_ref().ok();
        Self {
            pressure_min: examined.examination.map(|found| found.tension),
            load_residual: solution.map(|solution| solution.quantities.load_residual),
            condition: examined.examination.and_then(|found| found.condition),
            estimated_error: examined.estimated_error,
            other_seed: examined.other.seed.to_string(),
            other_failure: examined.other.failure.clone(),
            seed_difference: examined.other.difference,
            seeds_agree: examined.other.difference.zip(examined.other.allowed).map(|(found, allowed)| found <= allowed),
        }
    }
}

impl Cost {
    pub(super) fn of(timed: &Timed) -> Self {
        Self { seconds: median(&timed.seconds), peak_bytes: timed.peak_bytes }
    }
}

/// The median of some times, of two middle ones their mean.
///
/// # Panics
/// If there are none.
fn median(numbers: &[f64]) -> f64 {
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[middle] } else { 0.5 * (sorted[middle - 1] + sorted[middle]) }
}

impl Row {
    /// The largest known error of μ_v, μ_h and c.
    pub fn largest_error(&self) -> Option<f64> {
        self.errors[..3].iter().flatten().copied().reduce(f64::max)
    }

    /// A row without cost and stability.
    pub(super) fn of(
        case: usize,
        variant: (usize, &Variant),
        solved: &SolvedCase,
        reference: &Result<Reference, String>,
    ) -> Self {
        // a tolerance that is no looser than that of the reference cannot be measured by it
        let fit = reference.as_ref().ok().filter(|reference| match variant.1.setting {
            super::Setting::Tolerance(settings) => reference.tolerance < 0.5 * settings.tolerance,
            super::Setting::Panels { .. } | super::Setting::Grid(_) => true,
        });
        let solution = solved.outcome.as_ref().ok();
        let errors = solution.zip(fit).map_or([None; 4], |(ours, better)| better.errors_of(&ours.quantities));
        Self {
            case,
            variant: variant.0,
            failure: solved.outcome.as_ref().err().map(|failure| failure.to_string()),
            seed: solved.seed.to_string(),
            iterations: solved.effort.iterations,
            unknowns: solution.map(|_| solved.effort.unknowns),
            errors,
            reference: reference.clone(),
            cost: None,
            stability: None,
        }
    }
}

/// The header of `study.csv`.
const HEADER: [&str; 28] = [
    "case",
    "f",
    "alpha",
    "beta",
    "method",
    "setting",
    "seconds",
    "unknowns",
    "iterations",
    "error_mu_v",
    "error_mu_h",
    "error_c",
    "error_film_min",
    "peak_bytes",
    "status",
    "reason",
    "seed",
    "reference_tolerance",
    "reference_error",
    "reference_reason",
    "pressure_min",
    "load_residual",
    "condition",
    "estimated_error",
    "other_seed",
    "other_reason",
    "seed_difference",
    "seeds_agree",
];

/// A number that reads back as the same; nothing for none.
fn number(number: Option<f64>) -> String {
    number.map_or_else(String::new, |number| format!("{number:?}"))
}

/// The rows as `study.csv`: shortest round-trip numbers, empty where there is none.
///
/// # Errors
/// What the writer of CSV says; writing to memory does not fail.
pub fn csv(study: &Study, rows: &[Row]) -> csv::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for row in rows {
        let Parameters { alpha, beta, f, .. } = &study.cases[row.case];
        let variant = &study.variants[row.variant];
        let stability = row.stability.as_ref();
        let [mu_v, mu_h, c, film_min] = row.errors.map(number);
        let reference = row.reference.as_ref();
        let record: [String; HEADER.len()] = [
            (row.case + 1).to_string(),
            format!("{f:?}"),
            format!("{alpha:?}"),
            format!("{beta:?}"),
            variant.method.clone(),
            variant.setting.words(),
            number(row.cost.map(|cost| cost.seconds)),
            row.unknowns.map_or_else(String::new, |unknowns| unknowns.to_string()),
            row.iterations.to_string(),
            mu_v,
            mu_h,
            c,
            film_min,
            row.cost.map_or_else(String::new, |cost| cost.peak_bytes.to_string()),
            if row.failure.is_none() { "converged" } else { "failed" }.to_owned(),
            row.failure.clone().unwrap_or_default(),
            row.seed.clone(),
            number(reference.ok().map(|reference| reference.tolerance)),
            number(reference.ok().map(Reference::error)),
            reference.err().cloned().unwrap_or_default(),
            number(stability.and_then(|found| found.pressure_min)),
            number(stability.and_then(|found| found.load_residual)),
            number(stability.and_then(|found| found.condition)),
            number(stability.and_then(|found| found.estimated_error)),
            stability.map_or_else(String::new, |found| found.other_seed.clone()),
            stability.and_then(|found| found.other_failure.clone()).unwrap_or_default(),
            number(stability.and_then(|found| found.seed_difference)),
            stability.and_then(|found| found.seeds_agree).map_or_else(String::new, |agree| agree.to_string()),
        ];
        writer.write_record(record)?;
    }
    writer.into_inner().map_err(|error| error.into_error().into())
}
