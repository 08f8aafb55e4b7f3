//! The record of how a case was reached.

use crate::model::Parameters;

/// A point at which the solver was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// α there.
    pub alpha: f64,
    /// β there.
    pub beta: f64,
    /// f there.
    pub f: f64,
    /// Iterations of the solver.
    pub iterations: u64,
    /// Whether the solver converged.
    pub accepted: bool,
}

/// The points at which the solver was tried for one case, in their order, those of failed attempts included. Empty if
/// the first guess of all led to the solution. It is a function of the chain alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// The points.
    pub points: Vec<PathPoint>,
}

impl Path {
    pub(super) fn record(&mut self, parameters: &Parameters, iterations: u64, accepted: bool) {
        let &Parameters { alpha, beta, f, .. } = parameters;
        self.points.push(PathPoint { alpha, beta, f, iterations, accepted });
    }
}
