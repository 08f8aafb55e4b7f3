//! From solved cases to another one, along a straight line: predictor, corrector, step control.

use std::borrow::Cow;

use super::{CaseSolver, FailureKind, Line, Path, Seed, SolveContext, SolveError, StepControl};
use crate::model::Parameters;

/// A remainder of less than this part of a step is added to it.
const REMAINDER: f64 = 0.01;

/// A solver at work on one case.
pub(super) struct Corrector<'a, 'w, S: CaseSolver> {
    pub(super) solver: &'a S,
    pub(super) workspace: &'a mut S::Workspace,
    pub(super) context: &'a mut SolveContext<'w>,
    pub(super) path: &'a mut Path,
    /// The seed of the attempt, and how far it went.
    pub(super) seed: &'a mut Seed,
}

impl<S: CaseSolver> Corrector<'_, '_, S> {
    /// The first guess from solved cases.
    pub(super) fn predict(&mut self, solved: &[(Parameters, S::State)], parameters: &Parameters) -> S::State {
        self.solver.predict(self.workspace, solved, parameters)
    }

    /// The solution near a guess; recorded in the path, with its iterations.
    pub(super) fn solve(&mut self, parameters: &Parameters, guess: S::State) -> Result<(S::State, u64), SolveError> {
        self.context.check_abort()?;
        let before = self.context.effort.iterations;
        self.context.note_attempt(parameters);
        let result = self.solver.solve(self.workspace, parameters, guess, self.context);
        let iterations = self.context.effort.iterations - before;
        self.path.record(parameters, iterations, result.is_ok());
        self.context.note_end(result.as_ref().map(drop));
        Ok((result?, iterations))
    }

    /// The solution at an origin from which `target` is to be reached, from the solver's own start there.
    pub(super) fn begin(&mut self, origin: &Parameters, target: &Parameters) -> Result<S::State, SolveError> {
        let start = self.solver.start(self.workspace, origin, self.context);
        let reached = start.and_then(|(guess, _)| self.solve(origin, guess));
        match reached {
            Ok((state, _)) => Ok(state),
            Err(SolveError::Failed(failure)) => Err(failure.at(origin, target).into()),
            Err(error) => Err(error),
        }
    }

    /// The solution at `target`, by way of points on the line from the last of `solved` (one or two cases, the nearest
    /// last). `points` counts those that were solved on the way.
    ///
    /// # Errors
    /// [`SolveError`] if there is no line, a step that would be too short is needed, a failure on the way is
    /// conclusive, or the user asks to stop.
    pub(super) fn walk(
        &mut self,
        mut solved: Cow<'_, [(Parameters, S::State)]>,
        target: &Parameters,
        first_step: f64,
        control: &StepControl,
        points: &mut usize,
    ) -> Result<S::State, SolveError> {
        let from = solved.last().expect("a walk starts at a solved case").0.clone();
        let line = Line::new(&from, target).map_err(FailureKind::from)?;
        let way = line.length();
        let (mut done, mut step) = (0.0, first_step);
        loop {
            let left = way - done;
            let last = left <= (1.0 + REMAINDER) * step;
            if last {
                step = left;
            }
            let here = if last { target.clone() } else { line.at((done + step) / way) };
            let guess = self.predict(&solved, &here);
            match self.solve(&here, guess) {
                Ok((state, _)) if last => return Ok(state),
                Ok((state, iterations)) => {
                    push(solved.to_mut(), here, state);
                    *points += 1;
                    done += step;
                    step = control.after_success(step, iterations);
                }
                Err(SolveError::Failed(failure)) => match control.after_failure(step, way) {
                    Some(shorter) if !failure.kind.is_conclusive() => step = shorter,
                    _ => return Err(failure.at(&here, target).into()),
                },
                Err(error) => return Err(error),
            }
        }
    }
}

/// Adds a solved case to the last one or two, of which two are kept.
pub(super) fn push<T>(solved: &mut Vec<(Parameters, T)>, parameters: Parameters, state: T) {
    if solved.len() == 2 {
        solved.remove(0);
    }
    solved.push((parameters, state));
}
