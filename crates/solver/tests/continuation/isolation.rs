//! A panic of the solver, or a case that takes too long, is a failure of that case and of no other.

use std::sync::atomic::Ordering;
use std::time::Duration;

use stribeck_solver::continuation::{Chain, FailureKind, Interrupt, Seed, SolvedCase};
use stribeck_solver::{Output, Parameters};

use crate::continuation::fake::{Fake, seeds, solve};

const BETAS: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 16.0];

fn solve_within(fake: &Fake, limit: Duration) -> Vec<SolvedCase> {
    let (output, interrupt) = (Output::default(), Interrupt::new());
    let mut chain = Chain::new(fake, &output, &interrupt).with_time_limit(limit);
    BETAS.map(|beta| chain.solve(&Parameters::new(1.0, beta, 1.0)).unwrap()).into()
}

/// All but one case are solved, and this one failed for a reason that begins with these words.
fn assert_fails_alone(cases: &[SolvedCase], place: usize, words: &str) {
    for (i, case) in cases.iter().enumerate() {
        match &case.outcome {
            Ok(solution) => {
                assert!(i != place);
                assert!((solution.quantities.c - BETAS[i]).abs() < 1e-9, "{i}: not its own solution");
            }
            Err(failure) => assert!(i == place && failure.to_string().starts_with(words), "{i}: {failure}"),
        }
    }
}

#[test]
fn a_panic_fails_its_case_alone() {
    for (place, &beta) in BETAS.iter().enumerate() {
        let fake = Fake { panics_at: Some(beta), start_helps: true, ..Fake::reaching(1.5) };
        let cases = solve(&fake, &BETAS).unwrap();
        assert_fails_alone(&cases, place, &format!("the solver panicked: a panic at {beta}"));
        assert_eq!(cases[place].outcome.as_ref().unwrap_err().kind.name(), "panic");
        // What the panic left half-changed is not used again.
        let expected = if place + 1 == BETAS.len() { 1 } else { 2 };
        assert_eq!(fake.workspaces.load(Ordering::Relaxed), expected);
    }
}

#[test]
fn the_case_after_a_panic_is_seeded_by_those_before_it() {
    let fake = Fake { panics_at: Some(4.0), ..Fake::reaching(1.5) };
    let cases = solve(&fake, &BETAS).unwrap();
    let found = seeds(&cases);
    assert_eq!((&found[2], &found[3], &found[4]), (&Seed::None, &Seed::Predictor, &Seed::Predictor));
}

#[test]
fn a_case_that_takes_too_long_fails_alone_and_says_how_to_give_it_more() {
    let limit = Duration::from_millis(20);
    for (place, &beta) in BETAS.iter().enumerate() {
        let fake = Fake { stuck_at: Some(beta), start_helps: true, ..Fake::reaching(1.5) };
        let cases = solve_within(&fake, limit);
        assert_fails_alone(&cases, place, "not solved within 0.02 s, the time limit of a case; raise `time_limit`");
        let case = &cases[place];
        assert_eq!(case.outcome.as_ref().unwrap_err().kind, FailureKind::TimeLimit(limit));
        assert!(case.effort.iterations > 0 && case.effort.seconds >= limit.as_secs_f64(), "what it cost is told");
    }
}

#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let fake = || Fake::reaching(1.0);
    let told = |cases: Vec<SolvedCase>| -> Vec<_> {
        cases.into_iter().map(|case| (case.seed, case.path, case.outcome.unwrap().quantities)).collect()
    };
    let without = told(solve(&fake(), &BETAS).unwrap());
    assert_eq!(told(solve_within(&fake(), Duration::from_secs(3600))), without);
    assert_eq!(told(solve_within(&fake(), Duration::MAX)), without, "longer than a clock can tell");
}
