//! Which seeds are tried in which order, and what a failure or an interrupt does to the rest.

use stribeck_solver::continuation::{FailureKind, Interrupted, Seed, StepControl};

use crate::continuation::fake::{Fake, seeds, solve};

#[test]
fn the_first_case_has_the_start_the_second_its_neighbour_the_third_both() {
    let cases = solve(&Fake::reaching(1.0), &[1.0, 2.0, 4.0, 8.0]).unwrap();
    assert!(cases.iter().all(|case| case.outcome.is_ok()));
    assert_eq!(seeds(&cases), [Seed::ThickFilm, Seed::Neighbour, Seed::Predictor, Seed::Predictor]);
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
    let visited = fake.attempts();
    assert!(visited.iter().any(|&at| (at - 0.95).abs() < 1e-12), "{visited:?}");
    // a quarter is within reach, half of it is not
    let cases = solve(&Fake::reaching(1.0), &[1.0, 3.9_f64.exp()]).unwrap();
    assert_eq!(seeds(&cases)[1], Seed::Intermediate(3));
}

#[test]
fn the_last_seed_is_the_start() {
    let fake = Fake { start_helps: true, ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 20.0_f64.exp()]).unwrap();
    assert!(cases[1].outcome.is_ok());
    assert_eq!(seeds(&cases)[1], Seed::ThickFilm);
}

#[test]
fn a_failure_names_every_seed_tried_and_stops_no_other_case() {
    let fake = Fake { impossible: Some(2.0), ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 2.0, 2.5]).unwrap();
    let reason = &cases[1].outcome.as_ref().unwrap_err().to_string();
    // half of the way and three quarters of it are reached
    let expected = "from intermediate-2: too far; from thick-film: too far; \
                    from march-0: at beta = 2.0000e-1: too far; from march-0: at beta = 2.0000e-2: too far";
    assert_eq!(reason, expected);
    assert_eq!(cases[1].seed, Seed::March(0), "the last one tried");
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
    assert_eq!(
        cases[1].outcome.as_ref().unwrap_err().to_string(),
        format!("from neighbour: {}", FailureKind::FilmThinnerThanGrid)
    );
    assert_eq!(cases[1].effort.iterations, 1);
    assert!(cases[2].outcome.is_ok());
}

#[test]
fn the_seeds_are_tried_in_order() {
    // nothing converges at the fourth case, though everything is within reach
    let fake = Fake { impossible: Some(8.0), decades: vec![1, 0], start_helps: true, ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 2.0, 4.0, 8.0]).unwrap();
    let reason = &cases[3].outcome.as_ref().unwrap_err().to_string();
    let seeds: Vec<&str> = reason.split("; ").map(|part| part.split(": ").next().unwrap()).collect();
    assert_eq!(seeds, ["from predictor", "from intermediate-2", "from march-4", "from thick-film"]);
    let path: Vec<f64> = cases[3].path.points.iter().map(|point| point.beta).collect();
    assert_eq!(path[..2], [8.0, 8.0], "the predictor, then the whole step from the neighbour");
    assert!((path[2] / 32_f64.sqrt() - 1.0).abs() < 1e-14, "then half of it: {path:?}");
    assert_eq!(path.last(), Some(&8.0), "and last the case's own start");
    assert_eq!(path.iter().filter(|&&beta| beta == 8.0).count(), 6);
}

#[test]
fn origins_are_tried_as_the_solver_lists_them() {
    for decades in [vec![1, 2, 0], vec![0], vec![2]] {
        let fake = Fake { decades: decades.clone(), ..Fake::reaching(1.0) };
        let cases = solve(&fake, &[900.0]).unwrap();
        assert!(cases[0].outcome.is_err());
        let tried: Vec<f64> = fake.attempts().iter().map(|ln_beta| (900.0 / ln_beta.exp()).log10().round()).collect();
        assert_eq!(tried, decades.iter().map(|&decades| f64::from(decades)).collect::<Vec<_>>());
    }
}

#[test]
fn a_solution_of_which_nothing_can_be_known_leads_to_the_next_seed() {
    let fake = Fake { unknowable: Some(2.0), decades: vec![0], ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0, 2.0, 2.5]).unwrap();
    let reason = &cases[1].outcome.as_ref().unwrap_err().to_string();
    assert_eq!(reason, "from neighbour: not to be known; from thick-film: too far", "the step is not cut");
    assert_eq!(seeds(&cases)[2], Seed::Neighbour, "it seeds nothing");
}

#[test]
fn a_case_without_any_first_guess_says_so() {
    let fake = Fake { starts: false, decades: vec![0], ..Fake::reaching(1.0) };
    let cases = solve(&fake, &[1.0]).unwrap();
    assert_eq!(cases[0].outcome.as_ref().unwrap_err().to_string(), "no first guess: nowhere to start");
    assert_eq!(seeds(&cases), [Seed::None]);
}

/// A solver that is too quick to look for a request is stopped between its solves.
#[test]
fn an_interrupt_is_seen_between_solves() {
    let control = StepControl { first: 0.1, ..Fake::reaching(1.0).control };
    let march = Fake { stops_at: Some(10.0 * 0.1), heeds: false, decades: vec![1], control, ..Fake::reaching(1.0) };
    assert_eq!(solve(&march, &[10.0]).unwrap_err(), Interrupted);
    assert_eq!(march.attempts().len(), 1);
    let chain = Fake { stops_at: Some(2.0), heeds: false, ..Fake::reaching(1.0) };
    assert_eq!(solve(&chain, &[1.0, 2.0, 4.0]).unwrap_err(), Interrupted);
    assert_eq!(chain.attempts().len(), 2);
}
