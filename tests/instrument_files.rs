//! The worked example of `docs/how-to/from-instrument-files.md`: what both files were made of is found again.

use std::fs;
use std::path::{Path, PathBuf};

use crate::program::{code, err, out, say};
use serde_json::Value;
use tempfile::tempdir;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/how-to/instrument-files").join(name)
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path of text")
}

/// The lines that `material` prints are those of the sweep file, and the moduli are those of three terms: 3 MPa at rest
/// and 6 MPa at once.
#[test]
fn the_material_of_the_moduli_stands_in_the_sweep_file() {
    let directory = tempdir().expect("a temporary directory");
    let printed = say(directory.path(), &["material", text(&file("moduli.csv"))]);
    assert_eq!(code(&printed), 0, "{}", err(&printed));
    let sweep = fs::read_to_string(file("experiment.toml")).expect("read");
    let printed = out(&printed);
    let lines = printed.lines().skip_while(|line| *line != "[substrate]").skip(1);
    for line in lines.filter(|line| !line.is_empty()) {
        assert!(sweep.contains(line), "{line} is not in experiment.toml:\n{sweep}");
    }
    let json = say(directory.path(), &["material", text(&file("moduli.csv")), "--json"]);
    let found: Value = serde_json::from_str(&out(&json)).expect("JSON");
    let number = |name: &str| found[name].as_f64().unwrap_or_else(|| panic!("{name} in {found}"));
    for (name, truth) in [("relaxed_modulus", 3e6), ("instantaneous_modulus", 6e6)] {
        assert!((number(name) / truth - 1.0).abs() < 0.01, "{name}: {}", number(name));
    }
}

/// Viscosity (80 mPa s) and the times of the rubber come back within their standard errors.
#[test]
fn friction_and_moduli_give_the_viscosity_back() {
    let directory = tempdir().expect("a temporary directory");
    let (traction, experiment) = (file("traction.txt"), file("experiment.toml"));
    let fit = ["fit", text(&traction), text(&experiment), "--json"];
    let fitted = say(directory.path(), &[&fit[..], &["--unknown", "viscosity,retardation_time"]].concat());
    assert_eq!(code(&fitted), 0, "{}", err(&fitted));
    let said = err(&fitted);
    assert!(said.contains("`SRR (%)` as slide_roll_ratio") && said.contains("18 points"), "{said}");
    let found: Value = serde_json::from_str(&out(&fitted)).expect("JSON");
    let unknown = |name: &str| {
        let all = found["estimates"].as_array().expect("a list");
        let one = all.iter().find(|unknown| unknown["unknown"] == name).expect(name);
        let number = |key: &str| one[key].as_f64().unwrap_or_else(|| panic!("{key} in {one}"));
        [number("value"), number("standard_error"), number("start")]
    };
    let [viscosity, error, _] = unknown("viscosity");
    assert!((viscosity - 0.08).abs() < 3.0 * error && error < 0.002, "{viscosity} ± {error}");
    let [time, error, of_moduli] = unknown("retardation_time");
    assert!((time - of_moduli).abs() < 3.0 * error && error < 0.05 * time, "{time} ± {error}, {of_moduli}");
}
