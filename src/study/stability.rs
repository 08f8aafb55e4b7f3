//! The stability of a method at a case: its solution from the inside, and whether another seed leads there too.

use super::reference::Errors;
use super::run::Session;
use super::variant::guarded;
use super::{Examination, Setting, Variant};
use stribeck_solver::continuation::Seed;
use stribeck_solver::{FailureKind, Interrupted, Parameters, Solution, SolvedCase};

/// β of the neighbours from which a case is solved once more, over its own. The first is above, where films are
/// thinner: every other way to a case comes from thicker ones.
const NEIGHBOURS: [f64; 2] = [2.0, 0.5];

/// One case, examined by one variant.
#[derive(Clone, Debug)]
pub(super) struct Examined {
    /// The solution from the usual seed.
    pub solved: SolvedCase,
    /// The solution from the inside; `None` if there is none.
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

impl Session<'_> {
    /// Examines the cases of a chain.
    pub(super) fn examine(&self, variant: &Variant, cases: &[Parameters]) -> Result<Vec<Examined>, Interrupted> {
        let (output, interrupt) = (&self.output, self.interrupt);
        let solver = variant.setting.solver();
        let mut examinations = Vec::with_capacity(cases.len());
        let mut look = |examination| examinations.push(examination);
        let solved = guarded(cases, || solver.examine(cases, output, interrupt, &mut look))?;
        // a panic leaves the rest of them out
        examinations.resize(cases.len(), None);
        let mut estimates: Vec<Option<f64>> = solved.iter().map(estimate).collect();
        if let Some(setting) = variant.setting.estimating() {
            let solver = setting.solver();
            let again = guarded(cases, || solver.solve(cases, output, interrupt))?;
            estimates = again.iter().map(estimate).collect();
        }
        let cases = cases.iter().zip(solved).zip(examinations).zip(estimates);
        cases
            .map(|(((case, solved), examination), estimated_error)| {
                let other = self.solve_from_neighbour(variant, case, &solved)?;
                Ok(Examined { solved, examination, estimated_error, other })
            })
            .collect()
    }

    /// Solves a case from its neighbours, one after the other until one of them is the seed indeed.
    fn solve_from_neighbour(
        &self,
        variant: &Variant,
        case: &Parameters,
        solved: &SolvedCase,
    ) -> Result<Other, Interrupted> {
        let mut other = None;
        for factor in NEIGHBOURS {
            let pair = [Parameters { beta: factor * case.beta, ..case.clone() }, case.clone()];
            let solver = variant.setting.solver();
            let solved = guarded(&pair, || solver.solve(&pair, &self.output, self.interrupt))?;
            let [neighbour, again]: [SolvedCase; 2] = solved.try_into().expect("a case each");
            other = Some(again);
            if neighbour.outcome.is_ok() {
                break;
            }
        }
        let mut other = other.expect("there are neighbours");
        let is_seeded = matches!(other.seed, Seed::Neighbour | Seed::Predictor | Seed::Intermediate(_));
        if !is_seeded && other.outcome.is_ok() {
            // it went the usual way after all, which says nothing about the seed
            other.outcome = Err(FailureKind::Other("no neighbour leads to it".to_owned()).into());
        }
        let both = solved.outcome.as_ref().ok().zip(other.outcome.as_ref().ok());
        let difference = both.map(|(ours, theirs)| Errors::between(&theirs.quantities, &ours.quantities).largest());
        let allowed = both.map(|both| agreement(&variant.setting, both.into()));
        Ok(Other {
            seed: other.seed,
            failure: other.outcome.err().map(|failure| failure.to_string()),
            difference,
            allowed,
        })
    }
}

/// The largest of the estimated errors of a case.
fn estimate(solved: &SolvedCase) -> Option<f64> {
    solved.outcome.as_ref().ok()?.errors.largest()
}

/// The difference that two solutions of one case may have in μ_v, μ_h and c. Each may be off by the tolerance, or by
/// its estimated error; on a grid the iteration may leave some thousand times its residual.
fn agreement(setting: &Setting, solutions: [&Solution; 2]) -> f64 {
    match setting {
        Setting::Tolerance(settings) => 2.0 * settings.tolerance,
        Setting::Panels { .. } => solutions.into_iter().filter_map(|solution| solution.errors.largest()).sum(),
        Setting::Grid(settings) => 1e4 * settings.tolerance,
    }
}
