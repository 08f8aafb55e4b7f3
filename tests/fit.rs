//! `stribeck fit` from outside.

use std::fs;
use std::path::Path;

use crate::program::{code, err, out, say};
use serde_json::Value;
use stribeck_lab::{Experiment, Modulus, Motion, Roller};
use stribeck_solver::{Settings, Substrate, solve};

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

const SWEEP: &str = "[laboratory]\nradius = \"2 mm\"\nload = [100.0, 119.0]\nrelaxed_modulus = \"150 kPa\"\npoisson_ratio = 0.5\n\
                     viscosity = \"5.1 Pa s\"\nretardation_time = \"50 ms\"\nspeed = [1e-3, 1e-2]\nf = 10.0\n";

fn write_points(directory: &Path) {
    let rows = (0..10).map(|i| {
        let experiment =
            Experiment { motion: Motion::Sliding { speed: 1e-3 * 300.0_f64.powf(f64::from(i) / 9.0) }, ..TRUTH };
        let solution = solve(&experiment.parameters(&Substrate::default()), &Settings::default()).unwrap();
        let mu = solution.quantities.friction.drag * experiment.scales().friction;
        format!("{:e},119,{mu:e},{:e}\n", 1e3 * experiment.motion.flat_speed(), 0.01 * mu)
    });
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

/// From values that are hundreds of times off, a fit ends nowhere or elsewhere; a search by the built-in surface comes to
/// what the points were made with.
#[test]
fn a_search_finds_where_to_begin() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    for (values, unknowns) in [
        (["100 kPa", "20 s", "10.0"], "retardation_time"),
        (["20 MPa", "50 us", "100.0"], "relaxed_modulus,retardation_time,f"),
    ] {
        let far = [("150 kPa", values[0]), ("50 ms", values[1]), ("f = 10.0", &format!("f = {}", values[2]))];
        let far = far.iter().fold(SWEEP.to_owned(), |text, (near, far)| text.replace(near, far));
        fs::write(directory.path().join("sweep.toml"), far).unwrap();
        let fit = ["fit", "points.csv", "sweep.toml", "--unknown", unknowns, "--json"];
        let is_found = |said: &Value| {
            let truth = |name: &str| {
                [("relaxed_modulus", 1e5), ("retardation_time", 0.02), ("f", 10.0)]
                    .into_iter()
                    .find(|it| it.0 == name)
                    .unwrap()
                    .1
            };
            let is_near = |it: &Value| {
                (it["value"].as_f64().unwrap() / truth(it["unknown"].as_str().unwrap()) - 1.0).abs() < 1e-3
            };
            said["estimates"].as_array().unwrap().iter().all(is_near)
        };
        let said = say(directory.path(), &fit);
        assert!(code(&said) != 0 || !is_found(&serde_json::from_str(&out(&said)).unwrap()), "{}", out(&said));
        let said = say(directory.path(), &[&fit[..], &["--search"]].concat());
        assert_eq!(code(&said), 0, "{}", err(&said));
        assert!(err(&said).contains("begins at "), "{}", err(&said));
        assert!(is_found(&serde_json::from_str(&out(&said)).unwrap()), "{}", out(&said));
    }
    let wrong = ["fit", "points.csv", "sweep.toml", "--unknown", "f", "--search", "--bounds", "f=100:1"];
    let said = say(directory.path(), &wrong);
    assert!(code(&said) == 2 && err(&said).contains("the bounds of f leave nothing between them"), "{}", err(&said));
    let rolling = SWEEP
        .replace("speed = [1e-3, 1e-2]", "entrainment_speed = [1e-3, 1e-2]\nslide_roll_ratio = 0.5")
        .replace("load = [100.0, 119.0]", "load = 119.0");
    fs::write(directory.path().join("sweep.toml"), rolling).unwrap();
    fs::write(directory.path().join("points.csv"), "entrainment_speed,mu\n0.001,0.1\n0.002,0.1\n").unwrap();
    let said = say(directory.path(), &["fit", "points.csv", "sweep.toml", "--unknown", "viscosity", "--search"]);
    assert!(code(&said) == 2 && err(&said).contains("a rigid roller that slides"), "{}", err(&said));
}

#[test]
fn the_command_names_what_is_wrong() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    fs::write(directory.path().join("few.csv"), "speed,mu\n0.001,0.1\n").unwrap();
    fs::write(directory.path().join("relaxation.toml"), format!("{SWEEP}[solver]\nmethod = \"relaxation\"\n")).unwrap();
    fs::write(directory.path().join("plain.toml"), "[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [10.0]\n").unwrap();
    for (arguments, expected) in [
        (["points.csv", "sweep.toml", "viscosity,viscosity"], "viscosity is among the unknowns twice"),
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

/// The points in the shapes of laboratories: what was understood stands on stderr, and the fit is the same.
#[test]
fn files_of_laboratories_give_the_same_fit() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    let text = fs::read_to_string(directory.path().join("points.csv")).unwrap();
    let foreign =
        text.replace("speed (mm/s),load,mu,error", "Sliding Speed [mm/s],Normal load,COF,Std").replace(',', ";");
    let foreign = foreign.replace('.', ",").replace('\n', "\r\n");
    let wide: Vec<u8> = foreign.encode_utf16().flat_map(u16::to_le_bytes).collect();
    fs::write(directory.path().join("foreign.txt"), wide).unwrap();
    let rows: Vec<&str> = text.lines().collect();
    let half = |rows: &[&str]| [&["V,load,F,error"], rows].concat().join("\n");
    fs::write(directory.path().join("one.csv"), half(&rows[2..7])).unwrap();
    fs::write(directory.path().join("two.csv"), half(&rows[7..])).unwrap();
    let values = |data: &[&str]| -> Vec<f64> {
        let options = ["sweep.toml", "--unknown", "relaxed_modulus,retardation_time", "--json"];
        let said = say(directory.path(), &[&["fit"], data, &options].concat());
        assert_eq!(code(&said), 0, "{data:?}: {}", err(&said));
        assert!(err(&said).contains("as mu") || err(&said).contains("`mu`"), "{}", err(&said));
        let json: Value = serde_json::from_str(&out(&said)).unwrap();
        (0..2).map(|i| json["estimates"][i]["value"].as_f64().unwrap()).collect()
    };
    let expected = values(&["points.csv"]);
    assert_eq!(values(&["foreign.txt"]), expected);
    assert_eq!(values(&["one.csv", "two.csv", "--columns", "speed=V (mm/s),mu=F"]), expected);
}

/// Readings at few places are solved once for each, and their scatter is their error.
#[test]
fn repeated_readings_cost_no_more_than_their_means() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    let text = fs::read_to_string(directory.path().join("points.csv")).unwrap();
    let readings = text.lines().skip(2).flat_map(|row| {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        (0..30).map(move |i| format!("{},{},{}\n", cells[0], cells[1], cells[2] * (1.0 + 0.01 * f64::from(i % 3 - 1))))
    });
    let readings = format!("speed (mm/s),load,mu\n{}", readings.collect::<String>());
    fs::write(directory.path().join("readings.csv"), readings).unwrap();
    let said = say(
        directory.path(),
        &[
            "fit",
            "readings.csv",
            "sweep.toml",
            "--unknown",
            "relaxed_modulus",
            "--bounds",
            "relaxed_modulus=1e4:1e6",
            "--profile",
        ],
    );
    assert_eq!(code(&said), 0, "{}", err(&said));
    assert!(err(&said).contains("300 readings at 10 places"), "{}", err(&said));
    let text = out(&said);
    assert!(
        text.starts_with("10 points of readings.csv") && text.contains("interval") && text.contains(" kPa"),
        "{text}"
    );
}

/// A curve of the program is fitted by what it was computed with.
#[test]
fn a_curve_of_the_program_is_fitted_by_itself() {
    let directory = tempfile::tempdir().unwrap();
    let sweep = SWEEP.replace("[100.0, 119.0]", "119.0").replace("[1e-3, 1e-2]", "[1e-3, 1e-2, 1e-1]");
    fs::write(directory.path().join("curve.toml"), &sweep).unwrap();
    fs::write(directory.path().join("sweep.toml"), sweep.replace("5.1 Pa s", "4 Pa s")).unwrap();
    assert_eq!(code(&say(directory.path(), &["curve", "curve.toml", "--csv", "curve.csv"])), 0);
    let said = say(directory.path(), &["fit", "curve.csv", "sweep.toml", "--unknown", "viscosity", "--json"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let json: Value = serde_json::from_str(&out(&said)).unwrap();
    assert!((json["estimates"][0]["value"].as_f64().unwrap() / 5.1 - 1.0).abs() < 1e-4, "{json}");
}

/// Turns a minute are speeds by the radius of the sweep, and by none where that is looked for.
#[test]
fn turns_are_fitted_by_the_radius_of_the_sweep() {
    let directory = tempfile::tempdir().unwrap();
    let sweep = SWEEP.replace("[100.0, 119.0]", "119.0").replace("[1e-3, 1e-2]", "[1e-3, 1e-2, 1e-1]");
    fs::write(directory.path().join("curve.toml"), &sweep).unwrap();
    assert_eq!(code(&say(directory.path(), &["curve", "curve.toml", "--csv", "curve.csv"])), 0);
    let table = fs::read_to_string(directory.path().join("curve.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = |name: &str| names.iter().position(|it| *it == name).unwrap();
    let [speed, drag, radius] = ["speed", "mu_drag", "radius"].map(place);
    let mut text = "speed (rpm);COF\n".to_owned();
    for line in lines {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        let turns = cells[speed] / cells[radius] * 60.0 / std::f64::consts::TAU;
        text += &format!("{turns};{}\n", cells[drag]);
    }
    fs::write(directory.path().join("turns.csv"), text).unwrap();
    fs::write(directory.path().join("sweep.toml"), sweep.replace("5.1 Pa s", "4 Pa s")).unwrap();
    let fit =
        |unknown: &str| say(directory.path(), &["fit", "turns.csv", "sweep.toml", "--json", "--unknown", unknown]);
    let said = fit("viscosity");
    assert_eq!(code(&said), 0, "{}", err(&said));
    let json: Value = serde_json::from_str(&out(&said)).unwrap();
    assert!((json["estimates"][0]["value"].as_f64().unwrap() / 5.1 - 1.0).abs() < 1e-4, "{json}");
    let said = fit("radius");
    assert!(code(&said) == 2 && err(&said).contains("is in turns, not a speed"), "{}", err(&said));
}

#[test]
fn a_fit_ends_when_its_time_is_up() {
    let directory = tempfile::tempdir().unwrap();
    write_points(directory.path());
    let fit = ["fit", "points.csv", "sweep.toml", "--unknown", "viscosity"];
    let said = say(directory.path(), &[&fit[..], &["--time-limit", "0.000001s"]].concat());
    assert!(code(&said) == 5 && err(&said).contains("the time is up before"), "{}", err(&said));
    for (options, expected) in [
        (["--time-limit", "soon"], "write a time as in 90s, 10m or 1.5h"),
        (["--bounds", "f=0:100"], "f has bounds and is not looked for"),
        (["--bounds", "viscosity=6:10"], "is not between its bounds"),
        (["--bounds", "viscosity=6"], "write bounds as in f=0:100"),
        (["--columns", "mu"], "write quantity=column"),
    ] {
        let said = say(directory.path(), &[&fit[..], &options].concat());
        assert!(code(&said) == 2 && err(&said).contains(expected), "{options:?}: {}", err(&said));
    }
}

/// Drag of two soft bodies, computed by the program, gives back what describes the roller, and lines for its section.
#[test]
fn quantities_of_the_roller_are_found_from_a_curve() {
    let directory = tempfile::tempdir().unwrap();
    let sweep = |time: &str, ratios: &str| {
        format!(
            "[laboratory]\nradius = \"10 mm\"\nload = \"400 N/m\"\nviscosity = \"80 mPa s\"\nslide_roll_ratio = {ratios}\n\
             entrainment_speed = [\"5 mm/s\", \"20 mm/s\", \"0.1 m/s\", \"0.5 m/s\"]\n\
             [flat]\nrelaxed_modulus = \"1.5 MPa\"\npoisson_ratio = 0.5\nf = 2.0\nretardation_time = \"10 ms\"\n\
             [roller]\nrelaxed_modulus = \"3 MPa\"\npoisson_ratio = 0.5\nf = 1.0\nretardation_time = \"{time}\"\n"
        )
    };
    for (name, ratio) in [("slow", "-0.5"), ("fast", "0.8")] {
        let at = format!("{name}.toml");
        fs::write(directory.path().join(&at), sweep("2 ms", ratio)).unwrap();
        let said = say(directory.path(), &["curve", &at, "--csv", &format!("{name}.csv")]);
        assert_eq!(code(&said), 0, "{}", err(&said));
    }
    fs::write(directory.path().join("sweep.toml"), sweep("5 ms", "-0.5")).unwrap();
    let fit = ["fit", "slow.csv", "fast.csv", "sweep.toml", "--unknown", "roller.retardation_time,viscosity"];
    let said = say(directory.path(), &fit);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let text = out(&said);
    let (_, laboratory) = text.split_once("\n[laboratory]\nviscosity = ").expect(&text);
    let (viscosity, time) = laboratory.split_once("\n[roller]\nretardation_time = ").expect(&text);
    for (line, expected) in [(viscosity, 0.08), (time, 2e-3)] {
        let found: f64 = line.split_whitespace().next().unwrap().parse().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
    let rigid = say(directory.path(), &["fit", "slow.csv", "sweep.toml", "--unknown", "roller.colour"]);
    assert!(code(&rigid) == 2 && err(&rigid).contains("roller.retardation_time"), "{}", err(&rigid));
}
