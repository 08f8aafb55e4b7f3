//! Laws on random cases, the same ones each time.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use stribeck_solver::Parameters;
use stribeck_solver::collocation::Settings;

use crate::collocation::cases::{numbers, quantities, settings, solution, with_modes};
use crate::collocation::measure::{true_error, worst};

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

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, rng_seed: RngSeed::Fixed(2022), ..ProptestConfig::default() })]

    /// Every case has a solution with the wanted accuracy that obeys what any solution obeys.
    #[test]
    fn every_case_is_solved_and_sane(case in cases(), exponent in -6.0..-2.0) {
        let tolerance = 10_f64.powf(exponent);
        let solution = solution(settings(tolerance), &case, &numbers());
        let quantities = &solution.quantities;
        prop_assert!(worst(&solution.errors) <= tolerance, "{:?}", solution.errors);
        prop_assert!(quantities.load_residual <= 1e-10, "{quantities:?}");
        // the film is thinnest near the outlet, thinner than where the pressure is largest, which is ahead of the outlet
        prop_assert!(0.0 < quantities.film_min && quantities.film_min < quantities.c, "{quantities:?}");
        prop_assert!(quantities.x_outlet < quantities.x_p_max, "{quantities:?}");
        // a creeping substrate takes energy and gives none, and so does a film
        let friction = &quantities.friction;
        let slack = tolerance * friction.total();
        prop_assert!(friction.viscoelastic >= -slack && friction.hydrodynamic_cavity > 0.0, "{friction:?}");
        prop_assert!(friction.drag >= friction.viscoelastic - slack, "{friction:?}");
        prop_assert!((friction.drag - friction.hydrodynamic() - quantities.centroid).abs() <= 1e-14 * friction.drag);
        if case.f == 0.0 {
            prop_assert_eq!(friction.viscoelastic, 0.0);
        }
    }

    /// With panels of a higher degree and a twentieth of the tolerance nothing moves by more than three times the tolerance.
    #[test]
    fn the_tolerance_is_kept(case in cases(), exponent in -6.0..-2.0) {
        let tolerance = 10_f64.powf(exponent);
        let fine = Settings { tolerance: 0.05 * tolerance, degree: 12 };
        let fine = solution(fine, &case, &numbers()).quantities;
        let error = true_error(&quantities(tolerance, &case), &fine);
        prop_assert!(error <= 3.0 * tolerance, "off by {error:.1e} with a tolerance of {tolerance:.1e}");
    }
}
