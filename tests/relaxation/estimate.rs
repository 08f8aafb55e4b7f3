//! Richardson's estimate against the true error.

use stribeck::relaxation::Settings;

use crate::cases::{no_fields, reference, settings, solutions};

/// Within a factor of three where the film is resolved. F_v of the elastic cases is zero: there is nothing to compare.
#[test]
fn the_estimate_is_the_error_within_a_factor_of_three() {
    let wanted = [
        (1.0, 1.0, 1000.0),
        (10.0, 1.0, 100.0),
        (10.0, 1.0, 1000.0),
        (100.0, 10.0, 1000.0),
        (0.0, f64::INFINITY, 1000.0),
    ];
    for row in reference() {
        let parameters = &row.parameters;
        if !wanted.contains(&(parameters.f, parameters.alpha, parameters.beta)) {
            continue;
        }
        let with_estimate = Settings { estimate: true, ..settings(801) };
        let solution = solutions(with_estimate, std::slice::from_ref(parameters), &no_fields()).remove(0);
        let (found, errors) = (solution.quantities, solution.errors);
        let mut compared = vec![
            ("mu_h", errors.mu_h, found.friction.hydrodynamic(), row.hydrodynamic()),
            ("c", errors.c, found.c, row.c),
        ];
        if row.viscoelastic > 0.0 {
            compared.push(("mu_v", errors.mu_v, found.friction.viscoelastic, row.viscoelastic));
        } else {
            assert!(errors.mu_v < 1e-2, "{parameters:?}: estimate {:.1e} of an F_v that is zero", errors.mu_v);
        }
        for (name, estimate, value, exact) in compared {
            let error = (value / exact - 1.0).abs();
            assert!(
                error / 3.0 < estimate && estimate < 3.0 * error,
                "{parameters:?}: {name}: {estimate:.1e} for {error:.1e}"
            );
        }
    }
}

/// No estimate unless asked for, and none where there is no second grid.
#[test]
fn an_estimate_needs_a_second_grid() {
    let case = [stribeck::model::Parameters::new(1.0, 10.0, 1.0)];
    let without = solutions(settings(201), &case, &no_fields()).remove(0);
    assert!(without.errors.c.is_nan() && without.errors.mu_v.is_nan() && without.errors.mu_h.is_nan());
    let too_few = Settings { estimate: true, ..settings(151) };
    let reason = crate::cases::outcomes(too_few, &case, &no_fields()).remove(0).outcome.unwrap_err().reason;
    assert!(reason.contains("no error estimate") && reason.contains("201"), "{reason}");
}
