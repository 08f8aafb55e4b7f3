//! From one case to the next along a chain: seeds, predictor, retries.
//!
//! `line.rs` holds straight lines in (ln α, ln β, ln(1+f)), `step.rs` how long steps along them are, `walk.rs` the steps,
//! `chain.rs` the ladder of seeds of each case, `work.rs` what it costs and whether to go on, `path.rs` the record of how it
//! was reached, `trace.rs` the same in detail.

use std::fmt;
use std::str::FromStr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::model::{Failure, Fields, Limits, Output, Parameters, Quantities, RelativeErrors, Sensitivities};

mod chain;
mod line;
mod path;
mod step;
mod trace;
mod walk;
mod work;

pub use chain::panic_message;
pub use chain::{Chain, solve_chain};
pub use line::{Line, NoLine, distance, secant};
pub use path::{Path, PathPoint};
pub use step::StepControl;
pub use trace::{Event, Trace};
pub use work::{Halt, Work};

/// Set when the user asks the program to stop; solvers look at it often.
#[derive(Debug, Default)]
pub struct Interrupt(AtomicBool);

impl Interrupt {
    /// Not asked to stop.
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

/// Where the first guess of a case came from; recorded with the case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seed {
    /// There was no first guess at all.
    None,
    /// Hertz pressure on the dry contact.
    Hertz,
    /// Dry pressure, and the film of the elastic (EHL) solution at ā²β on the dry contact of half width ā.
    Elastic,
    /// The same where the dry contact is nearer to that of the instantaneous modulus.
    RescaledElastic,
    /// The film under a rigid cylinder on a rigid plane, at the case itself.
    ThickFilm,
    /// The converged neighbour along the chain.
    Neighbour,
    /// Extrapolated from the last two cases of the chain.
    Predictor,
    /// The neighbour, by way of so many intermediate points that are not published.
    Intermediate(usize),
    /// The start of another case where films are thicker, by way of so many cases that are not published, this one included.
    March(usize),
}

impl fmt::Display for Seed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Seed::None => formatter.write_str("none"),
            Seed::Hertz => formatter.write_str("hertz"),
            Seed::Elastic => formatter.write_str("elastic"),
            Seed::RescaledElastic => formatter.write_str("rescaled-elastic"),
            Seed::ThickFilm => formatter.write_str("thick-film"),
            Seed::Neighbour => formatter.write_str("neighbour"),
            Seed::Predictor => formatter.write_str("predictor"),
            Seed::Intermediate(points) => write!(formatter, "intermediate-{points}"),
            Seed::March(points) => write!(formatter, "march-{points}"),
        }
    }
}

/// A text that names no [`Seed`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not the name of a seed")]
pub struct NotASeed(String);

impl FromStr for Seed {
    type Err = NotASeed;

    /// The seed that is displayed as this text.
    fn from_str(text: &str) -> Result<Self, NotASeed> {
        let points = text.rsplit_once('-').and_then(|(_, points)| points.parse().ok()).unwrap_or(0);
        let seeds = [
            Seed::None,
            Seed::Hertz,
            Seed::Elastic,
            Seed::RescaledElastic,
            Seed::ThickFilm,
            Seed::Neighbour,
            Seed::Predictor,
            Seed::Intermediate(points),
            Seed::March(points),
        ];
        seeds.into_iter().find(|seed| seed.to_string() == text).ok_or_else(|| NotASeed(text.to_owned()))
    }
}

/// What a case cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Passes (relaxation) or Newton iterations (collocation), failed attempts included.
    pub iterations: u64,
    /// Matrix factorisations.
    pub factorisations: u64,
    /// Meshes that a displacement was computed for (collocation).
    pub meshes: u64,
    /// Numbers that the solution consists of: unknowns of its system (collocation) or points of its grid (relaxation).
    pub unknowns: usize,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// What came of one case of a chain.
#[derive(Clone, Debug)]
pub struct SolvedCase {
    /// The solution, or why there is none.
    pub outcome: Result<Solution, Failure>,
    /// Known whether or not the case converged.
    pub limits: Limits,
    /// The seed that led to the outcome (for a failure: the last one tried).
    pub seed: Seed,
    /// What ended the search before the method did; then there is no solution.
    pub cut: Option<Cut>,
    /// How it was reached.
    pub path: Path,
    /// How it was reached in detail; empty unless the chain is [traced](Chain::traced).
    pub trace: Trace,
    /// What it cost.
    pub effort: Effort,
}

impl SolvedCase {
    /// A case without a solution, whose seed, path and cost are not known.
    pub fn failed(failure: Failure, limits: Limits) -> Self {
        Self {
            outcome: Err(failure),
            limits,
            seed: Seed::None,
            cut: None,
            path: Path::default(),
            trace: Trace::default(),
            effort: Effort::default(),
        }
    }
}

/// What ended the search for a solution that the method would have gone on with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// The time that a case may take. The only outcome that depends on the machine.
    TimeLimit(Duration),
    /// A panic of the solver.
    Panic,
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
}

/// A chain that was given up because the user asked to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted;

/// A method that takes a case from a first guess to its solution.
///
/// A chain is a list of cases on a straight [`Line`] with the same substrate; those of a plan have the same f and α, and
/// ascending β.
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

    /// Whether the workspace of a chain that holds `from` is also good for `to`, and a line leads there.
    fn can_continue(&self, from: &Parameters, to: &Parameters) -> bool {
        Line::new(from, to).is_ok()
    }

    /// Places from which a case can be reached when no neighbour helps, best first; the first may be the case itself.
    fn origins(&self, parameters: &Parameters) -> Vec<Parameters>;

    /// How long the steps between cases may be.
    fn step_control(&self) -> StepControl;

    /// A first guess that needs no neighbour, and where it came from.
    ///
    /// # Errors
    /// [`Halt`] if there is none.
    fn start(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        work: &mut Work,
    ) -> Result<(Self::State, Seed), Halt>;

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
    /// [`Halt`] if the method does not converge or is interrupted. A conclusive [`Failure`] ends the search for the case
    /// in hand, also if it is met at a point on the way.
    fn solve(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        guess: Self::State,
        work: &mut Work,
    ) -> Result<Self::State, Halt>;

    /// What is to be known of a solution. May first improve the state until it is as accurate as wanted.
    ///
    /// # Errors
    /// [`Halt`] if there is nothing to be known after all, or the user asks to stop.
    fn evaluate(
        &self,
        workspace: &mut Self::Workspace,
        parameters: &Parameters,
        state: &mut Self::State,
        output: &Output,
        work: &mut Work,
    ) -> Result<Solution, Halt>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_is_read_as_it_is_written() {
        let alone = [Seed::None, Seed::Hertz, Seed::Elastic, Seed::RescaledElastic, Seed::ThickFilm, Seed::Neighbour];
        let counted = [0, 1, 12].into_iter().flat_map(|points| [Seed::Intermediate(points), Seed::March(points)]);
        for seed in alone.into_iter().chain([Seed::Predictor]).chain(counted) {
            assert_eq!(seed.to_string().parse(), Ok(seed));
        }
        for text in ["", "march", "march-", "march--1", "march-01", "Hertz", "hertz-1"] {
            assert!(text.parse::<Seed>().is_err(), "{text}");
        }
    }
}
