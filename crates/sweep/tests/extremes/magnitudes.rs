//! Numbers at the edges of double precision: a solution or a reason, soon.

use rayon::prelude::*;
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::exact::{self, fitted_c};
use stribeck_solver::{Output, Parameters, Quantities, RetardationMode, Substrate};

use super::measure::worst;
use crate::extremes::cases::{outcome, outcomes};
use stribeck_solver::collocation::{CollocationSolver, Settings};

/// Most iterations of any case whatever.
const MOST_ITERATIONS: u64 = 1000;

/// Whether all that is said of a case is a number.
fn are_numbers(quantities: &Quantities) -> bool {
    let Quantities {
        friction,
        c,
        film_min,
        p_max,
        x_p_max,
        x_outlet,
        centroid,
        dissipation,
        separation,
        load_residual,
    } = *quantities;
    let all = [friction.viscoelastic, friction.hydrodynamic(), friction.drag, c, film_min, p_max, x_p_max, x_outlet];
    let others = [friction.pressure, friction.shear(), quantities.energy_residual(1.0)];
    all.into_iter().chain(others).chain([centroid, dissipation, separation, load_residual]).all(f64::is_finite)
}

/// Each magnitude of one parameter, at ordinary values of the others and at extreme ones.
#[test]
fn every_number_of_double_precision_has_an_answer() {
    let magnitudes =
        [f64::from_bits(1), 1e-300, 1e-50, 1e-30, 1e-16, 1e-8, 1.0, 1e8, 1e16, 1e30, 1e50, 1e300, f64::MAX];
    let mut cases = Vec::new();
    for magnitude in magnitudes {
        for other in [1.0, 1e16] {
            cases.push(Parameters::new(magnitude, other, 1.0));
            cases.push(Parameters::new(1.0, magnitude, other));
            cases.push(Parameters::new(other, 1.0, magnitude));
        }
        for alpha in [0.0, f64::INFINITY] {
            cases.push(Parameters::new(alpha, magnitude, 1.0));
            cases.push(Parameters::new(alpha, 1.0, magnitude));
        }
        cases.push(Parameters::new(magnitude, magnitude, magnitude));
    }
    let settings = Settings::default();
    let output = Output { x: vec![-1.0, 0.0, 1.0].into(), limits: true, ..Output::default() };
    cases.par_iter().with_max_len(1).for_each(|case| {
        let solver = CollocationSolver::new(settings);
        let solved =
            solve_chain(&solver, std::slice::from_ref(case), &output, &Interrupt::new()).expect("no interrupt");
        let solved = &solved[0];
        assert!(solved.effort.iterations <= MOST_ITERATIONS, "{case:?}: {} iterations", solved.effort.iterations);
        match &solved.outcome {
            Ok(solution) => {
                assert!(case.computable().is_ok(), "{case:?}");
                assert!(are_numbers(&solution.quantities), "{case:?}: {:?}", solution.quantities);
                assert!(worst(&solution.errors) <= settings.tolerance, "{case:?}: {:?}", solution.errors);
                let fields =
                    [&solution.fields.pressure, &solution.fields.film_thickness, &solution.fields.displacement];
                assert!(fields.into_iter().flatten().flatten().all(|value| value.is_finite()), "{case:?}");
                assert!(exact::limits(case).dry_mu_v.is_finite(), "{case:?}");
            }
            Err(failure) => {
                assert!(failure.to_string().len() > 20, "{case:?}: {failure}");
                let refused = case.computable().is_err();
                assert_eq!(refused, failure.to_string().contains("double precision can be used"), "{failure}");
            }
        }
    });
}

/// A case that cannot be computed takes none of its chain with it.
#[test]
fn others_of_a_chain_are_solved_all_the_same() {
    let beta = [1e-300, 1.0, 10.0, 1e300];
    let chain = beta.map(|beta| Parameters::new(1.0, beta, 10.0));
    let solved = outcomes(Settings::default(), &chain);
    let there: Vec<bool> = solved.iter().map(|case| case.outcome.is_ok()).collect();
    assert_eq!(there, [false, true, true, false]);
    let alone = outcomes(Settings::default(), &chain[1..3]);
    for (in_chain, alone) in solved[1..3].iter().zip(&alone) {
        let c = |case: &stribeck_solver::continuation::SolvedCase| case.outcome.as_ref().expect("solved").quantities.c;
        assert_eq!(c(in_chain), c(alone));
    }
}

/// Films beyond what double precision can hold are refused for that reason at any tolerance, and the reason says so.
#[test]
fn films_too_thin_for_double_precision_are_refused() {
    for (alpha, f) in [(f64::INFINITY, 0.0), (0.01, 10.0), (100.0, 10.0)] {
        for beta in [1e19, 1e25, 1e49] {
            let solved = outcome(Settings::default(), &Parameters::new(alpha, beta, f));
            let reason = solved.outcome.expect_err("a film of 1e-12 is not to be had").to_string();
            assert!(reason.contains("lost in the rounding errors of double precision"), "{reason}");
            assert!(solved.effort.iterations <= MOST_ITERATIONS);
        }
    }
}

/// What of a film is known in double precision: 5e-17/c of it. A tolerance below that is refused for that reason and no
/// other; one ten times as large is kept.
#[test]
fn tolerances_below_the_rounding_errors_of_a_film_are_refused() {
    for (alpha, f) in [(f64::INFINITY, 0.0), (0.01, 10.0), (1.0, 10.0), (100.0, 10.0), (0.01, 1e4), (100.0, 1e4)] {
        for tolerance in [1e-10, 1e-8] {
            for (part, is_refused) in [(0.3, true), (0.8, true), (10.0, false)] {
                let case = Parameters::new(alpha, beta_of(alpha, f, part * 5e-17 / tolerance), f);
                let solved = outcome(Settings { tolerance, ..Settings::default() }, &case);
                match solved.outcome {
                    Ok(solution) => {
                        assert!(!is_refused, "{tolerance:e}, {case:?}: c = {:e}", solution.quantities.c);
                        assert!(worst(&solution.errors) <= tolerance, "{case:?}: {:?}", solution.errors);
                    }
                    Err(failure) => {
                        let wanted = format!("in double precision, not to the tolerance {tolerance:e}");
                        assert!(is_refused && failure.to_string().contains(&wanted), "{case:?}: {failure}");
                    }
                }
            }
        }
    }
}

/// The β at which the film has this c, by the formula, which is good to 5 %.
fn beta_of(alpha: f64, f: f64, c: f64) -> f64 {
    let formula = |beta: f64| fitted_c(&Parameters::new(alpha, beta, f)).expect("one retardation time");
    // c falls as a power of β between −3/5 and −1
    (0..100).fold(1e10, |beta: f64, _| beta * formula(beta) / c)
}

/// The rate of a mode counts, not α: a fast mode beside a slow one.
#[test]
fn a_mode_that_is_beyond_numbers_is_named() {
    let modes = vec![RetardationMode { share: 0.5, time: 1.0 }, RetardationMode { share: 0.5, time: 1e-80 }];
    let substrate = Substrate::new(modes).expect("shares add up to 1");
    let case = Parameters { substrate, ..Parameters::new(1.0, 10.0, 10.0) };
    let reason = case.computable().expect_err("a rate of 1e80").to_string();
    assert!(reason.contains("alpha of a mode = 1e80"), "{reason}");
    assert!(outcome(Settings::default(), &case).outcome.is_err());
}
