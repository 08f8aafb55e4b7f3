//! `solve` for cases of the laboratory, and the fields of a case in a file.

use std::fs;
use std::path::Path;

use serde_json::Value;
use stribeck_sweep::Field;
use stribeck_sweep::store::DataSet;
use tempfile::tempdir;

use crate::program::{code, err, out, say};

const SWEEP: &str = "[laboratory]\nradius = \"10 mm\"\nload = [\"200 N/m\", \"400 N/m\"]\nrelaxed_modulus = \"1 MPa\"\n\
                     poisson_ratio = 0.5\nviscosity = \"0.1 Pa s\"\nretardation_time = \"20 ms\"\nf = 3.0\n\
                     entrainment_speed = [\"3 mm/s\", \"30 mm/s\"]\nslide_roll_ratio = [0.5, 1.0]\n[solver]\n\
                     tolerance = 1e-6\n[output]\nx = { from = -2.0, to = 2.0, points = 41 }\n\
                     fields = [\"pressure\", \"film_thickness\", \"displacement\", \"shear_traction\", \"hysteresis_traction\"]\n";

fn json(directory: &Path, arguments: &[&str]) -> Value {
    let said = say(directory, &[&["solve", "--json"], arguments].concat());
    assert_eq!(code(&said), 0, "{}", err(&said));
    serde_json::from_str(&out(&said)).expect("JSON")
}

/// A case by its quantities is the case of the sweep at that place, in SI units, and so are its fields.
#[test]
fn a_case_of_the_laboratory_is_that_of_the_sweep() {
    let directory = tempdir().expect("a temporary directory");
    let home = directory.path();
    fs::write(home.join("lab.toml"), SWEEP).expect("written");
    assert_eq!(code(&say(home, &["run", "lab.toml", "-o", "results", "--quiet"])), 0);
    let at = "entrainment_speed=30 mm/s,slide_roll_ratio=50 %,load=\"200 N/m\"";
    let solved = json(home, &["--laboratory", "lab.toml", "--at", at, "--fields", "fields.csv"]);
    json(home, &["--laboratory", "lab.toml", "--at", at, "--fields", "fields.h5"]);
    let data = DataSet::open(&home.join("results")).expect("published");
    // f, load, slide_roll_ratio, entrainment_speed
    let index = [0, 0, 1];
    let place = data.place(index);
    for name in ["mu_drag", "mu_v", "film_min", "p_max"] {
        let expected = data.variable(name).expect("a column")[place];
        let found = solved[name].as_f64().expect("a number");
        assert!((found - expected).abs() <= 1e-5 * expected.abs(), "{name}: {found:e}, {expected:e}");
    }
    assert_eq!((solved["load"].as_f64(), solved["entrainment_speed"].as_f64()), (Some(200.0), Some(0.03)));
    let table = fs::read_to_string(home.join("fields.csv")).expect("written");
    let header =
        "x (a0),x (m),pressure (Pa),film_thickness (m),displacement (m),shear_traction (Pa),hysteresis_traction (Pa)";
    assert_eq!(table.lines().next(), Some(header));
    let rows: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 41);
    for (column, field) in Field::ALL.into_iter().enumerate() {
        let expected = data.field(field, index).expect("a field");
        let scale = expected.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        for (row, expected) in rows.iter().zip(&expected) {
            let found = row[column + 2];
            assert!((found - expected).abs() <= 1e-4 * scale, "{}: {found:e}, {expected:e}", field.name());
        }
    }
    let a0 = data.variable("a0").expect("a scale")[place];
    assert!(rows.iter().all(|row| (row[1] - row[0] * a0).abs() <= 1e-12 * a0));
    // The same numbers as HDF5, as a run of this case alone publishes them.
    fs::create_dir(home.join("alone")).expect("made");
    fs::copy(home.join("fields.h5"), home.join("alone/results.h5")).expect("copied");
    let alone = DataSet::open(&home.join("alone")).expect("a data set");
    for (column, field) in Field::ALL.into_iter().enumerate() {
        let values = alone.field(field, [0, 0, 0]).expect("a field");
        assert!(rows.iter().zip(values).all(|(row, value)| row[column + 2] == value), "{}", field.name());
    }
}

#[test]
fn fields_of_dimensionless_cases_have_their_units() {
    let directory = tempdir().expect("a temporary directory");
    let case = ["--alpha", "1", "--beta", "100", "--f", "10"];
    let solved = json(directory.path(), &[&case[..], &["--fields", "fields.csv"]].concat());
    let table = fs::read_to_string(directory.path().join("fields.csv")).expect("written");
    let header = "x (a0),pressure (2N/(pi a0)),film_thickness (a0^2/R),displacement (a0^2/R),shear_traction (N/R),\
                  hysteresis_traction (N/R)";
    assert_eq!(table.lines().next(), Some(header));
    let pressure = table.lines().skip(1).map(|line| line.split(',').nth(1).unwrap().parse::<f64>().expect("a number"));
    let largest = pressure.fold(0.0, f64::max);
    let p_max = solved["p_max"].as_f64().expect("a number");
    assert!(largest <= p_max && largest > 0.98 * p_max, "{largest}, {p_max}");
}

#[test]
fn what_is_missing_or_out_of_place_is_told() {
    let directory = tempdir().expect("a temporary directory");
    let home = directory.path();
    fs::write(home.join("lab.toml"), SWEEP).expect("written");
    fs::write(home.join("fields.csv"), "not ours").expect("written");
    fs::write(home.join("plain.toml"), "[axes]\nf = 1.0\nalpha = 1.0\nbeta = 10.0\n").expect("written");
    let at = "entrainment_speed=0.01,slide_roll_ratio=0.5";
    let all = format!("{at},load=300");
    for (arguments, status, words) in [
        (vec!["--laboratory", "lab.toml", "--at", at], 2, "load has 2 values in the sweep file, and a case has one"),
        (vec!["--laboratory", "lab.toml", "--at", "load=3 mm"], 2, "a length, not a load per length"),
        (vec!["--laboratory", "lab.toml", "--at", "loda=3"], 2, "a case can be chosen by f, radius, load"),
        (vec!["--laboratory", "plain.toml"], 2, "is dimensionless"),
        (vec!["--laboratory", "lab.toml", "--alpha", "1"], 2, "cannot be used with"),
        (vec!["--at", "load=3"], 2, "required"),
        (vec!["--laboratory", "lab.toml", "--at", &all, "--fields", "fields.txt"], 2, "ends in .csv"),
        (vec!["--laboratory", "lab.toml", "--at", &all, "--fields", "fields.csv"], 4, "has not written"),
    ] {
        let said = say(home, &[&["solve"], &arguments[..]].concat());
        assert_eq!(code(&said), status, "{arguments:?}: {}", err(&said));
        assert!(err(&said).contains(words), "{arguments:?}: {}", err(&said));
    }
    let said =
        say(home, &["solve", "--laboratory", "lab.toml", "--at", "entrainment_speed=100,slide_roll_ratio=0,load=300"]);
    assert!(err(&said).contains("is read as m/s; the sweep has 3 to 30 mm/s; did you mean mm/s?"), "{}", err(&said));
}
