//! Whether a solution is accepted: its estimated errors, how well its mesh resolves it, and whether the film is under
//! tension.

use super::adaptation::{indicators, panel_at_inlet};
use super::estimate::{Estimate, estimate};
use super::fields::fields;
use super::reference::{ReferencePanel, dot};
use super::scaling::layer;
use super::state::State;
use super::system::unknowns;
use super::workspace::Workspace;
use crate::continuation::{ErrorMeasure, FailureKind, Solution, SolveContext, SolveError};
use crate::model::{Output, Parameters};

/// The largest estimated error over the tolerance that is accepted.
pub(super) const ACCEPTED: f64 = 0.9;
/// Largest indicator over the root of the tolerance.
const RESOLVED: f64 = 0.3;
/// Longest panel where the film enters the contact, over the length of the layer there. A longer one hides from richer
/// panels what it makes of the flow.
const LONGEST_AT_INLET: f64 = 12.0;
/// Least pressure over the largest; below it the film would carry tension.
pub(super) const TENSION: f64 = -1e-6;
/// The same limit for a solution that is only good enough to go on from.
const ROUGH_TENSION: f64 = -1e-2;

/// The smallest pressure over the largest, and the panel it is on; between the nodes too: where the pressure is low, a
/// polynomial may dip below zero between positive values.
pub(super) fn tension(reference: &ReferencePanel, state: &State) -> (f64, usize) {
    const LOW: f64 = 1e-2;
    let most = state.pressure.iter().fold(0.0, |a: f64, &p| a.max(p));
    let size = reference.degree + 1;
    let (mut least, mut place) = (0.0, 0);
    for (panel, nodes) in state.pressure.windows(size).step_by(reference.degree).enumerate() {
        if nodes.iter().all(|&p| p > LOW * most) {
            continue;
        }
        let between = reference.between_nodes.chunks_exact(size).map(|row| dot(row, nodes));
        for value in between.chain(nodes.iter().copied()) {
            if value < least {
                (least, place) = (value, panel);
            }
        }
    }
    (least / most, place)
}

/// The solution with its fields and sensitivities.
pub(super) fn complete(
    workspace: &mut Workspace,
    (beta, state): (f64, &State),
    estimate: Estimate,
    output: &Output,
    context: &mut SolveContext,
) -> Solution {
    context.effort.unknowns = unknowns(workspace.coarse.displacement());
    let Estimate { quantities, errors, richer, beyond, .. } = estimate;
    let cavity_shear = output.cavity_shear;
    let fields = fields(workspace.fine.displacement(), beta, &richer, &quantities, output);
    let (mut sensitivities, mut sensitivity_errors) = (None, None);
    if output.sensitivities {
        let (corrector, displacement) = workspace.coarse.parts();
        let here = corrector.sensitivities(displacement, beta, state, cavity_shear, &mut context.effort);
        let (corrector, displacement) = workspace.fine.parts();
        let better = corrector.sensitivities(displacement, beta, &richer, cavity_shear, &mut context.effort);
        sensitivity_errors = Some(better.errors_beside(&here, &beyond.of_sensitivities()));
        sensitivities = Some(better);
    }
    Solution { quantities, errors, fields, sensitivities, sensitivity_errors }
}

/// Refuses a film under so much tension that it is not even good enough to go on from.
///
/// # Errors
/// [`FailureKind::Tension`].
pub(super) fn check_tension(tension: f64) -> Result<(), SolveError> {
    if tension < ROUGH_TENSION { Err(FailureKind::Tension { ratio: tension }.into()) } else { Ok(()) }
}

/// What decides whether a solution is accepted.
pub(super) struct Acceptance {
    /// Over the tolerance: the largest of the estimated errors, the extremes and the coarseness.
    pub(super) error: f64,
    /// The part of it that a longer mesh would mend.
    pub(super) cut: f64,
    /// Which of them is the largest.
    measure: ErrorMeasure,
    /// The smallest pressure over the largest.
    pub(super) tension: f64,
    /// The panel where the pressure is smallest.
    pub(super) place: usize,
    /// The length of the panel at the inlet over the longest that is accepted.
    pub(super) at_inlet: f64,
}

impl Acceptance {
    /// Estimates the errors of a solution, looks for tension, and at the panel at the inlet.
    pub(super) fn of(
        workspace: &mut Workspace,
        (parameters, state): (&Parameters, &State),
        output: &Output,
        tolerance: f64,
        context: &mut SolveContext,
    ) -> (Self, Estimate) {
        let case = (parameters.beta, state);
        let estimate = estimate(workspace, case, output.cavity_shear, tolerance, &mut context.effort);
        let reference = &workspace.coarse.displacement().discretisation.reference;
        let measures = [
            (estimate.worst() / tolerance, ErrorMeasure::Estimate),
            (estimate.extremes / tolerance, ErrorMeasure::Extremes),
            (coarseness(reference, state, tolerance), ErrorMeasure::Coarseness),
        ];
        let larger = |a: (f64, ErrorMeasure), b: (f64, ErrorMeasure)| if b.0 > a.0 { b } else { a };
        let (error, measure) = measures.into_iter().fold((0.0, ErrorMeasure::Estimate), larger);
        let (tension, place) = tension(reference, state);
        let at_inlet = panel_at_inlet(reference, state) / (LONGEST_AT_INLET * layer(parameters, state.c));
        (Self { error, cut: estimate.cut / tolerance, measure, tension, place, at_inlet }, estimate)
    }

    pub(super) fn is_accepted(&self) -> bool {
        self.error <= ACCEPTED && self.tension >= TENSION && self.at_inlet <= 1.0
    }

    /// How far the solution is from acceptance; at most 1 if it is accepted.
    pub(super) fn excess(&self) -> f64 {
        f64::max(self.error / ACCEPTED, self.tension / TENSION).max(self.at_inlet)
    }

    /// Why the solution is not accepted, on the last mesh.
    pub(super) fn failure(&self, tolerance: f64, panels: usize) -> FailureKind {
        if self.error > ACCEPTED {
            return FailureKind::ErrorTooLarge { measure: self.measure, times: self.error, tolerance, panels };
        }
        if self.tension < TENSION {
            return FailureKind::Tension { ratio: self.tension };
        }
        FailureKind::ErrorTooLarge { measure: ErrorMeasure::Coarseness, times: self.at_inlet, tolerance, panels }
    }
}

/// The square of the largest indicator, which is about the error of friction and flow, over the largest square that is
/// accepted. So a small estimate is never an accident of a coarse mesh, on which two errors happen to be alike.
fn coarseness(reference: &ReferencePanel, state: &State, tolerance: f64) -> f64 {
    let roughest = indicators(reference, state).into_iter().fold(0.0, f64::max);
    ACCEPTED * roughest * roughest / (RESOLVED * RESOLVED * tolerance)
}
