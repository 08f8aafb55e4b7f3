//! The collocation method as a [`CaseSolver`].

use std::sync::Arc;

use super::adaptation::{INLET_PANEL, Longest, Panels, equidistributed, indicators};
use super::estimate::{ENRICHMENT, Estimate, estimate};
use super::fields::fields;
use super::log_moments::MOST_MOMENTS;
use super::mesh::growth_behind;
use super::reference::{ReferencePanel, evaluate};
use super::scaling::{Scaling, layer};
use super::settings::Settings;
use super::state::State;
use super::system::unknowns;
use super::thick_film;
use super::workspace::{Workspace, half_width};
use crate::continuation::{CaseSolver, Halt, Seed, Solution, StepControl, Work, secant};
use crate::model::{Failure, Output, Parameters};

/// ā²β at which a march begins: films so thick that Newton's method converges from the rigid film.
const THICK: f64 = 0.01;
/// Newton's method leaves this part of the tolerance.
const NEWTON: f64 = 1e-3;
/// Largest indicator of a mesh on which a solution is good enough to go on from, and the one of a new mesh.
const ROUGH: f64 = 1e-3;
const SMOOTH: f64 = 1e-4;
/// Largest indicator over the root of the tolerance.
const RESOLVED: f64 = 0.3;
/// Meshes that are tried for a solution that is good enough to go on from, and for one with the wanted accuracy.
const ROUGH_MESHES: usize = 4;
const ACCURATE_MESHES: usize = 12;
/// The estimated error over the tolerance: accepted up to the first; the second is what a new mesh is made for; below the
/// third a coarser mesh will do for the next case.
const ACCEPTED: f64 = 0.9;
const AIM: f64 = 0.15;
const IDLE: f64 = 0.002;
/// Part of the tolerance that panels behind the outlet may leave, which are not refined with the others.
const BEHIND: f64 = 1e-4;
/// Most panels of a mesh.
const MOST_PANELS: usize = 160;
/// Least pressure over the largest; below it the film would carry tension.
const TENSION: f64 = -1e-6;
/// The same for a solution that is only good enough to go on from.
const ROUGH_TENSION: f64 = -1e-2;

/// The collocation solver with given settings.
pub struct CollocationSolver {
    settings: Settings,
    coarse: Arc<ReferencePanel>,
    fine: Arc<ReferencePanel>,
}

impl CollocationSolver {
    /// A solver with the given settings.
    pub fn new(settings: Settings) -> Self {
        Self {
            settings,
            coarse: Arc::new(ReferencePanel::new(settings.degree)),
            fine: Arc::new(ReferencePanel::new(settings.degree + ENRICHMENT)),
        }
    }

    /// Newton's method on the mesh of a state.
    fn correct(&self, workspace: &mut Workspace, beta: f64, state: &mut State, work: &mut Work) -> Result<(), Halt> {
        workspace.prepare_coarse(&state.mesh, &mut work.effort);
        let (corrector, displacement) = workspace.coarse.parts();
        corrector.correct(displacement, beta, state, NEWTON * self.settings.tolerance, work)?;
        state.error = None;
        Ok(())
    }

    /// The panels that would bring the error from so many times the tolerance to [`AIM`] times. Friction and flow converge
    /// faster than the pressure, about as the power 3d/2 of the number of panels.
    fn panels(&self, present: usize, error: f64) -> usize {
        let factor = (error / AIM).powf(1.0 / (1.5 * self.settings.degree as f64)).clamp(0.6, 1.8);
        let wanted = (present as f64 * factor).round() as usize;
        wanted.max(4)
    }

    /// The square of the largest indicator, which is about the error of friction and flow, over the one that is let pass: so
    /// that a small estimate is never an accident of a coarse mesh, on which two errors happen to be alike.
    fn coarseness(&self, state: &State) -> f64 {
        let roughest = indicators(&self.coarse, state).into_iter().fold(0.0, f64::max);
        ACCEPTED * roughest * roughest / (RESOLVED * RESOLVED * self.settings.tolerance)
    }

    fn remeshed(&self, parameters: &Parameters, state: &State, panels: Panels, reach: f64) -> State {
        let layer = layer(parameters, state.c);
        let longest = Longest { at_outlet: state.outlet_panel * layer, at_inlet: INLET_PANEL * layer };
        let mesh = equidistributed(&self.coarse, state, panels, reach, longest);
        state.on(&self.coarse, &mesh)
    }
}

/// The smallest pressure over the largest, and the panel it is on; between the nodes too: where the pressure is low, a
/// polynomial may dip below zero between positive values.
fn tension(reference: &ReferencePanel, state: &State) -> (f64, usize) {
    const LOW: f64 = 1e-2;
    const BETWEEN: [f64; 7] = [0.02, 0.06, 0.15, 0.3, 0.5, 0.7, 0.9];
    let most = state.pressure.iter().fold(0.0, |a: f64, &p| a.max(p));
    let size = reference.degree + 1;
    let mut coefficients = [0.0; MOST_MOMENTS];
    let (mut least, mut place) = (0.0, 0);
    for (panel, nodes) in state.pressure.windows(size).step_by(reference.degree).enumerate() {
        if nodes.iter().all(|&p| p > LOW * most) {
            continue;
        }
        reference.coefficients_of_nodes(nodes, &mut coefficients[..size]);
        let between = |gap: &[f64]| BETWEEN.map(|part| gap[0] + part * (gap[1] - gap[0]));
        let values = reference.nodes.windows(2).flat_map(between).map(|t| evaluate(&coefficients[..size], t));
        for value in values.chain(nodes.iter().copied()) {
            if value < least {
                (least, place) = (value, panel);
            }
        }
    }
    (least / most, place)
}

fn tension_failure(tension: f64) -> Halt {
    let reason = format!(
        "Newton's method found a film under tension, {tension:.1e} of the largest pressure: not a solution with cavitation"
    );
    Halt::Failed(Failure::new(reason))
}

impl CaseSolver for CollocationSolver {
    type Workspace = Workspace;
    type State = State;

    fn prepare(&self, parameters: &Parameters, _: &Output) -> Result<Workspace, Failure> {
        Ok(Workspace::new(&self.coarse, &self.fine, parameters))
    }

    /// The case itself if its film is thick, else the thick film of the same substrate.
    fn origins(&self, parameters: &Parameters) -> Vec<Parameters> {
        let beta = parameters.beta.min(THICK * half_width(parameters).powi(-2));
        vec![Parameters { beta, ..parameters.clone() }]
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
        work: &mut Work,
    ) -> Result<(State, Seed), Halt> {
        workspace.enter(parameters);
        let reach = Scaling::new(workspace.half_width(), parameters.beta).reach(self.settings.tolerance);
        let Settings { degree, tolerance } = self.settings;
        let growth = growth_behind(degree, BEHIND * tolerance);
        let mesh = thick_film::mesh(degree, growth, parameters.beta, reach);
        workspace.prepare_coarse(&mesh, &mut work.effort);
        Ok((thick_film::state(workspace.coarse.displacement(), parameters.beta), Seed::ThickFilm))
    }

    /// The nearest solution rescaled to the case; with two, as much more as the rescaled far one failed to predict the near one.
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
        match near.error {
            Some(error) if !(IDLE..=ACCEPTED).contains(&(2.0 * error)) => {
                let panels = Panels::Number(self.panels(near.mesh.panels(), error));
                self.remeshed(parameters, &guess, panels, to.reach(self.settings.tolerance))
            }
            None => self.remeshed(parameters, &guess, Panels::Indicator(SMOOTH), to.reach(self.settings.tolerance)),
            Some(_) => guess,
        }
    }

    fn solve(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        guess: State,
        work: &mut Work,
    ) -> Result<State, Halt> {
        workspace.enter(parameters);
        let reach = Scaling::new(workspace.half_width(), parameters.beta).reach(self.settings.tolerance);
        let mut state = guess;
        for _ in 0..ROUGH_MESHES {
            self.correct(workspace, parameters.beta, &mut state, work)?;
            let (tension, _) = tension(&self.coarse, &state);
            let roughest = indicators(&self.coarse, &state).into_iter().fold(0.0, f64::max);
            if roughest <= ROUGH {
                return if tension < ROUGH_TENSION { Err(tension_failure(tension)) } else { Ok(state) };
            }
            state = self.remeshed(parameters, &state, Panels::Indicator(SMOOTH), reach);
        }
        self.correct(workspace, parameters.beta, &mut state, work)?;
        Ok(state)
    }

    fn evaluate(
        &self,
        workspace: &mut Workspace,
        parameters: &Parameters,
        state: &mut State,
        output: &Output,
        work: &mut Work,
    ) -> Result<Solution, Halt> {
        let beta = parameters.beta;
        let reach = Scaling::new(workspace.half_width(), beta).reach(self.settings.tolerance);
        for _ in 0..ACCURATE_MESHES {
            workspace.prepare_fine(&state.mesh, &mut work.effort);
            let displacement = workspace.coarse.displacement();
            let (tolerance, cavity_shear) = (self.settings.tolerance, output.cavity_shear);
            let effort = &mut work.effort;
            let estimate = estimate(displacement, &mut workspace.fine, beta, state, cavity_shear, tolerance, effort);
            let (tension, place) = tension(&self.coarse, state);
            if tension < ROUGH_TENSION {
                return Err(tension_failure(tension));
            }
            let error = f64::max(estimate.worst() / tolerance, self.coarseness(state));
            state.error = Some(error);
            let free_of_tension = tension >= TENSION;
            if error <= ACCEPTED && free_of_tension {
                work.effort.unknowns = unknowns(workspace.coarse.displacement());
                let fields = fields(workspace.coarse.displacement(), beta, state, output);
                let Estimate { quantities, errors, .. } = estimate;
                return Ok(Solution { quantities, errors, fields });
            }
            // A little tension is an oscillation about p′ = 0 at the outlet that a shorter first panel resolves, or more panels.
            let mut panels = state.mesh.panels();
            if !free_of_tension && place == 0 {
                state.outlet_panel = 0.4 * state.mesh.film[1] / layer(parameters, state.c);
            } else {
                panels += 1;
            }
            if error > ACCEPTED {
                panels = self.panels(state.mesh.panels(), error).max(panels);
            }
            if panels > MOST_PANELS {
                break;
            }
            *state = self.remeshed(parameters, state, Panels::Number(panels), reach);
            self.correct(workspace, beta, state, work)?;
        }
        let (error, panels) = (state.error.unwrap_or(f64::INFINITY), state.mesh.panels());
        let (tension, _) = tension(&self.coarse, state);
        if error <= ACCEPTED {
            return Err(tension_failure(tension));
        }
        let reason = format!(
            "the estimated error is still {error:.1} times the tolerance {:e} with {panels} panels; ask for a larger tolerance",
            self.settings.tolerance
        );
        Err(Halt::Failed(Failure::new(reason)))
    }
}
