//! Sweeps over quantities of the laboratory: from their files to results in SI units, curves, measured points and fits.

use std::collections::{BTreeMap, HashSet};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::in_python::{check, python};
use crate::program::{code, err, out, say, with_results};
use proptest::prelude::*;
use serde_json::Value;
use stribeck_solver::Parameters;
use stribeck_sweep::store::{DataSet, Status};
use stribeck_sweep::{Column, Field, GridIndex, MAX_CHAIN, Plan, Sweep};

/// The paper's example (β ≈ 1.9·10³), at three speeds, with two loads.
const EXAMPLE: &str = "\
[laboratory]
radius = \"2 mm\"
load = [\"60 N/m\", \"119 N/m\"]
relaxed_modulus = 1e5
poisson_ratio = 0.0
viscosity = \"5.1 Pa s\"
retardation_time = \"20 ms\"
speed = [1e-4, 1e-3, \"20 mm/s\"]
f = 10.0
[output]
fields = [\"pressure\", \"film_thickness\"]
x = { from = -2.0, to = 2.0, points = 81 }
[solver]
tolerance = 1e-6
";

type Row = BTreeMap<String, String>;

fn table(path: &Path) -> Vec<Row> {
    let rows = csv::Reader::from_path(path).expect("a table").into_deserialize().map(|row| row.expect("a row"));
    rows.collect()
}

fn number(row: &Row, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} = {:?}", row[name]))
}

fn close(found: f64, expected: f64, part: f64) -> bool {
    (found - expected).abs() <= part * expected.abs()
}

#[test]
fn the_example_of_the_paper_has_its_beta_and_its_scales() {
    let directory = with_results(EXAMPLE);
    let rows = table(&directory.path().join("results/small/summary.csv"));
    assert_eq!(rows.len(), 6);
    let order: Vec<(f64, f64)> = rows.iter().map(|row| (number(row, "load"), number(row, "speed"))).collect();
    assert_eq!(order, [(60.0, 1e-4), (60.0, 1e-3), (60.0, 0.02), (119.0, 1e-4), (119.0, 1e-3), (119.0, 0.02)]);
    let row = &rows[4];
    assert!((number(row, "beta") - 1.9e3).abs() < 0.05e3, "{}", row["beta"]);
    for row in &rows {
        let (load, radius, speed) = (number(row, "load"), number(row, "radius"), number(row, "speed"));
        let a0 = (4.0 * load * radius / (PI * number(row, "relaxed_modulus"))).sqrt();
        assert!(close(number(row, "a0"), a0, 1e-14) && close(number(row, "alpha"), a0 / (speed * 0.02), 1e-14));
        let beta = 1e5 * a0.powi(4) / (12.0 * number(row, "viscosity") * speed * radius.powi(3));
        assert!(close(number(row, "beta"), beta, 1e-13));
        assert!(close(number(row, "friction_scale"), a0 / radius, 1e-14));
        assert!(close(number(row, "film_scale"), a0 * a0 / radius, 1e-14));
        assert!(close(number(row, "pressure_scale"), 2.0 * load / (PI * a0), 1e-14));
    }
}

/// Rolling and sliding: friction follows from one solution for each film, and a roller that does not turn is one that
/// slides at twice the entrainment speed.
#[test]
fn rolling_and_sliding_are_published_at_their_ratio() {
    let rolling = "entrainment_speed = [5e-5, 5e-4]\nslide_roll_ratio = [-1.0, 0.0, 1.0, 2.0]";
    let text =
        EXAMPLE.replace("[\"60 N/m\", \"119 N/m\"]", "119.0").replace("[1e-4, 1e-3, \"20 mm/s\"]", "[1e-4, 1e-3]");
    let fields = "fields = [\"film_thickness\", \"shear_traction\", \"hysteresis_traction\"]";
    let text = text.replace("fields = [\"pressure\", \"film_thickness\"]", fields);
    let text = text.replace("from = -2.0, to = 2.0, points = 81", "from = -20.0, to = 20.0, points = 4001");
    let rolls = with_results(&text.replace("speed = [1e-4, 1e-3]", rolling));
    let slides = with_results(&text);
    let rows = |directory: &tempfile::TempDir| table(&directory.path().join("results/small/summary.csv"));
    let (rows, sliding) = (rows(&rolls), rows(&slides));
    assert_eq!(rows.len(), 8);
    for (row, other) in rows[6..].iter().zip(&sliding) {
        assert_eq!(row["case"], other["case"]);
        for column in Column::summary() {
            assert_eq!(row[column.name()], other[column.name()], "{}", column.name());
        }
    }
    let data = DataSet::open(&rolls.path().join("results/small")).unwrap();
    let statuses = data.statuses().unwrap();
    for (place, row) in rows.iter().enumerate() {
        assert_eq!(statuses[place], Status::Converged);
        let [p, c, v, s] = ["mu_pressure", "mu_shear", "mu_v", "slide_roll_ratio"].map(|name| number(row, name));
        let s = 0.5 * s;
        // α is that of the flat, β that of both surfaces
        let flat = number(row, "entrainment_speed") * (1.0 + s);
        assert!(close(number(row, "alpha"), number(row, "a0") / (flat * 0.02), 1e-14));
        let drag = v - p + s * c;
        assert!(close(number(row, "mu_drag"), drag, 2e-5), "{row:?}");
        assert!(close(number(row, "mu_h"), p + s * c, 1e-9) && close(number(row, "mu_torque"), p + s * c, 1e-9));
        assert!(number(row, "energy_residual") < 2e-5, "{row:?}");
        // tractions in Pa add up to friction, over N and the grid of a0/100
        let index = data.shape().index(place);
        let dx = 0.01 * number(row, "a0") / number(row, "load");
        for (field, mu) in [(Field::ShearTraction, p + s * c), (Field::HysteresisTraction, v)] {
            let sum = dx * data.field(field, index).unwrap().iter().sum::<f64>();
            assert!((sum - mu).abs() < 0.06 * drag.abs(), "{}: {sum} {mu} {row:?}", field.name());
        }
    }
    // Pictures show ratios on both sides of 0, and choose them.
    for arguments in [&["plot", "results/small"][..], &["report", "results/small"]] {
        let said = say(rolls.path(), arguments);
        assert_eq!(code(&said), 0, "{}", err(&said));
    }
    let picture = fs::read_to_string(rolls.path().join("results/small/figures/mu_drag-along-slide_roll_ratio.svg"));
    assert!(picture.unwrap().contains("slide-to-roll ratio"));
    let said = say(rolls.path(), &["curve", "small.toml", "--at", "slide_roll_ratio=-1"]);
    assert!(code(&said) == 0 && out(&said).contains("speed: entrainment_speed"), "{}", err(&said));
    let said = say(rolls.path(), &["explain", "results/small", &rows[0]["case"], "--stored"]);
    assert!(out(&said).contains("--slide-roll -0.5"), "{}", out(&said));
    let alone = "fields = [\"shear_traction\"]";
    let text = text.replace("speed = [1e-4, 1e-3]", rolling).replace(fields, alone);
    fs::write(rolls.path().join("alone.toml"), text).unwrap();
    let said = say(rolls.path(), &["plan", "alone.toml"]);
    assert!(code(&said) == 2 && err(&said).contains("needs `film_thickness` too"), "{}", err(&said));
}

/// A case is the same case as without units, and its numbers are those times the scales.
#[test]
fn results_are_the_dimensionless_ones_times_the_scales() {
    let directory = with_results(EXAMPLE);
    for row in table(&directory.path().join("results/small/summary.csv")) {
        let arguments = ["--alpha", &row["alpha"], "--beta", &row["beta"], "--f", &row["f"], "--tolerance", "1e-6"];
        let said = say(directory.path(), &[&["solve", "--json"][..], &arguments].concat());
        let alone: Value = serde_json::from_str(&out(&said)).expect("JSON");
        assert_eq!(alone["case"], row["case"].as_str(), "one id");
        let scales =
            [("mu_v", "friction_scale"), ("mu_h", "friction_scale"), ("c", "film_scale"), ("p_max", "pressure_scale")];
        for (name, scale) in scales.into_iter().chain([("x_outlet", "a0"), ("dry_mu_v", "friction_scale")]) {
            let expected = alone[name].as_f64().expect(name) * number(&row, scale);
            assert!(close(number(&row, name), expected, 3e-6), "{name}: {} {expected}", row[name]);
        }
    }
}

#[test]
fn a_labelled_data_set_has_the_quantities_as_coordinates() {
    let directory = with_results(EXAMPLE);
    let read = "\
import sys, numpy, pandas, xarray
for engine in ('h5netcdf', 'netcdf4'):
    data = xarray.open_dataset(sys.argv[1] + '/results.h5', engine=engine)
    assert dict(data.sizes) == {'f': 1, 'load': 2, 'speed': 3, 'x': 81}, data.sizes
    assert list(data['load'].values) == [60, 119] and data['load'].units == 'N/m' and data.speed.units == 'm/s'
    for name in ('alpha', 'beta', 'a0', 'radius', 'viscosity', 'film_scale', 'pressure_scale', 'friction_scale'):
        assert name in data.coords, name
    assert data.radius.ndim == 0 and float(data.radius) == 2e-3 and data.radius.units == 'm'
    assert data.mu_tot.units == '1' and data.film_min.units == 'm' and data.pressure.units == 'Pa'
    table = pandas.read_csv(sys.argv[1] + '/summary.csv')
    for name in ('mu_tot', 'film_min', 'alpha', 'beta', 'a0', 'p_max'):
        assert (data[name].values.ravel() == table[name].values).all(), name
    film = data.film_thickness.sel(load=119).isel(f=0, speed=1)
    assert 0.9 < float(film.min()) / float(data.film_min.sel(load=119).isel(f=0, speed=1)) < 1.3
    # the pressure carries the load, in SI units
    position = data.x.values * float(data.a0.sel(load=119).isel(f=0, speed=1))
    load = numpy.trapezoid(data.pressure.sel(load=119).isel(f=0, speed=1).values, position)
    assert abs(load / 119 - 1) < 2e-3, load
";
    check(&Command::new(python()).args(["-c", read]).arg(directory.path().join("results/small")).output().unwrap());
}

/// Published derivatives against differences of fourth order of the results themselves, for every input.
#[test]
fn sensitivities_are_the_derivatives_of_what_is_published() {
    const STEP: f64 = 0.02;
    let inputs = [
        ("radius", 2e-3),
        ("load", 100.0),
        ("instantaneous_modulus", 1e6),
        ("poisson_ratio", 0.3),
        ("viscosity", 2.0),
        ("retardation_time", 0.05),
        ("speed", 0.02),
        ("f", 4.0),
    ];
    let rolling = [&inputs[..6], &inputs[7..], &[("entrainment_speed", 0.02), ("slide_roll_ratio", 1.6)]].concat();
    let of_motion = ["entrainment_speed", "slide_roll_ratio"];
    let sliding = inputs.iter().map(|(varied, _)| (*varied, inputs.to_vec()));
    for (varied, inputs) in sliding.chain(of_motion.map(|varied| (varied, rolling.clone()))) {
        let line = |(name, value): &(&str, f64)| {
            let values: Vec<f64> = (-2..=2).map(|i| value * (STEP * f64::from(i)).exp()).collect();
            if *name == varied { format!("{name} = {values:?}\n") } else { format!("{name} = {value:?}\n") }
        };
        let sweep = format!(
            "[laboratory]\n{}[substrate]\nmodes = [{{ share = 0.6, time = 1.0 }}, {{ share = 0.4, time = 20.0 }}]\n\
             [solver]\ntolerance = 1e-9\n[output]\nfields = []\nsensitivities = true\n",
            inputs.iter().map(line).collect::<String>()
        );
        let directory = with_results(&sweep);
        let rows = table(&directory.path().join("results/small/summary.csv"));
        assert_eq!(rows.len(), 5);
        for mu in ["mu_v", "mu_h", "mu_tot", "mu_drag", "mu_pressure", "mu_shear"] {
            // mu_pressure is negative
            let at = |i: usize| number(&rows[i], mu).abs().ln();
            let difference = (8.0 * (at(3) - at(1)) - (at(4) - at(0))) / (12.0 * STEP);
            let stated = number(&rows[2], &format!("dln_{mu}_dln_{varied}"));
            assert!((stated - difference).abs() < 1e-5, "{mu} by {varied}: {stated} {difference}");
            let error = number(&rows[2], &format!("error_dln_{mu}_dln_{varied}"));
            assert!((0.0..1e-4).contains(&error), "{mu} by {varied}: {error:e}");
        }
    }
}

/// f may stand in either section, and numbers with and without units are the same.
#[test]
fn the_same_sweep_written_differently_is_the_same() {
    let grid = |text: &str| Sweep::parse("sweep", text).unwrap_or_else(|error| panic!("{text}\n{error}")).grid;
    let in_axes = format!("[axes]\nf = [10.0]\n{}", EXAMPLE.replace("f = 10.0\n", ""));
    assert_eq!(grid(EXAMPLE), grid(&in_axes));
    let plain = EXAMPLE.replace("\"2 mm\"", "0.002").replace("\"5.1 Pa s\"", "5.1").replace("\"20 mm/s\"", "0.02");
    assert_eq!(grid(EXAMPLE), grid(&plain));
    let other_units = EXAMPLE.replace("\"5.1 Pa s\"", "\"5100 cP\"").replace("\"60 N/m\"", "\"0.06 kN/m\"");
    assert_eq!(Plan::new(&Sweep::parse("a", &other_units).unwrap()).cases(), 6);
}

/// Places with the same α, β and f are solved once, wherever they are, and every place is published.
#[test]
fn problems_in_common_are_solved_once() {
    let text = "[laboratory]\nradius = 0.002\nload = 100.0\nrelaxed_modulus = 1e5\npoisson_ratio = 0.0\n\
                viscosity = [1.0, 2.0, 4.0]\nretardation_time = [0.01, 0.02, 0.04]\nspeed = [0.01, 0.02, 0.04]\n\
                f = [0.0, 5.0]\n[output]\nfields = []\n";
    let plan = Plan::new(&Sweep::parse("common", text).unwrap());
    assert_eq!(plan.cases(), 54);
    // f = 0: β of five products of viscosity and speed. f = 5: pairs of powers of two, (i + k, j + k) with i, j, k from
    // 0 to 2.
    let pairs: HashSet<(i32, i32)> =
        (0..27).map(|n| (n / 9, n / 3 % 3, n % 3)).map(|(i, j, k)| (i + k, j + k)).collect();
    assert_eq!(plan.problems(), 5 + pairs.len());
    let directory = with_results(text);
    let rows = table(&directory.path().join("results/small/summary.csv"));
    assert_eq!(rows.len(), 54);
    let ids: HashSet<&String> = rows.iter().map(|row| &row["case"]).collect();
    assert_eq!(ids.len(), plan.problems());
    let said = say(directory.path(), &["run", "small.toml", "--quiet"]);
    assert!(out(&said).contains("nothing to do"), "{}", out(&said));
}

/// One thread or three, in one go or after an interruption between chains: the same bytes. Another speed is solved
/// alone.
#[test]
fn bytes_do_not_depend_on_threads_or_starts() {
    let directory = with_results(EXAMPLE);
    let bytes = |name: &str| {
        ["results.h5", "summary.csv"]
            .map(|file| fs::read(directory.path().join("results").join(name).join(file)).unwrap())
    };
    say(directory.path(), &["run", "small.toml", "--quiet", "--threads", "3", "-o", "results/three"]);
    assert!(bytes("small") == bytes("three"));
    for part in ["1/2", "2/2"] {
        let said = say(directory.path(), &["run", "small.toml", "--quiet", "--part", part, "-o", "results/parts"]);
        assert_eq!(code(&said), 0, "{}", err(&said));
    }
    let said = say(directory.path(), &["merge", "results/parts"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    assert!(bytes("small") == bytes("parts"));
    let more = EXAMPLE.replace("\"20 mm/s\"]", "\"20 mm/s\", 0.1]");
    fs::write(directory.path().join("small.toml"), more).unwrap();
    let said = say(directory.path(), &["plan", "small.toml"]);
    assert!(out(&said).contains("6 reused, 2 new"), "{}", out(&said));
}

/// The paper's method has the same cases: numbers agree to the error of its grid.
#[test]
fn the_relaxation_method_solves_them_too() {
    let text = EXAMPLE.replace("tolerance = 1e-6", "method = \"relaxation\"").replace("\"20 mm/s\"", "2e-3");
    let (relaxation, collocation) = (with_results(&text), with_results(&EXAMPLE.replace("\"20 mm/s\"", "2e-3")));
    let rows = |directory: &tempfile::TempDir| table(&directory.path().join("results/small/summary.csv"));
    for (one, other) in rows(&relaxation).iter().zip(rows(&collocation)) {
        assert_eq!(one["status"], "converged", "{}", one["reason"]);
        for name in ["mu_v", "mu_h", "mu_tot"] {
            assert!(close(number(one, name), number(&other, name), 0.05), "{name}: {} {}", one[name], other[name]);
        }
    }
}

/// Fast and slow ends: with the instantaneous and the relaxed modulus the substrate is elastic, and friction that of
/// its film.
#[test]
fn a_fast_and_a_slow_roller_see_an_elastic_substrate() {
    let material = "[substrate]\nrelaxed_modulus = 1e5\nrelaxation = [{ modulus = 2e5, time = 1e-3 }, { modulus = 1e5, time = 1e-2 }]\n";
    let laboratory = |modulus: &str, speed: f64| {
        format!(
            "[laboratory]\nradius = 0.01\nload = 100.0\n{modulus}poisson_ratio = 0.5\nviscosity = 10.0\nspeed = {speed:?}\n"
        )
    };
    let output = "[output]\nfields = []\n[solver]\ntolerance = 1e-7\n";
    for (speed, modulus) in [(1e-6, 1e5), (1e3, 4e5)] {
        let viscoelastic = with_results(&format!("{material}{}{output}", laboratory("", speed)));
        let elastic = with_results(&format!(
            "{}f = 0.0\n{output}",
            laboratory(&format!("relaxed_modulus = {modulus:?}\n"), speed)
        ));
        let first =
            |directory: &tempfile::TempDir| table(&directory.path().join("results/small/summary.csv")).remove(0);
        let (one, other) = (first(&viscoelastic), first(&elastic));
        assert!(
            close(number(&one, "mu_h"), number(&other, "mu_h"), 5e-3),
            "{speed}: {} {}",
            one["mu_h"],
            other["mu_h"]
        );
        assert!(close(number(&one, "film_min"), number(&other, "film_min"), 5e-3), "{speed}");
    }
}

#[test]
fn a_curve_is_drawn_and_written() {
    let directory = with_results(EXAMPLE);
    let points = "speed (mm/s),mu\n0.1,0.01\n1,0.03\n20,0.2\n";
    fs::write(directory.path().join("points.csv"), points).unwrap();
    let curve = |arguments: &[&str]| say(directory.path(), &[&["curve", "small.toml"][..], arguments].concat());
    let said = curve(&[]);
    assert_eq!(code(&said), 2);
    assert!(
        err(&said).contains("load has 2 values in the sweep file, and a curve has one; choose with --at load=VALUE")
    );
    let said = curve(&["--at", "load=110", "--csv", "curve.csv", "--measured", "points.csv"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let text = out(&said);
    assert!(text.contains("drag (mu_drag) against speed in m/s, logarithmic; crosses: measured"), "{text}");
    let drawn = text.chars().filter(|c| ('\u{2801}'..='\u{28ff}').contains(c)).count();
    assert!(drawn > 100, "{text}");
    let rows = table(&directory.path().join("curve.csv"));
    let published = table(&directory.path().join("results/small/summary.csv"));
    for (one, other) in rows.iter().zip(published.iter().filter(|row| row["load"] == "119.0")) {
        assert_eq!(number(one, "speed"), number(other, "speed"));
        for name in ["alpha", "beta", "mu_drag", "mu_tot", "film_min", "p_max"] {
            assert!(close(number(one, name), number(other, name), 3e-6), "{name}");
        }
    }
    let said = curve(&["--at", "lod=110"]);
    assert!(code(&said) == 2 && err(&said).contains("--at lod: a curve runs along the speed, and can be chosen by f"));
    for (wrong, expected) in [
        ("load=1e9", "the sweep has load from 60 to 119"),
        ("load=nan", "an axis and values of it"),
        ("load=60,119", "asks for several values"),
    ] {
        let said = curve(&["--at", wrong]);
        assert!(code(&said) == 2 && err(&said).contains(expected), "{}", err(&said));
    }
    let said = curve(&["--at", "load=110", "--at", "lod=1"]);
    assert!(code(&said) == 2 && err(&said).contains("--at lod: a curve runs along the speed"), "{}", err(&said));
    fs::write(directory.path().join("plain.toml"), "[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [10.0]\n").unwrap();
    let said = say(directory.path(), &["curve", "plain.toml"]);
    assert!(code(&said) == 2 && err(&said).contains("plain.toml is dimensionless"), "{}", err(&said));
}

/// A case without a solution is in the table, with its reason, and in the exit code.
#[test]
fn a_failed_speed_is_told() {
    let directory = tempfile::tempdir().unwrap();
    let text = EXAMPLE.replace("[\"60 N/m\", \"119 N/m\"]", "119.0").replace("[1e-4, 1e-3,", "[1e-60, 1e-3,");
    fs::write(directory.path().join("small.toml"), text).unwrap();
    let said = say(directory.path(), &["curve", "small.toml"]);
    assert_eq!(code(&said), 3, "{}", err(&said));
    assert!(out(&said).contains("failed at 1e-60 m/s: ") && out(&said).contains(" failed\n"), "{}", out(&said));
}

/// Pictures over the speed, with measured points of each load at its own curve.
#[test]
fn pictures_run_along_the_speed_and_show_what_was_measured() {
    let directory = with_results(EXAMPLE);
    let points = "speed,load,mu,error\n1e-4,60,0.01,0.001\n1e-3,119,0.03,0.002\n1e-3,80,0.5,0.1\n";
    fs::write(directory.path().join("points.csv"), points).unwrap();
    let plot = |arguments: &[&str]| say(directory.path(), &[&["plot", "results/small"][..], arguments].concat());
    let curves = ["--what", "curves", "--of", "mu_drag", "--along", "speed", "--measured", "points.csv"];
    let said = plot(&curves);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let picture = fs::read_to_string(directory.path().join("results/small/figures/mu_drag-along-speed.svg")).unwrap();
    for word in ["speed V", "m/s)", "N = 60 N/m", "N = 119 N/m", "measured"] {
        assert!(picture.contains(word), "{word}");
    }
    assert!(!picture.contains("a₀/R"), "friction is absolute");
    // The numbers behind it name the quantities; the point of a load without a curve is not drawn, so the axis ends
    // below it.
    let rows = table(&directory.path().join("results/small/figures/mu_drag-along-speed.csv"));
    assert!(rows.iter().all(|row| ["f", "load", "speed", "alpha", "beta"].iter().all(|name| row.contains_key(*name))));
    let said = plot(&[]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    for name in ["surface-mu_drag", "map-mu_v", "profile-pressure", "loop", "errors-along-speed"] {
        let is_there = directory.path().join(format!("results/small/figures/{name}.svg")).exists();
        assert_eq!(is_there, name != "errors-along-speed", "{name}");
    }
    let said = plot(&["--at", "load=119", "--what", "profiles", "--of", "film_thickness"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    for (arguments, expected) in [
        (&["--alpha", "1"][..], "--alpha …: this data set has the axes f, load, speed"),
        (&["--along", "beta"], "--along beta: this data set has the axes f, load, speed"),
        (&["--at", "load=500"], "--at load=500: the sweep has load from 60 to 119"),
        (&["--measured", "nowhere.csv"], "cannot read the measured points nowhere.csv"),
    ] {
        let said = plot(arguments);
        assert!(code(&said) == 2 && err(&said).contains(expected), "{}", err(&said));
    }
}

/// What an instrument that swaps bodies averages is drawn as any column, and the drag with its parts comes first.
#[test]
fn averages_over_both_runs_have_pictures() {
    let speeds = "entrainment_speed = { from = \"1 mm/s\", to = \"0.1 m/s\", points = 3, scale = \"log\" }\nslide_roll_ratio = [0.5, 1.0]\nswap = true\n";
    let text = format!(
        "[laboratory]\nradius = \"2 mm\"\nload = 119.0\nrelaxed_modulus = \"150 kPa\"\npoisson_ratio = 0.5\n\
         viscosity = \"5.1 Pa s\"\nretardation_time = \"50 ms\"\nf = 10.0\n{speeds}[output]\nfields = []\n"
    );
    let directory = with_results(&text);
    let said = say(directory.path(), &["plot", "results/small", "--what", "curves", "--of", "mu_sliding,mu_rolling"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let figures = directory.path().join("results/small/figures");
    for name in ["mu_sliding", "mu_rolling"] {
        let drawn = table(&figures.join(format!("{name}-along-entrainment_speed.csv")));
        let published = table(&directory.path().join("results/small/summary.csv"));
        for row in drawn {
            let same = |other: &&Row| {
                ["slide_roll_ratio", "entrainment_speed"].iter().all(|it| number(other, it) == number(&row, it))
            };
            let own = published.iter().find(same).expect("a case of the summary");
            assert_eq!(number(own, name), number(&row, "value"));
        }
    }
    let said = say(directory.path(), &["plot", "results/small"]);
    let first = "results/small/figures/mu_drag-mu_v-mu_shear-mu_pressure-along-entrainment_speed.svg\n";
    assert!(code(&said) == 0 && out(&said).starts_with(first), "{}", out(&said));
    // The load, which has one value, is not hidden.
    let picture = fs::read_to_string(directory.path().join(first.trim())).expect("drawn");
    assert!(picture.contains("N = 119 N/m") && picture.contains("SRR = "), "{picture}");
}

/// With three axes beside the speed and f the pictures take them together.
#[test]
fn several_axes_are_taken_together() {
    let text = EXAMPLE.replace("viscosity = \"5.1 Pa s\"", "viscosity = [1.0, 5.1]");
    let directory = with_results(&text);
    let curves = ["plot", "results/small", "--what", "curves", "--of", "mu_tot", "--along", "speed"];
    let said = say(directory.path(), &[&curves[..], &["--at", "viscosity=1"]].concat());
    assert_eq!(code(&said), 0, "{}", err(&said));
    let picture = fs::read_to_string(directory.path().join("results/small/figures/mu_tot-along-speed.svg")).unwrap();
    assert!(picture.contains("N = 60 N/m, η = 1 Pa s") && !picture.contains("η = 5.1"), "{picture}");
    let said = say(directory.path(), &["explain", "results/small", "10,87,1875"]);
    assert!(out(&said).contains("load = 119 N/m") && out(&said).contains("viscosity = 5.1 Pa s"), "{}", out(&said));
}

#[test]
fn a_page_holds_the_measured_points() {
    let directory = with_results(EXAMPLE);
    fs::write(directory.path().join("points.csv"), "speed,mu,error\n1e-3,0.03,0.002\n").unwrap();
    let said = say(directory.path(), &["report", "results/small", "--measured", "points.csv"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let page = fs::read_to_string(directory.path().join("results/small/report.html")).unwrap();
    let (_, rest) = page.split_once("id=\"contents\">").unwrap();
    let contents: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    assert_eq!(contents["measured"]["coordinates"]["speed"], serde_json::json!([1e-3]));
    assert_eq!(contents["measured"]["column"], "mu_drag");
    let words: Vec<&str> =
        contents["axis_words"].as_array().unwrap().iter().map(|axis| axis["name"].as_str().unwrap()).collect();
    assert_eq!(words, ["f", "load", "speed"]);
    assert_eq!(contents["laboratory"], true);
}

/// Quantities with any values, and which of them are axes.
fn laboratory() -> impl Strategy<Value = (String, [usize; 3])> {
    let axis = |low: f64, high: f64| {
        prop::collection::btree_set(1u32..1000, 1..4).prop_map(move |steps| {
            steps.into_iter().map(|step| low * (high / low).powf(f64::from(step) / 1000.0)).collect::<Vec<f64>>()
        })
    };
    let quantities =
        (axis(1e-3, 1e-1), axis(1.0, 1e3), axis(1e4, 1e7), axis(1e-3, 10.0), axis(1e-4, 1e2), axis(1e-5, 1.0));
    (quantities, prop::array::uniform5(any::<bool>()), prop::collection::btree_set(0u32..50, 1..3), any::<bool>())
        .prop_map(|((radius, load, modulus, viscosity, time, speed), varied, f, instantaneous)| {
            let f: Vec<f64> = f.into_iter().map(|f| f64::from(f) / 5.0).collect();
            let modulus_name = if instantaneous { "instantaneous_modulus" } else { "relaxed_modulus" };
            let names = ["radius", "load", modulus_name, "viscosity", "retardation_time"];
            let mut text = format!("[axes]\nf = {f:?}\n[laboratory]\nspeed = {speed:?}\npoisson_ratio = 0.5\n");
            let mut rows = 1;
            for ((name, values), is_axis) in names.into_iter().zip([radius, load, modulus, viscosity, time]).zip(varied)
            {
                rows *= if is_axis { values.len() } else { 1 };
                text += &if is_axis { format!("{name} = {values:?}\n") } else { format!("{name} = {:?}\n", values[0]) };
            }
            (text, [f.len(), rows, speed.len()])
        })
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    /// Chains hold every problem once, in ascending β, at one value of all but the speed; ids are those of its place.
    #[test]
    fn chains_run_along_the_speed_and_hold_every_problem_once((text, shape) in laboratory()) {
        let sweep = Sweep::parse("made", &text).map_err(|error| TestCaseError::fail(format!("{text}\n{error}")))?;
        prop_assert_eq!(sweep.grid.shape().lengths(), shape);
        let plan = Plan::new(&sweep);
        prop_assert_eq!(plan.cases(), shape.iter().product::<usize>());
        let mut solved = HashSet::new();
        for chain in plan.chains() {
            let cases = plan.parameters(&chain);
            prop_assert!((1..=MAX_CHAIN).contains(&cases.len()));
            prop_assert!(cases.windows(2).all(|pair: &[Parameters]| pair[0].beta < pair[1].beta));
            let places: Vec<GridIndex> = plan.places(&chain).collect();
            let along_one_row = |pair: &[GridIndex]| (pair[0].block, pair[0].row) == (pair[1].block, pair[1].row) && pair[0].along > pair[1].along;
            prop_assert!(places.windows(2).all(along_one_row));
            for (case, place) in cases.iter().zip(places) {
                prop_assert!(solved.insert(plan.id(case)), "a problem is solved twice");
                prop_assert_eq!(plan.id(case), plan.case_at(place));
            }
        }
        prop_assert_eq!(solved.len(), plan.problems());
        let places = (0..plan.cases()).map(|n| [n / (shape[1] * shape[2]), n / shape[2] % shape[1], n % shape[2]]);
        for place in places.map(GridIndex::from) {
            prop_assert!(solved.contains(&plan.case_at(place)), "a place without a case");
            let [f, alpha, beta] = sweep.grid.numbers(place);
            let experiment = sweep.grid.experiment(place).unwrap();
            prop_assert_eq!((f, alpha, beta), (experiment.f, experiment.alpha(), experiment.beta()));
        }
    }
}

/// The Python scripts are for f, α and β, and say so.
#[test]
fn a_script_refuses_what_has_other_axes() {
    let directory = with_results(EXAMPLE);
    let results = directory.path().join("results/small");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("scripts/compare.py");
    let mut command = Command::new(python());
    let said = command.arg(script).args([&results, &results]).args(["-o", "never.png"]).output().unwrap();
    let message = String::from_utf8(said.stderr).unwrap();
    assert_eq!(said.status.code(), Some(2), "{message}");
    assert!(message.contains("its dimensions are f load speed") && message.contains("`stribeck plot"), "{message}");
}

/// A file that was passed on may say anything of its dimensions.
#[test]
fn dimensions_that_are_none_are_refused() {
    let directory = with_results(EXAMPLE);
    let passed_on = directory.path().join("passed-on");
    fs::create_dir(&passed_on).unwrap();
    let file = passed_on.join("results.h5");
    fs::copy(directory.path().join("results/small/results.h5"), &file).unwrap();
    let rename =
        "import sys, h5py\nwith h5py.File(sys.argv[1], 'a') as file: file.attrs['stribeck_dimensions'] = sys.argv[2]";
    for (dimensions, is_right) in [
        ("f f f", false),
        ("f alpha speed", false),
        ("f load", false),
        ("load f speed", false),
        ("", false),
        ("f load speed", true),
    ] {
        check(&Command::new(python()).args(["-c", rename]).arg(&file).arg(dimensions).output().unwrap());
        let said = say(directory.path(), &["plot", "passed-on", "--what", "curves", "--of", "c"]);
        assert_eq!(code(&said), if is_right { 0 } else { 4 }, "{dimensions}: {}", err(&said));
        assert!(is_right || err(&said).contains("its dimensions are not f, quantities of the laboratory and a speed"));
    }
}
