//! The rigid film.

use std::f64::consts::{FRAC_PI_2, PI};

use stribeck_solver::CavityShear;
use stribeck_solver::exact::RigidFilm;

/// ∫ g dx from the outlet to infinity, with x = √(2h₀) tan θ, by Simpson's rule in θ.
fn ahead_of_outlet(film: &RigidFilm, g: impl Fn(f64) -> f64) -> f64 {
    let width = (2.0 * film.separation()).sqrt();
    let start = (film.outlet() / width).atan();
    let cells = 4000;
    let step = (FRAC_PI_2 - start) / f64::from(cells);
    let sum: f64 = (0..cells)
        .map(|i| {
            let angle = start + f64::from(i) * step;
            let weight = if i == 0 {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * g(width * angle.tan()) * width / angle.cos().powi(2)
        })
        .sum();
    // At θ = π/2, x = ∞: the value there is the limit, taken half a step before.
    let last = FRAC_PI_2 - 1e-6;
    (sum + g(width * last.tan()) * width / last.cos().powi(2)) * step / 3.0
}

fn pressure_gradient(film: &RigidFilm, x: f64) -> f64 {
    let h = 1e-3 * film.film(x).sqrt();
    let p = |i: f64| film.pressure(x + i * h);
    (8.0 * (p(1.0) - p(-1.0)) - (p(2.0) - p(-2.0))) / (12.0 * h)
}

#[test]
fn constants_of_the_limit() {
    for beta in [1e-8, 1e-2, 1.0, 100.0] {
        let film = RigidFilm::new(beta);
        assert!((beta * film.separation() - 0.2596861).abs() < 5e-8);
        assert!((film.c() / film.separation() - 1.2257484).abs() < 5e-8);
        assert!((film.outlet() / (2.0 * film.separation()).sqrt() + 0.4751299).abs() < 5e-8);
    }
}

#[test]
fn flow_is_conserved() {
    for beta in [1e-4, 0.3] {
        let film = RigidFilm::new(beta);
        for i in 0..60 {
            let x = film.outlet() * 0.99 + 0.1 * f64::from(i) * film.separation().sqrt();
            let u = film.film(x);
            let residual = beta * pressure_gradient(&film, x) * u.powi(3) + u - film.c();
            assert!(residual.abs() < 1e-8 * u, "beta={beta}, x={x}: {residual}");
        }
    }
}

#[test]
fn pressure_carries_the_load_and_ends_smoothly() {
    for beta in [1e-6, 1e-2, 1.0] {
        let film = RigidFilm::new(beta);
        let load = ahead_of_outlet(&film, |x| film.pressure(x));
        assert!((load / FRAC_PI_2 - 1.0).abs() < 1e-9, "beta={beta}: {load}");
        assert!((film.film(film.outlet()) / film.c() - 1.0).abs() < 1e-14, "u = c at the outlet");
        assert_eq!(film.pressure(film.outlet() * 1.0001), 0.0);
        let near = -film.outlet() * 1e-4;
        assert!(film.pressure(film.outlet() + near) < 1e-6 * film.max_pressure(), "p = p' = 0 at the outlet");
        for i in 1..200 {
            let x = film.outlet() + 0.05 * f64::from(i) * film.separation().sqrt();
            let p = film.pressure(x);
            assert!(p > 0.0 && p <= film.max_pressure() * (1.0 + 1e-12));
        }
    }
}

#[test]
fn far_ahead_the_pressure_falls_as_the_cube() {
    let film = RigidFilm::new(0.5);
    for x in [50.0, 99.0, 101.0, 150.0, 1e3, 1e6] {
        let expected = 4.0 / (3.0 * 0.5 * x * x * x);
        assert!((film.pressure(x) / expected - 1.0).abs() < 6.0 / (x * x) + 1e-10, "x={x}");
    }
}

/// Eq. 20 by quadrature, and the drag by both routes of the force balance: the misprint of Eq. 50 leaves out as much as
/// F_h.
#[test]
fn friction_by_quadrature_and_drag_by_force_balance() {
    let beta = 0.02;
    let film = RigidFilm::new(beta);
    // −p′u from (T2).
    let gradient_part = |x: f64| (film.film(x) - film.c()) / (beta * film.film(x).powi(2));
    let shear = ahead_of_outlet(&film, |x| 1.0 / (3.0 * PI * beta * film.film(x)) - gradient_part(x) / PI);
    let friction = film.friction(CavityShear::None);
    assert!((friction.hydrodynamic_film / shear - 1.0).abs() < 1e-8);
    assert_eq!(friction.hydrodynamic_cavity, 0.0);

    let everywhere = PI * (2.0 / film.separation()).sqrt();
    let full = film.friction(CavityShear::Full).hydrodynamic_cavity;
    let ahead = ahead_of_outlet(&film, |x| 1.0 / film.film(x));
    assert!((full / ((everywhere - ahead) / (3.0 * PI * beta)) - 1.0).abs() < 1e-8);
    let streamers = film.friction(CavityShear::Streamers).hydrodynamic_cavity;
    let squares = 0.5 * PI * (2.0 / film.separation()).sqrt() / film.separation();
    let ahead = ahead_of_outlet(&film, |x| film.film(x).powi(-2));
    assert!((streamers / (film.c() * (squares - ahead) / (3.0 * PI * beta)) - 1.0).abs() < 1e-8);
    assert!(0.0 < streamers && streamers < full);

    let moment = ahead_of_outlet(&film, |x| 2.0 / PI * film.pressure(x) * x);
    assert!((friction.drag / (friction.hydrodynamic() + moment) - 1.0).abs() < 1e-7);
    assert!(friction.drag > 1.5 * friction.total(), "F_tot is not the drag on the cylinder");
}
