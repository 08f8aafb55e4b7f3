//! `stribeck surface` and `stribeck evaluate` from outside.

use std::fs;
use std::path::Path;

use serde_json::Value;
use stribeck_sweep::surface::SurfaceOptions;
use tempfile::{TempDir, tempdir};

use crate::program::{code, err, out, say};

/// A directory with a surface over β, f = 10, in `s/surface.json`.
fn with_surface() -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    let text = "[axes]\nalpha = [1.0]\nf = [10.0]\nbeta = { from = 10.0, to = 100.0, scale = \"log\" }\n\
                [surface]\ntolerance = 1e-3\n";
    fs::write(directory.path().join("s.toml"), text).expect("written");
    let made = say(directory.path(), &["surface", "s.toml", "-o", "s", "--quiet"]);
    assert_eq!((code(&made), err(&made)), (0, String::new()));
    assert!(out(&made).contains("errors at 1000 random points (seed 1)"), "{}", out(&made));
    directory
}

/// `stribeck evaluate` of the surface.
fn evaluate(directory: &Path, more: &[&str]) -> std::process::Output {
    say(directory, &[&["evaluate", "s/surface.json"], more].concat())
}

#[test]
fn a_point_has_the_friction_of_solve_and_its_slope() {
    let directory = with_surface();
    let point = ["--beta", "40", "--json", "--derivatives"];
    let surface: Value = serde_json::from_slice(&evaluate(directory.path(), &point).stdout).expect("JSON");
    let drag = |beta: &str| {
        let solved = say(
            directory.path(),
            &["solve", "--alpha", "1", "--beta", beta, "--f", "10", "--tolerance", "1e-9", "--json"],
        );
        let case: Value = serde_json::from_slice(&solved.stdout).expect("JSON");
        case["mu_drag"].as_f64().expect("a number")
    };
    let (value, expected) = (surface["mu_drag"]["value"].as_f64().expect("a number"), drag("40"));
    assert!((value / expected - 1.0).abs() < 1e-3, "{value} {expected}");
    let slope = surface["mu_drag"]["derivatives"]["beta"].as_f64().expect("a number");
    let difference = (drag("40.4") - drag("39.6")) / 0.8;
    assert!((slope / difference - 1.0).abs() < 2e-2, "{slope} {difference}");
}

#[test]
fn rows_keep_their_order_and_those_outside_are_marked() {
    let directory = with_surface();
    let points = "name,beta\n\"b, c\",100\nfar,100.1\nlow,1e1\n";
    fs::write(directory.path().join("p.csv"), points).expect("written");
    let said = evaluate(directory.path(), &["--points", "p.csv", "-o", "o.csv"]);
    assert_eq!(code(&said), 3);
    assert_eq!(err(&said), "1 of 3 points lie outside the surface, which has beta from 10 to 100\n");
    let mut reader = csv::Reader::from_path(directory.path().join("o.csv")).expect("a table");
    assert_eq!(reader.headers().expect("a header"), vec!["name", "beta", "mu_drag", "mu_v", "mu_h", "c", "status"]);
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.iter().map(|row| &row[0]).collect::<Vec<_>>(), ["b, c", "far", "low"]);
    assert_eq!(rows.iter().map(|row| &row[6]).collect::<Vec<_>>(), ["inside", "outside", "inside"]);
    assert_eq!(&rows[1][2], "");
    let one = evaluate(directory.path(), &["--beta", "10", "--json"]);
    let one: Value = serde_json::from_slice(&one.stdout).expect("JSON");
    assert_eq!(rows[2][2].parse::<f64>().ok(), one["mu_drag"]["value"].as_f64());
    // The file of the points is not written over.
    let said = evaluate(directory.path(), &["--points", "p.csv", "-o", "p.csv"]);
    assert_eq!(
        (code(&said), fs::read_to_string(directory.path().join("p.csv")).expect("read")),
        (2, points.to_owned())
    );
}

#[test]
fn a_check_tells_whether_the_certificate_holds() {
    let directory = with_surface();
    let said = evaluate(directory.path(), &["--check", "50", "--seed", "9"]);
    assert_eq!(code(&said), 0, "{}", out(&said));
    let file = directory.path().join("s/surface.json");
    let text = fs::read_to_string(&file).expect("read");
    let stricter = text.replacen("\"tolerance\": 0.001", "\"tolerance\": 1e-9", 1);
    assert_ne!(stricter, text);
    fs::write(&file, stricter).expect("written");
    let said = evaluate(directory.path(), &["--check", "50", "--seed", "9"]);
    assert_eq!(code(&said), 1);
    assert!(out(&said).contains("DOES NOT HOLD"), "{}", out(&said));
}

#[test]
fn what_cannot_be_evaluated_is_told() {
    let directory = with_surface();
    let said = |more: &[&str]| {
        let said = evaluate(directory.path(), more);
        assert_eq!(code(&said), 2, "{more:?}");
        err(&said)
    };
    assert!(said(&["--beta", "101"]).contains("beta = 101 is outside the surface, which has beta from 10 to 100"));
    assert!(said(&["--f", "10"]).contains("the point needs a value of beta"));
    assert!(said(&["--beta", "20", "--f", "11"]).contains("was made for f = 10"));
    assert!(said(&["--beta", "20", "--at", "speed=1"]).contains("no axis `speed`; its axes are beta"));
    assert_eq!(code(&evaluate(directory.path(), &["--beta", "20", "--f", "10"])), 0);
    fs::write(directory.path().join("p.csv"), "beta\n20\nx\n").expect("written");
    assert!(said(&["--points", "p.csv"]).contains("p.csv: line 3: `x` in the column `beta` is no number"));
    fs::write(directory.path().join("p.csv"), "bet\n20\n").expect("written");
    assert!(said(&["--points", "p.csv"]).contains("no column `beta`"));
    let none = say(directory.path(), &["evaluate", "none.json", "--beta", "20"]);
    assert!(code(&none) == 2 && err(&none).contains("none.json: cannot read the surface"), "{}", err(&none));
}

#[test]
fn what_is_not_ours_is_not_replaced_and_damage_is_told_and_healed() {
    let directory = with_surface();
    let again = || say(directory.path(), &["surface", "s.toml", "-o", "s", "--quiet"]);
    let file = directory.path().join("s/surface.json");
    let made = fs::read(&file).expect("read");
    let shard =
        fs::read_dir(directory.path().join("s/shards")).expect("listed").next().expect("a shard").expect("listed");
    let mut bytes = fs::read(shard.path()).expect("read");
    bytes[100] ^= 1;
    fs::write(shard.path(), bytes).expect("written");
    let healed = again();
    assert_eq!(code(&healed), 0);
    assert!(err(&healed).starts_with("warning: "), "{}", err(&healed));
    assert_eq!(fs::read(&file).expect("read"), made);
    assert_eq!(err(&again()), "");

    fs::write(&file, "{\"mine\": 1}").expect("written");
    let refused = again();
    assert_eq!(code(&refused), 4);
    assert!(err(&refused).contains("`stribeck surface` has not written"), "{}", err(&refused));
    assert_eq!(fs::read_to_string(&file).expect("read"), "{\"mine\": 1}");
}

/// The status of a surface tells its rounds, the error that it has reached, and its cases.
#[test]
fn the_status_of_a_surface_tells_how_far_it_is() {
    let directory = with_surface();
    let status = || out(&say(directory.path(), &["status", "s"]));
    let line = |text: &str, name: &str| {
        let found = text.lines().find_map(|line| line.strip_prefix(name).map(str::trim)).map(str::to_owned);
        found.unwrap_or_else(|| panic!("no {name} in {text}"))
    };
    let finished = status();
    assert!(finished.contains("finished: s/surface.json"), "{finished}");
    let file: Value =
        serde_json::from_slice(&fs::read(directory.path().join("s/surface.json")).expect("read")).expect("JSON");
    let errors = file["certificate"]["errors"].as_array().expect("errors");
    let largest = errors.iter().map(|it| it["largest"].as_f64().expect("a number")).fold(0.0, f64::max);
    assert_eq!(line(&finished, "error"), format!("at most {largest:.1e} at random points; the tolerance is 1e-3"));
    let made_from = file["certificate"]["cases"].as_u64().expect("a number");
    let (rounds, cases) = {
        let words = line(&finished, "rounds");
        let (rounds, cases) = words.split_once(", ").expect("two numbers");
        (rounds.parse::<u64>().expect("rounds"), cases.trim_end_matches(" cases").parse::<u64>().expect("cases"))
    };
    assert!(rounds > 0 && cases == made_from, "{rounds} rounds, {cases} cases, made from {made_from}");
    let cases = line(&finished, "cases");
    let converged: u64 = cases.split(' ').next().and_then(|number| number.parse().ok()).expect("a number");
    assert!(converged >= made_from + 1000 && cases.ends_with(" 0 failed"), "{cases}");
    fs::remove_file(directory.path().join("s/surface.json")).expect("removed");
    assert!(status().contains("stopped; the same `stribeck surface` command goes on"), "{}", status());
}

/// The surface that is built in is of this solver, and of the file that makes it; at points of a seed that nothing was
/// chosen by it is within 1.5 tolerances.
#[test]
fn the_built_in_surface_holds() {
    let surface = stribeck::universe::universe();
    let file = surface.file();
    assert_eq!(file.results_version, stribeck_solver::collocation::RESULTS_VERSION);
    let sweep = stribeck_sweep::SurfaceSweep::read("sweeps/universe.toml").expect("valid");
    assert_eq!(file.sweep, sweep.sweep.text);
    let errors = stribeck_sweep::surface::compare_surface(&sweep, &surface, 200, 4711, &SurfaceOptions::default());
    for (name, errors) in surface.quantities().zip(errors.expect("compared")) {
        assert!(errors.largest < 1.5 * file.tolerance, "{name}: {errors:?}");
    }
}

#[test]
fn without_a_file_the_built_in_surface_is_evaluated() {
    let directory = tempdir().expect("a temporary directory");
    let point = ["--alpha", "0.3", "--beta", "700", "--f", "20"];
    let json = |words: &[&str]| -> Value {
        let said = say(directory.path(), &[words, &point, &["--json"]].concat());
        serde_json::from_slice(&said.stdout).unwrap_or_else(|_| panic!("{}", err(&said)))
    };
    let (found, solved) = (json(&["evaluate"]), json(&["solve", "--tolerance", "1e-8"]));
    for name in ["mu_drag", "mu_v", "mu_h", "c"] {
        let [found, solved] = [&found[name]["value"], &solved[name]].map(|it| it.as_f64().expect("a number"));
        assert!((found / solved - 1.0).abs() < 1.5e-4, "{name}: {found} {solved}");
    }
    let limits = say(directory.path(), &["evaluate", "--alpha", "inf", "--beta", "1e8", "--f", "0", "--json"]);
    let limits: Value = serde_json::from_slice(&limits.stdout).expect("JSON");
    assert!(limits["mu_v"]["value"].as_f64().expect("a number").abs() < 1e-7);
}
