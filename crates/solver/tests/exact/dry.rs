//! Dry sliding.

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;
use stribeck_solver::exact::{DryContact, contact_bounds};
use stribeck_solver::{Parameters, RetardationMode, Substrate};

use crate::exact::displacement::Load;
use crate::exact::quadrature::over_dry_contact;

/// (α, f) over decades, for laws that hold everywhere.
fn grid() -> impl Iterator<Item = (f64, f64)> {
    let alphas = (-6..=6).map(|i| 10_f64.powi(i));
    alphas.flat_map(|alpha| [1e-6, 1e-2, 1.0, 10.0, 100.0, 1e4, 1e6].map(|f| (alpha, f)))
}

#[test]
fn width_centre_and_friction_keep_ten_digits() {
    let table = include_str!("../reference/dry_contact.csv");
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|text| text.parse().unwrap()).collect();
        let &[alpha, f, half_width, centre, friction] = row.as_slice() else { panic!("five columns in {line}") };
        let contact = DryContact::new(alpha, f);
        for (name, value, exact) in [
            ("half width", contact.half_width(), half_width),
            ("centre", contact.centre(), centre),
            ("friction", contact.friction(), friction),
        ] {
            assert!((value / exact - 1.0).abs() < 1e-12, "{name} at alpha={alpha}, f={f}: {value} is not {exact}");
        }
        rows += 1;
    }
    assert!(rows > 50);
}

#[test]
fn pressure_carries_the_load() {
    for (alpha, f) in grid() {
        let load = over_dry_contact(&DryContact::new(alpha, f), |_| 1.0);
        assert!((load / FRAC_PI_2 - 1.0).abs() < 1e-8, "alpha={alpha}, f={f}: load {load}");
    }
}

/// In dry contact the surface follows the cylinder, w′ = x, so that F_v = (2/π) ∫ p x dx: the moment of the pressure
/// must give the closed form.
#[test]
fn friction_is_the_moment_of_the_pressure() {
    for (alpha, f) in grid() {
        let contact = DryContact::new(alpha, f);
        let moment = over_dry_contact(&contact, |x| 2.0 / PI * x);
        let error = moment - contact.friction();
        assert!(error.abs() < 1e-8 * contact.half_width(), "alpha={alpha}, f={f}: {error}");
    }
}

/// Largest pressures printed by CONTACT, to their four digits (see tests/reference/README.md), and the closed form's
/// own.
#[test]
fn largest_pressure_is_that_of_contact() {
    let (radius, load, speed, instantaneous_modulus, f) = (50.0, 600.0, 1000.0, 1905.0, 1.0);
    let relaxed_modulus = instantaneous_modulus / (1.0 + f);
    let a0 = (4.0 * load * radius / (PI * relaxed_modulus)).sqrt();
    let unit = 2.0 * load / (PI * a0);
    let table = include_str!("../reference/contact_visc_cylindr.csv");
    let closed_form = [60.321, 78.734, 84.718, 85.302];
    let mut rows = 0;
    for (line, own) in table.lines().skip(1).zip(closed_form) {
        let (time, printed) = line.split_once(',').unwrap();
        let (time, printed): (f64, f64) = (time.parse().unwrap(), printed.parse().unwrap());
        let largest = unit * DryContact::new(a0 / (speed * time), f).max_pressure();
        assert!((largest - printed).abs() <= 0.0101, "{time} s: {largest} is not {printed}");
        assert!((largest - own).abs() <= 0.0005, "{time} s: {largest} is not {own}");
        rows += 1;
    }
    assert_eq!(rows, 4);
}

#[test]
fn the_peak_is_the_highest_point() {
    for (alpha, f) in grid() {
        let contact = DryContact::new(alpha, f);
        let (x, peak) = contact.peak();
        let nearby = 20.0 * contact.half_width() * 1e-4;
        let fine = (-100..=100).map(|i| x + nearby * f64::from(i) / 100.0);
        let coarse = (0..=2000).map(|i| contact.trailing_edge() + contact.half_width() * f64::from(i) / 1000.0);
        let mut positions: Vec<f64> = fine.chain(coarse).collect();
        positions.sort_by(f64::total_cmp);
        let largest = contact.pressure_on(&positions).into_iter().fold(0.0, f64::max);
        assert!(largest <= peak * (1.0 + 1e-12), "alpha={alpha}, f={f}: {largest} above {peak}");
        assert!((contact.pressure(x) / peak - 1.0).abs() < 1e-8, "alpha={alpha}, f={f}");
    }
}

#[test]
fn elastic_limits_are_hertz() {
    for f in [0.0, 0.5, 10.0, 1e4] {
        let instantaneous = 1.0 / (1.0_f64 + f).sqrt();
        for (alpha, half_width) in [(0.0, instantaneous), (1e-14, instantaneous), (1e22, 1.0), (f64::INFINITY, 1.0)] {
            let contact = DryContact::new(alpha, f);
            assert!((contact.half_width() / half_width - 1.0).abs() < 1e-7);
            assert!((contact.max_pressure() * half_width - 1.0).abs() < 1e-7);
            assert!(contact.friction().abs() < 1e-7 && contact.centre().abs() < 1e-7);
            for i in -8..=8 {
                let x = half_width * f64::from(i) / 10.0;
                let hertz = (1.0 - (x / half_width).powi(2)).sqrt() / half_width;
                assert!((contact.pressure(x) / hertz - 1.0).abs() < 1e-6, "alpha={alpha}, f={f}, x={x}");
            }
        }
    }
    assert_eq!(DryContact::new(0.0, 3.0).friction(), 0.0);
    assert_eq!(DryContact::new(f64::INFINITY, 3.0).friction(), 0.0);
    assert_eq!(DryContact::new(7.0, 0.0).friction(), 0.0);
    assert_eq!(DryContact::new(7.0, 0.0).half_width(), 1.0);
}

#[test]
fn no_closed_form_for_several_modes_but_a_place_to_look() {
    let mode = |share, time| RetardationMode { share, time };
    let substrate = Substrate::new(vec![mode(0.7, 1.0), mode(0.3, 100.0)]).unwrap();
    let several = Parameters { substrate, ..Parameters::new(2.0, 10.0, 5.0) };
    assert_eq!(DryContact::of(&several), None);
    let (trailing, leading, half_width) = contact_bounds(&several);
    for alone in [DryContact::new(2.0, 5.0), DryContact::new(0.02, 5.0)] {
        assert!(trailing <= alone.trailing_edge() && alone.leading_edge() <= leading);
    }
    assert!((leading - trailing - 2.0 * half_width).abs() < 1e-15);
    assert!(half_width <= 1.2, "the hull is no wider than the contacts ask for");

    let slow = Substrate::new(vec![mode(1.0, 100.0)]).unwrap();
    let single = Parameters { substrate: slow, ..Parameters::new(2.0, 10.0, 5.0) };
    let contact = DryContact::of(&single).unwrap();
    assert_eq!(contact, DryContact::new(0.02, 5.0));
    let (trailing, leading, _) = contact_bounds(&single);
    assert_eq!((trailing, leading), (contact.trailing_edge(), contact.leading_edge()));
}

/// In the contact the surface is the cylinder: w′ = x, with w from the kernel (T10). And F_v = (2/π) ∫ p w′ dx.
#[test]
fn surface_follows_the_cylinder() {
    for (alpha, f) in [(1.0, 1.0), (0.1, 10.0), (3.0, 30.0), (10.0, 2.0), (1e-3, 100.0)] {
        let contact = DryContact::new(alpha, f);
        let load = Load::of(&contact, 1500);
        for i in -8..=8 {
            let x = contact.centre() + contact.half_width() * f64::from(i) / 10.0;
            let slope = load.slope(alpha, f, x);
            assert!((slope - x).abs() < 1e-4 * contact.half_width(), "alpha={alpha}, f={f}: w'({x}) = {slope}");
        }
        let friction = load.friction(alpha, f);
        assert!((friction - contact.friction()).abs() < 1e-4 * contact.half_width(), "alpha={alpha}, f={f}");
    }
}

#[test]
fn friction_vanishes_in_both_elastic_limits() {
    for f in [1e-3, 1.0, 1e3] {
        let friction = |alpha: f64| DryContact::new(alpha, f).friction();
        let largest = (-60..=60).map(|i| friction(10_f64.powf(f64::from(i) / 10.0))).fold(0.0, f64::max);
        assert!(largest > 0.0);
        for far in [1e9, 1e12, 1e15] {
            assert!(friction(1.0 / far) < 1e-6 * largest && friction(far) < 1e-6 * largest, "f={f}");
            assert!(friction(0.1 / far) < friction(1.0 / far), "falls towards alpha = 0");
            assert!(friction(10.0 * far) < friction(far), "falls towards alpha = inf");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(64)
    })]
    #[test]
    fn laws_hold_everywhere(log_alpha in -6.0..6.0_f64, log_f in -6.0..6.0_f64) {
        let (alpha, f) = (10_f64.powf(log_alpha), 10_f64.powf(log_f));
        let contact = DryContact::new(alpha, f);
        let (a, b) = (contact.half_width(), contact.centre());
        let instantaneous = 1.0 / (1.0 + f).sqrt();
        prop_assert!(instantaneous * (1.0 - 1e-15) <= a && a <= 1.0);
        prop_assert!(b >= 0.0 && contact.friction() >= 0.0);
        prop_assert_eq!((contact.trailing_edge(), contact.leading_edge()), (b - a, b + a));
        // Γ₂ as the paper has it; it cancels for a → 1.
        let printed = 0.5 * (1.0 / (a * a) - 1.0);
        prop_assert!((contact.gamma2() - printed).abs() <= 1e-13 * (1.0 + printed));
        let load = over_dry_contact(&contact, |_| 1.0);
        prop_assert!((load / FRAC_PI_2 - 1.0).abs() < 1e-8, "load {load}");
        let moment = over_dry_contact(&contact, |x| 2.0 / PI * x);
        let friction = contact.friction();
        prop_assert!((moment - friction).abs() < 1e-8 * a, "moment {moment}, friction {friction}");
        let x: Vec<f64> = (-300..=300).map(|i| b + a * f64::from(i) / 250.0).collect();
        let p = contact.pressure_on(&x);
        let peak = contact.max_pressure();
        prop_assert!(p.iter().all(|&p| p >= 0.0 && p <= peak * (1.0 + 1e-12)));
        prop_assert!(p[..50].iter().chain(&p[551..]).all(|&p| p == 0.0), "no pressure outside");
        // The recursion over many points and the integral to one point are the same.
        for i in [60, 150, 300, 451, 540] {
            prop_assert!((contact.pressure(x[i]) - p[i]).abs() <= 1e-11 * peak);
        }
    }
}
