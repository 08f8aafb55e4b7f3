//! The corrector: Newton's method, with chord steps where they pay.

use std::sync::Arc;

use super::displacement::Displacement;
use super::mesh::Mesh;
use super::sensitivity::sensitivities;
use super::state::State;
use super::system::System;
use super::timings::{Timings, timed};
use crate::continuation::{Effort, FailureKind, SolveContext, SolveError};
use crate::linear::{Factorisation, Matrix};
use crate::model::{CavityShear, Sensitivities};

/// Iterations after which the corrector is given up.
const MOST_ITERATIONS: u64 = 40;
/// A step of so many times the solution, or of [`WILD`] times after [`SETTLED`] iterations, leads nowhere.
const LOST: f64 = 1e4;
const WILD: f64 = 2.0;
const SETTLED: u64 = 10;
/// A chord step that leaves more than this of the one before is not worth its while: a factorisation costs about ten.
const CHORD_RATE: f64 = 0.3;
/// A larger step by the factors at hand is not gone, and after a larger one they are not used again.
const CHORD_STEP: f64 = 0.3;
/// Steps that are as small as this may be made of rounding errors.
const STALLED: f64 = 1e-4;

/// Newton's method on one mesh; keeps its buffers from case to case.
#[derive(Default)]
pub struct Corrector {
    /// The equations.
    pub(super) system: System,
    /// The factors of the last matrix.
    pub(super) factorisation: Factorisation,
    /// Those of the adjoint method: the next case uses the others.
    adjoint_factors: Factorisation,
    /// The mesh of the matrix that the last factors are of.
    factored: Option<Arc<Mesh>>,
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
        // whether the factors at hand are used, and the size of the last step by them
        let (mut chord, mut before) = (self.is_factored(&state.mesh), None);
        let (mut size, mut last, mut stalled) = (f64::INFINITY, f64::INFINITY, 0);
        for iteration in 1..=MOST_ITERATIONS {
            context.check_abort()?;
            context.effort.iterations += 1;
            self.linearise(displacement, beta, state, iteration > 1);
            if !chord {
                self.factorise(displacement, beta, state, &mut context.effort);
            }
            self.step(displacement, beta, state);
            size = self.system.size(state);
            let floor = state.rounding();
            let good = size <= before.map_or(CHORD_STEP, |before| CHORD_RATE * before) || size <= floor;
            if chord && !good {
                // about the same state again, with its own matrix
                self.linearise(displacement, beta, state, true);
                self.factorise(displacement, beta, state, &mut context.effort);
                self.step(displacement, beta, state);
                size = self.system.size(state);
                before = None;
            }
            if !size.is_finite() {
                return Err(FailureKind::NewtonBrokeDown.into());
            }
            context.note_residual(iteration, size);
            if size > LOST || (iteration >= SETTLED && size > WILD) {
                return Err(FailureKind::NewtonStalled { iterations: iteration, step: size }.into());
            }
            let part = self.system.admissible(state);
            self.system.advance(state, part);
            let left = match before.map(|before: f64| size / before) {
                Some(rate) if rate < 0.5 => size * rate / (1.0 - rate),
                _ => size,
            };
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
            chord = part == 1.0 && size < CHORD_STEP;
            before = chord.then_some(size);
        }
        Err(FailureKind::NewtonStalled { iterations: MOST_ITERATIONS, step: size }.into())
    }

    /// Residuals of a state; `advanced` if it is the one that the last step led to.
    pub fn linearise(&mut self, displacement: &Displacement, beta: f64, state: &State, advanced: bool) {
        let Self { system, timings, .. } = self;
        timed(&mut timings.assembly, || {
            if advanced {
                system.linearise_advanced(displacement, beta, state);
            } else {
                system.linearise(displacement, beta, state);
            }
        });
    }

    /// The factors of the matrix about a linearised state.
    pub fn factorise(&mut self, displacement: &Displacement, beta: f64, state: &State, effort: &mut Effort) {
        let Self { system, factorisation, timings, .. } = self;
        timed(&mut timings.assembly, || system.matrix(displacement, beta, state, &mut factorisation.matrix));
        timed(&mut timings.factorisation, || factorisation.factorise());
        self.factored = Some(Arc::clone(&state.mesh));
        effort.factorisations += 1;
    }

    /// Whether there are factors of a matrix on this very mesh, be it of the case before.
    fn is_factored(&self, mesh: &Arc<Mesh>) -> bool {
        self.factored.as_ref().is_some_and(|factored| Arc::ptr_eq(factored, mesh))
    }

    /// Forgets all but its memory.
    pub fn renew(&mut self) {
        self.factored = None;
        self.timings = Timings::default();
    }

    /// The matrix about a state.
    pub fn matrix(&mut self, displacement: &Displacement, beta: f64, state: &State) -> &Matrix {
        self.factored = None;
        self.linearise(displacement, beta, state, false);
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
        let Self { system, adjoint_factors, timings, .. } = self;
        effort.factorisations += 1;
        timed(&mut timings.sensitivities, || {
            sensitivities(system, adjoint_factors, displacement, beta, state, cavity_shear)
        })
    }

    /// One step about a linearised state, not yet gone.
    pub fn step(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        let Self { system, factorisation, timings, .. } = self;
        timed(&mut timings.step, || {
            system.fold_end(displacement, beta, state);
            factorisation.solve(&mut system.right_side);
            system.expand(displacement);
        });
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

    /// Newton's steps square; chord steps do not, but cost no factorisation, not even the first ones.
    #[test]
    fn a_good_guess_needs_no_factorisation() {
        let (displacement, mut state) = prepared(0.02);
        let interrupt = Interrupt::new();
        let (mut corrector, mut context) = (Corrector::default(), SolveContext::new(&interrupt));
        corrector.correct(&displacement, 0.02, &mut state, 1e-12, &mut context).expect("a thick film");
        let before = context.effort;
        corrector.correct(&displacement, 0.0201, &mut state, 1e-12, &mut context).expect("a thick film");
        assert_eq!(context.effort.factorisations, before.factorisations);
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
