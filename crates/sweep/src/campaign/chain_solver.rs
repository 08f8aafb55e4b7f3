//! The solver that a sweep asks for.

use std::time::Duration;

use crate::{Method, SolverSettings};
use stribeck_solver::collocation::CollocationSolver;
use stribeck_solver::continuation::{CaseSolver, Chain, Interrupt, Interrupted, SolvedCase};
use stribeck_solver::relaxation::RelaxationSolver;
use stribeck_solver::{Output, Parameters};

/// One of the methods with its settings, and the time that a case may take.
pub struct ChainSolver {
    method: AnySolver,
    /// `None` for as long as it takes.
    time_limit: Option<Duration>,
}

enum AnySolver {
    Collocation(CollocationSolver),
    Relaxation(RelaxationSolver),
}

impl ChainSolver {
    /// The method that the settings name.
    pub fn new(settings: &SolverSettings) -> Self {
        let method = match settings.method {
            Method::Collocation => AnySolver::Collocation(CollocationSolver::new(settings.collocation())),
            Method::Relaxation => AnySolver::Relaxation(RelaxationSolver::new(settings.relaxation)),
        };
        // Infinity, and what is as good as that, is no duration.
        Self { method, time_limit: Duration::try_from_secs_f64(settings.time_limit).ok() }
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
        match &self.method {
            AnySolver::Collocation(solver) => self.solve_each(solver, cases, false, output, interrupt),
            AnySolver::Relaxation(solver) => self.solve_each(solver, cases, false, output, interrupt),
        }
    }

    /// The last case of a chain, with a record of the way to it; `None` of no cases.
    pub fn trace_last(&self, cases: &[Parameters], output: &Output) -> Option<SolvedCase> {
        let nobody = Interrupt::new();
        let solved = match &self.method {
            AnySolver::Collocation(solver) => self.solve_each(solver, cases, true, output, &nobody),
            AnySolver::Relaxation(solver) => self.solve_each(solver, cases, true, output, &nobody),
        };
        solved.expect("nobody asks this chain to stop").pop()
    }

    fn solve_each<S: CaseSolver>(
        &self,
        solver: &S,
        cases: &[Parameters],
        trace_last: bool,
        output: &Output,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        let mut chain = Chain::new(solver, output, interrupt);
        if let Some(limit) = self.time_limit {
            chain = chain.within(limit);
        }
        let solve = |(place, case)| {
            chain.traced(trace_last && place + 1 == cases.len());
            chain.solve(case)
        };
        cases.iter().enumerate().map(solve).collect()
    }
}
