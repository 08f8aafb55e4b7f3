//! From a first guess to the solution: the plain iteration, and the accelerated one that falls back on it.

use super::Acceleration;
use super::acceptance::check_accepted;
use super::anderson::Anderson;
use super::iteration::{Iteration, LOAD_GAIN, PASSES_PER_BALANCE};
use super::reynolds::Relaxation;
use super::stiffness::thin_film_number;
use crate::continuation::{FailureKind, Iterations, SolveContext, SolveError};

/// λ over the number that limits it where the film is thin, κ of [`Relaxation::Local`].
const THIN_FILM: f64 = 0.1;
/// The same number for a uniform factor, which the thinnest place keeps small everywhere.
const THINNEST_PLACE: f64 = 1.0;
/// ω where the film is thick.
const OVER_RELAXATION: f64 = 1.8;
/// The largest uniform λ_p.
const LARGEST_UNIFORM: f64 = 0.5;
/// Rounds between two looks at the residuals of the plain iteration.
const ROUNDS_PER_LOOK: usize = 20;
/// Passes over the points of the grid after which acceleration is given up: twice what any case needed.
const MOST_ACCELERATED_PASSES: usize = 25;
/// Looks with a smaller residual each after which a reduced step is doubled.
const GOOD_LOOKS: usize = 50;
/// How often the plain iteration may diverge, and how far its steps may be reduced, before it is given up.
const MOST_DIVERGENCES: usize = 40;
const LEAST_REDUCTION: f64 = 1e-3;
/// Passes over the points of the grid after which the iteration that acceleration falls back on is given up.
const MOST_LOCAL_PASSES: usize = 60;
/// A plain iteration with local factors stalls if it does not halve its residual in so many passes over the points of
/// the grid.
const STALL_LOCAL: u64 = 15;
/// The same limit for a uniform factor, over the square of the points: its slowest error is smooth and takes O(n²)
/// passes.
const STALL_UNIFORM: f64 = 0.5;
/// How often acceleration may run away before it is given up.
const MOST_RESTARTS: i32 = 5;
/// Rounds that Anderson acceleration looks back.
const DEPTH: usize = 20;
/// A residual this many times the best so far is taken for divergence.
const DIVERGED: f64 = 1e3;
/// A relative error of the load beyond this is taken for divergence too.
const FLOATING: f64 = 0.3;

/// What an iteration is to reach, and how long it may take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Largest residual of flow and load.
    pub tolerance: f64,
    /// Passes after which the plain iteration is given up.
    pub most_passes: u64,
}

/// Iterates until the residuals of the discrete equations are within the tolerance.
///
/// `stiffness` is M of [`Relaxation::Local`]. With [`Acceleration::Anderson`] a runaway or a stall ends the
/// acceleration, and the iteration starts again from where it began without it: what acceleration may cost is bounded,
/// and what it ends on is judged like any other state.
///
/// # Errors
/// [`SolveError::Failed`] says why there is no solution, the others that the work is not to go on. The iteration then
/// holds the best state it saw.
pub fn converge(
    iteration: &mut Iteration,
    acceleration: Acceleration,
    target: Target,
    stiffness: f64,
    context: &mut SolveContext,
) -> Result<(), SolveError> {
    let mut solver = Convergence { iteration, target, stiffness, context };
    match acceleration {
        Acceleration::None => solver.plain(Rule::Uniform),
        Acceleration::Anderson => {
            let start = solver.iteration.state();
            if solver.accelerated()? {
                return Ok(());
            }
            solver.iteration.restore(&start);
            let most_passes = (MOST_LOCAL_PASSES * solver.iteration.p.len()) as u64;
            solver.target.most_passes = solver.target.most_passes.min(most_passes);
            solver.plain(Rule::Local)
        }
    }
}

/// Which relaxation factors a plain iteration uses.
#[derive(Clone, Copy)]
enum Rule {
    Uniform,
    Local,
}

struct Convergence<'i, 's, 'w> {
    iteration: &'i mut Iteration<'s>,
    target: Target,
    stiffness: f64,
    context: &'i mut SolveContext<'w>,
}

impl Convergence<'_, '_, '_> {
    fn relaxation(&self, rule: Rule, reduction: f64) -> Relaxation {
        let thin_film = reduction * THIN_FILM * self.stiffness;
        match rule {
            Rule::Local => Relaxation::Local { over_relaxation: OVER_RELAXATION, thin_film },
            Rule::Uniform => {
                let dx = self.iteration.shared.grid.spacing();
                let film = self.iteration.film_min().max(0.0);
                let number = thin_film_number(dx, self.iteration.beta, film, self.stiffness);
                Relaxation::Uniform((reduction * THINNEST_PLACE / number).clamp(1e-4, LARGEST_UNIFORM))
            }
        }
    }

    /// Passes in which a plain iteration has to halve its residual.
    fn patience(&self, rule: Rule) -> u64 {
        let n = self.iteration.p.len();
        match rule {
            Rule::Local => STALL_LOCAL * n as u64,
            Rule::Uniform => (STALL_UNIFORM * (n * n) as f64) as u64,
        }
    }

    /// Rounds without acceleration. A divergence goes back to the best state and halves the steps of pressure and load;
    /// a stretch that goes well doubles them again.
    fn plain(&mut self, rule: Rule) -> Result<(), SolveError> {
        let mut best = self.iteration.state();
        let mut least = f64::INFINITY;
        let (mut reduction, mut divergences, mut good_looks) = (1.0, 0, 0);
        let first_pass = self.iteration.passes;
        let (mut milestone, mut milestone_pass) = (f64::INFINITY, first_pass);
        let patience = self.patience(rule);
        loop {
            let residuals = self.iteration.residuals();
            self.context.note_residual(self.iteration.passes, residuals.largest());
            if residuals.within(self.target.tolerance) {
                return Ok(check_accepted(self.iteration)?);
            }
            let size = residuals.largest();
            if size < least {
                least = size;
                self.iteration.save(&mut best);
                good_looks += 1;
                if good_looks == GOOD_LOOKS {
                    reduction = f64::min(1.0, 2.0 * reduction);
                    good_looks = 0;
                }
            } else if self.ran_away(size, least) {
                reduction *= 0.5;
                divergences += 1;
                good_looks = 0;
                self.iteration.restore(&best);
                if divergences > MOST_DIVERGENCES || reduction < LEAST_REDUCTION {
                    return Err(FailureKind::Diverged(self.iterations(least)).into());
                }
            }
            if least < 0.5 * milestone {
                (milestone, milestone_pass) = (least, self.iteration.passes);
            }
            let passes = self.iteration.passes;
            if passes - first_pass > self.target.most_passes || passes - milestone_pass > patience {
                self.iteration.restore(&best);
                return Err(FailureKind::Stalled(self.iterations(least)).into());
            }
            let relaxation = self.relaxation(rule, reduction);
            for _ in 0..ROUNDS_PER_LOOK {
                self.iteration.round(relaxation, reduction * LOAD_GAIN);
            }
            self.iteration.update_film();
            self.context.check_abort()?;
        }
    }

    /// Rounds with Anderson acceleration; false if it ran away, stalled, or ended in a state that is no solution.
    fn accelerated(&mut self) -> Result<bool, SolveError> {
        let n = self.iteration.p.len();
        let scale = self.iteration.c().abs();
        let (mut x, mut image) = (vec![0.0; n + 1], vec![0.0; n + 1]);
        let mut anderson = Anderson::new(n + 1, DEPTH);
        let mut best = self.iteration.state();
        let mut least = f64::INFINITY;
        let mut restarts = 0;
        let mut relaxation = self.relaxation(Rule::Local, 1.0);
        let most_passes = (self.target.most_passes as usize).min(MOST_ACCELERATED_PASSES * n);
        let most_rounds = most_passes / PASSES_PER_BALANCE;
        for _ in 0..most_rounds {
            let residuals = self.iteration.residuals();
            self.context.note_residual(self.iteration.passes, residuals.largest());
            if residuals.within(self.target.tolerance) {
                return match check_accepted(self.iteration) {
                    Ok(()) => Ok(true),
                    Err(FailureKind::FlowLost) => Ok(false),
                    Err(kind) => Err(kind.into()),
                };
            }
            let size = residuals.largest();
            if size < least {
                least = size;
                self.iteration.save(&mut best);
            } else if self.ran_away(size, least) {
                restarts += 1;
                if restarts > MOST_RESTARTS {
                    return Ok(false);
                }
                self.iteration.restore(&best);
                anderson.forget();
                // plain rounds first, more and smaller ones each time
                relaxation = self.relaxation(Rule::Local, 0.5_f64.powi(restarts));
                for _ in 0..ROUNDS_PER_LOOK << restarts {
                    self.iteration.round(relaxation, LOAD_GAIN);
                }
                self.iteration.update_film();
            }
            self.pack(scale, &mut x);
            self.iteration.round(relaxation, LOAD_GAIN);
            self.pack(scale, &mut image);
            anderson.mix(&x, &mut image);
            let (before, plain_separation) = (self.iteration.film_min(), self.iteration.separation);
            x[..n].copy_from_slice(&self.iteration.p);
            image[..n].iter_mut().for_each(|p| *p = p.max(0.0));
            self.iteration.replace(&image[..n], image[n] * scale);
            let after = self.iteration.film_min();
            if !(after > 0.1 * before && after < 10.0 * before) {
                // too long a step: the plain one instead, and a new history
                self.iteration.replace(&x[..n], plain_separation);
                anderson.forget();
            }
            self.context.check_abort()?;
        }
        Ok(false)
    }

    /// True if the film closed, or if residuals or load left the neighbourhood of the best state so far. A cylinder
    /// that floats off has small residuals of flow, but no load.
    fn ran_away(&self, size: f64, least: f64) -> bool {
        let carried = self.iteration.load_residual().abs() <= f64::max(FLOATING, 10.0 * least);
        let near = size < DIVERGED * least && self.iteration.film_min() > 0.0;
        !(carried && near)
    }

    /// The unknowns (p, h₀), the latter in units of the film so that both count.
    fn pack(&self, scale: f64, x: &mut [f64]) {
        let n = self.iteration.p.len();
        x[..n].copy_from_slice(&self.iteration.p);
        x[n] = self.iteration.separation / scale;
    }

    /// How far the iteration came: its least residual, and what that took.
    fn iterations(&self, residual: f64) -> Iterations {
        Iterations { residual, passes: self.iteration.passes, tolerance: self.target.tolerance }
    }
}

const _: () = assert!(PASSES_PER_BALANCE * ROUNDS_PER_LOOK <= 1000, "an interrupt is noticed within a moment");
