//! Whether a solution is good enough: its estimated errors, how well its mesh resolves it, and whether the film is under tension.

use super::adaptation::indicators;
use super::estimate::{Estimate, estimate};
use super::fields::fields;
use super::log_moments::MOST_MOMENTS;
use super::reference::{ReferencePanel, evaluate};
use super::solver::{ACCEPTED, CollocationSolver};
use super::state::State;
use super::system::unknowns;
use super::workspace::Workspace;
use crate::continuation::{Halt, Solution, Work};
use crate::model::{Failure, Output};

/// Largest indicator over the root of the tolerance.
const RESOLVED: f64 = 0.3;
/// Least pressure over the largest; below it the film would carry tension.
pub(super) const TENSION: f64 = -1e-6;

/// The smallest pressure over the largest, and the panel it is on; between the nodes too: where the pressure is low, a
/// polynomial may dip below zero between positive values.
pub(super) fn tension(reference: &ReferencePanel, state: &State) -> (f64, usize) {
    const LOW: f64 = 1e-2;
    const BETWEEN: [f64; 7] = [0.02, 0.06, 0.15, 0.3, 0.5, 0.7, 0.9];
    let most = state.pressure.iter().fold(0.0, |a: f64, &p| a.max(p));
    let size = reference.degree + 1;
    let mut coefficients = [0.0; MOST_MOMENTS];
    let (mut least, mut place) = (0.0, 0);
    for (panel, nodes) in state.pressure.windows(size).step_by(reference.degree).enumerate() {
        if nodes.iter().all(|&p| p > LOW * most) {
            continue;
        }
        reference.coefficients_of_nodes(nodes, &mut coefficients[..size]);
        let between = |gap: &[f64]| BETWEEN.map(|part| gap[0] + part * (gap[1] - gap[0]));
        let values = reference.nodes.windows(2).flat_map(between).map(|t| evaluate(&coefficients[..size], t));
        for value in values.chain(nodes.iter().copied()) {
            if value < least {
                (least, place) = (value, panel);
            }
        }
    }
    (least / most, place)
}

pub(super) fn tension_failure(tension: f64) -> Halt {
    let reason = format!(
        "Newton's method found a film under tension, {tension:.1e} of the largest pressure: not a solution with cavitation"
    );
    Halt::Failed(Failure::new(reason))
}

/// The solution with its fields and sensitivities.
pub(super) fn complete(
    workspace: &mut Workspace,
    beta: f64,
    state: &State,
    estimate: Estimate,
    output: &Output,
    work: &mut Work,
) -> Solution {
    work.effort.unknowns = unknowns(workspace.coarse.displacement());
    let (corrector, displacement) = workspace.coarse.parts();
    let fields = fields(displacement, beta, state, output);
    let mut derivatives = || corrector.sensitivities(displacement, beta, state, output.cavity_shear, &mut work.effort);
    let sensitivities = output.sensitivities.then(&mut derivatives);
    let Estimate { quantities, errors, .. } = estimate;
    Solution { quantities, errors, fields, sensitivities }
}

/// What stands between a solution and its acceptance.
pub(super) struct Judgement {
    /// Over the tolerance: the largest of the estimated errors, the extremes and the coarseness.
    pub(super) error: f64,
    /// What that is.
    of: &'static str,
    /// The smallest pressure over the largest, and the panel it is on.
    pub(super) tension: f64,
    pub(super) place: usize,
}

impl Judgement {
    pub(super) fn is_accepted(&self) -> bool {
        self.error <= ACCEPTED && self.tension >= TENSION
    }

    /// How far it is from acceptance, 1 and less being none.
    pub(super) fn excess(&self) -> f64 {
        f64::max(self.error / ACCEPTED, self.tension / TENSION)
    }

    pub(super) fn failure(&self, tolerance: f64, panels: usize) -> Halt {
        if self.error <= ACCEPTED {
            return tension_failure(self.tension);
        }
        let times = if self.error < 1e4 { format!("{:.1}", self.error) } else { format!("{:.0e}", self.error) };
        let reason = format!(
            "{} is still {times} times the tolerance {tolerance:e} with {panels} panels; ask for a larger tolerance",
            self.of
        );
        Halt::Failed(Failure::new(reason))
    }
}

impl CollocationSolver {
    /// The square of the largest indicator, which is about the error of friction and flow, over the one that is let pass: so
    /// that a small estimate is never an accident of a coarse mesh, on which two errors happen to be alike.
    fn coarseness(&self, state: &State) -> f64 {
        let roughest = indicators(&self.coarse, state).into_iter().fold(0.0, f64::max);
        ACCEPTED * roughest * roughest / (RESOLVED * RESOLVED * self.settings.tolerance)
    }

    /// Estimates the errors of a solution and looks at it.
    pub(super) fn judge(
        &self,
        workspace: &mut Workspace,
        beta: f64,
        state: &State,
        output: &Output,
        work: &mut Work,
    ) -> (Judgement, Estimate) {
        let tolerance = self.settings.tolerance;
        workspace.prepare_fine(&state.mesh, &mut work.effort);
        let Workspace { coarse, fine, .. } = workspace;
        let effort = &mut work.effort;
        let estimate = estimate(coarse.displacement(), fine, beta, state, output.cavity_shear, tolerance, effort);
        let measures = [
            (estimate.worst() / tolerance, "the estimated error"),
            (estimate.extremes / tolerance, "what richer panels change in the largest pressure or the smallest film"),
            (self.coarseness(state), "the square of what is left of the pressure's polynomials"),
        ];
        let larger = |a: (f64, &'static str), b: (f64, &'static str)| if b.0 > a.0 { b } else { a };
        let (error, of) = measures.into_iter().fold((0.0, ""), larger);
        let (tension, place) = tension(&self.coarse, state);
        (Judgement { error, of, tension, place }, estimate)
    }
}
