//! Cases without a solution end with a reason, soon, and with no number that is not one.

use std::time::Instant;

use rayon::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::collocation::{self, CollocationSolver};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::relaxation::{Domain, Settings};

use crate::relaxation::cases::{no_fields, outcomes, relative, settings};
use crate::relaxation::far_cases::far_cases;

/// Passes over the points of the grid that no case may need, whatever comes of it: some seconds with 801 points.
const MOST_PASSES: u64 = 400;

/// What comes of one case, which must not take long.
fn outcome(points: usize, parameters: &Parameters) -> SolvedCase {
    let solved = outcomes(settings(points), std::slice::from_ref(parameters), &no_fields()).remove(0);
    let passes = solved.effort.iterations;
    assert!(passes < MOST_PASSES * points as u64, "{parameters:?}: {passes} passes with {points} points");
    solved
}

/// A reason, or numbers that can be; F_v may be wrong by a part of F_tot.
fn is_sane(parameters: &Parameters, case: &SolvedCase, part: f64) {
    match &case.outcome {
        Err(failure) => assert!(failure.to_string().len() > 20, "{parameters:?}: {failure:?}"),
        Ok(solution) => {
            let quantities = &solution.quantities;
            let friction = &quantities.friction;
            let positive = [
                quantities.c,
                quantities.film_min,
                quantities.p_max,
                friction.hydrodynamic_film,
                friction.hydrodynamic_cavity,
                friction.drag,
            ];
            assert!(positive.iter().all(|value| *value > 0.0 && value.is_finite()), "{parameters:?}: {quantities:?}");
            // zero where the substrate has no time to creep, or all of it
            let small = part * friction.total();
            assert!(
                friction.viscoelastic > -small && friction.viscoelastic.is_finite(),
                "{parameters:?}: {quantities:?}"
            );
            assert!(quantities.load_residual <= 1e-8, "{parameters:?}: {quantities:?}");
        }
    }
}

/// What no grid of so many points resolves is refused before the first pass; what it nearly resolves (inlets and
/// outlets are as wide as β^{−2/5}) by its flow.
#[test]
fn a_film_that_the_grid_does_not_resolve_is_a_failure_with_a_reason() {
    for points in [51, 101, 201] {
        for (beta, foreseen) in [(1e6, true), (0.0066 * (points as f64 - 1.0).powf(2.5), false)] {
            let solved = outcome(points, &Parameters::elastic(beta));
            let reason = solved.outcome.unwrap_err().to_string();
            assert!(reason.contains("does not resolve the film") && reason.contains("more points"), "{reason}");
            assert_eq!(solved.effort.iterations == 0, foreseen, "β = {beta}, {points} points: {reason}");
        }
    }
}

#[test]
fn a_domain_that_does_not_hold_the_contact_is_a_failure_that_says_so() {
    for (x_min, x_max) in [(-0.5, 3.0), (-3.0, 0.5), (2.0, 5.0), (-5.0, -2.0)] {
        let fixed = Settings { domain: Domain::Fixed { x_min, x_max }, ..settings(201) };
        let cases = [Parameters::elastic(10.0), Parameters::elastic(100.0)];
        for solved in outcomes(fixed, &cases, &no_fields()) {
            let reason = solved.outcome.unwrap_err().to_string();
            let numbers = [x_min, x_max].map(|x| x.to_string());
            assert!(numbers.iter().all(|number| reason.contains(number.as_str())), "{reason}");
            assert!(reason.contains("dry contact") && reason.contains("auto"), "{reason}");
        }
    }
}

/// A film so thick that its outlet lies behind the grid, or its largest pressure ahead of it: f = 0, and the same for
/// the instantaneous modulus, at β/(1+f).
#[test]
fn a_film_longer_than_its_grid_is_a_failure_that_says_so() {
    let cases = [(f64::INFINITY, 0.01, 0.0), (f64::INFINITY, 1e-3, 0.0), (0.01, 10.0, 1000.0), (0.1, 10.0, 1000.0)];
    for (alpha, beta, f) in cases {
        for points in [201, 401, 801] {
            let case = Parameters::new(alpha, beta, f);
            let solved = outcome(points, &case);
            if f == 0.0 {
                assert_eq!(solved.effort.iterations, 0, "the rigid film tells");
            }
            let reason = solved.outcome.unwrap_err().to_string();
            assert!(reason.contains("longer than the grid") && reason.contains("wider domain"), "{case:?}: {reason}");
        }
    }
}

/// What fails in the middle of a chain does not take the others along.
#[test]
fn a_failure_does_not_stop_the_chain() {
    let cases = [1e1, 1e9, 2e1].map(Parameters::elastic);
    let solved = outcomes(settings(101), &cases, &no_fields());
    assert!(solved[0].outcome.is_ok() && solved[1].outcome.is_err() && solved[2].outcome.is_ok());
}

/// Far outside of the paper's range.
#[test]
fn extreme_parameters_end_soon() {
    for f in [0.0, 1.0, 1e6] {
        for alpha in [0.0, 1e-8, 1.0, 1e8] {
            for beta in [1e-4, 1.0, 1e10] {
                if f == 0.0 && alpha != 1.0 {
                    continue;
                }
                let parameters = Parameters::new(alpha, beta, f);
                let begin = Instant::now();
                let solved = outcome(201, &parameters);
                println!(
                    "f {f:e}, alpha {alpha:e}, beta {beta:e}: {:.2?}, {} passes, {:?}",
                    begin.elapsed(),
                    solved.effort.iterations,
                    solved.outcome.as_ref().map(|solution| solution.quantities.c).map_err(ToString::to_string)
                );
                is_sane(&parameters, &solved, 1e-6);
            }
        }
    }
}

/// No wrong answer says converged, in a box that is much larger than the method's range: c of every case that is
/// accepted is that of collocation within 5 %, the rest has a reason.
#[test]
fn what_is_accepted_far_outside_is_right() {
    let judged: Vec<bool> = far_cases(120)
        .par_iter()
        .with_max_len(1)
        .map(|parameters| {
            let solved = outcome(201, parameters);
            // what a short domain leaves of F_v of a thick film
            is_sane(parameters, &solved, 1e-3);
            let Ok(solution) = solved.outcome else { return false };
            let exact = CollocationSolver::new(collocation::Settings { tolerance: 1e-4, ..Default::default() });
            let exact = solve_chain(&exact, std::slice::from_ref(parameters), &no_fields(), &Interrupt::new());
            let exact = exact.expect("nobody interrupts").remove(0).outcome;
            let exact = exact.unwrap_or_else(|why| panic!("{parameters:?}: {why}")).quantities;
            let by_c = relative(solution.quantities.c, exact.c);
            assert!(by_c < 0.05, "{parameters:?}: c is off by {by_c:.1e}");
            true
        })
        .collect();
    let accepted = judged.iter().filter(|&&accepted| accepted).count();
    assert!(accepted > 30 && accepted < 100, "{accepted} accepted");
}
