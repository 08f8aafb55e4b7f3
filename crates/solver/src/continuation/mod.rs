//! Chains of cases: each solution is the first guess of the next case, and other seeds are tried if it fails.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `chain.rs` | a chain, and the seeds that are tried for each case |
//! | `seed.rs` | the names of the seeds |
//! | `line.rs` | straight lines between cases in (ln α, ln β, ln(1+f)) |
//! | `walk.rs`, `step.rs` | steps along a line, and their lengths |
//! | `context.rs` | the cost of a case so far, and whether to abort it |
//! | `failure` | the kinds of failures, their sentences, and the attempts before |
//! | `path.rs`, `trace.rs` | how a case was reached, in short and in detail |

use std::sync::atomic::{AtomicBool, Ordering};

use crate::model::{Fields, Limits, Output, Parameters, Quantities, RelativeErrors, Sensitivities};

mod chain;
mod context;
mod failure;
mod line;
mod path;
mod seed;
mod step;
mod trace;
mod walk;
mod work_time;

pub use chain::{Chain, panic_message, solve_chain};
pub use context::{SolveContext, SolveError};
pub use failure::{ErrorMeasure, Failure, FailureKind, Iterations, Waypoint, kind_name_of_text};
pub use line::{Line, NoLine, distance, secant};
pub use path::{Path, PathPoint};
pub use seed::{NotASeed, Seed};
pub use step::StepControl;
pub use trace::{Event, Trace};

/// Set when the user asks the program to stop; solvers look at it often.
#[derive(Debug, Default)]
pub struct Interrupt(AtomicBool);

impl Interrupt {
    /// An interrupt that is not requested yet.
    pub const fn new() -> Self {
        Self(AtomicBool::new(false))
    }

    /// Asks all solvers to stop soon.
    pub fn request(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// True once [`Interrupt::request`] was called.
    pub fn requested(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// The cost of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Passes (relaxation) or Newton iterations (collocation), including those of failed attempts.
    pub iterations: u64,
    /// Matrix factorisations.
    pub factorisations: u64,
    /// Meshes for which a displacement was computed (collocation).
    pub meshes: u64,
    /// Size of the solution: unknowns of its system (collocation) or points of its grid (relaxation).
    pub unknowns: usize,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// The result of one case of a chain.
#[derive(Clone, Debug)]
pub struct SolvedCase {
    /// The solution, or why there is none.
    pub outcome: Result<Solution, Failure>,
    /// The limits beside the solution, known whether or not the case converged. [`Solver`](crate::Solver) computes them
    /// where they are asked for; a [`Chain`] alone leaves them unknown.
    pub limits: Limits,
    /// The seed that led to the solution; of a failed case the last seed that was tried.
    pub seed: Seed,
    /// How it was reached.
    pub path: Path,
    /// How it was reached in detail; empty unless the chain is [traced](Chain::traced).
    pub trace: Trace,
    /// The cost.
    pub effort: Effort,
}

impl SolvedCase {
    /// A failed case whose limits, seed, path and cost are not known.
    pub fn failed(failure: impl Into<Failure>) -> Self {
        Self {
            outcome: Err(failure.into()),
            limits: Limits::UNKNOWN,
            seed: Seed::None,
            path: Path::default(),
            trace: Trace::default(),
            effort: Effort::default(),
        }
    }
}

/// A converged case.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Its numbers.
    pub quantities: Quantities,
    /// Their estimated errors.
    pub errors: RelativeErrors,
    /// Its fields.
    pub fields: Fields,
    /// How its friction changes with its parameters, if that was asked for and the method knows it.
    pub sensitivities: Option<Sensitivities>,
    /// The estimated absolute errors of the sensitivities, where these are known.
    pub sensitivity_errors: Option<Sensitivities>,
}

/// The user asked to stop; the results of the chain in hand are dropped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("interrupted")]
pub struct Interrupted;

/// A method that takes a case from a first guess to its solution.
///
/// A chain is a list of cases on a straight [`Line`] with the same substrate; those of a plan have the same f and α,
/// and ascending β.
pub trait CaseSolver: Sync {
    /// What the cases of a chain share, and the buffers of the solver: one for each chain, used by one thread.
    type Workspace;
    /// A converged solution in the solver's own unknowns.
    type State: Clone;

    /// The workspace of the chain that begins with a case.
    ///
    /// # Errors
    /// [`Failure`] if no case of this kind can be solved.
    fn prepare(&self, parameters: &Parameters, output: &Output) -> Result<Self::Workspace, Failure>;

    /// Takes the workspace of a chain that is over; its memory may serve the next one, and nothing else of it.
    fn keep(&self, _: Self::Workspace) {}

    /// Whether the workspace of a chain that holds `from` is also good for `to`, and a line leads there.
    fn can_continue(&self, from: &Parameters, to: &Parameters) -> bool {
        Line::new(from, to).is_ok()
    }

    /// Cases from which a case can be reached when no neighbour helps, best first; the first may be the case itself.
    fn origins(&self, parameters: &Parameters) -> Vec<Parameters>;

    /// Whether a solved case is so far away that a case is better tried from the first of its
    /// [origins](CaseSolver::origins) before it is tried from there.
    fn is_far(&self, _from: &Parameters, _to: &Parameters) -> bool {
        false
    }

    /// How long the steps between cases may be.
    fn step_control(&self) -> StepControl;

    /// A first guess that needs no neighbour, and its seed.
    ///
    /// # Errors
    /// [`SolveError`] if there is none.
    fn start(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        context: &mut SolveContext,
    ) -> Result<(Self::State, Seed), SolveError>;

    /// A first guess from one or two solved cases, the nearest last; [`secant`] is the factor of an extrapolation.
    fn predict(
        &self,
        workspace: &mut Self::Workspace,
        solved: &[(Parameters, Self::State)],
        parameters: &Parameters,
    ) -> Self::State;

    /// The solution near a first guess.
    ///
    /// # Errors
    /// [`SolveError`] if the method does not converge or is interrupted. A conclusive [`Failure`] ends the search for
    /// the case in hand, also if it is met at a point on the way.
    fn solve(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        guess: Self::State,
        context: &mut SolveContext,
    ) -> Result<Self::State, SolveError>;

    /// Computes the numbers, fields and errors of a solution. May first improve the state until it is as accurate as
    /// wanted.
    ///
    /// # Errors
    /// [`SolveError`] if the solution is not accurate enough after all, or the user asks to stop.
    fn evaluate(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        state: &mut Self::State,
        output: &Output,
        context: &mut SolveContext,
    ) -> Result<Solution, SolveError>;
}
