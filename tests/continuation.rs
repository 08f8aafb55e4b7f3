//! How a chain is solved: which seeds are tried in which order, and what a failure or an interrupt does to the rest. The
//! solver is a fake that converges exactly when its guess is near enough, so every path is exact.

use std::sync::Mutex;

use stribeck::continuation::{CaseSolver, Halt, Interrupt, Interrupted, Seed, Solution, SolvedCase, Work, solve_chain};
use stribeck::model::{Failure, Fields, Friction, Output, Parameters, Quantities, RelativeErrors};

/// A solver whose state is ln β of the solution. A guess converges if it is within `reach` of the case.
struct Fake {
    reach: f64,
    /// Whether the start is a good guess.
    start_helps: bool,
    /// β below which the start is a good guess.
    start_below: Option<f64>,
    /// β at which the state found is no solution, whatever the guess.
    refused: Option<f64>,
    /// β at which nothing converges.
    impossible: Option<f64>,
    /// β at which the user asks to stop.
    stops_at: Option<f64>,
    /// ln β of every attempt.
    attempts: Mutex<Vec<f64>>,
}

impl Fake {
    fn reaching(reach: f64) -> Self {
        Self {
            reach,
            start_helps: false,
            start_below: None,
            refused: None,
            impossible: None,
            stops_at: None,
            attempts: Mutex::default(),
        }
    }

    fn fail(reason: &str) -> Halt {
        Halt::Failed(Failure::new(reason.to_owned()))
    }
}

impl CaseSolver for Fake {
    type Shared = ();
    type State = f64;

    fn prepare(&self, _: &Parameters, _: &Output) -> Result<(), Failure> {
        Ok(())
    }

    fn start(&self, (): &(), parameters: &Parameters, _: &mut Work) -> Result<(f64, Seed), Halt> {
        // β = 1 is the case that starts a chain
        let thick = self.start_below.is_some_and(|limit| parameters.beta < limit);
        let near = self.start_helps || thick || parameters.beta == 1.0;
        Ok((if near { parameters.beta.ln() } else { f64::INFINITY }, Seed::Elastic))
    }

    fn predict(&self, (): &(), solved: &[(f64, f64)], _: f64) -> f64 {
        // from two cases the next one as far again, from one the case itself
        match solved {
            [(_, far), (_, near)] => 2.0 * near - far,
            _ => solved[0].1,
        }
    }

    fn solve(&self, (): &(), parameters: &Parameters, guess: &f64, work: &mut Work) -> Result<f64, Halt> {
        let solution = parameters.beta.ln();
        self.attempts.lock().unwrap().push(solution);
        work.effort.iterations += 1;
        if self.stops_at == Some(parameters.beta) {
            work.interrupt.request();
            return Err(Halt::Interrupted);
        }
        if self.refused == Some(parameters.beta) {
            return Err(Halt::Failed(Failure { reason: "refused".to_owned(), conclusive: true }));
        }
        if self.impossible == Some(parameters.beta) || (guess - solution).abs() > self.reach {
            return Err(Self::fail("too far"));
        }
        Ok(solution)
    }

    fn evaluate(&self, (): &(), _: &Parameters, state: &f64, _: &Output, _: &mut Work) -> Result<Solution, Halt> {
        let friction = Friction { viscoelastic: 0.0, hydrodynamic_film: 0.0, hydrodynamic_cavity: 0.0, drag: 0.0 };
        let quantities = Quantities {
            friction,
            c: state.exp(),
            film_min: 0.0,
            p_max: 0.0,
            x_p_max: 0.0,
            x_outlet: 0.0,
            centroid: 0.0,
            separation: 0.0,
            load_residual: 0.0,
        };
        Ok(Solution { quantities, errors: RelativeErrors::UNKNOWN, fields: Fields::default() })
    }
}

fn solve(fake: &Fake, betas: &[f64]) -> Result<Vec<SolvedCase>, Interrupted> {
    let cases: Vec<Parameters> = betas.iter().map(|&beta| Parameters::new(1.0, beta, 1.0)).collect();
    solve_chain(fake, &cases, &Output { limits: false, ..Output::default() }, &Interrupt::new())
}

fn seeds(cases: &[SolvedCase]) -> Vec<Seed> {
    cases.iter().map(|case| case.seed.clone()).collect()
}

#[test]
fn the_first_case_has_the_start_the_second_its_neighbour_the_third_both() {
    let cases = solve(&Fake::reaching(1.0), &[1.0, 2.0, 4.0, 8.0]).unwrap();
    assert!(cases.iter().all(|case| case.outcome.is_ok()));
    assert_eq!(seeds(&cases), [Seed::Elastic, Seed::Neighbour, Seed::Predictor, Seed::Predictor]);
}

#[test]
fn each_case_gets_its_own_solution() {
    let betas = [1.0, 1.5, 2.5, 3.0];
    for (case, beta) in solve(&Fake::reaching(1.0), &betas).unwrap().iter().zip(betas) {
        let solution = case.outcome.as_ref().unwrap();
        assert!((solution.quantities.c - beta).abs() < 1e-12);
    }
}

#[test]
fn a_predictor_that_leads_astray_is_followed_by_the_neighbour() {
    // the step shrinks: ln β of 0, 1, 1.1; extrapolation gives 2
    let cases = solve(&Fake::reaching(1.0), &[1.0, 1.0_f64.exp(), 1.05_f64.exp()]).unwrap();
    assert_eq!(seeds(&cases)[2], Seed::Predictor, "2 is within reach of 1.05");
    let cases = solve(&Fake::reaching(0.5), &[1.0, 0.5_f64.exp(), 0.51_f64.exp()]).unwrap();
    assert_eq!(seeds(&cases)[2], Seed::Predictor);
    let cases = solve(&Fake::reaching(0.45), &[1.0, 0.45_f64.exp(), 0.449_f64.exp()]).unwrap();
    assert_eq!(seeds(&cases)[2], Seed::Neighbour, "0.9 is not within reach of 0.449");
}

#[test]
fn a_long_step_goes_by_way_of_points_that_are_not_published() {
    // half the step is within reach, the whole is not
    let fake = Fake::reaching(1.0);
    let cases = solve(&fake, &[1.0, 1.9_f64.exp()]).unwrap();
    assert_eq!(cases.len(), 2);
    assert_eq!(seeds(&cases)[1], Seed::Intermediate(1));
    let visited = fake.attempts.lock().unwrap().clone();
    assert!(visited.iter().any(|&at| (at - 0.95).abs() < 1e-12), "{visited:?}");
    // a quarter is within reach, half of it is not
    let cases = solve(&Fake::reaching(1.0), &[1.0, 3.9_f64.exp()]).unwrap();
    assert_eq!(seeds(&cases)[1], Seed::Intermediate(3));
}

#[test]
fn the_last_rung_is_the_start() {
    let fake = Fake { start_helps: true, ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 20.0_f64.exp()]).unwrap();
    assert!(cases[1].outcome.is_ok());
    assert_eq!(seeds(&cases)[1], Seed::Elastic);
}

#[test]
fn a_failure_names_every_seed_tried_and_stops_no_other_case() {
    let fake = Fake { impossible: Some(2.0), ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 2.0, 2.5]).unwrap();
    let reason = &cases[1].outcome.as_ref().unwrap_err().reason;
    for seed in ["neighbour", "intermediate-1", "intermediate-3", "elastic"] {
        assert!(reason.contains(&format!("from {seed}: too far")), "{reason}");
    }
    assert!(cases[2].outcome.is_ok());
    assert_eq!(seeds(&cases)[2], Seed::Neighbour, "seeded by the last case that converged");
    assert!(cases[1].effort.iterations > cases[0].effort.iterations, "failed attempts count");
}

#[test]
fn an_interrupt_ends_the_chain() {
    let fake = Fake { stops_at: Some(4.0), ..Fake::reaching(1.0) };
    assert_eq!(solve(&fake, &[1.0, 2.0, 4.0, 8.0]).unwrap_err(), Interrupted);
}

#[test]
fn an_empty_chain_is_solved_at_once() {
    assert!(solve(&Fake::reaching(1.0), &[]).unwrap().is_empty());
}

#[test]
fn a_start_that_fails_is_made_where_films_are_thick() {
    // the start converges below β = 100 only; a quarter of a decade is within reach
    let fake = Fake { start_below: Some(100.0), ..Fake::reaching(0.6) };
    let cases = solve(&fake, &[900.0]).unwrap();
    assert!(cases[0].outcome.is_ok(), "{:?}", cases[0].outcome);
    assert_eq!(seeds(&cases), [Seed::March(4)]);
    let cases = solve(&fake, &[9000.0]).unwrap();
    assert_eq!(seeds(&cases), [Seed::March(8)]);
    assert!(solve(&fake, &[90_000.0]).unwrap()[0].outcome.is_err());
}

#[test]
fn a_conclusive_failure_ends_the_search() {
    let fake = Fake { refused: Some(2.0), ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 2.0, 2.5]).unwrap();
    assert_eq!(cases[1].outcome.as_ref().unwrap_err().reason, "from neighbour: refused");
    assert_eq!(cases[1].effort.iterations, 1);
    assert!(cases[2].outcome.is_ok());
}
