//! From a first guess to the solution: the plain iteration, and the accelerated one that falls back on it.

use super::Acceleration;
use super::anderson::Anderson;
use super::iteration::{Iteration, LOAD_GAIN, PASSES_PER_BALANCE, index_of_largest};
use super::reynolds::{self, Relaxation};
use super::stiffness::thin_film_number;
use crate::continuation::{Halt, Interrupt};
use crate::model::Failure;

/// λ over the number that limits it where the film is thin, κ of [`Relaxation::Local`].
const THIN_FILM: f64 = 0.1;
/// The same for a factor that is uniform, and so kept small everywhere by the thinnest place.
const THINNEST_PLACE: f64 = 1.0;
/// ω where the film is thick.
const OVER_RELAXATION: f64 = 1.8;
/// The largest uniform λ_p.
const LARGEST_UNIFORM: f64 = 0.5;
/// Rounds between two looks at the residuals of the plain iteration.
const ROUNDS_PER_LOOK: usize = 20;
/// Rounds after which acceleration is given up: a small part of what the plain iteration may need.
const MOST_ACCELERATED_ROUNDS: usize = 6_000;
/// Looks with a smaller residual each after which a reduced step is doubled.
const GOOD_LOOKS: usize = 50;
/// How often the plain iteration may diverge, and how far its steps may be reduced, before it is given up.
const MOST_DIVERGENCES: usize = 40;
const LEAST_REDUCTION: f64 = 1e-3;
/// Passes after which the iteration that acceleration falls back on is given up.
const MOST_LOCAL_PASSES: u64 = 400_000;
/// How often acceleration may run away before it is given up.
const MOST_RESTARTS: i32 = 6;
/// Rounds that Anderson acceleration looks back.
const DEPTH: usize = 20;
/// A residual this many times the best so far is taken for divergence.
const DIVERGED: f64 = 1e3;
/// A relative error of the load beyond this is taken for divergence too.
const FLOATING: f64 = 0.3;
/// Largest error of the flow at mid-points that a grid may leave: beyond it the grid does not resolve the film.
const MOST_UNRESOLVED: f64 = 0.1;

/// Outlet and largest pressure lie at least so many points inside the grid.
const NEAREST_TO_AN_END: usize = 4;

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
/// `stiffness` is M of [`Relaxation::Local`]. With [`Acceleration::Anderson`] a runaway or a stall ends the acceleration,
/// and the iteration starts again from where it began without it: what acceleration may cost is bounded, and what it
/// ends on is judged like any other state.
///
/// # Errors
/// [`Halt::Failed`] says why there is no solution, [`Halt::Interrupted`] that the user asked to stop. The iteration then
/// holds the best state it saw.
pub fn converge(
    iteration: &mut Iteration,
    acceleration: Acceleration,
    target: Target,
    stiffness: f64,
    interrupt: &Interrupt,
) -> Result<(), Halt> {
    let mut solver = Convergence { iteration, target, stiffness, interrupt };
    match acceleration {
        Acceleration::None => solver.plain(Rule::Uniform),
        Acceleration::Anderson => {
            let start = solver.iteration.state();
            if solver.accelerated()? {
                return Ok(());
            }
            solver.iteration.restore(&start);
            solver.target.most_passes = solver.target.most_passes.min(MOST_LOCAL_PASSES);
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

struct Convergence<'i, 's> {
    iteration: &'i mut Iteration<'s>,
    target: Target,
    stiffness: f64,
    interrupt: &'i Interrupt,
}

impl Convergence<'_, '_> {
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

    /// Rounds without acceleration. A divergence goes back to the best state and halves the steps of pressure and load;
    /// a stretch that goes well doubles them again.
    fn plain(&mut self, rule: Rule) -> Result<(), Halt> {
        let mut best = self.iteration.state();
        let mut least = f64::INFINITY;
        let (mut reduction, mut divergences, mut good_looks) = (1.0, 0, 0);
        let first_pass = self.iteration.passes;
        loop {
            let residuals = self.iteration.residuals();
            if residuals.within(self.target.tolerance) {
                return self.check_grid().map_err(Halt::Failed);
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
                    return Err(self.failed("the iteration diverges with every relaxation factor tried", least));
                }
            }
            if self.iteration.passes - first_pass > self.target.most_passes {
                self.iteration.restore(&best);
                return Err(self.failed("the iteration stalls", least));
            }
            let relaxation = self.relaxation(rule, reduction);
            for _ in 0..ROUNDS_PER_LOOK {
                self.iteration.round(relaxation, reduction * LOAD_GAIN);
            }
            self.iteration.update_film();
            self.look_for_interrupt()?;
        }
    }

    /// Rounds with Anderson acceleration; false if it ran away, stalled, or ended in a state that is no solution.
    fn accelerated(&mut self) -> Result<bool, Halt> {
        let n = self.iteration.p.len();
        let scale = self.iteration.c().abs();
        let (mut x, mut image) = (vec![0.0; n + 1], vec![0.0; n + 1]);
        let mut anderson = Anderson::new(n + 1, DEPTH);
        let mut best = self.iteration.state();
        let mut least = f64::INFINITY;
        let mut restarts = 0;
        let mut relaxation = self.relaxation(Rule::Local, 1.0);
        let most_rounds = MOST_ACCELERATED_ROUNDS.min(self.target.most_passes as usize / PASSES_PER_BALANCE);
        for _ in 0..most_rounds {
            let residuals = self.iteration.residuals();
            if residuals.within(self.target.tolerance) {
                return match self.check_grid() {
                    Err(failure) if failure.conclusive => Err(Halt::Failed(failure)),
                    other => Ok(other.is_ok()),
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
            self.iteration.p.iter_mut().zip(&image).for_each(|(p, mixed)| *p = mixed.max(0.0));
            self.iteration.separation = image[n] * scale;
            self.iteration.update_film();
            let after = self.iteration.film_min();
            if !(after > 0.1 * before && after < 10.0 * before) {
                // too long a step: the plain one instead, and a new history
                self.iteration.p.copy_from_slice(&x[..n]);
                self.iteration.separation = plain_separation;
                self.iteration.update_film();
                anderson.forget();
            }
            self.look_for_interrupt()?;
        }
        Ok(false)
    }

    /// True if the film closed, or if residuals or load left the neighbourhood of the best state so far. A cylinder that
    /// floats off has small residuals of flow, but no load.
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

    fn look_for_interrupt(&self) -> Result<(), Halt> {
        if self.interrupt.requested() { Err(Halt::Interrupted) } else { Ok(()) }
    }

    fn failed(&self, what: &str, residual: f64) -> Halt {
        let (passes, tolerance) = (self.iteration.passes, self.target.tolerance);
        Halt::Failed(Failure::new(format!(
            "{what}: residual {residual:.1e} after {passes} passes, tolerance {tolerance:.1e}"
        )))
    }

    /// A converged state is a solution only on a grid that holds the film and resolves it.
    ///
    /// Small residuals alone are not enough: a cylinder that leans its load on an end of the grid has them too.
    fn check_grid(&self) -> Result<(), Failure> {
        let iteration = &self.iteration;
        let grid = &iteration.shared.grid;
        let outlet = iteration.p.iter().position(|&p| p > 0.0).unwrap_or(0);
        if outlet < NEAREST_TO_AN_END || index_of_largest(&iteration.p) + NEAREST_TO_AN_END >= grid.points {
            let (x_min, x_max) = (grid.x_min, grid.x_max);
            return Err(Failure::new(format!(
                "the film under pressure is longer than the grid, [{x_min:.3}, {x_max:.3}]; \
                 set a wider domain = [x_min, x_max] in [solver.relaxation]"
            )));
        }
        let c = iteration.c();
        let error = reynolds::conservation_error(&iteration.p, &iteration.u, iteration.beta, grid.spacing(), c);
        if error <= MOST_UNRESOLVED && iteration.film_min() > 0.0 {
            return Ok(());
        }
        if error <= 1.0 {
            let reason = format!(
                "the grid does not resolve the film: the flow at mid-points is wrong by {:.0} % of it; use more points",
                100.0 * error
            );
            return Err(Failure { reason, conclusive: true });
        }
        Err(Failure::new(
            "the iteration ends in a state that does not conserve the flow at all; use more points".into(),
        ))
    }
}

const _: () = assert!(PASSES_PER_BALANCE * ROUNDS_PER_LOOK <= 1000, "an interrupt is noticed within a moment");
