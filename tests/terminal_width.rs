//! What commands print fits a terminal of 80 columns; paths, ids and commands to copy may be longer.

use std::fs;
use std::path::Path;

use crate::in_python::root;
use crate::program::{stribeck, with_results};

const LABORATORY: &str = "[laboratory]\nradius = \"10 mm\"\nload = [\"200 N/m\", \"400 N/m\"]\nrelaxed_modulus = \"1 MPa\"\n\
                          poisson_ratio = 0.5\nviscosity = \"0.1 Pa s\"\nretardation_time = \"20 ms\"\nf = 3.0\n\
                          entrainment_speed = { from = \"0.1 mm/s\", to = \"1 m/s\", points = 9, scale = \"log\" }\n\
                          slide_roll_ratio = 0.5\n[solver]\ntolerance = 1e-3\n";

const SURFACE: &str = "[axes]\nalpha = { from = 0.5, to = 2.0, scale = \"log\" }\nbeta = [100.0]\nf = [10.0]\n\
                       [surface]\ntolerance = 1e-2\n";

const STUDY: &str = "[[case]]\nalpha = 1.0\nbeta = 100.0\nf = 10.0\n[[method]]\nmethod = \"collocation\"\n\
                     tolerance = [1e-3, 1e-4]\n[[method]]\nmethod = \"relaxation\"\npoints = 201\n";

/// Words that may be longer than a line: paths, and what stands in a command.
fn may_be_long(line: &str) -> bool {
    let is_command = line.trim_start().starts_with("stribeck ") || line.starts_with("  alone ");
    // An inline table of TOML stands in one line.
    let is_copied = is_command || line.starts_with("shift = {");
    let longest = line.split_whitespace().map(|word| word.chars().count()).max().unwrap_or(0);
    is_copied || longest > 60
}

/// The lines of a command's output that are too long.
fn too_long(directory: &Path, arguments: &[&str]) -> Vec<String> {
    let run = stribeck(directory).args(arguments).env("COLUMNS", "80").output().expect("the program starts");
    assert!(matches!(run.status.code(), Some(0 | 3)), "{arguments:?}: {}", String::from_utf8_lossy(&run.stderr));
    let text = String::from_utf8(run.stdout).expect("text");
    assert!(!text.is_empty(), "{arguments:?}");
    let long = text.lines().filter(|line| line.chars().count() > 80 && !may_be_long(line));
    long.map(|line| format!("{}: {line}", arguments.join(" "))).collect()
}

#[test]
fn what_commands_print_fits_eighty_columns() {
    let directory = with_results(
        "title = \"A sweep with a rather long title, which says what it is about in a few words\"\n[axes]\n\
         f = [0.0, 100.0]\nalpha = [0.1, 1.0]\nbeta = { from = 10.0, to = 1e4, points = 4, scale = \"log\" }\n\
         [solver]\ntolerance = 1e-3\n",
    );
    let home = directory.path();
    for (file, text) in [("lab.toml", LABORATORY), ("surface.toml", SURFACE), ("study.toml", STUDY)] {
        fs::write(home.join(file), text).expect("written");
    }
    let files = root().join("docs/how-to/instrument-files");
    for file in fs::read_dir(&files).expect("listed").map(|entry| entry.expect("listed").path()) {
        fs::copy(&file, home.join(file.file_name().expect("a name"))).expect("copied");
    }
    let commands: &[&[&str]] = &[
        &["run", "small.toml", "--quiet"],
        &["plan", "small.toml"],
        &["plan", "lab.toml"],
        &["run", "lab.toml", "--quiet"],
        &["plan", "lab.toml"],
        &["status", "results/small"],
        &["status", "results/lab"],
        &["explain", "results/small", "100,1,100"],
        &["explain", "results/small", "0,1,100"],
        &["explain", "results/lab", "load=200 N/m,entrainment_speed=0.1", "--stored"],
        &["solve", "--alpha", "1", "--beta", "100", "--f", "10", "--sensitivities"],
        &["solve", "--alpha", "1e-3", "--beta", "1e6", "--f", "1e5", "--tolerance", "1e-8"],
        &["solve", "--alpha", "1", "--beta", "100", "--f", "10", "--method", "relaxation", "--points", "201"],
        &["solve", "--laboratory", "lab.toml", "--at", "load=200 N/m,entrainment_speed=3 mm/s"],
        &["curve", "lab.toml", "--at", "load=200"],
        &["curve", "experiment.toml", "--at", "slide_roll_ratio=1", "--measured", "traction.txt"],
        &["fit", "traction.txt", "experiment.toml", "--unknown", "viscosity,retardation_time"],
        &["material", "moduli.csv"],
        &["material", "isotherms.csv", "--reference-temperature", "20 degC"],
        &["surface", "surface.toml", "--quiet"],
        &["status", "results/surface"],
        &["evaluate", "results/surface/surface.json", "--alpha", "1", "--derivatives"],
        &["study", "study.toml", "--quiet"],
    ];
    let long: Vec<String> = commands.iter().flat_map(|arguments| too_long(home, arguments)).collect();
    assert!(long.is_empty(), "{}", long.join("\n"));
}
