//! The record of the way to a case: there if it is wanted, as it was, and nothing else changes.

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{CaseSolver, Chain, Event, FailureKind, Interrupt, SolvedCase, Trace};
use stribeck_solver::relaxation::{self, RelaxationSolver};
use stribeck_solver::{FieldSelection, Output, Parameters};

use crate::continuation::fake::Fake;

/// The cases of a chain, traced or not.
fn solved<S: CaseSolver>(solver: &S, betas: &[f64], traced: bool) -> Vec<SolvedCase> {
    let output = Output { fields: FieldSelection::default(), ..Output::default() };
    let interrupt = Interrupt::new();
    let mut chain = Chain::new(solver, &output, &interrupt);
    chain.traced(traced);
    betas.iter().map(|&beta| chain.solve(&Parameters::new(1.0, beta, 10.0)).unwrap()).collect()
}

/// Laws of every trace of a case that converged.
fn check<S: CaseSolver>(solver: &S, betas: &[f64]) {
    for (case, bare) in solved(solver, betas, true).iter().zip(solved(solver, betas, false)) {
        assert_eq!(bare.trace, Trace::default(), "nothing is recorded unless it is wanted");
        // Written in full: NaN is equal to NaN.
        let numbers = |case: &SolvedCase| {
            let solution = case.outcome.as_ref().unwrap();
            format!("{:?}, {:?}", solution.quantities, solution.errors)
        };
        assert_eq!((numbers(case), &case.path), (numbers(&bare), &bare.path), "to watch changes nothing");

        let events = &case.trace.events;
        let attempts = events.iter().filter(|event| matches!(event, Event::Attempt { .. })).count();
        assert_eq!(attempts, case.path.points.len().max(1), "each point of the path is an attempt");
        assert_eq!(events.last(), Some(&Event::Solved));
        let evaluation = events.iter().position(|event| *event == Event::Evaluation).expect("it was evaluated");
        assert!(matches!(events[evaluation - 1], Event::Solved), "only a solution is evaluated");
        let residuals: Vec<f64> = events[..evaluation]
            .iter()
            .filter_map(|event| if let Event::Residual { residual, .. } = event { Some(*residual) } else { None })
            .collect();
        assert!(residuals.last() <= residuals.first(), "the last attempt came nearer: {residuals:?}");
    }
}

#[test]
fn the_way_of_a_collocation_case_is_recorded_as_it_was() {
    let settings = Settings::for_tolerance(1e-6);
    let solver = CollocationSolver::new(settings);
    check(&solver, &[10.0, 30.0, 50.0]);
    for case in solved(&solver, &[10.0, 30.0], true) {
        let estimate = case.trace.events.iter().rev().find_map(|event| match event {
            Event::Error { unknowns, error } => Some((*unknowns, *error)),
            _ => None,
        });
        let (unknowns, error) = estimate.expect("errors are estimated");
        assert_eq!(unknowns, case.effort.unknowns);
        let published = case.outcome.unwrap().errors.largest().expect("an estimate");
        assert!(error <= 0.9 && published <= 0.9 * settings.tolerance, "{published:e}, {error} of the tolerance");
    }
}

#[test]
fn the_way_of_a_relaxation_case_is_recorded_as_it_was() {
    check(&RelaxationSolver::new(relaxation::Settings { points: 101, ..Default::default() }), &[10.0, 15.0]);
}

#[test]
fn a_failed_attempt_is_recorded_with_its_reason() {
    let fake = Fake { impossible: Some(2.0), ..Fake::reaching(1.0) };
    let case = solved(&fake, &[1.0, 2.0], true).remove(1);
    let at_the_case = Event::Attempt { alpha: 1.0, beta: 2.0, f: 10.0 };
    let place = case.trace.events.iter().position(|event| *event == at_the_case).expect("it was tried");
    assert_eq!(case.trace.events[place + 1], Event::Failed(FailureKind::Other("too far".to_owned()).into()));
    assert!(!case.trace.events.contains(&Event::Evaluation));
}
