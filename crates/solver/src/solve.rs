//! One way to solve: cases, chains and lists of points, by the method that the settings name.

use std::time::{Duration, Instant};

use crate::collocation::{self, CollocationSolver};
use crate::continuation::{CaseSolver, Chain, Failure, FailureKind, Interrupt, Interrupted, Solution, SolvedCase};
use crate::exact::ChainLimits;
use crate::model::{Output, Parameters, SettingOutOfRange};
use crate::relaxation::{self, RelaxationSolver};

/// A numerical method with its settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The collocation method: fast, for nearly all parameters, with an error estimate that it meets.
    Collocation(collocation::Settings),
    /// The relaxation method of the paper: slow, on a uniform grid; independent of the other one.
    Relaxation(relaxation::Settings),
}

impl Default for Method {
    /// The collocation method at its default tolerance.
    fn default() -> Self {
        Self::Collocation(collocation::Settings::default())
    }
}

/// How to solve a case, and what to compute of its solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The method.
    pub method: Method,
    /// The time that a case may take; `None` for as long as it takes.
    pub time_limit: Option<Duration>,
    /// What to compute of a solution.
    pub output: Output,
}

impl Default for Settings {
    /// The collocation method with a tolerance of 1e-5, no time limit, and the numbers of a solution without its fields
    /// and limits.
    fn default() -> Self {
        Self { method: Method::default(), time_limit: None, output: Output::numbers() }
    }
}

/// Solves one case.
///
/// # Errors
/// [`Failure`] if the case has no solution that the method finds, or the method no such settings.
pub fn solve(parameters: &Parameters, settings: &Settings) -> Result<Solution, Failure> {
    let solver = Solver::new(settings);
    let solved = solver.solve_chain(std::slice::from_ref(parameters), &Interrupt::new());
    solved.expect("nobody interrupts").remove(0).outcome
}

/// A method that is ready to solve chains, from several threads too.
pub struct Solver {
    method: ReadyMethod,
    time_limit: Option<Duration>,
    output: Output,
}

enum ReadyMethod {
    Collocation(CollocationSolver),
    Relaxation(RelaxationSolver),
    /// With such settings every case fails.
    Refused(SettingOutOfRange),
}

impl Solver {
    /// A solver with the given settings. Where a setting is out of its range each case fails, and says so.
    pub fn new(settings: &Settings) -> Self {
        let checked = match &settings.method {
            Method::Collocation(settings) => settings.check(),
            Method::Relaxation(settings) => settings.check(),
        };
        let method = match (checked, settings.method) {
            (Err(why), _) => ReadyMethod::Refused(why),
            (Ok(()), Method::Collocation(settings)) => ReadyMethod::Collocation(CollocationSolver::new(settings)),
            (Ok(()), Method::Relaxation(settings)) => ReadyMethod::Relaxation(RelaxationSolver::new(settings)),
        };
        Self { method, time_limit: settings.time_limit, output: settings.output.clone() }
    }

    /// Solves the cases of a chain in their order; see [`solve_chain`](crate::continuation::solve_chain).
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop before the last case is done.
    pub fn solve_chain(&self, cases: &[Parameters], interrupt: &Interrupt) -> Result<Vec<SolvedCase>, Interrupted> {
        self.solve_cases(cases, false, interrupt)
    }

    /// Solves a chain and returns its last case, with a record of how it was reached; `None` of no cases.
    pub fn trace_last(&self, cases: &[Parameters]) -> Option<SolvedCase> {
        self.solve_cases(cases, true, &Interrupt::new()).expect("nobody interrupts").pop()
    }

    /// Whether a chain that holds `from` can go on with `to`.
    pub(crate) fn can_continue(&self, from: &Parameters, to: &Parameters) -> bool {
        match &self.method {
            ReadyMethod::Collocation(solver) => solver.can_continue(from, to),
            ReadyMethod::Relaxation(solver) => solver.can_continue(from, to),
            ReadyMethod::Refused(_) => false,
        }
    }

    fn solve_cases(
        &self,
        cases: &[Parameters],
        trace_last: bool,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        match &self.method {
            ReadyMethod::Collocation(solver) => self.solve_with(solver, cases, trace_last, interrupt),
            ReadyMethod::Relaxation(solver) => {
                // Its workspace holds the kernel of one α and f.
                let runs: Vec<&[Parameters]> = cases.chunk_by(|from, to| solver.can_continue(from, to)).collect();
                let last = runs.len().saturating_sub(1);
                let solve = |(place, run): (usize, &&[Parameters])| {
                    self.solve_with(solver, run, trace_last && place == last, interrupt)
                };
                Ok(runs.iter().enumerate().map(solve).collect::<Result<Vec<_>, _>>()?.concat())
            }
            ReadyMethod::Refused(why) => {
                Ok(cases.iter().map(|_| SolvedCase::failed(FailureKind::Setting(Box::new(why.clone())))).collect())
            }
        }
    }

    fn solve_with<S: CaseSolver>(
        &self,
        solver: &S,
        cases: &[Parameters],
        trace_last: bool,
        interrupt: &Interrupt,
    ) -> Result<Vec<SolvedCase>, Interrupted> {
        let mut limits = ChainLimits::default();
        let mut chain = Chain::new(solver, &self.output, interrupt);
        if let Some(limit) = self.time_limit {
            chain = chain.with_time_limit(limit);
        }
        let solve = |(place, case)| {
            chain.traced(trace_last && place + 1 == cases.len());
            let mut solved = chain.solve(case)?;
            if self.output.limits {
                let start = Instant::now();
                solved.limits = limits.of(case);
                solved.effort.seconds += start.elapsed().as_secs_f64();
            }
            Ok(solved)
        };
        cases.iter().enumerate().map(solve).collect()
    }
}
