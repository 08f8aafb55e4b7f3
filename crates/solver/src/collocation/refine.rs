//! The solution on richer panels, from that on the plain ones.

use super::displacement::Displacement;
use super::newton::Corrector;
use super::state::State;
use super::timings::timed;
use super::two_level::TwoLevel;
use crate::continuation::Effort;
use crate::linear::Factorisation;

/// Steps by the factors of the plain panels that cost as much as a factorisation of the richer ones.
const MOST_CHEAP_STEPS: usize = 8;
/// What such a step leaves, over it: less in nine cases of ten.
const LEFT: f64 = 0.3;
/// Steps by a factorisation of the richer ones.
const MOST_STEPS: usize = 5;

/// Newton's method on richer panels, with what it takes from the plain ones.
pub struct Refiner<'a> {
    /// The corrector of the richer panels.
    pub corrector: &'a mut Corrector,
    /// How the factors of the plain ones serve them.
    pub two_level: &'a mut TwoLevel,
    /// The factors of the solution on the plain ones, of a matrix near it.
    pub plain_factors: &'a mut Factorisation,
}

impl Refiner<'_> {
    /// Takes a guess so near to the solution that what is left is below `remainder`; returns what is left.
    ///
    /// Two or three steps by the factors of the plain panels do in most cases. Where too many would be needed a step by
    /// the matrix of the richer ones follows.
    pub fn refine(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &mut State,
        remainder: f64,
        effort: &mut Effort,
    ) -> f64 {
        let mut cheap = state.clone();
        if let Some(left) = self.refine_cheaply(displacement, beta, &mut cheap, remainder) {
            *state = cheap;
            return left;
        }
        self.refine_fully(displacement, beta, state, remainder, effort)
    }

    /// The same by the factors of the plain panels alone; `None` if these do too little.
    fn refine_cheaply(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &mut State,
        remainder: f64,
    ) -> Option<f64> {
        let Self { corrector, two_level, plain_factors } = self;
        let mut before = f64::INFINITY;
        for step in 1..=MOST_CHEAP_STEPS {
            corrector.linearise(displacement, beta, state, step > 1);
            let Corrector { system, timings, .. } = &mut **corrector;
            timed(&mut timings.step, || {
                if step == 1 {
                    two_level.linearise(system, displacement, beta, state);
                }
                system.fold_end(displacement, beta, state);
                two_level.solve(plain_factors, system);
                system.expand(displacement);
            });
            let (size, floor) = (system.size(state), state.rounding());
            let rate = size / before;
            // also where it is not a number
            if !(rate < 1.0 || size <= floor) {
                return None;
            }
            system.advance(state, 1.0);
            if size <= floor || LEFT * size <= remainder {
                return Some(f64::min(LEFT * size, remainder));
            }
            let needed = (remainder / (LEFT * size)).ln() / rate.ln();
            if step > 1 && step as f64 + needed > MOST_CHEAP_STEPS as f64 {
                return None;
            }
            before = size;
        }
        None
    }

    /// A full Newton step, and chord steps until what they leave, about the square of the first, is small enough.
    fn refine_fully(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &mut State,
        remainder: f64,
        effort: &mut Effort,
    ) -> f64 {
        let (mut first, mut left) = (None, f64::INFINITY);
        for step in 1..=MOST_STEPS {
            self.corrector.linearise(displacement, beta, state, step > 1);
            if first.is_none() {
                self.corrector.factorise(displacement, beta, state, effort);
            }
            self.corrector.step(displacement, beta, state);
            let size = self.corrector.system.size(state);
            self.corrector.system.advance(state, 1.0);
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
