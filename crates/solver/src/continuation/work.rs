//! The work on one case: what it has cost, whether to go on with it, and what happened on the way.

use std::time::{Duration, Instant};

use super::{Effort, Interrupt, Trace};
use crate::model::{Failure, Parameters};

/// Why a solver stops without a solution.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// There is none to be found, for this reason.
    Failed(Failure),
    /// The user asked to stop.
    Interrupted,
    /// The case has taken as long as it may.
    OutOfTime,
}

/// What a case has cost so far, and whether to go on with it.
#[derive(Debug)]
pub struct Work<'a> {
    /// Cost so far.
    pub effort: Effort,
    /// Set when the user asks to stop.
    pub interrupt: &'a Interrupt,
    deadline: Option<Instant>,
    trace: Option<Trace>,
}

impl<'a> Work<'a> {
    /// Nothing done yet, and all the time that it takes.
    pub fn new(interrupt: &'a Interrupt) -> Self {
        Self { effort: Effort::default(), interrupt, deadline: None, trace: None }
    }

    /// The same with a limit to the time it may take, from now on.
    #[must_use]
    pub fn within(self, limit: Duration) -> Self {
        // A moment beyond what a clock can tell is none.
        Self { deadline: Instant::now().checked_add(limit), ..self }
    }

    /// The same with a record of what happens.
    #[must_use]
    pub fn traced(self) -> Self {
        Self { trace: Some(Trace::default()), ..self }
    }

    /// Whether to go on: solvers ask at every iteration.
    ///
    /// # Errors
    /// [`Halt::Interrupted`] or [`Halt::OutOfTime`] if not.
    pub fn go_on(&self) -> Result<(), Halt> {
        if self.interrupt.requested() {
            return Err(Halt::Interrupted);
        }
        match self.deadline {
            Some(deadline) if Instant::now() >= deadline => Err(Halt::OutOfTime),
            _ => Ok(()),
        }
    }

    /// Notes the residual that an iteration left, by its number in the present attempt.
    pub fn note_residual(&mut self, iteration: u64, residual: f64) {
        if let Some(trace) = &mut self.trace {
            trace.residual(iteration, residual);
        }
    }

    /// Notes the estimated error of a solution with so many unknowns, over the tolerance.
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

    pub(super) fn note_end(&mut self, end: Result<(), &Halt>) {
        if let Some(trace) = &mut self.trace {
            trace.end(end);
        }
    }

    /// What was recorded; empty if nothing was to be.
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
        let work = Work::new(&interrupt);
        assert_eq!(work.go_on(), Ok(()));
        assert_eq!(Work::new(&interrupt).within(Duration::from_secs(3600)).go_on(), Ok(()));
        assert_eq!(Work::new(&interrupt).within(Duration::MAX).go_on(), Ok(()), "longer than any clock");
        assert_eq!(Work::new(&interrupt).within(Duration::ZERO).go_on(), Err(Halt::OutOfTime));
        interrupt.request();
        assert_eq!(work.go_on(), Err(Halt::Interrupted));
        assert_eq!(
            Work::new(&interrupt).within(Duration::ZERO).go_on(),
            Err(Halt::Interrupted),
            "who asks comes first"
        );
    }
}
