//! Numbers of points that keep what a sweep has: what `plan` and `run` say of them is true.

use std::fs;
use std::path::Path;

use tempfile::tempdir;

use crate::program::{err, out, say};

fn sweep(points: &str) -> String {
    format!(
        "title = \"Refined\"\n[axes]\nf = [10.0]\nalpha = [1.0]\n{points}\n[solver]\ntolerance = 1e-3\n\
         [output]\nfields = []\n"
    )
}

fn beta(points: usize, to: f64, scale: &str) -> String {
    sweep(&format!("beta = {{ from = 10.0, to = {to:?}, points = {points}, scale = \"{scale}\" }}"))
}

/// What `plan` says of refining, line by line.
fn told(directory: &Path, text: &str) -> Vec<String> {
    fs::write(directory.join("sweep.toml"), text).expect("written");
    let said = out(&say(directory, &["plan", "sweep.toml", "-o", "results"]));
    said.lines().filter_map(|line| line.strip_prefix("refine")).map(|line| line.trim().to_owned()).collect()
}

fn run(directory: &Path, text: &str) -> (String, String) {
    fs::write(directory.join("sweep.toml"), text).expect("written");
    let said = say(directory, &["run", "sweep.toml", "-o", "results", "--quiet", "--threads", "1"]);
    (out(&said), err(&said))
}

#[test]
fn the_numbers_of_points_that_are_named_keep_all_cases() {
    for scale in ["log", "linear"] {
        let directory = tempdir().expect("a temporary directory");
        run(directory.path(), &beta(4, 1000.0, scale));
        // 3 intervals: 6 and 9 of them hold the points before, 7 do not.
        let lines = [
            "7 points of beta keep all 4 cases of the sweep before",
            "10 points of beta keep all 4 cases of the sweep before",
        ];
        assert_eq!(told(directory.path(), &beta(8, 1000.0, scale)), lines, "{scale}");
        for (points, found) in [(7, 0), (10, 0)] {
            assert_eq!(
                told(directory.path(), &beta(points, 1000.0, scale)).len(),
                found,
                "{points} keep all themselves"
            );
        }
        let (said, _) = run(directory.path(), &beta(7, 1000.0, scale));
        assert!(said.contains("solved 3 cases (4 more were there already)"), "{said}");
        let (said, noted) = run(directory.path(), &beta(9, 1000.0, scale));
        assert!(noted.contains("note: 13 points of beta keep all 7 cases of it"), "{noted}");
        assert!(!said.contains("(7 more were there already)"), "{said}");
    }
}

#[test]
fn nothing_is_said_where_it_would_not_be_true() {
    let directory = tempdir().expect("a temporary directory");
    run(directory.path(), &beta(4, 1000.0, "log"));
    let nothing: Vec<String> = Vec::new();
    let tighter = beta(6, 1000.0, "log").replace("1e-3", "1e-4");
    let list = sweep("beta = [10.0, 20.0, 50.0, 100.0, 1000.0]");
    for other in [beta(6, 2000.0, "log"), beta(6, 1000.0, "linear"), beta(3, 1000.0, "log"), tighter, list] {
        assert_eq!(told(directory.path(), &other), nothing, "{other}");
    }
}

/// Two axes at once, and quantities of the laboratory.
#[test]
fn several_axes_are_refined_together() {
    let laboratory = |loads: usize, speeds: usize| {
        format!(
            "[laboratory]\nradius = \"10 mm\"\nload = {{ from = \"100 N/m\", to = \"400 N/m\", points = {loads} }}\n\
             relaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\nviscosity = \"0.1 Pa s\"\nretardation_time = \"20 ms\"\n\
             f = 3.0\nspeed = {{ from = \"10 mm/s\", to = \"1 m/s\", points = {speeds}, scale = \"log\" }}\n\
             [solver]\ntolerance = 1e-3\n[output]\nfields = []\n"
        )
    };
    let directory = tempdir().expect("a temporary directory");
    run(directory.path(), &laboratory(2, 3));
    let lines = told(directory.path(), &laboratory(3, 4));
    assert_eq!(
        lines,
        [
            "3 points of speed keep all 6 cases of the sweep before",
            "5 points of speed keep all 6 cases of the sweep before"
        ]
    );
    let (said, _) = run(directory.path(), &laboratory(3, 5));
    assert!(said.contains("(6 more were there already)"), "{said}");
}
