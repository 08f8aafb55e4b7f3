//! Fits to measured friction: what they find of points that were made, and what they refuse.

use std::fs;
use std::path::Path;

use crate::program::{code, err, out, say};
use serde_json::Value;
use stribeck_lab::Measured;
use stribeck_lab::fit::{Fit, FitError, SolverChoice, Task, Unknown, fit};
use stribeck_lab::{Experiment, LaboratoryQuantity, Modulus};
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{CavityShear, FieldSelection, Output, Parameters, RetardationMode, Substrate};

const TRUTH: Experiment = Experiment {
    radius: 2e-3,
    load: 119.0,
    modulus: Modulus::Relaxed(1e5),
    poisson_ratio: 0.5,
    viscosity: 5.1,
    retardation_time: 0.02,
    speed: 1e-3,
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

fn fitted(measured: &Measured, start: Experiment, substrate: &Substrate, names: &[&str]) -> Result<Fit, FitError> {
    fit(&Task {
        measured,
        experiment: start,
        substrate,
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(names),
        solver: SolverChoice { tolerance: 1e-7 },
    })
}

fn speeds(count: u32, from: f64, to: f64) -> Vec<f64> {
    (0..count).map(|i| from * (to / from).powf(f64::from(i) / f64::from(count - 1))).collect()
}

/// Friction of the truth.
fn exact(speeds: &[f64], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let solver = CollocationSolver::new(Settings::for_tolerance(1e-8));
    let output = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    let case = |speed: &f64| {
        let at = Experiment { speed: *speed, ..truth };
        Parameters { alpha: at.alpha(), beta: at.beta(), f: at.f, substrate: substrate.clone() }
    };
    let cases: Vec<Parameters> = speeds.iter().rev().map(case).collect();
    let solved = solve_chain(&solver, &cases, &output, &Interrupt::new()).expect("nobody interrupts");
    let friction = solved.into_iter().rev().map(|case| case.outcome.expect("solved").quantities.friction.total());
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

/// Forty sets of points with known noise: the squares of the deviations over the stated errors have the mean 1 that the theory of
/// errors gives them, with its standard deviation √(2/n), and so has χ² over its degrees of freedom.
#[test]
fn what_is_found_is_within_the_stated_errors() {
    const SETS: usize = 40;
    let (speeds, substrate) = (speeds(20, 1e-4, 1.0), Substrate::default());
    let exact = exact(&speeds, TRUTH, &substrate);
    for known in [true, false] {
        let mut noise = Noise(if known { 1 } else { 2 });
        let names = ["relaxed_modulus", "viscosity", "retardation_time"];
        let (mut squares, mut chi_squared) = ([0.0; 3], 0.0);
        for _ in 0..SETS {
            let noisy: Vec<f64> = exact.iter().map(|mu| mu * (0.02 * noise.normal()).exp()).collect();
            let errors = known.then(|| exact.iter().map(|mu| 0.02 * mu).collect());
            let start = Experiment { modulus: Modulus::Relaxed(1.2e5), ..TRUTH };
            let fit = fitted(&points(&speeds, noisy, errors), start, &substrate, &names).unwrap();
            for ((sum, estimate), truth) in squares.iter_mut().zip(&fit.estimates).zip([1e5, 5.1, 0.02]) {
                *sum += ((estimate.value - truth) / estimate.error).powi(2) / SETS as f64;
            }
            assert_eq!(fit.degrees_of_freedom, 17);
            chi_squared += fit.reduced_chi_squared / SETS as f64;
        }
        // three standard deviations of a mean of 40 squares; with an error from 17 degrees of freedom squares are larger by 17/15
        for mean in squares {
            assert!((0.33..1.85).contains(&mean), "{squares:?}");
        }
        let expected = if known { 1.0 } else { 4e-4 };
        assert!(
            (chi_squared / expected - 1.0).abs() < 3.0 * (2.0 / (17.0 * SETS as f64)).sqrt() + 0.01,
            "{chi_squared}"
        );
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
        let relative = |fit: &Fit, unit: f64| (fit.estimates[i].value / unit, fit.estimates[i].error / unit);
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
    assert!(matches!(error, FitError::NoMinimum { .. }), "{error}");
}

const SWEEP: &str = "[laboratory]\nradius = \"2 mm\"\nload = [100.0, 119.0]\nrelaxed_modulus = \"150 kPa\"\npoisson_ratio = 0.5\n\
                     viscosity = \"5.1 Pa s\"\nretardation_time = \"50 ms\"\nspeed = [1e-3, 1e-2]\nf = 10.0\n";

fn write_points(directory: &Path) {
    let speeds = speeds(10, 1e-3, 0.3);
    let friction = exact(&speeds, TRUTH, &Substrate::default());
    let rows = speeds.iter().zip(friction).map(|(speed, mu)| format!("{:e},119,{mu:e},{:e}\n", 1e3 * speed, 0.01 * mu));
    let text = format!("# made for a test\nspeed (mm/s),load,mu,error\n{}", rows.collect::<String>());
    fs::write(directory.join("points.csv"), text).unwrap();
    fs::write(directory.join("sweep.toml"), SWEEP).unwrap();
}

#[test]
fn the_command_tells_and_writes_a_fit() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    let fit =
        |arguments: &[&str]| say(directory.path(), &[&["fit", "points.csv", "sweep.toml"][..], arguments].concat());
    let said = fit(&["--unknown", "relaxed_modulus,retardation_time", "-o", "fit"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let text = out(&said);
    for words in [
        "std. error",
        "correlations",
        "reduced chi-squared",
        "residuals (fitted − measured)/standard error",
        "[laboratory]",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // What is printed for [laboratory] can be pasted, and is where the fit ended.
    let (_, pasted) = text.split_once("\n[laboratory]\n").unwrap();
    let value = |name: &str| -> f64 {
        let line = pasted.lines().find_map(|line| line.strip_prefix(&format!("{name} = "))).unwrap();
        line.split_whitespace().next().unwrap().parse().unwrap()
    };
    assert!(
        (value("relaxed_modulus") / 1e5 - 1.0).abs() < 1e-3 && (value("retardation_time") / 0.02 - 1.0).abs() < 1e-3
    );
    for name in ["fit.csv", "friction.svg", "residuals.svg"] {
        assert!(directory.path().join("fit").join(name).exists(), "{name}");
    }
    let rows: Vec<csv::StringRecord> =
        csv::Reader::from_path(directory.path().join("fit/fit.csv")).unwrap().records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 10);
    let said = fit(&["--unknown", "relaxed_modulus,retardation_time", "--json"]);
    let json: Value = serde_json::from_str(&out(&said)).unwrap();
    assert_eq!(json["estimates"][0]["unknown"], "relaxed_modulus");
    assert!((json["estimates"][1]["value"].as_f64().unwrap() / 0.02 - 1.0).abs() < 1e-3);
    assert_eq!(json["points"].as_array().unwrap().len(), 10);
}

#[test]
fn the_command_names_what_is_wrong() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    fs::write(directory.path().join("few.csv"), "speed,mu\n0.001,0.1\n").unwrap();
    fs::write(directory.path().join("relaxation.toml"), format!("{SWEEP}[solver]\nmethod = \"relaxation\"\n")).unwrap();
    fs::write(directory.path().join("plain.toml"), "[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [10.0]\n").unwrap();
    for (arguments, expected) in [
        (["points.csv", "sweep.toml", "viscosity,viscosity"], "--unknown has viscosity twice"),
        (["points.csv", "sweep.toml", "colour"], "give some of f, radius, load"),
        (["points.csv", "relaxation.toml", "viscosity"], "which the collocation method alone has"),
        (["points.csv", "plain.toml", "viscosity"], "plain.toml is dimensionless"),
        (
            ["few.csv", "sweep.toml", "viscosity"],
            "load has 2 values in the sweep file and is no column here; give it one",
        ),
        (["nowhere.csv", "sweep.toml", "viscosity"], "cannot read the measured points nowhere.csv"),
    ] {
        let [data, sweep, unknown] = arguments;
        let said = say(directory.path(), &["fit", data, sweep, "--unknown", unknown]);
        assert!(code(&said) == 2 && err(&said).contains(expected), "{arguments:?}: {}", err(&said));
    }
}
