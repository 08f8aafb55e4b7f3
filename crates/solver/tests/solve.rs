//! Solving by settings: one case, a chain, and points in any order.

use std::time::Duration;

use stribeck_solver::{
    FailureKind, Interrupt, Interrupted, Method, Output, Parameters, RetardationMode, Settings, SolvedCase, Solver,
    Substrate, exact, solve, solve_points,
};
use stribeck_solver::{collocation, relaxation};

/// What must not depend on the way to it.
fn numbers(case: &SolvedCase) -> Result<Vec<u64>, String> {
    let solution = case.outcome.as_ref().map_err(ToString::to_string)?;
    let (quantities, errors) = (&solution.quantities, &solution.errors);
    let friction = &quantities.friction;
    let all = [friction.viscoelastic, friction.total(), friction.drag, quantities.c, quantities.film_min, errors.mu_v];
    Ok(all.map(f64::to_bits).to_vec())
}

fn solved(points: &[Parameters], settings: &Settings) -> Vec<SolvedCase> {
    solve_points(points, settings, &Interrupt::new()).expect("nobody interrupts")
}

/// A mixture: a grid in α and β, a curve over speed, both elastic limits, two substrates, a point twice, and impossible
/// ones.
fn mixture() -> Vec<Parameters> {
    let modes = [(0.4, 1.0), (0.6, 10.0)].map(|(share, time)| RetardationMode { share, time });
    let substrate = Substrate::new(modes.to_vec()).expect("a substrate");
    let both = Substrate::of_two_bodies(modes[..1].to_vec(), modes[1..].to_vec()).expect("a substrate");
    let mut points = Vec::new();
    for alpha in [0.1, 10.0] {
        points.extend((0..10).map(|i| Parameters::new(alpha, 5.0 * 1.5_f64.powi(i), 10.0)));
    }
    points.extend((0..20).map(|i| 1.3_f64.powi(i)).map(|inverse| Parameters::new(0.01 * inverse, 3.0 * inverse, 4.0)));
    points.extend(
        [20.0, 40.0].map(|beta| Parameters { substrate: substrate.clone(), ..Parameters::new(1.0, beta, 5.0) }),
    );
    points.extend([20.0, 40.0].map(|beta| Parameters { substrate: both.clone(), ..Parameters::new(1.0, beta, 5.0) }));
    points.extend([20.0, 40.0].map(|beta| Parameters::new(0.0, beta, 5.0)));
    points.extend([Parameters::elastic(30.0), Parameters::elastic(60.0), points[3].clone()]);
    points.extend([Parameters::new(1.0, 1e30, 1.0), Parameters::new(1.0, f64::NAN, 1.0)]);
    points
}

#[test]
fn one_case_is_a_chain_of_one() {
    let (case, settings) = (Parameters::new(1.0, 100.0, 10.0), Settings::default());
    let chain = Solver::new(&settings).solve_chain(std::slice::from_ref(&case), &Interrupt::new()).unwrap();
    assert_eq!(solve(&case, &settings).unwrap().quantities, chain[0].outcome.as_ref().unwrap().quantities);
    assert_eq!(
        solved(&[case], &settings)[0].outcome.as_ref().unwrap().quantities.c,
        chain[0].outcome.as_ref().unwrap().quantities.c
    );
}

#[test]
fn points_are_solved_in_any_order_with_the_same_numbers() {
    let points = mixture();
    let there = solved(&points, &Settings::default());
    let backwards: Vec<Parameters> = points.iter().rev().cloned().collect();
    let back = solved(&backwards, &Settings::default());
    for ((point, there), back) in points.iter().zip(&there).zip(back.iter().rev()) {
        assert_eq!(numbers(there), numbers(back), "{point:?}");
        assert_eq!((there.seed, &there.path), (back.seed, &back.path), "{point:?}");
    }
    // The film does not know whose a mode is, its hysteresis does.
    let both = points.iter().position(|point| point.substrate.of_roller() > 0).expect("two bodies");
    let friction = |place: usize| there[place].outcome.as_ref().unwrap().quantities.friction;
    assert!((friction(both).viscoelastic / friction(both - 2).viscoelastic - 1.0).abs() < 1e-5);
    assert!(friction(both).viscoelastic_roller > 0.0 && friction(both - 2).viscoelastic_roller == 0.0);
    let failed: Vec<usize> = (0..points.len()).filter(|&place| there[place].outcome.is_err()).collect();
    assert_eq!(failed, [points.len() - 2, points.len() - 1], "only the impossible ones fail");
    let from_neighbours =
        there.iter().filter(|case| case.path.points.is_empty() && case.seed.points().is_none()).count();
    assert!(from_neighbours > points.len() / 2, "most points have a neighbour to start from: {from_neighbours}");
}

#[test]
fn points_are_solved_on_any_number_of_threads_with_the_same_numbers() {
    let points = mixture();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| solved(&points, &Settings::default()).iter().map(numbers).collect::<Vec<_>>())
    };
    assert_eq!(on(1), on(3));
}

/// The workspace of the relaxation method is that of one α and f: points of others are not solved with it.
#[test]
fn the_relaxation_method_solves_each_point_with_its_own_kernel() {
    let settings = relaxation::Settings { points: 101, ..relaxation::Settings::default() };
    let settings = Settings { method: Method::Relaxation(settings), ..Settings::default() };
    let points: Vec<Parameters> = [10.0, 12.0]
        .into_iter()
        .flat_map(|beta| [0.5, 1.0, 2.0].map(|alpha| Parameters::new(alpha, beta, 5.0)))
        .collect();
    let as_one_chain = Solver::new(&settings).solve_chain(&points, &Interrupt::new()).unwrap();
    let twice = points.iter().chain(&points).zip(solved(&points, &settings).into_iter().chain(as_one_chain));
    for (point, case) in twice {
        let (here, alone) = (case.outcome.unwrap().quantities, solve(point, &settings).unwrap().quantities);
        assert!((here.c / alone.c - 1.0).abs() < 1e-6, "{point:?}: {} {}", here.c, alone.c);
        assert!((here.friction.viscoelastic / alone.friction.viscoelastic - 1.0).abs() < 1e-6, "{point:?}");
    }
}

#[test]
fn limits_beside_a_case_are_known_whether_or_not_it_is_solved() {
    let settings = Settings { output: Output { limits: true, ..Output::numbers() }, ..Settings::default() };
    let chain = [Parameters::new(1.0, 100.0, 10.0), Parameters::new(1.0, 1e30, 10.0)];
    let cases = Solver::new(&settings).solve_chain(&chain, &Interrupt::new()).unwrap();
    assert!(cases[0].outcome.is_ok() && cases[1].outcome.is_err());
    for (case, parameters) in cases.iter().zip(&chain) {
        assert_eq!(case.limits, exact::limits(parameters));
        assert!(case.limits.dry_mu_v > 0.0);
    }
    let without = Solver::new(&Settings::default()).solve_chain(&chain, &Interrupt::new()).unwrap();
    assert!(without.iter().all(|case| case.limits.dry_mu_v.is_nan()));
}

#[test]
fn a_time_limit_is_kept() {
    let settings = Settings { time_limit: Some(Duration::ZERO), ..Settings::default() };
    let failure = solve(&Parameters::new(1.0, 100.0, 10.0), &settings).unwrap_err();
    assert_eq!(failure.kind, FailureKind::TimeLimit(Duration::ZERO));
}

#[test]
fn settings_out_of_their_range_are_a_failure() {
    let case = Parameters::new(1.0, 100.0, 10.0);
    let kind = |method| solve(&case, &Settings { method, ..Settings::default() }).unwrap_err().kind;
    let collocation = collocation::Settings::default();
    let relaxation = relaxation::Settings::default();
    for (method, expected) in [
        (
            Method::Collocation(collocation::Settings { tolerance: f64::NAN, ..collocation }),
            "tolerance = NaN is no setting of the collocation method: it must be from 1e-10 to 0.1",
        ),
        (
            Method::Collocation(collocation::Settings { degree: 3, ..collocation }),
            "degree = 3 is no setting of the collocation method: it must be from 4 to 16",
        ),
        (
            Method::Relaxation(relaxation::Settings { points: 800, ..relaxation }),
            "points = 800 is no setting of the relaxation method: it must be odd",
        ),
        (
            Method::Relaxation(relaxation::Settings { points: 101, estimate: true, ..relaxation }),
            "points = 101 is no setting of the relaxation method: it must be from 201 to 20001",
        ),
        (
            Method::Relaxation(relaxation::Settings { tolerance: 0.0, ..relaxation }),
            "tolerance = 0.0 is no setting of the relaxation method: it must be from 1e-12 to 0.01",
        ),
    ] {
        let kind = kind(method);
        assert!(matches!(kind, FailureKind::Setting(_)), "{kind:?}");
        assert_eq!(kind.to_string(), expected);
    }
}

#[test]
fn an_interrupt_ends_all_points() {
    let interrupt = Interrupt::new();
    interrupt.request();
    assert_eq!(solve_points(&mixture(), &Settings::default(), &interrupt).unwrap_err(), Interrupted);
    assert!(solve_points(&[], &Settings::default(), &interrupt).unwrap().is_empty());
}

#[test]
fn only_the_last_case_of_a_traced_chain_is_traced() {
    let chain = [10.0, 20.0].map(|beta| Parameters::new(1.0, beta, 10.0));
    let solver = Solver::new(&Settings::default());
    let last = solver.trace_last(&chain).expect("two cases");
    assert!(!last.trace.events.is_empty());
    let plain = solver.solve_chain(&chain, &Interrupt::new()).unwrap();
    assert!(plain.iter().all(|case| case.trace.events.is_empty()));
    assert_eq!(numbers(&last), numbers(&plain[1]));
    assert!(solver.trace_last(&[]).is_none());
}
