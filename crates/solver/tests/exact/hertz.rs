//! Hertz.

use std::f64::consts::{FRAC_PI_2, PI};

use stribeck_solver::exact::{DryContact, HertzContact};

/// ∫ p(s) g(s) ds by the midpoint rule in the angle, exponentially exact for smooth g.
fn over_contact(contact: &HertzContact, cells: u32, g: impl Fn(f64) -> f64) -> f64 {
    let step = PI / f64::from(cells);
    let terms = (0..cells).map(|i| {
        let angle = (f64::from(i) + 0.5) * step;
        let s = contact.half_width() * angle.cos();
        contact.pressure(s) * g(s) * contact.half_width() * angle.sin() * step
    });
    terms.sum()
}

#[test]
fn carries_the_load() {
    for compliance in [1.0, 0.3, 1e-6] {
        let contact = HertzContact::new(compliance);
        assert!((over_contact(&contact, 100, |_| 1.0) - FRAC_PI_2).abs() < 1e-13);
    }
}

#[test]
fn surface_follows_the_cylinder_inside() {
    for compliance in [1.0, 0.25] {
        let contact = HertzContact::new(compliance);
        for i in -10..=10 {
            let x = contact.half_width() * f64::from(i) / 10.0;
            let film = 0.5 * x * x - contact.displacement(x) + contact.displacement(0.0);
            assert!(film.abs() < 1e-15, "no gap at {x}");
        }
        for x in [1.001, 1.5, 4.0] {
            let x = x * contact.half_width();
            assert!(0.5 * x * x - contact.displacement(x) + contact.displacement(0.0) > 0.0, "a gap at {x}");
        }
    }
}

#[test]
fn displacement_is_that_of_the_pressure() {
    for compliance in [1.0, 0.25] {
        let contact = HertzContact::new(compliance);
        for x in [1.2, 3.0, -40.0] {
            let x = x * contact.half_width();
            let quadrature = compliance / PI * over_contact(&contact, 400, |s| (x - s).abs().ln());
            assert!((contact.displacement(x) - quadrature).abs() < 1e-12, "x={x}");
        }
        // Inside the logarithm is singular between the nodes: second order is left.
        let quadrature = compliance / PI * over_contact(&contact, 100_000, |s| s.abs().ln());
        assert!((contact.displacement(0.0) - quadrature).abs() < 1e-5);
        let far = 1e9;
        assert!((contact.displacement(far) - 0.5 * compliance * far.ln()).abs() < 1e-12);
    }
}

#[test]
fn dry_contact_is_hertz_without_retardation() {
    for (dry, hertz) in [
        (DryContact::new(3.0, 0.0), HertzContact::new(1.0)),
        (DryContact::new(f64::INFINITY, 8.0), HertzContact::new(1.0)),
        (DryContact::new(0.0, 8.0), HertzContact::new(1.0 / 9.0)),
    ] {
        for i in -12..=12 {
            let x = f64::from(i) / 10.0 * hertz.half_width();
            assert!((dry.pressure(x) - hertz.pressure(x)).abs() < 1e-7 * hertz.pressure(0.0));
        }
    }
}
