//! A fit finds what its points were made of.

use super::{SOFT_ROLLER, TRUTH, drag, exact, fitted, points, speeds, unknowns};
use stribeck_lab::{Experiment, FrictionFit, FrictionTask, Measured, Modulus, Motion};
use stribeck_solver::{CavityShear, RetardationMode, Substrate};

/// Points without noise give back what they were made of, from a start that is far away.
#[test]
fn exact_points_are_fitted_exactly() {
    let speeds = speeds(15, 1e-3, 0.5);
    let modes = vec![RetardationMode { share: 0.6, time: 0.3 }, RetardationMode { share: 0.4, time: 2.05 }];
    for substrate in [Substrate::default(), Substrate::new(modes).unwrap()] {
        let measured = points(&speeds, exact(&speeds, TRUTH, &substrate), None);
        let start =
            Experiment { modulus: Modulus::Relaxed(3e5), viscosity: 2.0, retardation_time: 0.1, f: 3.0, ..TRUTH };
        let fit =
            fitted(&measured, start, &substrate, &["relaxed_modulus", "f", "viscosity", "retardation_time"]).unwrap();
        for (estimate, truth) in fit.estimates.iter().zip([1e5, 10.0, 5.1, 0.02]) {
            assert!((estimate.value / truth - 1.0).abs() < 1e-3, "{}: {}", estimate.unknown.name(), estimate.value);
        }
        assert!(fit.reduced_chi_squared.sqrt() < 1e-5, "{}", fit.reduced_chi_squared);
    }
}

/// Drag of two viscoelastic bodies, and of a soft roller over a rigid flat, gives back what describes the roller.
#[test]
fn quantities_of_the_roller_are_found() {
    let pairs: Vec<(f64, f64)> = [0.2, -0.8, 1.0]
        .into_iter()
        .flat_map(|ratio| speeds(5, 1e-3, 0.2).into_iter().map(move |it| (it, ratio)))
        .collect();
    let motion = Motion::Rolling { entrainment_speed: 1e-3, slide_roll_ratio: 0.2 };
    let both = Experiment { roller: SOFT_ROLLER, motion, ..TRUTH };
    let rigid = Modulus::Relaxed(f64::INFINITY);
    let alone = Experiment { modulus: rigid, poisson_ratio: 0.0, f: 0.0, retardation_time: 0.0, ..both };
    let modes = vec![RetardationMode { share: 0.6, time: 0.3 }, RetardationMode { share: 0.4, time: 2.05 }];
    let spectrum = Substrate::new(modes).unwrap();
    for (truth, names) in [
        (both, &["viscosity", "roller.retardation_time", "roller.f", "relaxed_modulus"][..]),
        (both, &["roller.relaxed_modulus", "retardation_time", "f"]),
        (alone, &["roller.relaxed_modulus", "roller.f", "roller.retardation_time"]),
    ] {
        let measured = rolling_points(&pairs, truth, &spectrum);
        let mut start = truth;
        for (unknown, factor) in unknowns(names).iter().zip([1.6, 0.5, 2.0, 0.7]) {
            unknown.set(&mut start, factor * unknown.value(&truth));
        }
        let fit = fitted(&measured, start, &spectrum, names).unwrap();
        for estimate in &fit.estimates {
            let expected = estimate.unknown.value(&truth);
            assert!((estimate.value / expected - 1.0).abs() < 1e-3, "{}: {}", estimate.unknown.name(), estimate.value);
        }
        assert!(fit.reduced_chi_squared.sqrt() < 1e-5, "{}", fit.reduced_chi_squared);
    }
}

/// A curve against the speed is nearly one power of it where films are thin, and does not tell the modulus from the
/// viscosity. Rolling and sliding do: what rolls shows the pressure flow alone, which has another power.
#[test]
fn rolling_tells_what_a_speed_curve_does_not() {
    let truth = Experiment { f: 0.0, retardation_time: 0.0, modulus: Modulus::Relaxed(1e6), viscosity: 0.01, ..TRUTH };
    let elastic = Substrate::default();
    let names = ["relaxed_modulus", "viscosity"];
    let errors = |ratios: [f64; 2]| {
        let speeds = speeds(10, 1e-3, 1e-2);
        let pairs: Vec<(f64, f64)> =
            ratios.iter().flat_map(|ratio| speeds.iter().map(|speed| (*speed, *ratio))).collect();
        let motions: Vec<Motion> = pairs
            .iter()
            .map(|&(speed, slide_roll_ratio)| Motion::Rolling { entrainment_speed: speed, slide_roll_ratio })
            .collect();
        let friction = drag(&motions, truth, &elastic);
        let measured = Measured {
            errors: Some(friction.iter().map(|mu| 0.02 * mu).collect()),
            friction,
            coordinates: vec![
                ("entrainment_speed", pairs.iter().map(|pair| pair.0).collect()),
                ("slide_roll_ratio", pairs.iter().map(|pair| pair.1).collect()),
            ],
            ..points(&vec![1.0; pairs.len()], Vec::new(), None)
        };
        let start = Experiment { motion: motions[0], viscosity: 0.012, ..truth };
        let fit = fitted(&measured, start, &elastic, &names).unwrap();
        let relative = |i: usize| fit.estimates[i].error / fit.estimates[i].value;
        assert!((fit.estimates[1].value / truth.viscosity - 1.0).abs() < 1e-2, "{:?}", fit.estimates);
        [relative(0), relative(1)]
    };
    let (sliding, both) = (errors([2.0, 2.0 - 1e-9]), errors([2.0, 0.0]));
    println!("relative errors of modulus and viscosity: {sliding:?} sliding, {both:?} sliding and rolling");
    for (alone, with) in sliding.into_iter().zip(both) {
        assert!(with < 0.2 * alone, "{sliding:?} {both:?}");
    }
}

/// A curve of a fit leads through what was fitted at its points, and points at two loads are on two of them.
#[test]
fn curves_lead_through_the_fitted_points() {
    let own = speeds(4, 1e-3, 0.1);
    let of = |load| exact(&own, Experiment { load, ..TRUTH }, &Substrate::default());
    let speeds = [own.clone(), own.clone()].concat();
    let mut measured = points(&speeds, [of(119.0), of(60.0)].concat(), None);
    measured.coordinates.push(("load", [[119.0; 4], [60.0; 4]].concat()));
    let task = FrictionTask {
        measured: &measured,
        experiment: Experiment { viscosity: 4.0, ..TRUTH },
        substrate: &Substrate::default(),
        roller_spectrum: &Substrate::default(),
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(&["viscosity"]),
        bounds: Vec::new(),
        tolerance: 1e-7,
    };
    let fit = FrictionFit::new(&task).expect("a fit");
    let curves = fit.curves(&task);
    assert_eq!(curves.iter().map(|curve| curve.points.clone()).collect::<Vec<_>>(), [[0, 1, 2, 3], [4, 5, 6, 7]]);
    for curve in &curves {
        for point in &curve.points {
            let (speed, fitted) = (speeds[*point], fit.points[*point].fitted);
            let place = curve.line.partition_point(|(at, _)| *at < speed * (1.0 - 1e-9)).clamp(1, curve.line.len() - 1);
            let (from, to) = (curve.line[place - 1], curve.line[place]);
            let share = (speed / from.0).ln() / (to.0 / from.0).ln();
            let on_line = from.1 + share * (to.1 - from.1);
            assert!((on_line / fitted - 1.0).abs() < 2e-3, "{speed}: {on_line} and {fitted}");
        }
    }
}

/// Points of entrainment speeds and slide-to-roll ratios.
fn rolling_points(pairs: &[(f64, f64)], truth: Experiment, substrate: &Substrate) -> Measured {
    let motions: Vec<Motion> = pairs
        .iter()
        .map(|&(entrainment_speed, slide_roll_ratio)| Motion::Rolling { entrainment_speed, slide_roll_ratio })
        .collect();
    let friction = drag(&motions, truth, substrate);
    Measured {
        coordinates: vec![
            ("entrainment_speed", pairs.iter().map(|pair| pair.0).collect()),
            ("slide_roll_ratio", pairs.iter().map(|pair| pair.1).collect()),
        ],
        // relative errors, though the drag changes its sign where the roller is faster
        errors: Some(friction.iter().map(|mu| mu.abs()).collect()),
        ..points(&vec![1.0; pairs.len()], friction, None)
    }
}
