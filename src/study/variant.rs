//! A method at one of its settings, and what can be asked of it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use super::examination::{Examination, Examine, examine};
use stribeck_solver::collocation::{self, CollocationSolver};
use stribeck_solver::continuation::{Chain, Effort, Interrupt, Interrupted, SolvedCase, panic_message, solve_chain};
use stribeck_solver::relaxation::{self, RelaxationSolver};
use stribeck_solver::{FailureKind, Output, Parameters};

/// A method at one of its settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// Name of the method; the same for all its settings.
    pub method: String,
    /// The setting.
    pub setting: Setting,
}

/// What a method is varied by, and the rest of its settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// Collocation to a tolerance.
    Tolerance(collocation::Settings),
    /// Collocation on a fixed number of panels of a degree.
    Panels {
        /// Panels of the film.
        panels: usize,
        /// Degree of the pressure on each.
        degree: usize,
    },
    /// Relaxation on a grid.
    Grid(relaxation::Settings),
}

impl Setting {
    /// In a table: `tolerance 1e-5`, `12 panels of degree 8`, `801 points`.
    pub fn words(&self) -> String {
        match self {
            Setting::Tolerance(settings) => format!("tolerance {:e}", settings.tolerance),
            Setting::Panels { panels, degree } => format!("{panels} panels of degree {degree}"),
            Setting::Grid(settings) => format!("{} points", settings.points),
        }
    }

    /// In a picture: `1e-5`, `12`, `801`.
    pub fn mark(&self) -> String {
        match self {
            Setting::Tolerance(settings) => format!("{:e}", settings.tolerance),
            Setting::Panels { panels, .. } => panels.to_string(),
            Setting::Grid(settings) => settings.points.to_string(),
        }
    }

    /// A solver of its own, with nothing in it from other cases.
    pub(super) fn solver(&self) -> Box<dyn Subject> {
        match *self {
            Setting::Tolerance(settings) => Box::new(CollocationSolver::new(settings)),
            Setting::Panels { panels, degree } => Box::new(CollocationSolver::with_panels(panels, degree)),
            Setting::Grid(settings) => Box::new(RelaxationSolver::new(settings)),
        }
    }

    /// The same with an estimate of the errors, where it has none of itself and one is to be had.
    pub(super) fn estimating(self) -> Option<Self> {
        match self {
            Setting::Grid(settings) if settings.points >= relaxation::Settings::ESTIMATE_POINTS => {
                Some(Setting::Grid(relaxation::Settings { estimate: true, ..settings }))
            }
            _ => None,
        }
    }
}

/// Solves cases; a panic of the solver becomes failed cases with its message.
pub(super) fn guarded(
    cases: &[Parameters],
    solve: impl FnOnce() -> Result<Vec<SolvedCase>, Interrupted>,
) -> Result<Vec<SolvedCase>, Interrupted> {
    let start = Instant::now();
    catch_unwind(AssertUnwindSafe(solve)).unwrap_or_else(|payload| {
        let seconds = start.elapsed().as_secs_f64() / cases.len() as f64;
        let reason = format!("the solver panicked: {}; please report it", panic_message(payload.as_ref()));
        let effort = Effort { seconds, ..Effort::default() };
        let failed = SolvedCase { effort, ..SolvedCase::failed(FailureKind::Other(reason)) };
        Ok(vec![failed; cases.len()])
    })
}

/// A solver under study.
pub(super) trait Subject {
    /// Solves the cases of a chain.
    fn solve(
        &self,
        cases: &[Parameters],
        output: &Output,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted>;

    /// The same, and `look` at each case with what its solution looks like from the inside; `None` if it failed.
    fn examine(
        &self,
        cases: &[Parameters],
        output: &Output,
        interrupt: &Interrupt,
        look: &mut dyn FnMut(Option<Examination>),
    ) -> Result<Vec<SolvedCase>, Interrupted>;
}

impl<S: Examine> Subject for S {
    fn solve(
        &self,
        cases: &[Parameters],
        output: &Output,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        solve_chain(self, cases, output, interrupt)
    }

    fn examine(
        &self,
        cases: &[Parameters],
        output: &Output,
        interrupt: &Interrupt,
        look: &mut dyn FnMut(Option<Examination>),
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        let mut chain = Chain::new(self, output, interrupt);
        let solve = |case| {
            let solved = chain.solve(case)?;
            let last = if solved.outcome.is_ok() { chain.last() } else { None };
            look(last.map(|(workspace, parameters, state)| examine(self, workspace, parameters, state)));
            Ok(solved)
        };
        cases.iter().map(solve).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A panic is a failed row of each case, with its message and the time it took.
    #[test]
    fn a_panic_becomes_failed_cases() {
        let cases = [Parameters::elastic(10.0), Parameters::elastic(20.0)];
        let solved = guarded(&cases, || panic!("index out of bounds")).expect("nobody asked to stop");
        assert_eq!(solved.len(), 2);
        for case in solved {
            let reason = case.outcome.expect_err("failed").to_string();
            assert_eq!(reason, "the solver panicked: index out of bounds; please report it");
            assert!(case.effort.seconds > 0.0);
        }
    }
}
