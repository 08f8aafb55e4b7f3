//! Cases without a solution end with a reason, soon, and with no number that is not one.

use std::time::Instant;

use stribeck::continuation::SolvedCase;
use stribeck::model::Parameters;
use stribeck::relaxation::{Domain, Settings};

use crate::cases::{no_fields, outcomes, settings};

/// A reason, or numbers that can be.
fn is_sane(parameters: &Parameters, case: &SolvedCase) {
    match &case.outcome {
        Err(failure) => assert!(failure.reason.len() > 20, "{parameters:?}: {failure:?}"),
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
            let small = 1e-6 * friction.total();
            assert!(
                friction.viscoelastic > -small && friction.viscoelastic.is_finite(),
                "{parameters:?}: {quantities:?}"
            );
            assert!(quantities.load_residual <= 1e-8, "{parameters:?}: {quantities:?}");
        }
    }
}

#[test]
fn a_film_that_the_grid_does_not_resolve_is_a_failure_with_a_reason() {
    for points in [51, 101] {
        let case = Parameters::elastic(1e5);
        let solved = outcomes(settings(points), std::slice::from_ref(&case), &no_fields()).remove(0);
        let reason = solved.outcome.unwrap_err().reason;
        assert!(!reason.contains("NaN") && !reason.contains("inf:"), "{reason}");
        assert!(["resolve", "diverges", "stalls"].iter().any(|word| reason.contains(word)), "{reason}");
    }
}

#[test]
fn a_domain_that_does_not_hold_the_contact_is_a_failure_that_says_so() {
    for (x_min, x_max) in [(-0.5, 3.0), (-3.0, 0.5), (2.0, 5.0), (-5.0, -2.0)] {
        let fixed = Settings { domain: Domain::Fixed { x_min, x_max }, ..settings(201) };
        let cases = [Parameters::elastic(10.0), Parameters::elastic(100.0)];
        for solved in outcomes(fixed, &cases, &no_fields()) {
            let reason = solved.outcome.unwrap_err().reason;
            let numbers = [x_min, x_max].map(|x| x.to_string());
            assert!(numbers.iter().all(|number| reason.contains(number.as_str())), "{reason}");
            assert!(reason.contains("dry contact") && reason.contains("auto"), "{reason}");
        }
    }
}

/// A film so thick that its outlet lies behind the grid, or its largest pressure ahead of it: f = 0, and the same for the
/// instantaneous modulus, at β/(1+f).
#[test]
fn a_film_longer_than_its_grid_is_a_failure_that_says_so() {
    let cases = [(f64::INFINITY, 0.01, 0.0), (f64::INFINITY, 1e-3, 0.0), (0.01, 10.0, 1000.0), (0.1, 10.0, 1000.0)];
    for (alpha, beta, f) in cases {
        for points in [201, 401, 801] {
            let case = Parameters::new(alpha, beta, f);
            let solved = outcomes(settings(points), std::slice::from_ref(&case), &no_fields()).remove(0);
            let reason = solved.outcome.unwrap_err().reason;
            assert!(reason.contains("longer than the grid") && reason.contains("wider domain"), "{case:?}: {reason}");
        }
    }
}

/// What fails in the middle of a chain does not take the others along.
#[test]
fn a_failure_does_not_stop_the_chain() {
    let cases = [1e2, 1e9, 2e2].map(Parameters::elastic);
    let solved = outcomes(settings(101), &cases, &no_fields());
    assert!(solved[0].outcome.is_ok() && solved[1].outcome.is_err() && solved[2].outcome.is_ok());
}

/// Far outside of the paper's range.
#[test]
fn extreme_parameters_end_soon() {
    let mut most = 0;
    for f in [0.0, 1.0, 1e6] {
        for alpha in [0.0, 1e-8, 1.0, 1e8] {
            for beta in [1e-4, 1.0, 1e10] {
                if f == 0.0 && alpha != 1.0 {
                    continue;
                }
                let parameters = Parameters::new(alpha, beta, f);
                let begin = Instant::now();
                let solved = outcomes(settings(201), std::slice::from_ref(&parameters), &no_fields()).remove(0);
                println!(
                    "f {f:e}, alpha {alpha:e}, beta {beta:e}: {:.2?}, {} passes, {:?}",
                    begin.elapsed(),
                    solved.effort.iterations,
                    solved.outcome.as_ref().map(|solution| solution.quantities.c).map_err(|failure| &failure.reason)
                );
                most = most.max(solved.effort.iterations);
                is_sane(&parameters, &solved);
            }
        }
    }
    // some seconds, on any machine of today
    assert!(most < 2_000_000, "{most} passes");
}
