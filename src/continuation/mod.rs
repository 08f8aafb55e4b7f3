//! From one case to the next along a chain: seeds, predictor, retries.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::model::{Failure, Fields, Limits, Parameters, Quantities, RelativeErrors};

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
#[derive(Clone, Debug, PartialEq)]
pub enum Seed {
    /// The elastic (EHL) solution at the same β.
    Elastic,
    /// The elastic solution at β/(1+f), rescaled to the instantaneous modulus.
    RescaledElastic,
    /// The converged neighbour along the chain.
    Neighbour,
    /// Extrapolated from the last two cases of the chain.
    Predictor,
    /// The neighbour, by way of so many intermediate points that are not published.
    Intermediate(usize),
}

impl fmt::Display for Seed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Seed::Elastic => formatter.write_str("elastic"),
            Seed::RescaledElastic => formatter.write_str("rescaled-elastic"),
            Seed::Neighbour => formatter.write_str("neighbour"),
            Seed::Predictor => formatter.write_str("predictor"),
            Seed::Intermediate(points) => write!(formatter, "intermediate-{points}"),
        }
    }
}

/// What a case cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Passes (relaxation) or Newton iterations (collocation), failed attempts included.
    pub iterations: u64,
    /// Matrix factorisations.
    pub factorisations: u64,
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
    /// What it cost.
    pub effort: Effort,
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
}

/// A chain that was given up because the user asked to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted;

/// The cases of one chain: same f, α and substrate, β ascending.
pub type Chain = [Parameters];
