//! Richardson's estimate against the true error.

use stribeck_solver::Parameters;
use stribeck_solver::relaxation::Settings;

use crate::relaxation::cases::{chain, no_fields, reference, settings, solutions};

/// Within a factor of three where the film is resolved. F_v of the elastic cases is zero: there is nothing to compare.
#[test]
fn the_estimate_is_the_error_within_a_factor_of_three() {
    for (alpha, f) in [(f64::INFINITY, 0.0), (1.0, 1.0), (1.0, 10.0), (10.0, 100.0)] {
        let betas = [100.0, 1000.0];
        let rows = reference().into_iter().filter(|row| {
            (row.parameters.alpha, row.parameters.f) == (alpha, f) && betas.contains(&row.parameters.beta)
        });
        let with_estimate = Settings { estimate: true, ..settings(801) };
        for (row, solution) in rows.zip(solutions(with_estimate, &chain(alpha, f, &betas), &no_fields())) {
            let (found, errors, case) = (solution.quantities, solution.errors, &row.parameters);
            let mut compared = vec![
                ("mu_h", errors.mu_h, found.friction.hydrodynamic(), row.hydrodynamic()),
                ("c", errors.c, found.c, row.c),
            ];
            if row.viscoelastic > 0.0 {
                compared.push(("mu_v", errors.mu_v, found.friction.viscoelastic, row.viscoelastic));
            } else {
                assert!(errors.mu_v < 1e-3, "{case:?}: estimate {:.1e} of an F_v that is zero", errors.mu_v);
            }
            for (name, estimate, value, exact) in compared {
                let error = (value / exact - 1.0).abs();
                let within = error / 3.0 < estimate && estimate < 3.0 * error;
                assert!(within, "{case:?}: {name}: {estimate:.1e} for {error:.1e}");
            }
        }
    }
}

/// The thinnest film of f = 1, alone: nothing to start from but the elastic solution, and a second grid to solve.
#[test]
fn a_thin_film_alone_has_an_estimate() {
    let case = chain(1.0, 1.0, &[1000.0]);
    let row = reference().into_iter().find(|row| row.parameters == case[0]).expect("the reference has it");
    let solution = solutions(Settings { estimate: true, ..settings(801) }, &case, &no_fields()).remove(0);
    let error = (solution.quantities.c / row.c - 1.0).abs();
    let estimate = solution.errors.c;
    assert!(error / 3.0 < estimate && estimate < 3.0 * error, "{estimate:.1e} for {error:.1e}");
}

/// No estimate unless asked for, and none, but a solution, where there is no second grid or it does not resolve the
/// film.
#[test]
fn an_estimate_needs_a_second_grid() {
    let case = [Parameters::new(1.0, 10.0, 1.0)];
    let without = solutions(settings(201), &case, &no_fields()).remove(0);
    assert!(without.errors.c.is_nan() && without.errors.mu_v.is_nan() && without.errors.mu_h.is_nan());
    let too_few = solutions(Settings { estimate: true, ..settings(151) }, &case, &no_fields()).remove(0);
    assert!(too_few.errors.c.is_nan());
    let thin = chain(1.0, 100.0, &[100.0, 300.0, 1000.0]);
    let coarse = Settings { estimate: true, ..settings(401) };
    let errors: Vec<f64> = solutions(coarse, &thin, &no_fields()).iter().map(|solution| solution.errors.c).collect();
    assert!(errors[0] > 0.0 && errors[2].is_nan(), "{errors:?}: 201 points resolve β = 100, not 1000");
}

/// The estimate changes nothing but the estimate.
#[test]
fn an_estimate_leaves_the_solution_alone() {
    let cases = chain(10.0, 10.0, &[20.0, 50.0]);
    let without = solutions(settings(201), &cases, &no_fields());
    let with = solutions(Settings { estimate: true, ..settings(201) }, &cases, &no_fields());
    for (without, with) in without.iter().zip(&with) {
        assert_eq!(without.quantities, with.quantities);
    }
}
