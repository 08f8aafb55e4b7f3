//! The relaxation method as a [`CaseSolver`].

use std::collections::HashMap;
use std::f64::consts::LN_10;
use std::iter;
use std::sync::{Arc, Mutex, PoisonError};

use super::acceptance::{check_resolvable, elastic_film, film_on_contact};
use super::convergence::{Target, converge};
use super::far_field::FarField;
use super::fields::fields;
use super::iteration::{Discretisation, Iteration, levelled_kernel};
use super::quantities::quantities;
use super::stiffness::{stiffness, thin_film_number};
use super::{Domain, Grid, Settings, State};
use crate::continuation::{
    CaseSolver, Failure, FailureKind, Seed, Solution, SolveContext, SolveError, StepControl, secant,
};
use crate::exact;
use crate::model::{CavityShear, FieldSelection, Lubricant, Output, Parameters, Quantities, RelativeErrors};

/// Passes after which the plain iteration is given up.
const MOST_PASSES: u64 = 2_000_000;
/// Passes after which the plain iteration for a first guess on a coarse grid is given up.
const ROUGH_PASSES: u64 = 20_000;
/// Decades of β below a case from which it is reached by way of thicker films when its own start fails.
const MARCH_DECADES: [i32; 2] = [1, 2];
/// Steps of such a march in each decade.
const MARCH_STEPS: f64 = 4.0;
/// The largest [`thin_film_number`] of a grid that is of use for a first guess.
const COARSEST: f64 = 20.0;

/// The relaxation solver with given settings. Elastic solutions that start chains are solved once and shared.
pub struct RelaxationSolver {
    settings: Settings,
    /// Elastic solutions by the bits of their β; a thread that needs one being solved by another waits for it.
    elastic: Mutex<HashMap<u64, Arc<SharedSeed>>>,
}

/// An elastic solution and the grid it lives on.
type ElasticSeed = Arc<(Grid, State)>;

/// An elastic solution, or its failure, once the first thread that needs it has solved it; the other threads wait.
type SharedSeed = Mutex<Option<Result<ElasticSeed, Failure>>>;

/// The discrete equations of a case on one of the grids.
#[derive(Clone, Copy)]
struct Equations<'a> {
    level: &'a Discretisation,
    /// M of [`super::reynolds::Relaxation::Local`].
    stiffness: f64,
    beta: f64,
}

/// The data that the cases of one (α, f) share: the cases of a chain for this solver differ in β alone.
pub struct Workspace {
    /// Finest grid first, each of half the intervals of the one before.
    levels: Vec<Discretisation>,
    /// M of [`super::reynolds::Relaxation::Local`].
    stiffness: f64,
    /// The points of the output beyond the grid.
    beyond: FarField,
}

impl Workspace {
    /// The grid of the solution, with its matrices.
    pub(super) fn finest(&self) -> &Discretisation {
        &self.levels[0]
    }

    fn equations<'a>(&self, level: &'a Discretisation, beta: f64) -> Equations<'a> {
        Equations { level, stiffness: self.stiffness, beta }
    }

    /// See [`check_resolvable`].
    fn check_resolvable(&self, parameters: &Parameters) -> Result<(), SolveError> {
        Ok(check_resolvable(parameters, &self.finest().grid, self.stiffness)?)
    }
}

impl RelaxationSolver {
    /// A solver with the given settings.
    pub fn new(settings: Settings) -> Self {
        Self { settings, elastic: Mutex::default() }
    }

    fn target(&self) -> Target {
        Target { tolerance: self.settings.tolerance, most_passes: MOST_PASSES }
    }

    /// The grid of a case: on its dry contact, or where the settings want it.
    fn grid(&self, parameters: &Parameters) -> Result<Grid, Failure> {
        let (trailing, leading, _) = exact::contact_bounds(parameters);
        match self.settings.domain {
            Domain::Auto => Ok(self.automatic_grid(parameters)),
            Domain::Fixed { x_min, x_max } if x_min < trailing && leading < x_max && x_max > 0.0 => {
                Ok(Grid { x_min, x_max, points: self.settings.points })
            }
            Domain::Fixed { x_min, x_max } => {
                Err(FailureKind::DomainTooNarrow { domain: [x_min, x_max], contact: [trailing, leading] }.into())
            }
        }
    }

    fn automatic_grid(&self, parameters: &Parameters) -> Grid {
        let (trailing, leading, half_width) = exact::contact_bounds(parameters);
        let (x_min, x_max) = (trailing - 2.0 * half_width, leading + 3.0 * half_width);
        Grid { x_min, x_max, points: self.settings.points }
    }

    fn workspace(&self, parameters: &Parameters, grid: Grid, output: &Output) -> Workspace {
        let grids = iter::successors(Some(grid), Grid::coarser);
        let wanted = if output.fields.is_empty() { &[][..] } else { &output.x };
        let beyond = wanted.iter().copied().filter(|&x| !grid.contains(x));
        Workspace {
            levels: grids.map(|grid| Discretisation::new(parameters, grid)).collect(),
            stiffness: stiffness(parameters, grid),
            beyond: FarField::points(&levelled_kernel(parameters, &grid), &grid, beyond),
        }
    }

    /// A better guess from a guess on the finest grid, coarse to fine. A coarse grid that does not resolve the film is
    /// left out, and one that does not converge soon only fails to help.
    fn refine(
        &self,
        workspace: &Workspace,
        beta: f64,
        mut guess: State,
        context: &mut SolveContext,
    ) -> Result<State, SolveError> {
        let finest = workspace.finest();
        let rough = Target { tolerance: self.settings.tolerance.max(1e-4), most_passes: ROUGH_PASSES };
        for level in workspace.levels.iter().skip(1).rev() {
            if thin_film_number(level.grid.spacing(), beta, guess.c, workspace.stiffness) > COARSEST {
                continue;
            }
            let coarse = guess.on(&finest.grid, level);
            match self.solve_equations(workspace.equations(level, beta), &coarse, rough, context) {
                Ok(state) => guess = state.on(&level.grid, finest),
                Err(SolveError::Failed(_)) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(guess)
    }

    fn solve_equations(
        &self,
        Equations { level, stiffness, beta }: Equations,
        guess: &State,
        target: Target,
        context: &mut SolveContext,
    ) -> Result<State, SolveError> {
        let mut iteration = Iteration::new(level, beta, guess);
        let result = converge(&mut iteration, self.settings.acceleration, target, stiffness, context);
        context.effort.iterations += iteration.passes;
        result.map(|()| iteration.state())
    }

    /// Richardson's estimate of the errors, from the same case on the grid of half as many intervals; unknown if there
    /// is no such grid or it does not resolve the film.
    fn estimate(
        &self,
        workspace: &Workspace,
        beta: f64,
        (state, fine): (&State, &Quantities),
        cavity_shear: CavityShear,
        context: &mut SolveContext,
    ) -> Result<RelativeErrors, SolveError> {
        let Some(level) = workspace.levels.get(1) else { return Ok(RelativeErrors::UNKNOWN) };
        let guess = state.on(&workspace.finest().grid, level);
        let coarse = match self.solve_equations(workspace.equations(level, beta), &guess, self.target(), context) {
            Ok(coarse) => quantities(&Iteration::new(level, beta, &coarse), cavity_shear),
            Err(SolveError::Failed(_)) => return Ok(RelativeErrors::UNKNOWN),
            Err(error) => return Err(error),
        };
        let (found, before) = (&fine.friction, &coarse.friction);
        let relative = |fine: f64, coarse: f64| richardson(fine, coarse, fine.abs());
        Ok(RelativeErrors {
            mu_v: richardson(found.viscoelastic, before.viscoelastic, found.viscoelastic_error_scale()),
            mu_h: relative(found.hydrodynamic(), before.hydrodynamic()),
            c: relative(fine.c, coarse.c),
            drag: relative(found.drag, before.drag),
            pressure: relative(found.pressure, before.pressure),
            shear: relative(found.shear(), before.shear()),
            film_min: relative(fine.film_min, coarse.film_min),
            p_max: relative(fine.p_max, coarse.p_max),
        })
    }

    /// The elastic solution at β, from Hertz pressure; solved by the first thread that asks.
    fn elastic(&self, beta: f64, context: &mut SolveContext) -> Result<ElasticSeed, SolveError> {
        let seed = {
            // what a thread that panicked left behind is either whole or not there
            let mut seeds = self.elastic.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(seeds.entry(beta.to_bits()).or_default())
        };
        let mut seed = seed.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = &*seed {
            return known.clone().map_err(SolveError::Failed);
        }
        let result = match self.solve_elastic(beta, context) {
            Ok(solved) => Ok(Arc::new(solved)),
            Err(SolveError::Failed(failure)) => Err(failure),
            Err(error) => return Err(error),
        };
        seed.insert(result).clone().map_err(SolveError::Failed)
    }

    fn solve_elastic(&self, beta: f64, context: &mut SolveContext) -> Result<(Grid, State), SolveError> {
        let parameters = Parameters::elastic(beta);
        // a fixed domain for narrow contacts need not hold the elastic one
        let grid = self.grid(&parameters).unwrap_or_else(|_| self.automatic_grid(&parameters));
        let no_fields = Output { fields: FieldSelection::default(), ..Output::default() };
        let workspace = self.workspace(&parameters, grid, &no_fields);
        workspace.check_resolvable(&parameters)?;
        let pressure = (0..grid.points).map(|i| hertz(grid.x(i))).collect();
        let guess = State::resting(workspace.finest(), pressure, elastic_film(beta));
        let guess = self.refine(&workspace, beta, guess, context)?;
        let equations = workspace.equations(workspace.finest(), beta);
        let state = self.solve_equations(equations, &guess, self.target(), context)?;
        Ok((grid, state))
    }
}

/// Hertz pressure of the relaxed contact (T16).
fn hertz(x: f64) -> f64 {
    (1.0 - x * x).max(0.0).sqrt()
}

/// The nearest β of those at which elastic solutions are shared: a quarter of a decade apart, so that chains share
/// them.
fn shared_beta(beta: f64) -> f64 {
    const PER_DECADE: f64 = 4.0;
    10_f64.powf((PER_DECADE * beta.log10()).round() / PER_DECADE)
}

/// Richardson's estimate of the relative error of a second-order value, from the grids of Δx and 2Δx.
fn richardson(fine: f64, coarse: f64, scale: f64) -> f64 {
    ((fine - coarse) / 3.0).abs() / scale
}

impl CaseSolver for RelaxationSolver {
    type Workspace = Workspace;
    type State = State;

    fn prepare(&self, parameters: &Parameters, output: &Output) -> Result<Workspace, Failure> {
        Ok(self.workspace(parameters, self.grid(parameters)?, output))
    }

    /// The workspace holds the kernel of one α and f.
    fn can_continue(&self, from: &Parameters, to: &Parameters) -> bool {
        (from.alpha, from.f, &from.substrate) == (to.alpha, to.f, &to.substrate)
    }

    /// The case itself, then thicker films.
    fn origins(&self, parameters: &Parameters) -> Vec<Parameters> {
        let thicker = MARCH_DECADES
            .map(|decades| Parameters { beta: parameters.beta * 0.1_f64.powi(decades), ..parameters.clone() });
        iter::once(parameters.clone()).chain(thicker).collect()
    }

    /// A march never cuts its steps, and the way between neighbours is cut into four at most: a solve that fails costs
    /// as much as many that succeed. Passes say nothing about a step.
    fn step_control(&self) -> StepControl {
        StepControl {
            first: LN_10 / MARCH_STEPS,
            largest: f64::INFINITY,
            smallest: 0.0,
            smallest_part: 0.25,
            reduction: 0.5,
            iterations: None,
        }
    }

    /// The dry pressure of the case, plus what a film adds to that of an elastic contact: p(ξ) − √(1−ξ²) over ā, with x
    /// = b + āξ (centre b, half width ā), of the elastic solution for the compliance ā², at ā²β. Without the film's
    /// part if that has no solution on its grid. For several retardation times, whose dry contact has no closed form,
    /// the elastic pressure alone.
    fn start(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        context: &mut SolveContext,
    ) -> Result<(State, Seed), SolveError> {
        workspace.check_resolvable(parameters)?;
        if parameters.is_relaxed_elastic() {
            let seed = self.elastic(parameters.beta, context)?;
            return Ok((seed.1.on(&seed.0, workspace.finest()), Seed::Hertz));
        }
        let (trailing, leading, half_width) = exact::contact_bounds(parameters);
        let centre = 0.5 * (trailing + leading);
        let rescaled = half_width * half_width < parameters.instantaneous_compliance().sqrt();
        let seed_beta = shared_beta(half_width * half_width * parameters.beta);
        let target = workspace.finest();
        let places: Vec<f64> = (0..target.grid.points).map(|i| target.grid.x(i)).collect();
        let ellipse = |x: f64| hertz((x - centre) / half_width) / half_width;
        let dry = exact::DryContact::of(parameters)
            .map_or_else(|| places.iter().map(|&x| ellipse(x)).collect(), |contact| contact.pressure_on(&places));
        let own_film = film_on_contact(parameters);
        let (pressure, film, seed) = match self.elastic(seed_beta, context) {
            Ok(elastic) => {
                let (grid, state) = (&elastic.0, &elastic.1);
                let film_part =
                    |x: f64| grid.interpolate(&state.pressure, (x - centre) / half_width) / half_width - ellipse(x);
                let pressure = places.iter().zip(&dry).map(|(&x, dry)| f64::max(0.0, dry + film_part(x))).collect();
                let seed = if rescaled { Seed::RescaledElastic } else { Seed::Elastic };
                (pressure, own_film * state.c / elastic_film(seed_beta), seed)
            }
            Err(SolveError::Failed(_)) => (dry, own_film, Seed::Hertz),
            Err(error) => return Err(error),
        };
        let guess = State::resting(target, pressure, film);
        Ok((self.refine(workspace, parameters.beta, guess, context)?, seed))
    }

    /// c and p extrapolated in ln β; from one case c β^{3/5} is taken to stay the same, and the pressure too.
    fn predict(&self, workspace: &mut Workspace, solved: &[(Parameters, State)], parameters: &Parameters) -> State {
        let (near_case, near) = solved.last().expect("a prediction needs a solved case");
        let (pressure, c) = match solved {
            [(far_case, far), _] => {
                let t = secant(far_case, near_case, parameters);
                let pairs = near.pressure.iter().zip(&far.pressure);
                let pressure = pairs.map(|(near, far)| (near + t * (near - far)).max(0.0)).collect();
                (pressure, near.c * (near.c / far.c).powf(t))
            }
            _ => (near.pressure.clone(), near.c * (parameters.beta / near_case.beta).powf(-0.6)),
        };
        State::resting(workspace.finest(), pressure, c)
    }

    fn solve(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        guess: State,
        context: &mut SolveContext,
    ) -> Result<State, SolveError> {
        workspace.check_resolvable(parameters)?;
        let equations = workspace.equations(workspace.finest(), parameters.beta);
        self.solve_equations(equations, &guess, self.target(), context)
    }

    fn evaluate(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        state: &mut State,
        output: &Output,
        context: &mut SolveContext,
    ) -> Result<Solution, SolveError> {
        context.effort.unknowns = self.settings.points;
        let fine = Iteration::new(workspace.finest(), parameters.beta, state);
        let quantities = quantities(&fine, output.cavity_shear);
        let errors = match self.settings.estimate {
            true => self.estimate(workspace, parameters.beta, (state, &quantities), output.cavity_shear, context)?,
            false => RelativeErrors::UNKNOWN,
        };
        let Quantities { c, x_outlet: outlet, .. } = quantities;
        let lubricant = Lubricant { beta: parameters.beta, c, outlet, cavity_shear: output.cavity_shear };
        let fields = fields(&fine, &lubricant, &workspace.beyond, output);
        Ok(Solution { quantities, errors, fields, sensitivities: None, sensitivity_errors: None })
    }
}
