//! Fits to measured friction: the quantities of the laboratory whose solutions agree with it best.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `unknown`, `bounds` | [`Unknown`]: what a fit may look for; [`Bounds`]: where it may be |
//! | `beginning` | [`best_beginning`]: where a fit may begin, without solving |
//! | `prediction` | friction at the measured points, and how it changes with the unknowns |
//! | `problem` | residuals and their Jacobian, for the Levenberg–Marquardt method |
//! | `statistics` | standard errors and correlations |
//! | `profile` | intervals of unknowns, while the others follow |
//! | `curve` | [`FittedCurve`]: fitted friction along the speed |
//!
//! Unknowns are positive; the search runs in their logarithms. Residuals are (μ − μᵢ)/σᵢ where the file has standard
//! errors σᵢ. For means of readings they are ln(μ/μᵢ) μᵢ/σᵢ. Otherwise they are ln(μ/μᵢ): equal relative errors, whose
//! size then follows from the residuals.

mod beginning;
mod bounds;
mod curve;
mod prediction;
mod problem;
mod profile;
mod statistics;
mod unknown;

use levenberg_marquardt::{LevenbergMarquardt, TerminationReason};

use crate::{Experiment, Measured};
pub use beginning::best_beginning;
pub use bounds::Bounds;
pub use curve::FittedCurve;
use prediction::Predictor;
use problem::{Found, Problem};
pub use statistics::Inseparable;
use statistics::{Statistics, statistics};
use stribeck_solver::{CavityShear, Failure, Interrupt, Substrate};
pub use unknown::Unknown;

/// Relative changes of residuals and unknowns below which a fit has converged.
const TOLERANCE: f64 = 1e-8;
/// Residuals, relative to the friction, that are larger than what the errors of solutions make.
const RESOLVED: f64 = 1e-5;
/// A slope of the residuals (a cosine) below which the search has ended at a minimum.
const FLAT: f64 = 0.01;
/// Norm of the first step over the scale of the problem: what is far away is reached in several steps.
const FIRST_STEP: f64 = 1.0;

/// Measured points, the experiment that they belong to, and what is unknown of it.
#[derive(Clone, Debug)]
pub struct FrictionTask<'a> {
    /// The measured points.
    pub measured: &'a Measured,
    /// The experiment, with the start of each unknown; the columns of the points replace its values.
    pub experiment: Experiment,
    /// The retardation spectrum of the flat.
    pub substrate: &'a Substrate,
    /// That of the roller; it counts where the roller has an f.
    pub roller_spectrum: &'a Substrate,
    /// What fills the gap behind the outlet.
    pub cavity_shear: CavityShear,
    /// The unknowns, at least one and each once.
    pub unknowns: Vec<Unknown>,
    /// Where unknowns must stay, for those that are bounded.
    pub bounds: Vec<Bounds>,
    /// Relative error wanted of the solutions; a fit takes 1e-7 or less.
    pub tolerance: f64,
}

/// What goes on beside a fit.
#[derive(Clone, Copy)]
pub struct Watch<'a> {
    /// Ends it.
    pub interrupt: &'a Interrupt,
    /// Is told after each evaluation how many there were, and the best unknowns so far.
    pub evaluated: &'a dyn Fn(usize, &[f64]),
}

/// The reason why nothing was fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrictionFitError {
    /// The file does not go with the task.
    #[error("{what}")]
    Task {
        /// What is wrong, and what to do.
        what: String,
    },
    /// A point has no solution at the start.
    #[error(
        "the point on {place} has no solution at the start of the fit: {failure}; begin nearer to the expected values"
    )]
    Start {
        /// Where the point stands.
        place: String,
        /// Why it failed.
        failure: Box<Failure>,
    },
    /// The search ended without a minimum.
    #[error("no minimum was found after {evaluations} evaluations: {why}; begin nearer to the expected values")]
    NoMinimum {
        /// The number of times that all points were solved.
        evaluations: usize,
        /// The reason of its end.
        why: String,
    },
    /// The search was told to stop before there was anything.
    #[error("the time is up before all points were solved once; give more time")]
    TimeLimit,
    /// Some unknowns have the same effect.
    #[error(transparent)]
    Inseparable(#[from] Inseparable),
}

/// One unknown, found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The unknown.
    pub unknown: Unknown,
    /// The value at which the search began.
    pub start: f64,
    /// Its value.
    pub value: f64,
    /// Its standard error; NaN at a bound.
    pub error: f64,
    /// True if it is at one of its bounds.
    pub at_bound: bool,
}

/// One point, fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedPoint {
    /// The place of its file among those of the measured points, and its line there.
    pub place: (usize, u64),
    /// Its experiment, with the unknowns found.
    pub experiment: Experiment,
    /// The measured friction coefficient.
    pub measured: f64,
    /// Its standard error, if the file has it.
    pub error: Option<f64>,
    /// The friction coefficient of the solution.
    pub fitted: f64,
    /// (μ − μᵢ)/σᵢ, ln(μ/μᵢ) μᵢ/σᵢ for means of readings, or ln(μ/μᵢ) without standard errors.
    pub residual: f64,
}

/// Quantities of the laboratory fitted to measured friction.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionFit {
    /// The unknowns.
    pub estimates: Vec<Estimate>,
    /// Their correlations, row by row.
    pub correlation: Vec<Vec<f64>>,
    /// The points, in the order of the file.
    pub points: Vec<FittedPoint>,
    /// Points less unknowns.
    pub degrees_of_freedom: usize,
    /// Sum of the squared residuals over the degrees of freedom: about 1 where standard errors are known and right,
    /// else the square of the relative error of a point. NaN without degrees of freedom.
    pub reduced_chi_squared: f64,
    /// The number of times that all points were solved.
    pub evaluations: usize,
    /// False if the search was told to stop: the values are the best so far, and nothing is known of their errors (NaN).
    pub is_minimum: bool,
}

impl FrictionFit {
    /// Fits the unknowns of a task.
    ///
    /// # Errors
    /// [`FrictionFitError`] if points and unknowns do not go together, points have no solution, the search finds no
    /// minimum, or the unknowns have the same effect.
    pub fn new(task: &FrictionTask<'_>) -> Result<Self, FrictionFitError> {
        Self::watched(task, &Watch { interrupt: &Interrupt::new(), evaluated: &|_, _| {} })
    }

    /// Fits the unknowns of a task while somebody watches, and may end it: then it has the best values so far, and is
    /// no minimum.
    ///
    /// # Errors
    /// As [`FrictionFit::new`], and [`FrictionFitError::TimeLimit`] if the interrupt was requested before the points
    /// were solved once.
    pub fn watched(task: &FrictionTask<'_>, watch: &Watch<'_>) -> Result<Self, FrictionFitError> {
        let predictor = Predictor::new(task)?;
        let (found, evaluations) = search(task, &predictor, watch)?;
        let free: Vec<usize> = (0..found.unknowns.len()).filter(|unknown| !found.at_bounds[*unknown]).collect();
        let names: Vec<Unknown> = free.iter().map(|unknown| task.unknowns[*unknown]).collect();
        let known_errors = task.measured.errors.is_some();
        let jacobian = found.jacobian.select_columns(&free);
        let Statistics { errors, correlation, degrees_of_freedom, reduced_chi_squared } = match found.is_minimum {
            true => statistics(&jacobian, &found.residuals, known_errors, &names)?,
            false => Statistics::of_no_minimum(&found.residuals, names.len()),
        };
        let place = |unknown: usize| free.iter().position(|free| *free == unknown);
        let estimates = task.unknowns.iter().enumerate().map(|(i, unknown)| Estimate {
            unknown: *unknown,
            start: unknown.value(&task.experiment),
            value: found.unknowns[i],
            error: place(i).map_or(f64::NAN, |place| found.unknowns[i] * errors[place] / found.scale),
            at_bound: found.at_bounds[i],
        });
        let of_all = |i: usize, j: usize| place(i).zip(place(j)).map_or(f64::NAN, |(i, j)| correlation[i][j]);
        let unknowns = 0..found.unknowns.len();
        let points =
            predictor.experiments(&found.unknowns).into_iter().enumerate().map(|(i, experiment)| FittedPoint {
                place: task.measured.places[i],
                experiment,
                measured: task.measured.friction[i],
                error: task.measured.errors.as_ref().map(|errors| errors[i]),
                fitted: found.friction[i],
                residual: found.residuals[i] * found.scale,
            });
        Ok(Self {
            estimates: estimates.collect(),
            correlation: unknowns.clone().map(|i| unknowns.clone().map(|j| of_all(i, j)).collect()).collect(),
            points: points.collect(),
            degrees_of_freedom,
            reduced_chi_squared: reduced_chi_squared * found.scale * found.scale,
            evaluations,
            is_minimum: found.is_minimum,
        })
    }
}

/// Searches for the minimum; also returns the number of evaluations.
fn search(
    task: &FrictionTask<'_>,
    predictor: &Predictor<'_>,
    watch: &Watch<'_>,
) -> Result<(Found, usize), FrictionFitError> {
    let problem = Problem::new(predictor, task.measured, &task.bounds, watch)?;
    let method = LevenbergMarquardt::new()
        .with_ftol(TOLERANCE)
        .with_xtol(TOLERANCE)
        .with_gtol(TOLERANCE)
        .with_stepbound(FIRST_STEP);
    let (problem, report) = method.minimize(problem);
    let (evaluations, was_refused) = (problem.evaluations(), problem.was_refused());
    if problem.interrupted() {
        return problem.best().map(|found| (found, evaluations)).ok_or(FrictionFitError::TimeLimit);
    }
    let no_minimum = |why: String| Err(FrictionFitError::NoMinimum { evaluations, why });
    match report.termination {
        // What is left is below the errors of the solutions.
        TerminationReason::NoImprovementPossible(_) => {}
        reason if reason.was_successful() => {}
        reason => return no_minimum(describe(&reason)),
    }
    let Some(found) = problem.found() else {
        return no_minimum("the last values tried have no solution".to_owned());
    };
    // Steps that are taken back one after the other look like convergence, and so do steps that are too short.
    let is_resolved = found.residuals.norm() > RESOLVED * (found.residuals.len() as f64).sqrt();
    if (was_refused || is_resolved) && slope(&found) > FLAT {
        return no_minimum("beyond these values cases have no solution, or an unknown runs away".to_owned());
    }
    Ok((found, evaluations))
}

/// The largest cosine between the residuals and a column of the Jacobian: 0 at a minimum. Unknowns at their bounds do
/// not count.
fn slope(found: &Found) -> f64 {
    let Found { residuals, jacobian, at_bounds, .. } = found;
    let cosine = |(column, _): (nalgebra::DVectorView<'_, f64>, &bool)| {
        let length = column.norm() * residuals.norm();
        if length > 0.0 { (column.dot(residuals) / length).abs() } else { 0.0 }
    };
    jacobian.column_iter().zip(at_bounds).filter(|(_, at_bound)| !**at_bound).map(cosine).fold(0.0, f64::max)
}

fn describe(reason: &TerminationReason) -> String {
    match reason {
        TerminationReason::LostPatience => "the residuals still fall".to_owned(),
        TerminationReason::Numerical(what) => format!("a number of the search is none ({what})"),
        other => format!("{other:?}"),
    }
}
