//! Fits to measured friction: what they find of points that were made, and what they refuse.

use rayon::prelude::*;
use stribeck_lab::{
    Experiment, FrictionFit, FrictionFitError, FrictionTask, LaboratoryQuantity, Measured, Modulus, Motion, Unknown,
};
use stribeck_solver::{
    CavityShear, Interrupt, Method, Parameters, RetardationMode, Settings, Substrate, collocation, solve_points,
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
};

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

/// Points of total friction over the speed.
fn points(speeds: &[f64], friction: Vec<f64>, errors: Option<Vec<f64>>) -> Measured {
    Measured {
        path: "made".into(),
        column: "mu_tot",
        lines: (2..).take(speeds.len()).collect(),
        friction,
        errors,
        coordinates: vec![("speed", speeds.to_vec())],
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
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(names),
        tolerance: 1e-7,
    })
}

fn speeds(count: u32, from: f64, to: f64) -> Vec<f64> {
    (0..count).map(|i| from * (to / from).powf(f64::from(i) / f64::from(count - 1))).collect()
}

/// Friction of the truth.
fn exact(speeds: &[f64], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let method = Method::Collocation(collocation::Settings::for_tolerance(1e-8));
    let settings = Settings { method, ..Settings::default() };
    let case = |speed: &f64| Experiment { motion: Motion::Sliding { speed: *speed }, ..truth }.parameters(substrate);
    let cases: Vec<Parameters> = speeds.iter().map(case).collect();
    let solved = solve_points(&cases, &settings, &Interrupt::new()).expect("nobody interrupts");
    let friction = solved.into_iter().map(|case| case.outcome.expect("solved").quantities.friction.total());
    friction.map(|force| force * truth.scales().friction).collect()
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

/// Forty sets of points with known noise: the squares of the deviations over the stated errors have the mean 1 that the
/// theory of errors gives them, with its standard deviation √(2/n), and so has χ² over its degrees of freedom.
#[test]
fn deviations_are_as_large_as_the_stated_errors() {
    const SETS: usize = 40;
    let (speeds, substrate) = (speeds(20, 1e-4, 1.0), Substrate::default());
    let (exact, truth) = (exact(&speeds, TRUTH, &substrate), [1e5, 5.1, 0.02]);
    for known in [true, false] {
        let mut noise = Noise(if known { 1 } else { 2 });
        let mut noisy = || exact.iter().map(|mu| mu * (0.02 * noise.normal()).exp()).collect::<Vec<f64>>();
        let sets: Vec<Vec<f64>> = (0..SETS).map(|_| noisy()).collect();
        let fit = |friction: &Vec<f64>| {
            let errors = known.then(|| exact.iter().map(|mu| 0.02 * mu).collect());
            let names = ["relaxed_modulus", "viscosity", "retardation_time"];
            let start = Experiment { modulus: Modulus::Relaxed(1.2e5), ..TRUTH };
            fitted(&points(&speeds, friction.clone(), errors), start, &substrate, &names).unwrap()
        };
        let fits: Vec<FrictionFit> = sets.par_iter().map(fit).collect();
        assert!(fits.iter().all(|fit| fit.degrees_of_freedom == 17));
        let mean = |of: &dyn Fn(&FrictionFit) -> f64| fits.iter().map(of).sum::<f64>() / SETS as f64;
        for (i, truth) in truth.into_iter().enumerate() {
            let square = mean(&|fit| ((fit.estimates[i].value - truth) / fit.estimates[i].error).powi(2));
            // Three standard deviations of a mean of 40 squares. With an error from 17 degrees of freedom the
            // squares are larger by 17/15.
            assert!((0.33..if known { 1.67 } else { 1.85 }).contains(&square), "unknown {i}: {square}");
        }
        let chi_squared = mean(&|fit| fit.reduced_chi_squared) / if known { 1.0 } else { 4e-4 };
        assert!((chi_squared - 1.0).abs() < 3.0 * (2.0 / (17.0 * SETS as f64)).sqrt() + 0.01, "{chi_squared}");
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
        refused(&measured, &["relaxed_modulus", "instantaneous_modulus"]).contains("look for one of the moduli and f")
    );
    let few = points(&speeds[..2], friction[..2].to_vec(), None);
    assert!(refused(&few, &["viscosity", "f"]).contains("2 points are too few for 2 unknowns"));
    let mut negative = measured.clone();
    negative.friction[3] = -0.1;
    assert!(refused(&negative, &["viscosity"]).contains("the friction coefficient on line 5 is not above 0"));
    let drag = Measured { column: "mu_drag", ..measured.clone() };
    assert!(refused(&drag, &["viscosity"]).contains("mu_drag cannot be fitted"));
    let elastic = Experiment { f: 0.0, ..TRUTH };
    let error = fitted(&measured, elastic, &substrate, &["f"]).unwrap_err().to_string();
    assert!(error.contains("f begins at 0"), "{error}");
    let mut extreme = measured.clone();
    extreme.coordinates[0].1[0] = 1e-60;
    let error = refused(&extreme, &["viscosity"]);
    assert!(error.contains("the point on line 2 has no solution at the start of the fit"), "{error}");
    assert!(Unknown::named("poisson_ratio").is_none() && Unknown::all().count() == LaboratoryQuantity::ALL.len());
}

/// Friction that no f can make: the search runs after it, and says that there is no minimum.
#[test]
fn a_search_that_runs_away_is_no_fit() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let friction: Vec<f64> = exact(&speeds, TRUTH, &substrate).iter().map(|mu| 50.0 * mu).collect();
    let error = fitted(&points(&speeds, friction, None), TRUTH, &substrate, &["f"]).unwrap_err();
    assert!(matches!(error, FrictionFitError::NoMinimum { .. }), "{error}");
}
