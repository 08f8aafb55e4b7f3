//! How stable a method is at a case: what its solution looks like from the inside, and whether another seed leads there too.

use super::reference::Errors;
use super::variant::guarded;
use super::{Examination, Setting, Variant};
use stribeck_solver::continuation::{Interrupt, Interrupted, Seed, Solution, SolvedCase};
use stribeck_solver::{FailureKind, Output, Parameters};

/// β of the neighbours that a case is solved from once more, over its own: first from above, where films are thinner, for
/// every other way to a case comes from thicker ones.
const NEIGHBOURS: [f64; 2] = [2.0, 0.5];

/// What one variant did with one case.
#[derive(Clone, Debug)]
pub(super) struct Examined {
    /// The solution in its usual way.
    pub solved: SolvedCase,
    /// How it looks from the inside; `None` if there is none.
    pub examination: Option<Examination>,
    /// The largest of its estimated errors of μ_v, μ_h and c.
    pub estimated_error: Option<f64>,
    /// The same case from a neighbour.
    pub other: Other,
}

/// A case solved from another seed.
#[derive(Clone, Debug)]
pub struct Other {
    /// The seed that led to it.
    pub seed: Seed,
    /// Why it failed.
    pub failure: Option<String>,
    /// The largest relative difference of μ_v, μ_h and c between both solutions; `None` without both.
    pub difference: Option<f64>,
    /// The largest difference with which the two agree; `None` without both.
    pub allowed: Option<f64>,
}

/// Examines the cases of a chain.
pub(super) fn examine(
    variant: &Variant,
    cases: &[Parameters],
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Vec<Examined>, Interrupted> {
    let solver = variant.setting.solver();
    let mut examinations = Vec::with_capacity(cases.len());
    let solved =
        guarded(cases, || solver.examine(cases, output, interrupt, &mut |examination| examinations.push(examination)))?;
    // a panic leaves the rest of them out
    examinations.resize(cases.len(), None);
    let mut estimates: Vec<Option<f64>> = solved.iter().map(estimate).collect();
    if let Some(setting) = variant.setting.estimating() {
        let solver = setting.solver();
        let again = guarded(cases, || solver.solve(cases, output, interrupt))?;
        estimates = again.iter().map(estimate).collect();
    }
    let mut found = Vec::with_capacity(cases.len());
    for (((case, solved), examination), estimated_error) in cases.iter().zip(solved).zip(examinations).zip(estimates) {
        let other = from_neighbour(variant, case, &solved, output, interrupt)?;
        found.push(Examined { solved, examination, estimated_error, other });
    }
    Ok(found)
}

/// The largest of the estimated errors of a case.
fn estimate(solved: &SolvedCase) -> Option<f64> {
    solved.outcome.as_ref().ok()?.errors.largest()
}

/// Solves a case from its neighbours, one after the other until one of them is the seed indeed.
fn from_neighbour(
    variant: &Variant,
    case: &Parameters,
    solved: &SolvedCase,
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Other, Interrupted> {
    let mut other = None;
    for factor in NEIGHBOURS {
        let pair = [Parameters { beta: factor * case.beta, ..case.clone() }, case.clone()];
        let solver = variant.setting.solver();
        let [neighbour, again]: [SolvedCase; 2] =
            guarded(&pair, || solver.solve(&pair, output, interrupt))?.try_into().expect("a case each");
        let seeded = neighbour.outcome.is_ok();
        other = Some(again);
        if seeded {
            break;
        }
    }
    let mut other = other.expect("there are neighbours");
    let led = matches!(other.seed, Seed::Neighbour | Seed::Predictor | Seed::Intermediate(_));
    if !led && other.outcome.is_ok() {
        // it went the usual way after all, which says nothing about the seed
        let reason = "no neighbour leads to it".to_owned();
        other.outcome = Err(FailureKind::Other(reason).into());
    }
    let both = solved.outcome.as_ref().ok().zip(other.outcome.as_ref().ok());
    let difference = both.map(|(ours, theirs)| Errors::between(&theirs.quantities, &ours.quantities).largest());
    let allowed = both.map(|both| agreement(&variant.setting, both.into()));
    Ok(Other { seed: other.seed, failure: other.outcome.err().map(|failure| failure.to_string()), difference, allowed })
}

/// How much two solutions of one case may differ in μ_v, μ_h and c: each may be off by the tolerance, or by its estimated
/// error; on a grid the iteration may leave some thousand times its residual.
fn agreement(setting: &Setting, solutions: [&Solution; 2]) -> f64 {
    match setting {
        Setting::Tolerance(settings) => 2.0 * settings.tolerance,
        Setting::Panels { .. } => solutions.into_iter().filter_map(|solution| solution.errors.largest()).sum(),
        Setting::Grid(settings) => 1e4 * settings.tolerance,
    }
}
