//! The corrector: Newton's method, with chord steps where they pay.

use super::displacement::Displacement;
use super::factorisation::Factorisation;
use super::matrix::Matrix;
use super::sensitivity::sensitivities;
use super::state::State;
use super::system::System;
use super::timings::{Timings, timed};
use crate::continuation::{Effort, FailureKind, SolveContext, SolveError};
use crate::model::{CavityShear, Sensitivities};

/// Iterations after which the corrector is given up.
const MOST_ITERATIONS: u64 = 40;
/// A step of so many times the solution, or of [`WILD`] times after [`SETTLED`] iterations, leads nowhere.
const LOST: f64 = 1e4;
const WILD: f64 = 2.0;
const SETTLED: u64 = 10;
/// A chord step that leaves more than this of the one before is not worth its while: a factorisation costs about five.
const CHORD_RATE: f64 = 0.2;
/// Steps that are as small as this may be made of rounding errors.
const STALLED: f64 = 1e-4;
/// Rounding error of the film (T12), whose terms are of order 1.
const ROUNDING: f64 = 2e-15;

/// Newton's method on one mesh; keeps its buffers from case to case.
#[derive(Default)]
pub struct Corrector {
    system: System,
    factorisation: Factorisation,
    /// Where the time went.
    pub timings: Timings,
}

impl Corrector {
    /// Takes a guess to the solution on its mesh, so near that what is left is below `tolerance` of u, c and the
    /// largest p, or as near as rounding allows: below 2·10⁻¹⁵ over the thinnest film, or where three whole steps of
    /// less than 10⁻⁴ did not get any smaller.
    ///
    /// The step is only shortened so far that the film stays positive.
    ///
    /// # Errors
    /// [`SolveError`] if it does not converge, or the user asks to stop.
    pub fn correct(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &mut State,
        tolerance: f64,
        context: &mut SolveContext,
    ) -> Result<(), SolveError> {
        let (mut before, mut fresh) = (f64::INFINITY, false);
        let (mut size, mut last, mut stalled) = (f64::INFINITY, f64::INFINITY, 0);
        for iteration in 1..=MOST_ITERATIONS {
            context.check_abort()?;
            context.effort.iterations += 1;
            self.linearise(displacement, beta, state);
            if !fresh {
                self.factorise(displacement, beta, state, &mut context.effort);
            }
            self.step(displacement, beta, state);
            size = self.system.size(state);
            if !size.is_finite() {
                return Err(FailureKind::NewtonBrokeDown.into());
            }
            let thinnest = state.film.iter().fold(state.c, |a, &u| a.min(u));
            let floor = ROUNDING / thinnest;
            if fresh && size > CHORD_RATE * before && size > floor {
                // about the same state again, with its own matrix
                self.linearise(displacement, beta, state);
                self.factorise(displacement, beta, state, &mut context.effort);
                self.step(displacement, beta, state);
                size = self.system.size(state);
                (before, fresh) = (f64::INFINITY, false);
            }
            context.note_residual(iteration, size);
            if size > LOST || (iteration >= SETTLED && size > WILD) {
                return Err(FailureKind::NewtonStalled { iterations: iteration, step: size }.into());
            }
            let part = self.system.admissible(state);
            self.system.advance(state, part);
            let rate = size / before;
            let left = if fresh && rate < 0.5 { size * rate / (1.0 - rate) } else { size };
            if part == 1.0 && (left <= tolerance || size <= floor) {
                return Ok(());
            }
            // Rounding moves the outlet by so little that only the steepest films notice: a whole step that is small
            // but no smaller than the ones before is the end of what arithmetic can do.
            stalled = if part == 1.0 && size < STALLED && size > 0.3 * last { stalled + 1 } else { 0 };
            if stalled == 3 {
                return Ok(());
            }
            last = size;
            fresh = part == 1.0 && size < 0.3;
            before = if fresh { size } else { f64::INFINITY };
        }
        Err(FailureKind::NewtonStalled { iterations: MOST_ITERATIONS, step: size }.into())
    }

    fn linearise(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        timed(&mut self.timings.assembly, || self.system.linearise(displacement, beta, state));
    }

    fn factorise(&mut self, displacement: &Displacement, beta: f64, state: &State, effort: &mut Effort) {
        let Self { system, factorisation, timings } = self;
        timed(&mut timings.assembly, || system.matrix(displacement, beta, state, &mut factorisation.matrix));
        timed(&mut timings.factorisation, || factorisation.factorise());
        effort.factorisations += 1;
    }

    /// The matrix about a state.
    pub fn matrix(&mut self, displacement: &Displacement, beta: f64, state: &State) -> &Matrix {
        self.linearise(displacement, beta, state);
        self.system.matrix(displacement, beta, state, &mut self.factorisation.matrix);
        &self.factorisation.matrix
    }

    /// How friction of a solution changes with its parameters.
    pub fn sensitivities(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &State,
        cavity_shear: CavityShear,
        effort: &mut Effort,
    ) -> Sensitivities {
        let Self { system, factorisation, timings } = self;
        effort.factorisations += 1;
        timed(&mut timings.sensitivities, || {
            sensitivities(system, factorisation, displacement, beta, state, cavity_shear)
        })
    }

    /// One step about a linearised state, not yet gone.
    fn step(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        let Self { system, factorisation, timings } = self;
        timed(&mut timings.step, || {
            system.fold_end(displacement, beta, state);
            factorisation.solve(&mut system.right_side);
            system.expand(displacement);
        });
    }

    /// A full Newton step, and chord steps until what they leave, about the square of the first, is below `remainder`.
    /// Returns what they leave.
    pub fn refine(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &mut State,
        remainder: f64,
        effort: &mut Effort,
    ) -> f64 {
        const MOST_STEPS: usize = 5;
        let (mut first, mut left) = (None, f64::INFINITY);
        for _ in 0..MOST_STEPS {
            self.linearise(displacement, beta, state);
            if first.is_none() {
                self.factorise(displacement, beta, state, effort);
            }
            self.step(displacement, beta, state);
            let size = self.system.size(state);
            self.system.advance(state, 1.0);
            let contraction = *first.get_or_insert(size);
            // a chord step leaves about as large a part of itself as the first step was of the solution
            left = size * contraction;
            if left <= remainder || !size.is_finite() {
                break;
            }
        }
        left
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::reference::ReferencePanel;
    use super::super::thick_film;
    use super::*;
    use crate::continuation::Interrupt;
    use crate::model::{DisplacementKernel, Parameters};

    fn prepared(beta: f64) -> (Displacement, State) {
        let mut displacement = Displacement::new(&Arc::new(ReferencePanel::new(8)));
        let kernel = DisplacementKernel::new(&Parameters::new(1.0, beta, 10.0));
        displacement.set_mesh(&thick_film::mesh(8, 3.0, beta, 1e3), &kernel, &mut Timings::default());
        let state = thick_film::state(&displacement, beta);
        (displacement, state)
    }

    #[test]
    fn nothing_is_allocated_once_the_buffers_are_there() {
        let (displacement, start) = prepared(0.02);
        let interrupt = Interrupt::new();
        let (mut corrector, mut context) = (Corrector::default(), SolveContext::new(&interrupt));
        corrector.correct(&displacement, 0.02, &mut start.clone(), 1e-10, &mut context).expect("a thick film");
        let mut state = start.clone();
        let mut converged = false;
        let count = allocation_counter::measure(|| {
            converged = corrector.correct(&displacement, 0.03, &mut state, 1e-10, &mut context).is_ok();
        });
        assert!(converged && context.effort.iterations > 4);
        assert_eq!(count.count_total, 0);
    }

    /// Newton's steps square; chord steps do not, but cost no factorisation.
    #[test]
    fn a_good_guess_needs_one_factorisation() {
        let (displacement, mut state) = prepared(0.02);
        let interrupt = Interrupt::new();
        let (mut corrector, mut context) = (Corrector::default(), SolveContext::new(&interrupt));
        corrector.correct(&displacement, 0.02, &mut state, 1e-12, &mut context).expect("a thick film");
        let before = context.effort;
        corrector.correct(&displacement, 0.0201, &mut state, 1e-12, &mut context).expect("a thick film");
        assert_eq!(context.effort.factorisations - before.factorisations, 1);
        assert!(context.effort.iterations - before.iterations <= 6);
    }

    #[test]
    fn an_interrupt_is_seen_at_every_iteration() {
        let (displacement, mut state) = prepared(0.02);
        let interrupt = Interrupt::new();
        interrupt.request();
        let mut context = SolveContext::new(&interrupt);
        let result = Corrector::default().correct(&displacement, 0.02, &mut state, 1e-12, &mut context);
        assert_eq!(result, Err(SolveError::Interrupted));
        assert_eq!(context.effort.iterations, 0);
    }

    #[test]
    fn a_hopeless_guess_ends_as_a_failure() {
        let (displacement, mut state) = prepared(0.02);
        state.c = f64::NAN;
        let interrupt = Interrupt::new();
        let mut context = SolveContext::new(&interrupt);
        let result = Corrector::default().correct(&displacement, 0.02, &mut state, 1e-12, &mut context);
        assert!(matches!(result, Err(SolveError::Failed(_))));
    }
}
