//! What must not change the numbers.

use stribeck_solver::relaxation::{Acceleration, Domain, Settings};
use stribeck_solver::{Parameters, Quantities};

use crate::relaxation::cases::{
    chain, fields_at, grid, no_fields, outcomes, quantities, relative, settings, solutions, uniform,
};

/// Largest relative difference of the numbers of two solutions.
fn difference(a: &Quantities, b: &Quantities) -> f64 {
    let numbers = |quantities: &Quantities| {
        let friction = &quantities.friction;
        let film = [quantities.c, quantities.film_min, quantities.p_max, quantities.x_outlet, quantities.centroid];
        (film, [friction.viscoelastic, friction.hydrodynamic_film, friction.hydrodynamic_cavity, friction.drag])
    };
    let ((film_a, forces_a), (film_b, forces_b)) = (numbers(a), numbers(b));
    let total = a.friction.total();
    let film = film_a.iter().zip(film_b).map(|(a, b)| relative(*a, b));
    let forces = forces_a.iter().zip(forces_b).map(|(a, b)| (a - b).abs() / total);
    film.chain(forces).fold(0.0, f64::max)
}

const CASES: [(f64, f64, f64); 4] = [(1.0, 10.0, 0.0), (1.0, 100.0, 1.0), (10.0, 100.0, 10.0), (1.0, 100.0, 100.0)];

/// Where the grid ends does not matter: the inlet and the cavity are integrated to infinity.
#[test]
fn the_domain_does_not_matter() {
    for (alpha, beta, f) in CASES {
        let parameters = Parameters::new(alpha, beta, f);
        let auto = quantities(settings(801), &parameters);
        let ends = grid(&parameters, 2);
        let width = ends[1] - ends[0];
        // the same step on a quarter more
        let domain = Domain::Fixed { x_min: ends[0] - 0.1 * width, x_max: ends[1] + 0.15 * width };
        let wide = quantities(Settings { domain, ..settings(1001) }, &parameters);
        let change = difference(&auto, &wide);
        assert!(change < 2e-3, "{parameters:?}: {change:.1e}");
        assert!(
            relative(auto.c, wide.c) < 2e-4 && relative(auto.friction.drag, wide.friction.drag) < 5e-4,
            "{parameters:?}"
        );
    }
}

/// Nor for a film much thicker than the contact is wide, on a domain ten times as long.
#[test]
fn a_thick_film_does_not_feel_the_domain() {
    for beta in [0.03, 0.1, 0.3] {
        let parameters = Parameters::elastic(beta);
        let long = Settings { domain: Domain::Fixed { x_min: -30.0, x_max: 40.0 }, ..settings(801) };
        let (auto, long) = (quantities(settings(801), &parameters), quantities(long, &parameters));
        let (c, drag) = (relative(auto.c, long.c), relative(auto.friction.drag, long.friction.drag));
        println!("β = {beta}: c {c:.1e}, drag {drag:.1e}, x_outlet {:.2}", auto.x_outlet);
        assert!(c < 5e-4 && drag < 5e-4, "β = {beta}: c {c:.1e}, drag {drag:.1e}");
    }
}

/// A case alone, at the end of a chain, and at the end of a finer one.
#[test]
fn the_seed_does_not_matter() {
    for (alpha, beta, f) in CASES {
        let alone = solutions(settings(401), &chain(alpha, f, &[beta]), &no_fields()).pop().unwrap();
        for betas in [vec![0.5 * beta, beta], vec![0.3 * beta, 0.5 * beta, 0.7 * beta, 0.85 * beta, beta]] {
            let last = solutions(settings(401), &chain(alpha, f, &betas), &no_fields()).pop().unwrap();
            let change = difference(&alone.quantities, &last.quantities);
            assert!(change < 1e-6, "α = {alpha}, f = {f}, {betas:?}: {change:.1e}");
        }
    }
}

/// The chain says where each case came from.
#[test]
fn seeds_are_recorded() {
    let names = |alpha: f64, f: f64| -> Vec<String> {
        let solved = outcomes(settings(201), &chain(alpha, f, &[10.0, 20.0, 40.0]), &no_fields());
        solved.iter().map(|case| case.seed.to_string()).collect()
    };
    assert_eq!(names(1.0, 0.0), ["hertz", "neighbour", "predictor"]);
    assert_eq!(names(10.0, 1.0), ["elastic", "neighbour", "predictor"]);
}

/// Acceleration changes the way, not the end.
#[test]
fn plain_and_accelerated_iteration_agree() {
    for (alpha, beta, f) in [(1.0, 10.0, 0.0), (10.0, 30.0, 10.0)] {
        let of =
            |acceleration| quantities(Settings { acceleration, ..settings(201) }, &Parameters::new(alpha, beta, f));
        let change = difference(&of(Acceleration::None), &of(Acceleration::Anderson));
        assert!(change < 1e-5, "α = {alpha}, β = {beta}, f = {f}: {change:.1e}");
    }
}

/// The same case solved twice gives the same bits.
#[test]
fn solving_again_gives_the_same_bits() {
    let cases = chain(1.0, 10.0, &[10.0, 30.0, 100.0]);
    let output = fields_at(uniform(-4.0, 4.0, 81));
    let [first, second] = [(); 2].map(|()| solutions(settings(201), &cases, &output));
    for (first, second) in first.iter().zip(&second) {
        assert_eq!(first.quantities, second.quantities);
        assert_eq!(first.fields, second.fields);
    }
}

/// Displacement beyond the grid is that which a wider grid has there.
#[test]
fn fields_beyond_the_grid_are_those_of_a_wider_one() {
    for (alpha, f) in [(1.0, 0.0), (1.0, 10.0), (10.0, 1.0)] {
        let case = [Parameters::new(alpha, 30.0, f)];
        let ends = grid(&case[0], 2);
        let domain = Domain::Fixed { x_min: ends[0] - 3.5, x_max: ends[1] + 3.5 };
        let step = (ends[1] - ends[0]) / 400.0;
        let points = ((ends[1] - ends[0] + 7.0) / step) as usize + 1;
        let x = uniform(ends[0] - 3.0, ends[1] + 3.0, 301);
        let narrow = solutions(settings(401), &case, &fields_at(x.clone())).remove(0).fields;
        let wide = solutions(Settings { domain, ..settings(points) }, &case, &fields_at(x.clone())).remove(0).fields;
        let (narrow_film, wide_film) = (narrow.film_thickness.unwrap(), wide.film_thickness.unwrap());
        let (narrow_w, wide_w) = (narrow.displacement.unwrap(), wide.displacement.unwrap());
        let (narrow_p, wide_p) = (narrow.pressure.unwrap(), wide.pressure.unwrap());
        for i in 0..x.len() {
            assert!((narrow_w[i] - wide_w[i]).abs() < 1e-3, "f = {f}, x = {}: {} and {}", x[i], narrow_w[i], wide_w[i]);
            assert!((narrow_film[i] - wide_film[i]).abs() < 1e-3, "f = {f}, x = {}", x[i]);
            assert!((narrow_p[i] - wide_p[i]).abs() < 5e-3, "f = {f}, x = {}: {} and {}", x[i], narrow_p[i], wide_p[i]);
        }
    }
}
