//! Steps along a way: how they grow and shrink, where a walk gives up, and what is recorded of it.

use proptest::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::continuation::{Line, Path, Seed, StepControl};

use crate::continuation::fake::{Fake, seeds, solve, solve_cases};

/// Steps in ln β that depend on the solver's iterations.
fn informed() -> StepControl {
    StepControl { first: 0.5, largest: 2.0, smallest: 0.1, smallest_part: 0.0, reduction: 0.4, iterations: Some(6.0) }
}

/// A fake that takes the last case as the guess, so that no step longer than `reach` succeeds, and whose one origin is
/// `decades` below the case.
fn walker(reach: f64, decades: i32, control: StepControl) -> Fake {
    Fake {
        extrapolates: false,
        decades: vec![decades],
        start_below: Some(f64::INFINITY),
        control,
        iterations: 6,
        ..Fake::reaching(reach)
    }
}

fn betas(path: &Path, accepted: bool) -> Vec<f64> {
    path.points.iter().filter(|point| point.accepted == accepted).map(|point| point.beta).collect()
}

#[test]
fn a_step_follows_the_effort_of_the_one_before() {
    let control = informed();
    assert_eq!(control.after_success(0.5, 6), 0.5, "as many iterations as wanted");
    assert_eq!(control.after_success(0.5, 3), 1.0, "half as many");
    assert_eq!(control.after_success(0.5, 8), 0.375, "more");
    assert_eq!(control.after_success(0.5, 0), 1.5, "at most three times as long");
    assert_eq!(control.after_success(0.5, 1000), 0.25, "at least half as long");
    assert_eq!(control.after_success(1.5, 2), 2.0, "no longer than the largest");
    assert_eq!(control.after_success(0.15, 1000), 0.1, "no shorter than the smallest");
    let uninformed = StepControl { iterations: None, ..control };
    assert_eq!(uninformed.after_success(0.5, 1), 0.5);
}

#[test]
fn a_failed_step_is_cut_down_to_the_smallest() {
    let control = informed();
    assert_eq!(control.after_failure(0.5, 10.0), Some(0.2));
    assert_eq!(control.after_failure(0.25, 10.0), Some(0.1));
    assert_eq!(control.after_failure(0.24, 10.0), None);
    assert_eq!(control.after_failure(10.0, 10.0), Some(2.0), "nor longer than the largest");
    let quarters = StepControl { smallest_part: 0.25, reduction: 0.5, ..control };
    assert_eq!(quarters.after_failure(4.0, 4.0), Some(2.0));
    assert_eq!(quarters.after_failure(2.0, 4.0), Some(1.0));
    assert_eq!(quarters.after_failure(1.0, 4.0), None);
}

#[test]
fn steps_grow_while_the_solver_is_quick() {
    let quick = Fake { iterations: 3, ..walker(100.0, 3, informed()) };
    let case = solve(&quick, &[100.0]).unwrap().remove(0);
    let (visited, origin) = (quick.attempts(), 0.1_f64.ln());
    let steps: Vec<f64> = visited.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let expected = [0.5, 1.0, 2.0, 2.0, 1000_f64.ln() - 5.5];
    assert_eq!(steps.len(), expected.len(), "{steps:?}");
    assert!((visited[0] - origin).abs() < 1e-12);
    assert!(steps.iter().zip(expected).all(|(step, expected)| (step - expected).abs() < 1e-12), "{steps:?}");
    assert_eq!(case.seed, Seed::March(5));
}

#[test]
fn a_remainder_is_not_worth_a_step() {
    let even = walker(100.0, 1, StepControl { first: 10_f64.ln() / 4.0 * 0.999, ..informed() });
    assert_eq!(solve(&even, &[100.0]).unwrap()[0].seed, Seed::March(4));
}

#[test]
fn the_path_holds_all_that_was_tried() {
    // 0.5 fails, 0.2 succeeds
    let fake = walker(0.3, 1, informed());
    let case = solve(&fake, &[10.0]).unwrap().remove(0);
    assert!(case.outcome.is_ok());
    let points = &case.path.points;
    assert_eq!(points.iter().map(|point| point.beta.ln()).collect::<Vec<_>>(), fake.attempts());
    assert!(points.iter().all(|point| (point.alpha, point.f, point.iterations) == (1.0, 1.0, 6)));
    assert_eq!(points.iter().map(|point| point.iterations).sum::<u64>(), case.effort.iterations);
    assert_eq!((points[0].beta, points[points.len() - 1].beta), (1.0, 10.0));
    assert_eq!(betas(&case.path, false).len(), 1);
    let accepted = betas(&case.path, true);
    assert!(accepted.is_sorted());
    assert_eq!(case.seed, Seed::March(accepted.len() - 1), "the case itself is published");
}

#[test]
fn a_first_guess_that_succeeds_leaves_no_path() {
    let cases = solve(&Fake::reaching(1.0), &[1.0, 2.0, 4.0]).unwrap();
    assert_eq!(seeds(&cases), [Seed::ThickFilm, Seed::Neighbour, Seed::Predictor]);
    assert!(cases.iter().all(|case| case.path == Path::default()));
}

/// Along the speed, α and β change together.
#[test]
fn a_walk_goes_along_the_line_in_all_coordinates() {
    let cases = [Parameters::new(1.0, 1.0, 1.0), Parameters::new(0.2, 20.0, 5.0)];
    let solved = solve_cases(&Fake { decades: vec![0], ..Fake::reaching(1.0) }, &cases).unwrap();
    assert_eq!(solved[1].seed, Seed::Intermediate(3));
    let line = Line::new(&cases[0], &cases[1]).unwrap();
    let expected = [1.0, 0.5, 0.25, 0.5, 0.75, 1.0].map(|t| line.at(t));
    let points = solved[1].path.points.iter().map(|point| (point.alpha, point.beta, point.f));
    assert!(points.eq(expected.iter().map(|here| (here.alpha, here.beta, here.f))));
}

#[test]
fn where_no_line_leads_a_case_is_started_anew() {
    let cases = [Parameters::new(0.0, 1.0, 1.0), Parameters::new(1.0, 2.0, 1.0), Parameters::new(1.0, 4.0, 1.0)];
    let fake = Fake { start_below: Some(3.0), decades: vec![0], ..Fake::reaching(1.0) };
    let solved = solve_cases(&fake, &cases).unwrap();
    assert_eq!(seeds(&solved), [Seed::ThickFilm, Seed::ThickFilm, Seed::Predictor]);
    let stuck = Fake { start_below: None, decades: vec![0], ..Fake::reaching(1.0) };
    let solved = solve_cases(&stuck, &cases).unwrap();
    let reason = &solved[1].outcome.as_ref().unwrap_err().to_string();
    assert!(reason.starts_with("from neighbour: no line leads from alpha = 0 to alpha = 1"), "{reason}");
}

#[test]
fn a_walk_that_gives_up_says_where() {
    // beyond the origin no step down to the smallest, 0.1, succeeds
    let fake = walker(0.05, 1, informed());
    let case = solve(&fake, &[10.0]).unwrap().remove(0);
    let reason = case.outcome.unwrap_err().to_string();
    assert_eq!(reason, "from march-1: at beta = 1.2214e0: too far", "0.5, then 0.2, and 0.08 is too short");
    assert_eq!(case.seed, Seed::March(1));
    assert_eq!(betas(&case.path, false).len(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    /// Whatever the solver can reach: no step is shorter than the smallest (save the last), a walk arrives if the reach
    /// allows a step that may be taken, and it is the same walk every time.
    #[test]
    fn walks_keep_to_their_steps(reach in 0.02..3.0_f64, decades in 1..6, iterations in 1..20_u64) {
        let fake = || Fake { iterations, ..walker(reach, decades, informed()) };
        let first = fake();
        let case = solve(&first, &[50.0]).unwrap().remove(0);
        let accepted = betas(&case.path, true);
        let arrived = case.outcome.is_ok();
        let steps: Vec<f64> = accepted.windows(2).map(|pair| (pair[1] / pair[0]).ln()).collect();
        prop_assert!(steps.iter().rev().skip(usize::from(arrived)).all(|&step| step >= 0.1 - 1e-12), "{:?}", steps);
        prop_assert!(steps.iter().all(|&step| step <= reach.min(2.02) + 1e-12), "{:?}", steps);
        // a step that failed is cut by 0.4, so one of at least 0.4 of the reach is always tried
        prop_assert!(arrived || 0.4 * reach <= 0.1 * 1.01);
        prop_assert!(!arrived || *accepted.last().unwrap() == 50.0);
        let again = fake();
        prop_assert_eq!(&solve(&again, &[50.0]).unwrap()[0].path, &case.path);
        prop_assert_eq!(again.attempts(), first.attempts());
    }
}
