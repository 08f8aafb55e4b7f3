//! Each correction of a printed equation that the solver stands on: the corrected form keeps a law that the printed one
//! breaks (table "printed and right" of `docs/explanation/theory.md`).

use std::f64::consts::{FRAC_PI_2, PI};

use stribeck_solver::exact::{HertzContact, RigidFilm};
use stribeck_solver::kernel::cell_average_log;
use stribeck_solver::{CavityShear, Output};

use crate::relaxation::cases::{ON_401, chain, no_fields, reference, relative, settings, solutions};

/// Eq. 41 uses ln|x_i − x_k|, infinite at i = k. With the average over the cell the surface under Hertz pressure
/// follows the cylinder to second order; with the infinite term left out, to first order only.
#[test]
fn equation_41_needs_the_average_over_the_cell() {
    let printed = |m: f64, _: f64| m.abs().ln();
    let left_out = |m: f64, _: f64| if m == 0.0 { 0.0 } else { m.abs().ln() };
    let kernels: [fn(f64, f64) -> f64; 3] = [printed, left_out, cell_average_log];
    let hertz = HertzContact::new(1.0);
    // largest |w(x) − w(0) − x²/2| at 0 < x ≤ 1/2
    let error = |kernel: fn(f64, f64) -> f64, half: i32| {
        let dx = 1.0 / f64::from(half);
        let surface = |i: i32| -> f64 {
            let terms = (-half..=half).map(|k| kernel(f64::from(i - k) * dx, dx) * hertz.pressure(f64::from(k) * dx));
            terms.sum::<f64>() * dx / PI
        };
        let rise = |i: i32| surface(i) - surface(0) - 0.5 * (f64::from(i) * dx).powi(2);
        (1..=half / 2).map(|i| rise(i).abs()).fold(0.0, |worst, error| if error <= worst { worst } else { error })
    };
    let [infinite, first, second] = kernels.map(|kernel| [error(kernel, 100), error(kernel, 400)]);
    assert!(infinite.iter().all(|error| !error.is_finite()), "{infinite:?}");
    assert!(second[1] < 2e-4 && second[1] < second[0] / 7.0, "{second:?}");
    assert!(first[1] > 5.0 * second[1] && first[1] > first[0] / 7.0, "{first:?} beside {second:?}");
}

/// Eq. 44 moves h₀ by the absolute value of the load residual. The load of a rigid film, 1/(2βc) with c in proportion
/// to h₀, is then found from below only: a cylinder that carries too little is lifted, and never carries its load.
#[test]
fn equation_44_must_lower_the_cylinder_too() {
    const BETA: f64 = 0.1;
    let film = RigidFilm::new(BETA);
    let load = |separation: f64| film.separation() / (2.0 * BETA * film.c() * separation);
    let follow = |start: f64, residual: &dyn Fn(f64) -> f64| {
        let gain = 0.1 * film.separation();
        (0..2000).fold(start, |separation, _| separation + gain * residual(load(separation) / FRAC_PI_2 - 1.0))
    };
    for start in [0.5, 2.0].map(|factor| factor * film.separation()) {
        assert!(relative(follow(start, &|signed| signed), film.separation()) < 1e-9, "from {start}");
    }
    let lifted = follow(2.0 * film.separation(), &f64::abs);
    assert!(lifted > 3.0 * film.separation(), "{lifted}");
}

/// Eq. 22 with its printed sign: friction that drives the cylinder.
#[test]
fn equation_22_dissipates() {
    for case in ON_401.solved.iter().filter(|case| case.reference.viscoelastic > 0.0) {
        let (p, w) = (case.pressure(), case.displacement());
        let work: f64 = (1..p.len() - 1).map(|i| 0.5 * p[i] * (w[i + 1] - w[i - 1])).sum();
        let printed = -2.0 / PI * work;
        let friction = case.quantities().friction.viscoelastic;
        assert!(printed < 0.0 && friction > 0.0, "{:?}: {printed}, {friction}", case.reference.parameters);
    }
}

/// Eq. 50: F_v + F_h is not what holds the cylinder back. At f = 0 and β = 10 the missing term is as large as F_h, at
/// 100 nearly half of it.
#[test]
fn equation_50_is_not_the_drag() {
    for (beta, part) in [(10.0, 1.0), (100.0, 0.44)] {
        let case = ON_401
            .solved
            .iter()
            .find(|case| case.reference.parameters.f == 0.0 && case.reference.parameters.beta == beta);
        let case = case.expect("the reference has this case");
        let friction = &case.quantities().friction;
        let missing = (friction.drag - friction.total()) / friction.hydrodynamic();
        assert!((missing - part).abs() < 0.01, "{missing}");
        assert!(relative(friction.drag, case.reference.drag) < 1e-3);
        assert!(relative(friction.total(), case.reference.drag) > 0.25);
    }
}

/// Eq. 20 integrated over all x takes the gap behind the outlet as full. Streamers that keep the flow conduct a third
/// of that shear, and the choice is not a detail: it is a quarter of F_h at β = 10.
#[test]
fn equation_20_does_not_say_what_fills_the_cavity() {
    let row = reference().into_iter().find(|row| row.parameters.f == 0.0 && row.parameters.beta == 10.0).unwrap();
    let friction = [CavityShear::Full, CavityShear::Streamers, CavityShear::None].map(|cavity_shear| {
        let output = Output { cavity_shear, ..no_fields() };
        solutions(settings(401), &chain(1.0, 0.0, &[10.0]), &output).remove(0).quantities.friction
    });
    let [full, streamers, none] = friction;
    assert!(relative(full.hydrodynamic_cavity, row.cavity_full) < 1e-3, "{full:?}");
    assert!(relative(streamers.hydrodynamic_cavity, row.cavity_streamers) < 1e-3, "{streamers:?}");
    assert_eq!(none.hydrodynamic_cavity, 0.0);
    assert!(friction.iter().all(|friction| friction.hydrodynamic_film == full.hydrodynamic_film));
    assert!(full.hydrodynamic() > 1.15 * streamers.hydrodynamic() && full.hydrodynamic() > 1.3 * none.hydrodynamic());
    // what depends on F_h follows, what does not does not
    assert!((full.drag - none.drag - full.hydrodynamic_cavity).abs() < 1e-12);
    assert_eq!(full.viscoelastic, none.viscoelastic);
}
