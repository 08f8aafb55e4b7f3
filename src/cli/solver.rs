//! The solver that a sweep asks for.

use crate::collocation::CollocationSolver;
use crate::continuation::{Interrupt, Interrupted, SolvedCase, solve_chain};
use crate::model::{Output, Parameters};
use crate::relaxation::RelaxationSolver;
use crate::sweep::{Method, SolverSettings};

/// One of the methods, with its settings.
pub enum Solver {
    /// Collocation.
    Collocation(CollocationSolver),
    /// Relaxation.
    Relaxation(RelaxationSolver),
}

impl Solver {
    /// The method that the settings name.
    pub fn new(settings: &SolverSettings) -> Self {
        match settings.method {
            Method::Collocation => Self::Collocation(CollocationSolver::new(settings.collocation())),
            Method::Relaxation => Self::Relaxation(RelaxationSolver::new(settings.relaxation)),
        }
    }

    /// Solves the cases of a chain in their order.
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop before the last case is done.
    pub fn solve_chain(
        &self,
        cases: &[Parameters],
        output: &Output,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        match self {
            Self::Collocation(solver) => solve_chain(solver, cases, output, interrupt),
            Self::Relaxation(solver) => solve_chain(solver, cases, output, interrupt),
        }
    }
}
