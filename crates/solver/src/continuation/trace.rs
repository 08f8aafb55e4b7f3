//! The record of every attempt, residual and error estimate on the way to a case.

use super::SolveError;
use crate::model::Parameters;

/// Iterations of an attempt whose residuals are all kept; of later ones ever fewer are.
const KEPT: u64 = 40;
/// A later residual is kept if its iteration number is this many times that of the residual kept before it.
const SPACING: f64 = 1.3;

/// The events on the way to a case, in their order. Like the path it is a function of the chain alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// The events.
    pub events: Vec<Event>,
}

/// Something that happened on the way to a case.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// The solver starts at a point.
    Attempt {
        /// α there.
        alpha: f64,
        /// β there.
        beta: f64,
        /// f there.
        f: f64,
    },
    /// What an iteration left: the step of Newton's method over the solution (collocation), or the larger one of the
    /// residuals of Reynolds' equation and of the load (relaxation).
    Residual {
        /// Iterations (collocation) or passes (relaxation) up to it; counted anew on each mesh or grid.
        iteration: u64,
        /// The residual.
        residual: f64,
    },
    /// The errors of a solution were estimated.
    Error {
        /// Unknowns of the solution.
        unknowns: usize,
        /// The largest of the estimates over the tolerance: at most 0.9 is accepted.
        error: f64,
    },
    /// The numbers, fields and errors of the solution are computed.
    Evaluation,
    /// The attempt, or the evaluation, succeeded.
    Solved,
    /// The attempt, or the evaluation, failed.
    Failed(SolveError),
}

impl Trace {
    pub(super) fn attempt(&mut self, at: &Parameters) {
        self.events.push(Event::Attempt { alpha: at.alpha, beta: at.beta, f: at.f });
    }

    pub(super) fn evaluation(&mut self) {
        self.events.push(Event::Evaluation);
    }

    pub(super) fn residual(&mut self, iteration: u64, residual: f64) {
        if let Some(Event::Residual { iteration: last, .. }) = self.events.last() {
            let anew = iteration <= *last;
            if !anew && iteration > KEPT && (iteration as f64) < SPACING * *last as f64 {
                return;
            }
        }
        self.events.push(Event::Residual { iteration, residual });
    }

    pub(super) fn error(&mut self, unknowns: usize, error: f64) {
        self.events.push(Event::Error { unknowns, error });
    }

    pub(super) fn end(&mut self, end: Result<(), &SolveError>) {
        self.events.push(match end {
            Ok(()) => Event::Solved,
            Err(error) => Event::Failed(error.clone()),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_residuals_are_thinned_and_a_new_series_begins_in_full() {
        let mut trace = Trace::default();
        for iteration in 1..=100_000 {
            trace.residual(iteration, 1.0 / iteration as f64);
        }
        let first = trace.events.len();
        assert!((40..80).contains(&first), "{first} kept");
        for iteration in 1..=5 {
            trace.residual(iteration, 0.5);
        }
        assert_eq!(trace.events.len(), first + 5);
    }
}
