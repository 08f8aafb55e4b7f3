//! The collocation method as a [`CaseSolver`].

use std::f64::consts::LN_10;
use std::sync::{Arc, Mutex, MutexGuard};

use super::acceptance::{ACCEPTED, Acceptance, TENSION, check_tension, complete, tension};
use super::adaptation::{Longest, Panels, equidistributed, indicators};
use super::bounds::ROUNDING;
use super::mesh::growth_behind;
use super::reference::ReferencePanel;
use super::scaling::{Scaling, layer};
use super::settings::Settings;
use super::starting_solutions::{self, SOLVED_WITH};
use super::state::State;
use super::system::unknowns;
use super::thick_film;
use super::two_level::{ENRICHMENT, Tables};
use super::workspace::{Workspace, half_width};
use crate::continuation::{
    CaseSolver, Effort, Failure, FailureKind, Seed, Solution, SolveContext, SolveError, StepControl, distance, secant,
};
use crate::model::{Output, Parameters};

/// ā²β at which a march begins: films so thick that Newton's method converges from the rigid film.
const THICK: f64 = 0.01;
/// β of a case that the table does not lead to at once, over that of the one from which it is tried next.
const THICKER: f64 = 1000.0;
/// Distance of the last case from which on the table is the cheaper start: 2.5 points a decade along β, where meshes
/// and filters are kept, and 12 along other lines.
const FAR_ALONG_BETA: f64 = 0.4 * LN_10;
const FAR: f64 = 0.08 * LN_10;
/// Newton's method stops at this part of the tolerance.
const NEWTON: f64 = 1e-3;
/// Largest indicator of a mesh on which a solution is good enough to go on from, and the one of a new mesh.
const ROUGH: f64 = 1e-3;
const SMOOTH: f64 = 1e-4;
/// Meshes that are tried for a solution that is good enough to go on from.
const ROUGH_MESHES: usize = 4;
/// Refinement has stalled when a new mesh reduces the best error by less than 20 %.
const GAIN: f64 = 0.8;
/// Refinement is given up after so many stalled meshes in a row.
const STALLED_MESHES: usize = 4;
/// The estimated error over the tolerance that a new mesh is made for.
pub(super) const AIM: f64 = 0.15;
/// The next case gets a new mesh if the error over the tolerance was below the first or above the second of these.
const IDLE: f64 = 0.001;
pub(super) const CLOSE: f64 = 0.45;
/// It also gets a new mesh if the old one would reach less than this part of the length wanted: no estimate sees what
/// lies beyond a mesh.
const SHORT: f64 = 0.8;
/// Part of the tolerance that what lies beyond a mesh may have in the errors before the next mesh reaches further.
const SHORT_INLET: f64 = 0.3;
/// Part of the tolerance that panels behind the outlet may leave, which are not refined with the others.
pub(super) const BEHIND: f64 = 1e-4;
/// Most panels of a mesh.
const MOST_PANELS: usize = *Settings::PANELS.end();
/// Flow c of the thinnest films that can be told from rounding errors: those of (T12), some 10⁻¹⁶, count a few hundred
/// thousand times at a steep inlet.
const THINNEST: f64 = 1e-11;
/// The collocation solver with given settings.
pub struct CollocationSolver {
    pub(super) settings: Settings,
    /// A fixed number of panels, or as many as the tolerance takes.
    pub(super) panels: Option<usize>,
    /// How many times as far as it takes meshes reach.
    pub(super) farther: f64,
    /// Whether cases without neighbours march from a thick film, though there is a table.
    pub(super) marches: bool,
    /// Of the panels of the table.
    pub(super) of_table: Arc<ReferencePanel>,
    pub(super) coarse: Arc<ReferencePanel>,
    pub(super) fine: Arc<ReferencePanel>,
    /// What estimates take from the solutions.
    pub(super) two_level: Arc<Tables>,
    /// Workspaces of chains that are over.
    pub(super) spare: Mutex<Vec<Workspace>>,
}

impl CollocationSolver {
    /// A solver with the given settings.
    ///
    /// # Panics
    /// If they are outside of [`Settings::TOLERANCE`] and [`Settings::DEGREE`].
    pub fn new(settings: Settings) -> Self {
        let Settings { tolerance, degree } = settings;
        assert!(Settings::TOLERANCE.contains(&tolerance), "no solver for a tolerance of {tolerance:e}");
        assert!(Settings::DEGREE.contains(&degree), "no solver with panels of degree {degree}");
        let coarse = Arc::new(ReferencePanel::new(settings.degree));
        let fine = Arc::new(ReferencePanel::new(settings.degree + ENRICHMENT));
        let same = degree == SOLVED_WITH.degree;
        Self {
            settings,
            panels: None,
            farther: 1.0,
            marches: !starting_solutions::is_present(),
            of_table: if same { Arc::clone(&coarse) } else { Arc::new(ReferencePanel::new(SOLVED_WITH.degree)) },
            two_level: Arc::new(Tables::new(&coarse, &fine)),
            coarse,
            fine,
            spare: Mutex::default(),
        }
    }

    /// The same solver with meshes that reach so many times as far ahead as the tolerance takes: to study what they
    /// leave out, not to use it.
    #[must_use]
    pub fn reaching(self, times: f64) -> Self {
        Self { farther: times, ..self }
    }

    /// The same solver without the table of starting solutions, by marches alone: to study what it saves, and to make
    /// it.
    #[must_use]
    pub fn marching(self) -> Self {
        Self { marches: true, ..self }
    }

    fn spare(&self) -> MutexGuard<'_, Vec<Workspace>> {
        self.spare.lock().expect("nothing panics while it is held")
    }

    /// How far a mesh reaches.
    pub(super) fn reach(&self, scaling: Scaling) -> f64 {
        self.farther * scaling.reach(self.settings.tolerance)
    }

    /// Newton's method on the mesh of a state.
    pub(super) fn correct(
        &self,
        workspace: &mut Workspace,
        beta: f64,
        state: &mut State,
        context: &mut SolveContext,
    ) -> Result<(), SolveError> {
        let panels = state.mesh.panels();
        if panels > MOST_PANELS {
            return Err(FailureKind::TooManyPanels { panels, most: MOST_PANELS }.into());
        }
        workspace.prepare_coarse(&state.mesh, &mut context.effort);
        let (corrector, displacement) = workspace.coarse.parts();
        corrector.correct(displacement, beta, state, NEWTON * self.settings.tolerance, context)?;
        state.error = None;
        if state.c < THINNEST {
            return Err(FailureKind::FilmTooThin { c: state.c, least: THINNEST }.into());
        }
        Ok(())
    }

    /// The panels that would bring the error from so many times the tolerance to [`AIM`] times. Friction and flow
    /// converge faster than the pressure, about as the power 3d/2 of the number of panels.
    pub(super) fn panels(&self, present: usize, error: f64) -> usize {
        let factor = (error / AIM).powf(1.0 / (1.5 * self.settings.degree as f64)).clamp(0.6, 1.8);
        let wanted = (present as f64 * factor).round() as usize;
        wanted.max(4)
    }

    /// Whether films are thick at a case.
    fn is_thick(parameters: &Parameters, half_width: f64) -> bool {
        parameters.beta <= THICK * half_width.powi(-2)
    }

    pub(super) fn remeshed(&self, parameters: &Parameters, state: &State, panels: Panels, reach: f64) -> State {
        let longest = Longest::of(parameters, state);
        let mesh = equidistributed(&self.coarse, state, panels, reach, longest);
        state.on(&self.coarse, &mesh)
    }
}

impl CaseSolver for CollocationSolver {
    type Workspace = Workspace;
    type State = State;

    fn prepare(&self, parameters: &Parameters, _: &Output) -> Result<Workspace, Failure> {
        let spare = self.spare().pop();
        Ok(match spare {
            Some(workspace) => workspace.renewed(parameters),
            None => Workspace::new([&self.coarse, &self.fine], &self.two_level, parameters),
        })
    }

    fn keep(&self, workspace: Workspace) {
        self.spare().push(workspace);
    }

    /// The case itself; unless its film is thick, another one of the same substrate from which the table may lead to
    /// it where it does not at once; and the thick film.
    fn origins(&self, parameters: &Parameters) -> Vec<Parameters> {
        let half_width = half_width(parameters);
        if Self::is_thick(parameters, half_width) {
            return vec![parameters.clone()];
        }
        let thick = Parameters { beta: THICK * half_width.powi(-2), ..parameters.clone() };
        if self.marches {
            return vec![thick];
        }
        let thicker = Parameters { beta: parameters.beta / THICKER, ..parameters.clone() };
        let between = (thicker.beta > thick.beta).then_some(thicker);
        [Some(parameters.clone()), between, Some(thick)].into_iter().flatten().collect()
    }

    fn is_far(&self, from: &Parameters, to: &Parameters) -> bool {
        let far = if from.alpha == to.alpha && from.f == to.f { FAR_ALONG_BETA } else { FAR };
        !self.marches && distance(from, to) > far
    }

    /// Factors of three in β at first, up to ten, down to 1.05.
    fn step_control(&self) -> StepControl {
        StepControl {
            first: 3.0_f64.ln(),
            largest: 10.0_f64.ln(),
            smallest: 0.05,
            smallest_part: 0.0,
            reduction: 0.4,
            iterations: Some(10.0),
        }
    }

    fn start(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        context: &mut SolveContext,
    ) -> Result<(State, Seed), SolveError> {
        workspace.enter(parameters);
        let reach = self.reach(Scaling::new(workspace.half_width(), parameters.beta));
        if !Self::is_thick(parameters, workspace.half_width()) {
            return Ok((self.guess_from_table(parameters, reach), Seed::Table));
        }
        let Settings { degree, tolerance } = self.settings;
        let growth = growth_behind(degree, BEHIND * tolerance);
        let mesh = thick_film::mesh(degree, growth, parameters.beta, reach);
        workspace.prepare_coarse(&mesh, &mut context.effort);
        Ok((thick_film::state(workspace.coarse.displacement(), parameters.beta), Seed::ThickFilm))
    }

    /// The nearest solution rescaled to the case; with two, as much more as the rescaled far one failed to predict the
    /// near one.
    fn predict(&self, workspace: &mut Workspace, solved: &[(Parameters, State)], parameters: &Parameters) -> State {
        workspace.enter(parameters);
        let scaling = |at: &Parameters| {
            let same = at.alpha == parameters.alpha && at.f == parameters.f;
            Scaling::new(if same { workspace.half_width() } else { half_width(at) }, at.beta)
        };
        let (near_parameters, near) = solved.last().expect("a prediction needs a solved case");
        let to = scaling(parameters);
        let mut guess = near.rescaled(scaling(near_parameters), to);
        if let [(far_parameters, far), _] = solved {
            let back = far.rescaled(scaling(far_parameters), scaling(near_parameters));
            let back = if back.mesh.film == near.mesh.film { back } else { back.on(&self.coarse, &near.mesh) };
            guess.add_difference(secant(far_parameters, near_parameters, parameters), near, &back);
        }
        let reach = self.reach(to);
        match near.error {
            Some(error) if !(IDLE..=CLOSE).contains(&error) => {
                let panels = Panels::Number(self.panels(near.mesh.panels(), error));
                self.remeshed(parameters, &guess, panels, reach)
            }
            Some(_) if guess.mesh.reach() < SHORT * reach => {
                let panels = Panels::Number(near.mesh.panels());
                self.remeshed(parameters, &guess, panels, reach)
            }
            Some(_) => guess,
            None => self.remeshed(parameters, &guess, Panels::Indicator(SMOOTH), reach),
        }
    }

    fn solve(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        guess: State,
        context: &mut SolveContext,
    ) -> Result<State, SolveError> {
        workspace.enter(parameters);
        let reach = self.reach(Scaling::new(workspace.half_width(), parameters.beta));
        let mut state = guess;
        for _ in 0..ROUGH_MESHES {
            self.correct(workspace, parameters.beta, &mut state, context)?;
            let (tension, _) = tension(&self.coarse, &state);
            let roughest = indicators(&self.coarse, &state).into_iter().fold(0.0, f64::max);
            if roughest <= ROUGH {
                return check_tension(tension).map(|()| state);
            }
            state = self.remeshed(parameters, &state, Panels::Indicator(SMOOTH), reach);
        }
        self.correct(workspace, parameters.beta, &mut state, context)?;
        Ok(state)
    }

    fn evaluate(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        state: &mut State,
        output: &Output,
        context: &mut SolveContext,
    ) -> Result<Solution, SolveError> {
        let beta = parameters.beta;
        let reach = self.reach(Scaling::new(workspace.half_width(), beta));
        if self.panels.is_some() {
            return self.evaluate_on_fixed_panels(workspace, parameters, state, output, context);
        }
        let rounding = ROUNDING / state.c;
        if rounding > ACCEPTED * self.settings.tolerance {
            let (c, tolerance) = (state.c, self.settings.tolerance);
            return Err(FailureKind::ToleranceTooTight { c, rounding, tolerance }.into());
        }
        let (mut least, mut stalled) = (f64::INFINITY, 0);
        loop {
            let (acceptance, solution) =
                Acceptance::of(workspace, (parameters, state), output, self.settings.tolerance, context);
            state.error = Some(acceptance.error);
            context.note_error(unknowns(workspace.coarse.displacement()), acceptance.error);
            check_tension(acceptance.tension)?;
            if acceptance.is_accepted() {
                let solution = solution.accepted(ACCEPTED * self.settings.tolerance);
                return Ok(complete(workspace, (beta, state), solution, output, context));
            }
            stalled = if acceptance.excess() > GAIN * least { stalled + 1 } else { 0 };
            least = least.min(acceptance.excess());
            let finer = self.refined(parameters, state, &acceptance, reach);
            if stalled == STALLED_MESHES || finer.mesh.panels() > MOST_PANELS {
                return Err(acceptance.failure(self.settings.tolerance, state.mesh.panels()).into());
            }
            *state = finer;
            self.correct(workspace, beta, state, context)?;
        }
    }
}

impl CollocationSolver {
    /// The matrix of Newton's method at a solution, column by column: flow over u and the load as rows, p at the nodes,
    /// c and x_out as columns.
    pub fn jacobian(&self, workspace: &mut Workspace, parameters: &Parameters, state: &State) -> Vec<Vec<f64>> {
        workspace.enter(parameters);
        workspace.prepare_coarse(&state.mesh, &mut Effort::default());
        let (corrector, displacement) = workspace.coarse.parts();
        corrector.matrix(displacement, parameters.beta, state).to_columns()
    }

    /// The smallest pressure of a solution over the largest, between the nodes too; 0 if it is nowhere negative.
    pub fn tension(&self, state: &State) -> f64 {
        tension(&self.coarse, state).0
    }

    /// A guess on a mesh on which a solution should do better. A little tension is an oscillation about p′ = 0 at the
    /// outlet, which a shorter first panel resolves; all else takes more panels.
    fn refined(&self, parameters: &Parameters, state: &State, acceptance: &Acceptance, reach: f64) -> State {
        let mut panels = state.mesh.panels();
        let mut state = state.clone();
        if acceptance.tension < TENSION && acceptance.place == 0 {
            state.outlet_panel = 0.4 * state.mesh.film[1] / layer(parameters, state.c);
        } else {
            panels += 1;
        }
        if acceptance.error > ACCEPTED {
            panels = self.panels(state.mesh.panels(), acceptance.error).max(panels);
        }
        let longer = (acceptance.cut / SHORT_INLET).cbrt().max(1.0);
        let mut longest = Longest::of(parameters, &state);
        if acceptance.at_inlet > 1.0 {
            longest.at_inlet *= 0.5;
        }
        let mesh = equidistributed(&self.coarse, &state, Panels::Number(panels), longer * reach, longest);
        state.on(&self.coarse, &mesh)
    }
}
