//! The tables that the program writes are measured points for each command that takes some.

use std::fs;
use std::path::Path;

use crate::program::{code, err, out, say};
use serde_json::Value;
use tempfile::tempdir;

const SWEEP: &str = "[laboratory]\nradius = \"2 mm\"\nload = 119.0\nrelaxed_modulus = \"100 kPa\"\npoisson_ratio = 0.5\n\
                     viscosity = \"5.1 Pa s\"\nretardation_time = \"20 ms\"\nspeed = [1e-3, 1e-2, 1e-1]\nf = 10.0\n\
                     [output]\nfields = []\n";
const TABLES: [&str; 3] = ["results/sweep/summary.csv", "curve.csv", "fitted/fit.csv"];

/// Runs the program, which must end well, and returns what it said on both streams.
fn ends_well(directory: &Path, arguments: &[&str]) -> String {
    let said = say(directory, arguments);
    assert_eq!(code(&said), 0, "{arguments:?}: {}", err(&said));
    out(&said) + &err(&said)
}

/// A directory with all three tables, of the same experiment.
fn with_tables() -> tempfile::TempDir {
    let directory = tempdir().expect("a temporary directory");
    let path = directory.path();
    fs::write(path.join("sweep.toml"), SWEEP).expect("written");
    fs::write(path.join("start.toml"), SWEEP.replace("5.1 Pa s", "4 Pa s")).expect("written");
    ends_well(path, &["run", "sweep.toml", "--quiet"]);
    ends_well(path, &["curve", "sweep.toml", "--csv", "curve.csv"]);
    ends_well(path, &["fit", "curve.csv", "start.toml", "--unknown", "viscosity", "-o", "fitted"]);
    directory
}

/// Each is fitted by what it was computed with.
#[test]
fn own_tables_are_fitted() {
    let directory = with_tables();
    for table in TABLES {
        let said = say(directory.path(), &["fit", table, "start.toml", "--unknown", "viscosity", "--json"]);
        assert_eq!(code(&said), 0, "{table}: {}", err(&said));
        let json: Value = serde_json::from_str(&out(&said)).expect("JSON");
        let viscosity = json["estimates"][0]["value"].as_f64().expect("a number");
        assert!((viscosity / 5.1 - 1.0).abs() < 1e-4, "{table}: {json}");
        assert_eq!(json["points"].as_array().expect("a list").len(), 3, "{table}");
    }
}

/// Each is laid over the curve that it came from, in the terminal, in pictures and in the page.
#[test]
fn own_tables_are_laid_over_curves() {
    let directory = with_tables();
    let path = directory.path();
    for table in TABLES {
        let said = ends_well(path, &["curve", "sweep.toml", "--measured", table]);
        assert!(said.contains("crosses: measured") && said.contains("; 3 rows"), "{table}: {said}");
        let drag = ["--what", "curves", "--of", "mu_drag", "--along", "speed", "-o", "figures"];
        let said = ends_well(path, &[&["plot", "results/sweep", "--measured", table][..], &drag].concat());
        assert!(!said.contains("no point"), "{table}: {said}");
        let drawn = fs::read_to_string(path.join("figures/mu_drag-along-speed.csv")).expect("a table of the picture");
        let measured = drawn.lines().filter(|line| line.contains(",measured,")).count();
        assert_eq!(measured, 3, "{table}: {drawn}");
        let said = ends_well(path, &["report", "results/sweep", "--measured", table, "-o", "page.html"]);
        assert!(!said.contains("point belongs") && !said.contains("No measured points"), "{table}: {said}");
        fs::remove_file(path.join("page.html")).expect("the page");
    }
}
