//! Different parameters that are the same problem.

use stribeck_solver::{Parameters, Quantities};

use crate::collocation::cases::{difference, numbers, quantities, settings, solution, with_modes};
use crate::collocation::measure::worst;

/// At α = 0 the solution is the elastic one at β/(1+f): lengths along x times a = 1/√(1+f), films times a², p over a,
/// and with them forces times a.
#[test]
fn strength_rescales_the_frozen_substrate() {
    for (f, beta) in [(1.0_f64, 10.0), (100.0, 1e3), (1e4, 1e5)] {
        let frozen = quantities(1e-9, &Parameters::new(0.0, beta, f));
        let elastic = quantities(1e-9, &Parameters::elastic(beta / (1.0 + f)));
        let a = (1.0 + f).powf(-0.5);
        let mut scaled: Quantities = elastic;
        scaled.c *= a * a;
        scaled.film_min *= a * a;
        scaled.p_max /= a;
        scaled.x_p_max *= a;
        scaled.x_outlet *= a;
        for force in [
            &mut scaled.friction.hydrodynamic_film,
            &mut scaled.friction.hydrodynamic_cavity,
            &mut scaled.friction.drag,
            &mut scaled.centroid,
        ] {
            *force *= a;
        }
        let error = difference(&frozen, &scaled);
        assert!(error < 1e-8, "f = {f}, β = {beta}: {error:.1e}");
    }
}

/// Only α over the time of a mode counts.
#[test]
fn times_are_relative_to_alpha() {
    for factor in [1e-3, 7.0, 1e4] {
        let one = quantities(1e-6, &Parameters::new(2.0, 100.0, 10.0));
        let other = quantities(1e-6, &with_modes(2.0 * factor, 100.0, 10.0, &[(1.0, factor)]));
        let error = difference(&one, &other);
        assert!(error < 1e-12, "{factor}: {error:.1e}");
    }
}

/// Without retardation α and the modes mean nothing.
#[test]
fn an_elastic_substrate_has_no_times() {
    let elastic = quantities(1e-6, &Parameters::elastic(100.0));
    for alpha in [0.0, 1e-4, 1.0, 1e4] {
        assert_eq!(elastic, quantities(1e-6, &Parameters::new(alpha, 100.0, 0.0)));
        assert_eq!(elastic, quantities(1e-6, &with_modes(alpha, 100.0, 0.0, &[(0.5, 1.0), (0.5, 100.0)])));
    }
    for f in [1.0, 100.0, 1e4] {
        assert_eq!(elastic, quantities(1e-6, &Parameters::new(f64::INFINITY, 100.0, f)));
    }
}

/// One mode and its two parts are the same material, to 1e-12.
#[test]
fn a_mode_split_in_two_changes_nothing() {
    for (alpha, beta, f) in [(0.01, 10.0, 100.0), (1.0, 100.0, 10.0), (10.0, 1e3, 100.0), (100.0, 1.0, 1.0)] {
        let one = quantities(1e-6, &Parameters::new(alpha, beta, f));
        for shares in [[0.5, 0.5], [0.3, 0.7]] {
            let two = quantities(1e-6, &with_modes(alpha, beta, f, &[(shares[0], 1.0), (shares[1], 1.0)]));
            let error = difference(&two, &one);
            assert!(error < 1e-12, "α = {alpha}, β = {beta}, f = {f}: {error:.1e}");
        }
    }
}

/// Modes do not have an order.
#[test]
fn modes_may_be_listed_in_any_order() {
    let one = quantities(1e-6, &with_modes(1.0, 100.0, 10.0, &[(0.2, 0.1), (0.3, 1.0), (0.5, 30.0)]));
    let other = quantities(1e-6, &with_modes(1.0, 100.0, 10.0, &[(0.5, 30.0), (0.2, 0.1), (0.3, 1.0)]));
    let error = difference(&one, &other);
    assert!(error < 1e-12, "{error:.1e}");
}

/// Two modes six decades apart: the quick one has relaxed and the slow one has not begun, so that the substrate is
/// elastic, with a modulus between. Neither leaves a trace but its modulus, up to the ratio of its time to that of the
/// contact.
#[test]
fn modes_six_decades_apart_are_solved() {
    for beta in [1.0, 100.0, 1e4] {
        // f = 3, half of it slow: compliance (1 + 1.5)/4 of the relaxed one
        let case = with_modes(1.0, beta, 3.0, &[(0.5, 1e-3), (0.5, 1e3)]);
        let both = solution(settings(1e-7), &case, &numbers());
        assert!(worst(&both.errors) <= 1e-7 && both.quantities.load_residual < 1e-10);
        // that of α = 0 with 1/(1+f) = 2.5/4
        let between = quantities(1e-7, &Parameters::new(0.0, beta, 0.6));
        let far = difference(&both.quantities, &between);
        let nearer = with_modes(1.0, beta, 3.0, &[(0.5, 1e-4), (0.5, 1e4)]);
        let near = difference(&quantities(1e-7, &nearer), &between);
        assert!(near < 0.03 && near < 0.2 * far, "β = {beta}: {far:.1e}, then {near:.1e}");
    }
}

/// A mode whose share vanishes does not count, whatever its time.
#[test]
fn a_mode_without_a_share_does_not_count() {
    for time in [1e-3, 0.05, 30.0] {
        let one = quantities(1e-9, &Parameters::new(1.0, 100.0, 10.0));
        let distances = [1e-2, 1e-4, 1e-6].map(|share| {
            difference(&quantities(1e-9, &with_modes(1.0, 100.0, 10.0, &[(1.0 - share, 1.0), (share, time)])), &one)
        });
        for (distance, share) in distances.iter().zip([1e-2, 1e-4, 1e-6]) {
            assert!(*distance < 20.0 * share, "time {time}: {distances:?}");
        }
    }
}
