//! Fits to measured friction: what they find of points that were made, and what they refuse.

use rayon::prelude::*;
use stribeck_lab::{
    Bounds, Experiment, FrictionFit, FrictionFitError, FrictionTask, LaboratoryQuantity, Measured, Modulus, Motion,
    Relaxation, RelaxationTerm, Roller, RollerQuantity, Unknown, Watch,
};
use stribeck_solver::{
    CavityShear, Interrupt, Method, Parameters, RetardationMode, Settings, SolvedCase, Substrate, collocation,
    solve_points,
};

const TRUTH: Experiment = Experiment {
    radius: 2e-3,
    load: 119.0,
    modulus: Modulus::Relaxed(1e5),
    poisson_ratio: 0.5,
    viscosity: 5.1,
    retardation_time: 0.02,
    motion: Motion::Sliding { speed: 1e-3 },
    f: 10.0,
    roller: Roller::RIGID,
    temperature: None,
};

/// A roller that is softer at once and creeps less than the flat.
const SOFT_ROLLER: Roller =
    Roller { modulus: Modulus::Relaxed(2e5), poisson_ratio: 0.4, f: 3.0, retardation_time: 0.15 };

/// Numbers that are as good as random, from 0 to 1: a linear congruential generator (Knuth's MMIX).
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// With mean 0 and variance 1 (Box and Muller).
    fn normal(&mut self) -> f64 {
        let (radius, angle) = ((-2.0 * (1.0 - self.uniform()).ln()).sqrt(), self.uniform());
        radius * (2.0 * std::f64::consts::PI * angle).cos()
    }
}

fn unknowns(names: &[&str]) -> Vec<Unknown> {
    names.iter().map(|name| Unknown::named(name).expect(name)).collect()
}

/// Points of drag over the speed.
fn points(speeds: &[f64], friction: Vec<f64>, errors: Option<Vec<f64>>) -> Measured {
    Measured {
        files: vec!["made".into()],
        column: "mu_drag",
        places: (2..).take(speeds.len()).map(|line| (0, line)).collect(),
        friction,
        errors,
        coordinates: vec![("speed", speeds.to_vec())],
        is_averaged: false,
        is_computed: false,
        without_unit: Vec::new(),
    }
}

fn fitted(
    measured: &Measured,
    start: Experiment,
    substrate: &Substrate,
    names: &[&str],
) -> Result<FrictionFit, FrictionFitError> {
    FrictionFit::new(&FrictionTask {
        measured,
        experiment: start,
        substrate,
        roller_spectrum: substrate,
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(names),
        bounds: Vec::new(),
        tolerance: 1e-7,
    })
}

fn speeds(count: u32, from: f64, to: f64) -> Vec<f64> {
    (0..count).map(|i| from * (to / from).powf(f64::from(i) / f64::from(count - 1))).collect()
}

/// Drag of the truth, which slides at these speeds.
fn exact(speeds: &[f64], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let motions: Vec<Motion> = speeds.iter().map(|speed| Motion::Sliding { speed: *speed }).collect();
    drag(&motions, truth, substrate)
}

/// Drag of the truth: what pushes on the flat, from the pressure and the shear along it. The pressure works on the
/// slope of the flat, and the shear on the flat is P − S C the other way. Both bodies have the same spectrum.
fn drag(motions: &[Motion], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let method = Method::Collocation(collocation::Settings::for_tolerance(1e-8));
    let settings = Settings { method, ..Settings::default() };
    let experiments: Vec<Experiment> = motions.iter().map(|motion| Experiment { motion: *motion, ..truth }).collect();
    let cases: Vec<Parameters> = experiments.iter().map(|it| it.parameters_of_both(substrate, substrate)).collect();
    let solved = solve_points(&cases, &settings, &Interrupt::new()).expect("nobody interrupts");
    let on_flat = |(case, it): (SolvedCase, &Experiment)| {
        let friction = case.outcome.expect("solved").quantities.friction;
        let shear = it.motion.slide_roll() * friction.shear() - friction.pressure;
        (friction.viscoelastic_flat() + shear) * it.scales().friction
    };
    solved.into_iter().zip(&experiments).map(on_flat).collect()
}

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

/// Forty sets of points of an experiment with 2 % of noise: the squares of the deviations over the stated errors have
/// the mean 1 that the theory of errors gives them, with its standard deviation √(2/n), and so has χ² over its degrees
/// of freedom. The errors of the points are in the file or not.
fn check_deviations((truth, substrate): (Experiment, &Substrate), speeds: &[f64], names: &[&str], known: bool) {
    const SETS: usize = 40;
    let exact = exact(speeds, truth, substrate);
    let mut noise = Noise(if known { 1 } else { 2 });
    let mut noisy = || exact.iter().map(|mu| mu * (0.02 * noise.normal()).exp()).collect::<Vec<f64>>();
    let sets: Vec<Vec<f64>> = (0..SETS).map(|_| noisy()).collect();
    let fit = |friction: &Vec<f64>| {
        let errors = known.then(|| exact.iter().map(|mu| 0.02 * mu).collect());
        let mut start = truth;
        start.set(LaboratoryQuantity::Viscosity, 1.2 * truth.viscosity);
        fitted(&points(speeds, friction.clone(), errors), start, substrate, names).unwrap()
    };
    let fits: Vec<FrictionFit> = sets.par_iter().map(fit).collect();
    let freedom = (speeds.len() - names.len()) as f64;
    assert!(fits.iter().all(|fit| fit.degrees_of_freedom as f64 == freedom));
    let mean = |of: &dyn Fn(&FrictionFit) -> f64| fits.iter().map(of).sum::<f64>() / SETS as f64;
    for (i, unknown) in unknowns(names).into_iter().enumerate() {
        let truth = unknown.value(&truth);
        let square = mean(&|fit| {
            ((fit.estimates[i].value / truth).ln() / fit.estimates[i].error * fit.estimates[i].value).powi(2)
        });
        // Three standard deviations of a mean of 40 squares. With an error from 17 degrees of freedom the squares are
        // larger by 17/15.
        assert!((0.33..if known { 1.67 } else { 1.85 }).contains(&square), "{}: {square}", unknown.name());
    }
    let chi_squared = mean(&|fit| fit.reduced_chi_squared) / if known { 1.0 } else { 4e-4 };
    assert!((chi_squared - 1.0).abs() < 3.0 * (2.0 / (freedom * SETS as f64)).sqrt() + 0.01, "{chi_squared}");
}

#[test]
fn deviations_are_as_large_as_the_stated_errors() {
    for known in [true, false] {
        let names = ["relaxed_modulus", "viscosity", "retardation_time"];
        check_deviations((TRUTH, &Substrate::default()), &speeds(20, 1e-4, 1.0), &names, known);
    }
}

/// The material of `sweeps/gel.toml`, with its roller, load and fluid, from ten to a thousand times the speed of its
/// largest friction.
#[test]
#[ignore = "slow: forty fits to two retardation times"]
fn deviations_are_as_large_as_the_stated_errors_for_a_gel() {
    let terms = [(40.239e3, 2.597), (6.024e3, 73.04)];
    let terms = terms.map(|(modulus, time)| RelaxationTerm { modulus, time });
    let gel = Relaxation::new(8532.0, terms.to_vec()).expect("a material").material();
    let truth = Experiment {
        radius: 10e-3,
        load: 2.0,
        modulus: Modulus::Relaxed(gel.relaxed_modulus),
        viscosity: 0.9e-3,
        retardation_time: gel.retardation_time,
        f: gel.f,
        ..TRUTH
    };
    let names = ["viscosity", "retardation_time", "f"];
    check_deviations((truth, &gel.substrate), &speeds(10, 1e-3, 0.1), &names, true);
}

/// The material of `sweeps/rubber.toml` with its roller, load of 500 N/m and oil, where its friction is largest and its
/// five times still count.
#[test]
#[ignore = "slow: forty fits to five retardation times"]
fn deviations_are_as_large_as_the_stated_errors_for_a_rubber() {
    let terms = [(1607.1e3, 1.0), (228.6e3, 10.0), (361.5e3, 100.0), (63.9e3, 1e3), (68.7e3, 1e4)];
    let terms = terms.map(|(modulus, time)| RelaxationTerm { modulus, time });
    let rubber = Relaxation::new(1.2e6, terms.to_vec()).expect("a material").material();
    let truth = Experiment {
        radius: 5e-3,
        load: 500.0,
        modulus: Modulus::Relaxed(rubber.relaxed_modulus),
        viscosity: 1.0,
        retardation_time: rubber.retardation_time,
        f: rubber.f,
        ..TRUTH
    };
    let names = ["viscosity", "retardation_time", "f"];
    check_deviations((truth, &rubber.substrate), &speeds(10, 1e-4, 0.1), &names, true);
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

/// A fit in other units, of points in another order, is the same fit.
#[test]
fn order_and_units_do_not_matter() {
    let (speeds, substrate) = (speeds(12, 1e-3, 0.3), Substrate::default());
    let mut noise = Noise(7);
    let friction: Vec<f64> =
        exact(&speeds, TRUTH, &substrate).iter().map(|mu| mu * (1.0 + 0.01 * noise.normal())).collect();
    let names = ["viscosity", "retardation_time"];
    let one = fitted(&points(&speeds, friction.clone(), None), TRUTH, &substrate, &names).unwrap();
    let reversed = |values: &[f64]| values.iter().rev().copied().collect::<Vec<f64>>();
    let other = fitted(&points(&reversed(&speeds), reversed(&friction), None), TRUTH, &substrate, &names).unwrap();
    // All lengths ten times, all times three times: the same α, β and a₀/R.
    let (length, time) = (10.0, 3.0);
    let scaled = Experiment {
        radius: TRUTH.radius * length,
        load: TRUTH.load * length,
        viscosity: TRUTH.viscosity * time,
        retardation_time: TRUTH.retardation_time * time,
        ..TRUTH
    };
    let faster: Vec<f64> = speeds.iter().map(|speed| speed * length / time).collect();
    let third = fitted(&points(&faster, friction, None), scaled, &substrate, &names).unwrap();
    for i in 0..2 {
        let relative = |fit: &FrictionFit, unit: f64| (fit.estimates[i].value / unit, fit.estimates[i].error / unit);
        let (value, error) = relative(&one, 1.0);
        for (other_value, other_error) in [relative(&other, 1.0), relative(&third, time)] {
            assert!((other_value / value - 1.0).abs() < 1e-5 && (other_error / error - 1.0).abs() < 1e-3);
        }
    }
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let friction = exact(&speeds, TRUTH, &substrate);
    let measured = points(&speeds, friction.clone(), None);
    let refused =
        |measured: &Measured, names: &[&str]| fitted(measured, TRUTH, &substrate, names).unwrap_err().to_string();
    let together = refused(&measured, &["relaxed_modulus", "viscosity", "radius", "load"]);
    assert!(together.contains("cannot be told apart") && together.contains("viscosity"), "{together}");
    assert!(refused(&measured, &["speed"]).contains("speed is a column of the measured points"));
    assert!(
        refused(&measured, &["relaxed_modulus", "instantaneous_modulus"])
            .contains("look for one of the moduli of a body and f")
    );
    let few = points(&speeds[..2], friction[..2].to_vec(), None);
    assert!(refused(&few, &["viscosity", "f"]).contains("2 points are too few for 2 unknowns"));
    let mut negative = measured.clone();
    negative.friction[3] = -0.1;
    assert!(refused(&negative, &["viscosity"]).contains("the friction coefficient on line 5 is not above 0"));
    let motion = Motion::Rolling { entrainment_speed: 1e-3, slide_roll_ratio: 0.5 };
    let rolling = Experiment { motion, ..TRUTH };
    let error = fitted(&measured, rolling, &substrate, &["viscosity"]).unwrap_err().to_string();
    assert!(error.contains("the sweep file gives slide_roll_ratio and entrainment_speed"), "{error}");
    let elastic = Experiment { f: 0.0, ..TRUTH };
    let error = fitted(&measured, elastic, &substrate, &["f"]).unwrap_err().to_string();
    assert!(error.contains("f begins at 0"), "{error}");
    let mut extreme = measured.clone();
    extreme.coordinates[0].1[0] = 1e-60;
    let error = refused(&extreme, &["viscosity"]);
    assert!(error.contains("the point on line 2 has no solution at the start of the fit"), "{error}");
    for name in ["poisson_ratio", "slide_roll_ratio", "roller_speed", "flat_speed"] {
        assert!(Unknown::named(name).is_none(), "{name}");
    }
    assert_eq!(Unknown::all().count(), LaboratoryQuantity::ALL.len() - 5 + 1 + RollerQuantity::ALL.len());
    assert!(refused(&measured, &["roller.f"]).contains("roller.f is looked for, and the roller is rigid"));
    let soft = Experiment { roller: SOFT_ROLLER, ..TRUTH };
    let refused = |start, names: &[&str]| fitted(&measured, start, &substrate, names).unwrap_err().to_string();
    let both = refused(soft, &["roller.relaxed_modulus", "roller.instantaneous_modulus"]);
    assert!(both.contains("one of the moduli of a body"), "{both}");
    let elastic = refused(Experiment { roller: Roller { f: 0.0, ..SOFT_ROLLER }, ..TRUTH }, &["roller.f"]);
    assert!(elastic.contains("roller.f begins at 0"), "{elastic}");
    let rigid = Experiment { modulus: Modulus::Relaxed(f64::INFINITY), f: 0.0, ..soft };
    assert!(refused(rigid, &["relaxed_modulus"]).contains("relaxed_modulus is looked for, and the flat is rigid"));
    // a roller that slides without turning has relaxed: no friction tells its times
    let at_rest = refused(soft, &["viscosity", "roller.retardation_time"]);
    assert!(at_rest.contains("roller.retardation_time"), "{at_rest}");
}

/// Friction that no f can make: the search runs after it, and says that there is no minimum.
#[test]
fn a_search_that_runs_away_is_no_fit() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let friction: Vec<f64> = exact(&speeds, TRUTH, &substrate).iter().map(|mu| 50.0 * mu).collect();
    let error = fitted(&points(&speeds, friction, None), TRUTH, &substrate, &["f"]).unwrap_err();
    assert!(matches!(error, FrictionFitError::NoMinimum { .. }), "{error}");
}

/// A common factor of all standard errors changes no minimum, however small the errors are.
#[test]
fn a_common_factor_of_errors_changes_no_minimum() {
    let speeds = speeds(6, 1e-3, 0.3);
    let mut noise = Noise(11);
    let friction: Vec<f64> =
        exact(&speeds, TRUTH, &Substrate::default()).iter().map(|mu| mu * (1.0 + 0.05 * noise.normal())).collect();
    let start = Experiment { viscosity: 1.0, ..TRUTH };
    let fit = |factor: f64| {
        let errors = Some(friction.iter().map(|mu| factor * mu).collect());
        let fit =
            fitted(&points(&speeds, friction.clone(), errors), start, &Substrate::default(), &["viscosity"]).unwrap();
        (fit.estimates[0].value, fit.estimates[0].error / factor)
    };
    let (value, error) = fit(0.05);
    for factor in [1e-6, 1e-10, 1e-100] {
        let (other, other_error) = fit(factor);
        assert!((other / value - 1.0).abs() < 1e-5 && (other_error / error - 1.0).abs() < 1e-3, "{factor}: {other}");
    }
}

/// Bounds hold the search between them: a minimum inside is the same, and one outside is found at the bound.
#[test]
fn bounds_are_kept() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let measured = points(&speeds, exact(&speeds, TRUTH, &substrate), None);
    let start = Experiment { viscosity: 4.0, f: 8.0, ..TRUTH };
    let fit = |least, most| {
        let bounds = vec![Bounds { unknown: Unknown::Strength, least, most }];
        FrictionFit::new(&FrictionTask {
            measured: &measured,
            experiment: start,
            substrate: &substrate,
            roller_spectrum: &substrate,
            cavity_shear: CavityShear::Full,
            unknowns: unknowns(&["viscosity", "f"]),
            bounds,
            tolerance: 1e-7,
        })
    };
    for (least, most) in [(None, Some(100.0)), (Some(0.0), Some(100.0)), (Some(1.0), None), (Some(9.9), None)] {
        let start_is_inside = least.is_none_or(|least| least < 8.0);
        let Ok(fit) = fit(least, most) else {
            assert!(!start_is_inside);
            continue;
        };
        assert!(start_is_inside && (fit.estimates[1].value / 10.0 - 1.0).abs() < 1e-4, "{:?}", fit.estimates);
        assert!(!fit.estimates[1].at_bound && fit.estimates[1].error.is_finite());
    }
    let held = fit(Some(7.0), Some(9.0)).expect("a minimum at the bound");
    let [viscosity, strength] = held.estimates[..] else { panic!("two") };
    assert!(strength.at_bound && strength.error.is_nan() && (strength.value / 9.0 - 1.0).abs() < 1e-2, "{strength:?}");
    assert!(!viscosity.at_bound && viscosity.error > 0.0);
}

/// The interval of the one unknown of a fit is where its sum of squares has risen as it should, and in a fit of several
/// it is about that of the standard error where errors are small.
#[test]
fn intervals_follow_the_profile_of_the_residuals() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let exact = exact(&speeds, TRUTH, &substrate);
    let errors = Some(exact.iter().map(|mu| 0.01 * mu).collect());
    let measured = points(&speeds, exact, errors);
    let interrupt = Interrupt::new();
    let watch = Watch { interrupt: &interrupt, evaluated: &|_, _| {} };
    for names in [&["viscosity"][..], &["viscosity", "f"]] {
        let task = FrictionTask {
            measured: &measured,
            experiment: TRUTH,
            substrate: &substrate,
            roller_spectrum: &substrate,
            cavity_shear: CavityShear::Full,
            unknowns: unknowns(names),
            bounds: Vec::new(),
            tolerance: 1e-7,
        };
        let fit = FrictionFit::new(&task).expect("a fit");
        for (estimate, ends) in fit.estimates.iter().zip(fit.intervals(&task, &watch).expect("in time")) {
            for (end, sign) in ends.into_iter().zip([-1.0, 1.0]) {
                let reached = (end.expect("an end") / estimate.value).ln() * estimate.value / estimate.error;
                assert!((sign * reached - 1.0).abs() < 0.2, "{}: {reached}", estimate.unknown.name());
            }
        }
    }
    interrupt.request();
    let task = FrictionTask {
        measured: &measured,
        experiment: TRUTH,
        substrate: &substrate,
        roller_spectrum: &substrate,
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(&["viscosity"]),
        bounds: Vec::new(),
        tolerance: 1e-7,
    };
    let error = FrictionFit::watched(&task, &watch).unwrap_err();
    assert_eq!(error, FrictionFitError::TimeLimit);
    // told to stop in between, it has the best values so far, and says that they are no more
    let interrupt = Interrupt::new();
    let told = std::cell::RefCell::new(Vec::new());
    let evaluated = |evaluations: usize, best: &[f64]| {
        told.replace(best.to_vec());
        if evaluations == 2 {
            interrupt.request();
        }
    };
    let mut far = task.clone();
    far.experiment.viscosity *= 3.0;
    let fit = FrictionFit::watched(&far, &Watch { interrupt: &interrupt, evaluated: &evaluated }).expect("the best");
    let [viscosity] = &fit.estimates[..] else { panic!("{:?}", fit.estimates) };
    assert!(!fit.is_minimum && viscosity.error.is_nan() && viscosity.value == told.borrow()[0], "{viscosity:?}");
    assert!(fit.points.iter().all(|point| point.fitted.is_finite()) && fit.reduced_chi_squared > 1.0);
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
