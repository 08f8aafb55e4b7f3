//! Each correction of a printed equation that this module stands on: the corrected form keeps a law that the printed
//! one breaks (table "printed and right" in `docs/explanation/theory.md`).

use std::f64::consts::{FRAC_PI_2, PI};

use stribeck_solver::exact::{DryContact, approx_elastic_c};

use crate::exact::displacement::Load;

const CASES: [(f64, f64); 3] = [(1.0, 1.0), (0.2, 10.0), (3.0, 4.0)];

/// k ā e^{sign·r·ξ} ∫ e^{−sign·r·s} {…} ds of Eq. 24 between the angles of s, with the midpoint rule in the angle.
fn equation_24(contact: &DryContact, k: f64, rate: f64, xi: f64, angles: (f64, f64)) -> f64 {
    let (gamma1, gamma2) = (contact.gamma1(), contact.gamma2());
    let cells = 2000;
    let step = (angles.1 - angles.0) / f64::from(cells);
    let terms = (0..cells).map(|i| {
        let (sin, cos) = (angles.0 + (f64::from(i) + 0.5) * step).sin_cos();
        (rate * (xi - cos)).exp() * (sin * sin + gamma2 - gamma1 * cos)
    });
    k * contact.half_width() * terms.sum::<f64>() * step
}

/// Load of a pressure over ξ, by the midpoint rule in the angle.
fn load(contact: &DryContact, pressure: impl Fn(f64) -> f64) -> f64 {
    let cells = 400;
    let step = PI / f64::from(cells);
    let angle = |i: u32| (f64::from(i) + 0.5) * step;
    contact.half_width() * (0..cells).map(|i| pressure(angle(i)) * angle(i).sin() * step).sum::<f64>()
}

/// Eq. 24: the rate in the exponents is k = (1+f)αā, with the sign that fades towards larger s, and s runs from ξ to
/// the leading edge. Only so does the pressure end at the trailing edge and carry the load; another rate, sign or limit
/// in the printed formula does not.
#[test]
fn equation_24_has_its_exponents_and_limit() {
    for (alpha, f) in CASES {
        let contact = DryContact::new(alpha, f);
        let k = (1.0 + f) * alpha * contact.half_width();
        let right = |angle: f64| equation_24(&contact, k, k, angle.cos(), (0.0, angle));
        assert!((load(&contact, right) / FRAC_PI_2 - 1.0).abs() < 1e-5);
        assert!(right(PI).abs() < 1e-5 && right(0.0).abs() < 1e-5);
        for i in 1..30 {
            let angle = 0.1 * f64::from(i);
            let x = contact.centre() + contact.half_width() * angle.cos();
            assert!((contact.pressure(x) / right(angle) - 1.0).abs() < 1e-4, "alpha={alpha}, f={f}, angle={angle}");
        }

        // K for k: the trailing edge is not free.
        let rate = (1.0 + f) * alpha;
        assert!(equation_24(&contact, k, rate, -1.0, (0.0, PI)).abs() > 1e-2);
        // The exponents exchanged: nor here.
        let exchanged = |angle: f64| equation_24(&contact, k, -k, angle.cos(), (0.0, angle));
        assert!(exchanged(PI).abs() > 1e-2 && (load(&contact, exchanged) / FRAC_PI_2 - 1.0).abs() > 1e-2);
        // From the trailing edge to ξ: tension where there must be pressure.
        let behind = |angle: f64| equation_24(&contact, k, k, angle.cos(), (angle, PI));
        assert!((1..30).all(|i| behind(0.1 * f64::from(i)) < 0.0));
        assert!(load(&contact, behind) < 0.0);
    }
}

/// Eq. 29 gives b/ā. Only the contact around b = āΓ₁ + 1/α has a surface that follows the cylinder, w′ = x.
#[test]
fn equation_29_is_in_units_of_the_half_width() {
    for (alpha, f) in CASES {
        let contact = DryContact::new(alpha, f);
        let printed = contact.gamma1() + 1.0 / (alpha * contact.half_width());
        assert!((contact.half_width() * printed / contact.centre() - 1.0).abs() < 1e-12);
        let right = Load::of(&contact, 1000);
        let wrong = right.moved(printed - contact.centre());
        for xi in [-0.7, 0.0, 0.6] {
            let x = contact.centre() + xi * contact.half_width();
            assert!((right.slope(alpha, f, x) - x).abs() < 1e-4, "alpha={alpha}, f={f}, x={x}");
            let x = printed + xi * contact.half_width();
            assert!((wrong.slope(alpha, f, x) - x).abs() > 1e-2, "alpha={alpha}, f={f}, x={x}");
        }
    }
}

/// Eq. 22: F_v opposes the motion. A half space cannot drive the cylinder, so the printed −(2/π) ∫ p w′ dx is wrong.
#[test]
fn equation_22_dissipates() {
    for (alpha, f) in CASES {
        let contact = DryContact::new(alpha, f);
        let friction = Load::of(&contact, 600).friction(alpha, f);
        assert!(friction > 0.0 && -friction < 0.0);
        assert!((friction / contact.friction() - 1.0).abs() < 1e-4, "{friction} is not {}", contact.friction());
        assert!((-friction / contact.friction() - 1.0).abs() > 1.0);
    }
}

/// Eqs. 34 and 49: the fit holds from β = 100 to 1000 and overshoots beyond, where c falls as β^{−3/5}.
#[test]
fn equation_34_is_a_fit_and_no_asymptote() {
    let rows = include_str!("../reference/single_mode.csv").lines().skip(1);
    let elastic = rows.map(|row| row.split(',').map(|text| text.parse().unwrap()).collect::<Vec<f64>>());
    let elastic: Vec<(f64, f64)> = elastic.filter(|row| row[0] == 0.0).map(|row| (row[2], row[3])).collect();
    let error = |beta: f64| {
        let &(_, c) = elastic.iter().find(|row| row.0 == beta).unwrap();
        approx_elastic_c(beta) / c - 1.0
    };
    assert!(error(100.0).abs() < 1.2e-3 && error(1000.0).abs() < 1.2e-3);
    assert!(error(1e4) > 0.15);
    // Local exponents of c(β): solutions settle at −0.6, the fit at −0.5.
    let &[.., (beta1, c1), (beta2, c2)] = elastic.as_slice() else { panic!("elastic rows in the reference") };
    let solved = (c2 / c1).ln() / (beta2 / beta1).ln();
    assert!((solved + 0.6).abs() < 0.01, "{solved}");
    let fitted = (approx_elastic_c(1e12) / approx_elastic_c(1e11)).log10();
    assert!((fitted + 0.5).abs() < 1e-4);
    assert!((c2 * beta2.powf(0.6) / 0.4458 - 1.0).abs() < 0.01);
}
