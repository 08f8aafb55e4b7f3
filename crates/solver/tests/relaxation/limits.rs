//! Limits with known answers.

use stribeck_solver::continuation::Solution;
use stribeck_solver::exact::{DryContact, HertzContact};
use stribeck_solver::{Parameters, Quantities};

use crate::relaxation::cases::{
    ON_801, Solved, chain, fields_at, no_fields, on_any_grid, relative, settings, solutions, uniform,
};

fn assert_same(found: &Quantities, expected: &Quantities, tolerance: f64, what: &str) {
    let pairs = [
        ("c", found.c, expected.c),
        ("film_min", found.film_min, expected.film_min),
        ("p_max", found.p_max, expected.p_max),
        ("x_outlet", found.x_outlet, expected.x_outlet),
        ("mu_h_film", found.friction.hydrodynamic_film, expected.friction.hydrodynamic_film),
        ("mu_h_cavity", found.friction.hydrodynamic_cavity, expected.friction.hydrodynamic_cavity),
        ("mu_drag", found.friction.drag, expected.friction.drag),
    ];
    for (name, found, expected) in pairs {
        assert!(relative(found, expected) < tolerance, "{what}: {name} {found} instead of {expected}");
    }
}

/// α → ∞: the relaxed elastic substrate, whatever f.
#[test]
fn slow_sliding_is_relaxed_elastic() {
    let betas = [10.0, 100.0];
    let elastic = solutions(settings(401), &chain(1.0, 0.0, &betas), &no_fields());
    for f in [1.0, 100.0] {
        for (alpha, tolerance) in [(1e6, 5e-5), (f64::INFINITY, 1e-12)] {
            let slow = solutions(settings(401), &chain(alpha, f, &betas), &no_fields());
            for (slow, elastic) in slow.iter().zip(&elastic) {
                let what = format!("f = {f}, α = {alpha}");
                assert_same(&slow.quantities, &elastic.quantities, tolerance, &what);
                assert!(slow.quantities.friction.viscoelastic.abs() < 1e-5, "{what}");
            }
        }
    }
}

/// α = 0: the elastic solution at β/(1+f), lengths over √(1+f), films over 1+f, pressures times √(1+f).
fn without_creep_is_rescaled(f: f64) {
    let (stiffening, beta) = (1.0 + f, 20.0);
    let root = f64::sqrt(stiffening);
    let fast = solutions(settings(401), &[Parameters::new(0.0, beta * stiffening, f)], &no_fields()).remove(0);
    let mut expected = solutions(settings(401), &[Parameters::elastic(beta)], &no_fields()).remove(0).quantities;
    expected.c /= stiffening;
    expected.film_min /= stiffening;
    expected.p_max *= root;
    expected.x_outlet /= root;
    // forces over N a₀/R scale as the lengths
    expected.friction.hydrodynamic_film /= root;
    expected.friction.hydrodynamic_cavity /= root;
    expected.friction.drag /= root;
    assert_same(&fast.quantities, &expected, 1e-6, &format!("f = {f}"));
}

#[test]
fn sliding_without_time_to_creep_is_rescaled_elastic() {
    for f in [1.0, 10.0, 100.0] {
        without_creep_is_rescaled(f);
    }
}

/// The less time to creep, the nearer; F_v falls as α ln α.
#[test]
fn fast_sliding_approaches_the_rescaled_elastic_film() {
    let mut last = f64::INFINITY;
    let limit = solutions(settings(401), &chain(0.0, 1.0, &[10.0]), &no_fields()).remove(0).quantities;
    for alpha in [0.3, 0.1, 0.03, 0.01, 1e-3, 1e-6] {
        let fast = solutions(settings(401), &chain(alpha, 1.0, &[10.0]), &no_fields()).remove(0).quantities;
        let distance = relative(fast.friction.drag, limit.friction.drag);
        assert!(distance < 0.7 * last && distance < 1.5 * alpha * (1.0 / alpha).ln(), "α = {alpha}: {distance:.1e}");
        assert!(relative(fast.c, limit.c) < 2.0 * alpha && relative(fast.p_max, limit.p_max) < 2.0 * alpha);
        last = distance;
    }
}

/// f → 0: the elastic solution, and F_v in proportion to f.
#[test]
fn little_creep_is_little_friction() {
    let elastic = solutions(settings(401), &[Parameters::elastic(30.0)], &no_fields()).remove(0).quantities;
    let mut friction = Vec::new();
    for f in [1e-2, 1e-4] {
        let little = solutions(settings(401), &[Parameters::new(1.0, 30.0, f)], &no_fields()).remove(0).quantities;
        assert_same(&little, &elastic, 2.0 * f, &format!("f = {f}"));
        friction.push((little.friction.viscoelastic - elastic.friction.viscoelastic) / f);
    }
    assert!(relative(friction[0], friction[1]) < 2e-2, "{friction:?}");
}

/// F_v = 0 on an elastic substrate. On the grid the kernel is even and the sum vanishes to rounding; what is left is
/// how far the tail ahead of the grid, of the size 2/(3βX²), is from its own displacement.
#[test]
fn an_elastic_substrate_has_no_friction() {
    for case in on_any_grid().filter(|case| case.reference.parameters.f == 0.0) {
        let (beta, end) = (case.reference.parameters.beta, case.x[case.x.len() - 1]);
        let tail = 2.0 / (3.0 * beta * end * end);
        let friction = case.quantities().friction;
        assert!(friction.viscoelastic.abs() < 1e-3 * tail, "β = {beta}: {:.1e}", friction.viscoelastic);
        assert!(friction.viscoelastic.abs() < 2e-6 * friction.total(), "β = {beta}: {:.1e}", friction.viscoelastic);
    }
}

/// The film takes part of the friction of dry sliding away, less and less of it as β grows.
#[test]
fn friction_approaches_dry_sliding_from_below() {
    for (alpha, f) in [(1.0, 1.0), (1.0, 10.0), (1.0, 100.0), (10.0, 10.0), (10.0, 100.0), (100.0, 100.0)] {
        let dry = DryContact::new(alpha, f).friction();
        let of_case = |case: &&Solved| (case.reference.parameters.alpha, case.reference.parameters.f) == (alpha, f);
        let found: Vec<f64> =
            ON_801.solved.iter().filter(of_case).map(|case| case.quantities().friction.viscoelastic).collect();
        assert_eq!(found.len(), 3);
        assert!(
            found.is_sorted() && found[2] < dry && found[2] > 0.9 * dry,
            "α = {alpha}, f = {f}: {found:?}, dry {dry}"
        );
    }
}

/// c β^{3/5} falls towards 0.4458 on an elastic substrate, u_min/c towards 0.796.
#[test]
fn the_elastic_film_has_its_asymptote() {
    let betas = [100.0, 1000.0, 10_000.0];
    let solved = solutions(settings(801), &chain(1.0, 0.0, &betas), &no_fields());
    let scaled: Vec<f64> = solved.iter().zip(betas).map(|(case, beta)| case.quantities.c * beta.powf(0.6)).collect();
    assert!(scaled.is_sorted_by(|a, b| a > b) && scaled[2] > 0.4458, "{scaled:?}");
    // at 10⁴ the grid is 0.5 % off, the film 0.6 % above its asymptote
    assert!(relative(scaled[2], 0.4458) < 1.5e-2, "{scaled:?}");
    let ratio = solved[1].quantities.film_min / solved[1].quantities.c;
    assert!(relative(ratio, 0.796) < 2e-2, "{ratio}");
}

/// Far from the edges the pressure is that of dry contact when the film is thin.
#[test]
fn pressure_approaches_that_of_dry_contact() {
    let x = uniform(-0.7, 0.7, 29);
    let elastic = solutions(settings(801), &chain(1.0, 0.0, &[10.0, 1000.0]), &fields_at(x.clone()));
    let hertz = HertzContact::new(1.0);
    let contact = DryContact::new(1.0, 1.0);
    let middle: Vec<f64> = x.iter().map(|x| contact.centre() + contact.half_width() * x).collect();
    let creeping = solutions(settings(801), &chain(1.0, 1.0, &[10.0, 1000.0]), &fields_at(middle.clone()));
    let dry_elastic: Vec<f64> = x.iter().map(|&x| hertz.pressure(x)).collect();
    for (solved, dry) in [(elastic, dry_elastic), (creeping, contact.pressure_on(&middle))] {
        let distance = |case: &Solution| {
            let pairs = case.fields.pressure.as_ref().unwrap().iter().zip(&dry);
            pairs.map(|(p, dry)| (p - dry).abs()).fold(0.0, f64::max)
        };
        let (thick, thin) = (distance(&solved[0]), distance(&solved[1]));
        assert!(thin < 2e-2 && thin < thick / 5.0, "{thick:.1e} at β = 10, {thin:.1e} at 1000");
    }
}
