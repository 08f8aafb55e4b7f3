//! A solver that converges exactly when its guess is near enough, so that every path is exact.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use stribeck_solver::continuation::{
    CaseSolver, FailureKind, Interrupt, Interrupted, Seed, Solution, SolveContext, SolveError, SolvedCase, StepControl,
    solve_chain,
};
use stribeck_solver::{Failure, Fields, Friction, Output, Parameters, Quantities, RelativeErrors};

/// A solver whose state is ln β of the solution. A guess converges if it is within `reach` of the case.
pub struct Fake {
    pub reach: f64,
    /// Whether two solved cases are extrapolated, as if the next were as far again; the last one is taken as it is if
    /// not.
    pub extrapolates: bool,
    /// Whether the start is a good guess.
    pub start_helps: bool,
    /// β below which the start is a good guess.
    pub start_below: Option<f64>,
    /// Whether there is a start at all.
    pub starts: bool,
    /// β/10^n of the origins.
    pub decades: Vec<i32>,
    /// Step control.
    pub control: StepControl,
    /// Iterations of a solve.
    pub iterations: u64,
    /// β at which the state found is no solution, whatever the guess.
    pub refused: Option<f64>,
    /// β at which nothing converges.
    pub impossible: Option<f64>,
    /// β whose solution is not good enough to be known.
    pub unknowable: Option<f64>,
    /// β at which the user asks to stop.
    pub stops_at: Option<f64>,
    /// Whether the solver itself heeds such a request.
    pub heeds: bool,
    /// β at which the solver panics.
    pub panics_at: Option<f64>,
    /// β at which it works for ever.
    pub stuck_at: Option<f64>,
    /// Workspaces that were made.
    pub workspaces: AtomicUsize,
    /// ln β of every attempt.
    pub attempts: Mutex<Vec<f64>>,
}

impl Fake {
    pub fn reaching(reach: f64) -> Self {
        let quarter_decade = 10_f64.ln() / 4.0;
        Self {
            reach,
            extrapolates: true,
            start_helps: false,
            start_below: None,
            starts: true,
            decades: vec![0, 1, 2],
            control: StepControl {
                first: quarter_decade,
                largest: f64::INFINITY,
                smallest: 0.0,
                smallest_part: 0.25,
                reduction: 0.5,
                iterations: None,
            },
            iterations: 1,
            refused: None,
            impossible: None,
            unknowable: None,
            stops_at: None,
            heeds: true,
            panics_at: None,
            stuck_at: None,
            workspaces: AtomicUsize::new(0),
            attempts: Mutex::default(),
        }
    }

    pub fn attempts(&self) -> Vec<f64> {
        self.attempts.lock().unwrap().clone()
    }
}

fn fail(reason: &str) -> SolveError {
    FailureKind::Other(reason.to_owned()).into()
}

impl CaseSolver for Fake {
    type Workspace = ();
    type State = f64;

    fn prepare(&self, _: &Parameters, _: &Output) -> Result<(), Failure> {
        self.workspaces.fetch_add(1, Ordering::Relaxed);
        Ok(())
    }

    fn origins(&self, parameters: &Parameters) -> Vec<Parameters> {
        let origin = |decades| match decades {
            0 => parameters.clone(),
            _ => Parameters { beta: parameters.beta * 0.1_f64.powi(decades), ..parameters.clone() },
        };
        self.decades.iter().copied().map(origin).collect()
    }

    fn step_control(&self) -> StepControl {
        self.control
    }

    fn start(&self, (): &mut (), parameters: &Parameters, _: &mut SolveContext) -> Result<(f64, Seed), SolveError> {
        if !self.starts {
            return Err(fail("nowhere to start"));
        }
        // β = 1 is the case that starts a chain
        let thick = self.start_below.is_some_and(|limit| parameters.beta < limit);
        let near = self.start_helps || thick || parameters.beta == 1.0;
        Ok((if near { parameters.beta.ln() } else { f64::INFINITY }, Seed::ThickFilm))
    }

    fn predict(&self, (): &mut (), solved: &[(Parameters, f64)], _: &Parameters) -> f64 {
        match solved {
            [(_, far), (_, near)] if self.extrapolates => 2.0 * near - far,
            _ => solved[solved.len() - 1].1,
        }
    }

    fn solve(
        &self,
        (): &mut (),
        parameters: &Parameters,
        guess: f64,
        context: &mut SolveContext,
    ) -> Result<f64, SolveError> {
        let solution = parameters.beta.ln();
        self.attempts.lock().unwrap().push(solution);
        context.effort.iterations += self.iterations;
        if self.stops_at == Some(parameters.beta) {
            context.interrupt.request();
            if self.heeds {
                return Err(SolveError::Interrupted);
            }
        }
        assert!(self.panics_at != Some(parameters.beta), "a panic\n\tat {}", parameters.beta);
        while self.stuck_at == Some(parameters.beta) {
            context.check_abort()?;
            context.effort.iterations += 1;
            context.note_residual(context.effort.iterations, 1.0);
        }
        if self.refused == Some(parameters.beta) {
            return Err(FailureKind::FilmThinnerThanGrid.into());
        }
        if self.impossible == Some(parameters.beta) || (guess - solution).abs() > self.reach {
            return Err(fail("too far"));
        }
        Ok(solution)
    }

    fn evaluate(
        &self,
        (): &mut (),
        parameters: &Parameters,
        state: &mut f64,
        _: &Output,
        _: &mut SolveContext,
    ) -> Result<Solution, SolveError> {
        if self.unknowable == Some(parameters.beta) {
            return Err(fail("not to be known"));
        }
        let friction = Friction {
            viscoelastic: 0.0,
            viscoelastic_roller: 0.0,
            hydrodynamic_film: 0.0,
            hydrodynamic_cavity: 0.0,
            pressure: 0.0,
            drag: 0.0,
        };
        let quantities = Quantities {
            friction,
            c: state.exp(),
            film_min: 0.0,
            p_max: 0.0,
            x_p_max: 0.0,
            x_outlet: 0.0,
            centroid: 0.0,
            dissipation: 0.0,
            separation: 0.0,
            load_residual: 0.0,
        };
        let (errors, fields) = (RelativeErrors::UNKNOWN, Fields::default());
        Ok(Solution { quantities, errors, fields, sensitivities: None, sensitivity_errors: None })
    }
}

pub fn solve(fake: &Fake, betas: &[f64]) -> Result<Vec<SolvedCase>, Interrupted> {
    solve_cases(fake, &betas.iter().map(|&beta| Parameters::new(1.0, beta, 1.0)).collect::<Vec<_>>())
}

pub fn solve_cases(fake: &Fake, cases: &[Parameters]) -> Result<Vec<SolvedCase>, Interrupted> {
    solve_chain(fake, cases, &Output { limits: false, ..Output::default() }, &Interrupt::new())
}

pub fn seeds(cases: &[SolvedCase]) -> Vec<Seed> {
    cases.iter().map(|case| case.seed).collect()
}
