//! Collocation on a fixed number of panels: to study the method, not to use it.

use super::acceptance::{Acceptance, check_tension, complete};
use super::adaptation::Panels;
use super::scaling::Scaling;
use super::settings::Settings;
use super::solver::CollocationSolver;
use super::state::State;
use super::workspace::Workspace;
use crate::continuation::{FailureKind, Solution, SolveContext, SolveError};
use crate::model::{Output, Parameters};

/// Meshes of a fixed number of panels, each laid out by the solution on the one before.
const FIXED_MESHES: usize = 3;

impl CollocationSolver {
    /// A solver with a fixed number of panels of a degree; its error is estimated but not controlled. On the way to a
    /// case panels are as many as Newton's method needs.
    ///
    /// # Panics
    /// If they are outside of [`Settings::PANELS`] and [`Settings::DEGREE`].
    pub fn with_panels(panels: usize, degree: usize) -> Self {
        assert!(Settings::PANELS.contains(&panels), "no solver with {panels} panels");
        Self { panels: Some(panels), ..Self::new(Settings { tolerance: *Settings::TOLERANCE.start(), degree }) }
    }

    /// The solution on the fixed number of panels, laid out for it, whatever its error is.
    ///
    /// # Errors
    /// [`SolveError`] if sizes that change gradually take more panels, Newton's method fails, the film is under
    /// tension, or the user asks to stop.
    pub(super) fn evaluate_on_fixed_panels(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        state: &mut State,
        output: &Output,
        context: &mut SolveContext,
    ) -> Result<Solution, SolveError> {
        let panels = self.panels.expect("a solver with a fixed number of panels");
        let beta = parameters.beta;
        let reach = self.reach(Scaling::new(workspace.half_width(), beta));
        for _ in 0..FIXED_MESHES {
            *state = self.remeshed(parameters, state, Panels::Number(panels), reach);
            let least = state.mesh.panels();
            if least > panels {
                return Err(FailureKind::TooFewPanels { least, panels }.into());
            }
            self.correct(workspace, beta, state, context)?;
        }
        let (acceptance, solution) =
            Acceptance::of(workspace, (parameters, &*state), output, self.settings.tolerance, context);
        check_tension(acceptance.tension)?;
        Ok(complete(workspace, (beta, state), solution, output, context))
    }
}
