//! How long the steps of a walk are.

/// Step lengths along a [`Line`](super::Line), in units of its logarithmic coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepControl {
    /// First step from an origin.
    pub first: f64,
    /// No step is longer than this, save the whole way from a neighbour, which is tried first.
    pub largest: f64,
    /// No failed step is followed by one shorter than this.
    pub smallest: f64,
    /// No failed step is followed by one shorter than this part of the whole way.
    pub smallest_part: f64,
    /// Length of a step over the length of the failed step before it.
    pub reduction: f64,
    /// Iterations of the corrector that make a step neither too long nor too short; `None` if a solver's iterations say
    /// nothing about the step, which then stays as it is.
    pub iterations: Option<f64>,
}

impl StepControl {
    /// The next step after one that took `iterations`: longer if these were few, shorter if they were many.
    pub fn after_success(&self, step: f64, iterations: u64) -> f64 {
        let Some(wanted) = self.iterations else { return step };
        let scaled = step * (wanted / iterations as f64).clamp(0.5, 3.0);
        scaled.max(self.smallest).min(self.largest)
    }

    /// The step in place of one that failed, on a way of the given length; `None` if it would be too short to be tried.
    pub fn after_failure(&self, step: f64, way: f64) -> Option<f64> {
        let shorter = (step * self.reduction).min(self.largest);
        (shorter >= self.smallest.max(self.smallest_part * way)).then_some(shorter)
    }
}
