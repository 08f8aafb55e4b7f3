//! The stated errors are as large as the deviations of fits to noisy points.

use super::{Noise, TRUTH, exact, fitted, points, speeds, unknowns};
use rayon::prelude::*;
use stribeck_lab::{
    Experiment, FrictionFit, FrictionTask, LaboratoryQuantity, Modulus, Relaxation, RelaxationTerm, Watch,
};
use stribeck_solver::{CavityShear, Interrupt, Substrate};

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
}
