//! Laws on random cases: the same ones each time, and in slow tests other ones each time.

use proptest::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::collocation::Settings;

use crate::collocation::cases::{numbers, settings, solution, with_modes};
use crate::collocation::measure::{true_error, worst};
use crate::property::with_seed;

/// α, β and f in the box, with one to three modes up to four decades apart.
fn cases() -> impl Strategy<Value = Parameters> {
    let strength = prop_oneof![1 => Just(0.0), 9 => (-2.0..4.0).prop_map(|exponent: f64| 10_f64.powf(exponent))];
    let mode = (0.05..1.0, -2.0..2.0);
    (-4.0..4.0, -2.0..8.0, strength, proptest::collection::vec(mode, 1..=3)).prop_map(
        |(alpha, beta, f, modes): (f64, f64, f64, Vec<(f64, f64)>)| {
            let sum: f64 = modes.iter().map(|mode| mode.0).sum();
            let modes: Vec<(f64, f64)> = modes.iter().map(|(share, time)| (share / sum, 10_f64.powf(*time))).collect();
            with_modes(10_f64.powf(alpha), 10_f64.powf(beta), f, &modes)
        },
    )
}

/// A case has a solution with the wanted accuracy that obeys what any solution obeys. With panels of a higher degree
/// and a twentieth of the tolerance nothing moves by more than three times the tolerance.
fn is_solved_sane_and_accurate(case: &Parameters, tolerance: f64) -> Result<(), TestCaseError> {
    let found = solution(settings(tolerance), case, &numbers());
    let quantities = &found.quantities;
    prop_assert!(worst(&found.errors) <= tolerance, "{:?}", found.errors);
    prop_assert!(quantities.load_residual <= 1e-10, "{quantities:?}");
    // The film is thinnest near the outlet, thinner than where the pressure is largest, which is ahead of the outlet.
    prop_assert!(0.0 < quantities.film_min && quantities.film_min < quantities.c, "{quantities:?}");
    prop_assert!(quantities.x_outlet < quantities.x_p_max, "{quantities:?}");
    // A creeping substrate takes energy and gives none, and so does a film.
    let friction = &quantities.friction;
    let slack = tolerance * friction.total();
    prop_assert!(friction.viscoelastic >= -slack && friction.hydrodynamic_cavity > 0.0, "{friction:?}");
    prop_assert!(friction.drag >= friction.viscoelastic - slack, "{friction:?}");
    prop_assert!((friction.drag - friction.hydrodynamic() - quantities.centroid).abs() <= 1e-14 * friction.drag);
    if case.f == 0.0 {
        prop_assert_eq!(friction.viscoelastic, 0.0);
    }
    let fine = Settings { tolerance: 0.05 * tolerance, degree: 12 };
    let fine = solution(fine, case, &numbers()).quantities;
    let error = true_error(quantities, &fine);
    prop_assert!(error <= 3.0 * tolerance, "off by {error:.1e} with a tolerance of {tolerance:.1e}");
    Ok(())
}

proptest! {
    #![proptest_config(with_seed(200, 2022))]

    #[test]
    fn every_case_is_solved_sane_and_accurate(case in cases(), exponent in -6.0..-2.0) {
        is_solved_sane_and_accurate(&case, 10_f64.powf(exponent))?;
    }
}

mod with_a_fresh_seed {
    use super::*;
    use crate::property::with_fresh_seed;

    proptest! {
        #![proptest_config(with_fresh_seed(400))]

        #[test]
        #[ignore = "slow: a fresh seed"]
        fn every_case_is_solved_sane_and_accurate(case in cases(), exponent in -6.0..-2.0) {
            is_solved_sane_and_accurate(&case, 10_f64.powf(exponent))?;
        }
    }
}
