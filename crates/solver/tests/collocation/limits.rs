//! Limits with known answers.

use stribeck_solver::exact::{DryContact, DrySliding, RigidFilm};
use stribeck_solver::{CavityShear, Parameters};

use crate::collocation::cases::{difference, numbers, quantities, relative, settings, solutions, with_modes};

/// Cases of one substrate at powers of ten of β.
fn decades(alpha: f64, f: f64, exponents: impl Iterator<Item = i32>) -> Vec<Parameters> {
    exponents.map(|exponent| Parameters::new(alpha, 10_f64.powi(exponent), f)).collect()
}

/// What is left of the way to a limit, step by step: each less than `part` of the one before.
fn approaches(what: &str, distances: &[f64], part: f64) {
    for pair in distances.windows(2) {
        assert!(pair[1] < part * pair[0], "{what}: {distances:?}");
    }
}

/// c β^{3/5} → 0.4458 and u_min/c → 0.796, each decade closer by the same factor.
#[test]
fn thin_elastic_films_scale_with_beta() {
    let cases = decades(f64::INFINITY, 0.0, 3..=8);
    let solved = solutions(settings(1e-6), &cases, &numbers());
    let flow: Vec<f64> =
        solved.iter().zip(&cases).map(|(solved, case)| solved.quantities.c * case.beta.powf(0.6)).collect();
    let film: Vec<f64> = solved.iter().map(|solved| solved.quantities.film_min / solved.quantities.c).collect();
    assert!((flow[5] - 0.4458).abs() < 2e-4 && (film[5] - 0.796).abs() < 1e-3, "{flow:?} {film:?}");
    let steps = |values: &[f64]| values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect::<Vec<_>>();
    approaches("c β^{3/5}", &steps(&flow), 0.6);
    approaches("u_min/c", &steps(&film), 0.6);
}

/// The rigid film: what the substrate yields is of the order of its displacement over the film, β.
#[test]
fn thick_films_are_those_of_a_rigid_cylinder_on_a_rigid_plane() {
    for (alpha, f) in [(f64::INFINITY, 0.0), (1.0, 10.0), (10.0, 100.0), (0.0, 1.0)] {
        let distances: Vec<[f64; 5]> = [1e-2, 1e-3, 1e-4]
            .map(|beta| {
                let found = quantities(1e-8, &Parameters::new(alpha, beta, f));
                let rigid = RigidFilm::new(beta);
                let friction = rigid.friction(CavityShear::Full);
                [
                    relative(found.c, rigid.c()),
                    relative(found.x_outlet, rigid.outlet()),
                    relative(found.p_max, rigid.max_pressure()),
                    relative(found.friction.hydrodynamic(), friction.hydrodynamic()),
                    relative(found.friction.drag, friction.drag),
                ]
            })
            .to_vec();
        for i in 0..5 {
            let distances: Vec<f64> = distances.iter().map(|at| at[i]).collect();
            assert!(distances[2] < 1e-3, "α = {alpha}, f = {f}, {i}: {distances:?}");
            approaches("rigid", &distances, 0.2);
        }
    }
}

/// α → 0 at f: the substrate with its instantaneous modulus. The difference is proportional to α (ln α).
#[test]
fn frozen_substrates_are_elastic() {
    for (f, beta) in [(1.0, 10.0), (100.0, 1e3), (1e4, 1e5)] {
        let frozen = quantities(1e-9, &Parameters::new(0.0, beta, f));
        let distances =
            [1e-5, 1e-6, 1e-7].map(|alpha| difference(&quantities(1e-9, &Parameters::new(alpha, beta, f)), &frozen));
        assert!(distances[2] < 1e-3, "f = {f}, β = {beta}: {distances:?}");
        approaches("α → 0", &distances, 0.2);
    }
}

/// α → ∞: the relaxed modulus. The difference is proportional to 1/α.
#[test]
fn relaxed_substrates_are_elastic() {
    for (f, beta) in [(1.0, 10.0), (100.0, 1e2), (1e4, 1e3)] {
        let relaxed = quantities(1e-7, &Parameters::elastic(beta));
        let at_infinity = difference(&quantities(1e-7, &Parameters::new(f64::INFINITY, beta, f)), &relaxed);
        assert!(at_infinity < 1e-6, "f = {f}, β = {beta}: {at_infinity:.1e}");
        let distances =
            [1e2, 1e3, 1e4].map(|alpha| difference(&quantities(1e-7, &Parameters::new(alpha, beta, f)), &relaxed));
        assert!(distances[2] < 5e-3, "f = {f}, β = {beta}: {distances:?}");
        approaches("α → ∞", &distances, 0.2);
    }
}

/// β → ∞: F_v of dry sliding, and F_h → 0. The difference falls with the film's thickness.
#[test]
fn thin_films_have_the_friction_of_dry_sliding() {
    for (alpha, f) in [(0.01, 10.0), (1.0, 1.0), (1.0, 100.0), (10.0, 100.0), (100.0, 1e3)] {
        let dry = DryContact::new(alpha, f);
        let cases = decades(alpha, f, 4..=8);
        let solved = solutions(settings(1e-7), &cases, &numbers());
        let distances: Vec<f64> =
            solved.iter().map(|solved| relative(solved.quantities.friction.viscoelastic, dry.friction())).collect();
        let shear: Vec<f64> = solved.iter().map(|solved| solved.quantities.friction.hydrodynamic()).collect();
        let edges: Vec<f64> =
            solved.iter().map(|solved| (solved.quantities.x_outlet - dry.trailing_edge()).abs()).collect();
        assert!(distances[4] < 1e-3, "α = {alpha}, f = {f}: {distances:?}");
        approaches("F_v", &distances, 0.6);
        approaches("F_h", &shear, 1.0);
        approaches("x_out", &edges, 0.6);
    }
}

/// The same with several retardation times, and where the contact ends.
#[test]
fn thin_films_on_several_modes_have_the_friction_of_dry_sliding() {
    for (alpha, f, modes) in [
        (1.0, 10.0, &[(0.5, 1.0), (0.5, 10.0)][..]),
        (0.3, 100.0, &[(0.9, 10.0), (0.1, 0.1)]),
        (1.0, 100.0, &[(0.3, 0.03), (0.3, 1.0), (0.4, 30.0)]),
    ] {
        let dry = DrySliding::of(&with_modes(alpha, 1.0, f, modes));
        let cases: Vec<Parameters> = (5..=8).map(|i| with_modes(alpha, 10_f64.powi(i), f, modes)).collect();
        let solved = solutions(settings(1e-7), &cases, &numbers());
        let friction = solved.iter().map(|solved| relative(solved.quantities.friction.viscoelastic, dry.friction()));
        let edges = solved.iter().map(|solved| (solved.quantities.x_outlet - dry.trailing_edge()).abs());
        let (friction, edges): (Vec<f64>, Vec<f64>) = (friction.collect(), edges.collect());
        assert!(friction[3] < 1e-3 && edges[3] < 1e-2 * dry.half_width(), "{modes:?}: {friction:?} {edges:?}");
        approaches("F_v", &friction, 0.6);
        approaches("x_out", &edges, 0.6);
    }
}
