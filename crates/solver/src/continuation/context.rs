//! The context of solving one case: its cost so far, when to abort it, and the record of what happened.

use std::time::Duration;

use super::work_time::work_time;
use super::{Effort, Failure, FailureKind, Interrupt, Trace};
use crate::model::Parameters;

/// Why a solver stops without a solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// The method finds no solution.
    #[error(transparent)]
    Failed(#[from] Failure),
    /// The user asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// The case has taken as long as it may.
    #[error("out of time")]
    OutOfTime,
}

impl From<FailureKind> for SolveError {
    fn from(kind: FailureKind) -> Self {
        Self::Failed(kind.into())
    }
}

/// The cost of a case so far, its deadline, and the record of what happens.
#[derive(Debug)]
pub struct SolveContext<'a> {
    /// Cost so far.
    pub effort: Effort,
    /// Set when the user asks to stop.
    pub interrupt: &'a Interrupt,
    /// Of the [`work_time`] of the thread.
    deadline: Option<Duration>,
    trace: Option<Trace>,
}

impl<'a> SolveContext<'a> {
    /// A context without a time limit or a record.
    pub fn new(interrupt: &'a Interrupt) -> Self {
        Self { effort: Effort::default(), interrupt, deadline: None, trace: None }
    }

    /// The same context with a limit of the time that this thread works from now on. The time in which it is stopped,
    /// or waits for a processor, does not count.
    #[must_use]
    pub fn with_time_limit(self, limit: Duration) -> Self {
        // A deadline that the clock cannot represent is no deadline.
        Self { deadline: work_time().checked_add(limit), ..self }
    }

    /// The same context with a record of what happens.
    #[must_use]
    pub fn traced(self) -> Self {
        Self { trace: Some(Trace::default()), ..self }
    }

    /// Checks whether to abort the case; solvers call it at every iteration.
    ///
    /// # Errors
    /// [`SolveError::Interrupted`] or [`SolveError::OutOfTime`] if so.
    pub fn check_abort(&self) -> Result<(), SolveError> {
        if self.interrupt.requested() {
            return Err(SolveError::Interrupted);
        }
        match self.deadline {
            Some(deadline) if work_time() >= deadline => Err(SolveError::OutOfTime),
            _ => Ok(()),
        }
    }

    /// Notes the residual that an iteration left, by its number in the present attempt.
    pub fn note_residual(&mut self, iteration: u64, residual: f64) {
        if let Some(trace) = &mut self.trace {
            trace.residual(iteration, residual);
        }
    }

    /// Notes the number of unknowns of a solution, and its estimated error over the tolerance.
    pub fn note_error(&mut self, unknowns: usize, error: f64) {
        if let Some(trace) = &mut self.trace {
            trace.error(unknowns, error);
        }
    }

    pub(super) fn note_attempt(&mut self, at: &Parameters) {
        if let Some(trace) = &mut self.trace {
            trace.attempt(at);
        }
    }

    pub(super) fn note_evaluation(&mut self) {
        if let Some(trace) = &mut self.trace {
            trace.evaluation();
        }
    }

    pub(super) fn note_end(&mut self, end: Result<(), &SolveError>) {
        if let Some(trace) = &mut self.trace {
            trace.end(end);
        }
    }

    /// Takes the record; empty without [`SolveContext::traced`].
    pub(super) fn take_trace(&mut self) -> Trace {
        self.trace.take().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_goes_on_until_it_is_interrupted_or_out_of_time() {
        let interrupt = Interrupt::new();
        let context = SolveContext::new(&interrupt);
        assert_eq!(context.check_abort(), Ok(()));
        assert_eq!(SolveContext::new(&interrupt).with_time_limit(Duration::from_secs(3600)).check_abort(), Ok(()));
        assert_eq!(
            SolveContext::new(&interrupt).with_time_limit(Duration::MAX).check_abort(),
            Ok(()),
            "longer than any clock"
        );
        assert_eq!(
            SolveContext::new(&interrupt).with_time_limit(Duration::ZERO).check_abort(),
            Err(SolveError::OutOfTime)
        );
        interrupt.request();
        assert_eq!(context.check_abort(), Err(SolveError::Interrupted));
        assert_eq!(
            SolveContext::new(&interrupt).with_time_limit(Duration::ZERO).check_abort(),
            Err(SolveError::Interrupted),
            "who asks comes first"
        );
    }
}
