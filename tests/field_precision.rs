//! Fields of single precision: how far they are from those of double precision, their size, and what happens when a
//! sweep changes from one to the other.

use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::program::{code, err, out, say, with_results};
use stribeck_sweep::Field;
use stribeck_sweep::store::DataSet;

const SWEEP: &str = "\
title = \"Rounded\"
[axes]
f = [10.0]
alpha = [1.0, 10.0]
beta = { from = 10.0, to = 100.0, points = 6, scale = \"log\" }
[output]
x = { from = -2.0, to = 2.0, points = 601 }
";

/// A roller that may turn, in SI units.
const LABORATORY: &str = "\
title = \"Rounded\"
[laboratory]
radius = \"2 mm\"
load = 119.0
relaxed_modulus = 1e5
poisson_ratio = 0.0
viscosity = \"5.1 Pa s\"
retardation_time = \"20 ms\"
entrainment_speed = [5e-5, 5e-4, 5e-3]
slide_roll_ratio = [0.0, 2.0]
f = 10.0
[output]
x = { from = -2.0, to = 2.0, points = 601 }
";

const SINGLE: &str = "field_precision = \"single\"\n";

/// Runs a sweep into `out` and returns what the program says.
fn run(directory: &Path, sweep: &str, more: &[&str]) -> String {
    fs::write(directory.join("sweep.toml"), sweep).expect("written");
    let said = say(directory, &[&["run", "sweep.toml", "-o", "out", "--quiet", "--threads", "1"], more].concat());
    assert_eq!(code(&said), 0, "{}", err(&said));
    out(&said)
}

fn plan(directory: &Path, sweep: &str) -> String {
    fs::write(directory.join("sweep.toml"), sweep).expect("written");
    out(&say(directory, &["plan", "sweep.toml", "-o", "out"]))
}

fn bytes(results: &Path) -> [Vec<u8>; 2] {
    ["summary.csv", "results.h5"].map(|name| fs::read(results.join(name)).expect("published"))
}

/// The largest difference of two publications of a field, over the number itself and over the largest of its case.
fn differences(field: Field, [exact, found]: [&DataSet; 2]) -> (f64, f64) {
    let (mut of_number, mut of_case) = (0.0_f64, 0.0_f64);
    for place in 0..exact.shape().places() {
        let index = exact.shape().index(place);
        let [exact, found] = [exact, found].map(|data| data.field(field, index).expect("a field"));
        let largest = exact.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        for (exact, found) in exact.into_iter().zip(found).filter(|(exact, found)| exact != found) {
            let difference = (found - exact).abs();
            of_number = of_number.max(difference / exact.abs());
            of_case = of_case.max(difference / largest);
        }
    }
    (of_number, of_case)
}

#[test]
fn rounded_fields_are_near_the_others_and_smaller() {
    let unit = 2.0_f64.powi(-24);
    for (sweep, in_si) in [(SWEEP, false), (LABORATORY, true)] {
        let [double, single] = [sweep.to_owned(), format!("{sweep}{SINGLE}")].map(|sweep| with_results(&sweep));
        let homes = [&double, &single].map(|directory| directory.path().join("results/small"));
        let [double, single] = [&homes[0], &homes[1]].map(|home| bytes(home));
        assert!(double[0] == single[0], "summary.csv differs");
        assert!(single[1].len() < 3 * double[1].len() / 4, "{} of {} bytes", single[1].len(), double[1].len());
        let [double, single] = [&homes[0], &homes[1]].map(|home| DataSet::open(home).expect("published"));
        for field in Field::ALL {
            let (of_number, of_case) = differences(field, [&double, &single]);
            assert!(of_case > 0.0, "{} is rounded", field.name());
            match (in_si, field) {
                (false, _) => assert!(of_number <= unit, "{}: {of_number:e}", field.name()),
                // It follows from the film, with what cancels in it.
                (true, Field::ShearTraction) => assert!(of_case <= 16.0 * unit, "{}: {of_case:e}", field.name()),
                (true, _) => assert!(of_number <= 2.01 * unit, "{}: {of_number:e}", field.name()),
            }
        }
    }
}

#[test]
fn a_sweep_goes_from_double_to_single_without_solving_and_not_back() {
    let single = format!("{SWEEP}{SINGLE}");
    let [once_double, once_single, there, back] = [(); 4].map(|()| tempdir().expect("a temporary directory"));
    run(once_double.path(), SWEEP, &[]);
    run(once_single.path(), &single, &[]);
    let [double_bytes, single_bytes] = [&once_double, &once_single].map(|home| bytes(&home.path().join("out")));

    run(there.path(), SWEEP, &[]);
    assert!(plan(there.path(), &single).contains("12 reused, 0 new"));
    run(there.path(), &single, &[]);
    assert!(bytes(&there.path().join("out")) == single_bytes);

    run(back.path(), &single, &[]);
    let planned = plan(back.path(), SWEEP);
    assert!(planned.contains("0 reused, 0 new, 12 stale"), "{planned}");
    assert!(planned.contains("12: stored without fields of double precision"), "{planned}");
    assert!(run(back.path(), SWEEP, &[]).contains("solved 12 cases"));
    assert!(bytes(&back.path().join("out")) == double_bytes);
    assert!(plan(back.path(), &single).contains("12 reused, 0 new"), "double fields serve both");
    for home in [&there, &back] {
        assert_eq!(code(&say(home.path(), &["verify", "out"])), 0);
        let told = out(&say(home.path(), &["explain", "out", "10,1,10"]));
        assert!(told.contains("converged"), "{told}");
    }
}

/// As with parts of two x: they are no one sweep, and a run of the whole takes from them what it can.
#[test]
fn parts_of_two_precisions_are_not_merged() {
    let single = format!("{SWEEP}{SINGLE}");
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    run(here, &single, &["--part", "1/2"]);
    run(here, SWEEP, &["--part", "2/2"]);
    let merged = say(here, &["merge", "out"]);
    assert_ne!(code(&merged), 0);
    assert!(err(&merged).contains("part"), "{}", err(&merged));
    let said = run(here, SWEEP, &[]);
    assert!(said.contains("solved 6 cases (6 more were there already)"), "{said}");
    let alone = tempdir().expect("a temporary directory");
    run(alone.path(), SWEEP, &[]);
    assert!(bytes(&here.join("out")) == bytes(&alone.path().join("out")));
}
