//! A solution from the inside of its method.

use super::condition::condition;
use stribeck_solver::Parameters;
use stribeck_solver::collocation::CollocationSolver;
use stribeck_solver::continuation::CaseSolver;
use stribeck_solver::relaxation::RelaxationSolver;

/// The most equations of which a condition number is computed. The time grows with their cube: fifteen seconds for this
/// many.
pub const MOST_EQUATIONS: usize = 2001;

/// The state of a solution inside its method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Examination {
    /// The smallest pressure over the largest; 0 where it is nowhere negative.
    pub tension: f64,
    /// Condition number of the equations about the solution, equilibrated. It is infinite if they are singular, and
    /// `None` if they are more than [`MOST_EQUATIONS`].
    pub condition: Option<f64>,
}

/// A method whose solutions can be examined from the inside.
pub(super) trait Examine: CaseSolver {
    /// The smallest pressure over the largest.
    fn tension(&self, state: &Self::State) -> f64;

    /// The number of equations, at most.
    fn equations(&self, state: &Self::State) -> usize;

    /// The matrix of the linearised equations about a solution, column by column.
    fn jacobian(&self, workspace: &mut Self::Workspace, parameters: &Parameters, state: &Self::State) -> Vec<Vec<f64>>;
}

impl Examine for CollocationSolver {
    fn tension(&self, state: &Self::State) -> f64 {
        self.tension(state)
    }

    fn equations(&self, state: &Self::State) -> usize {
        state.pressure.len()
    }

    fn jacobian(&self, workspace: &mut Self::Workspace, parameters: &Parameters, state: &Self::State) -> Vec<Vec<f64>> {
        self.jacobian(workspace, parameters, state)
    }
}

impl Examine for RelaxationSolver {
    fn tension(&self, state: &Self::State) -> f64 {
        let (least, most) = state.pressure.iter().fold((0.0_f64, 0.0_f64), |(a, b), &p| (a.min(p), b.max(p)));
        least / most
    }

    fn equations(&self, state: &Self::State) -> usize {
        state.pressure.len()
    }

    fn jacobian(&self, workspace: &mut Self::Workspace, parameters: &Parameters, state: &Self::State) -> Vec<Vec<f64>> {
        self.jacobian(workspace, parameters, state)
    }
}

/// Examines a solution.
pub(super) fn examine<S: Examine>(
    solver: &S,
    workspace: &mut S::Workspace,
    parameters: &Parameters,
    state: &S::State,
) -> Examination {
    let few = solver.equations(state) <= MOST_EQUATIONS;
    let condition = few.then(|| condition(&solver.jacobian(workspace, parameters, state)));
    Examination { tension: solver.tension(state), condition }
}
