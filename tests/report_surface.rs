//! `stribeck report` of a surface from outside: the page holds the surface, and in a browser friction moves as it says.

use std::fs;
use std::path::Path;

use assert_cmd::cargo::cargo_bin;
use stribeck::report::surface_page;
use stribeck::universe::universe;
use tempfile::{TempDir, tempdir};

use crate::in_python::{check, file_of_python};
use crate::program::{code, err, out, say};

/// Over two axes, from limit to limit of one.
const PLANE: &str = r#"
title = "Plane </script> {{sweep}}"
[axes]
alpha = { from = 0.0, to = inf }
beta = { from = 10.0, to = 1000.0, scale = "log" }
f = [10.0]
[surface]
tolerance = 1e-3
"#;

/// Along a speed. As a sweep it has 9 cases.
const LINE: &str = r#"
[laboratory]
radius = "2 mm"
relaxed_modulus = "10 MPa"
poisson_ratio = 0.5
viscosity = "1 Pa s"
retardation_time = "20 ms"
f = 10.0
load = "100 N/m"
speed = { from = "0.1 mm/s", to = "100 mm/s", points = 9, scale = "log" }
[output]
fields = []
[surface]
tolerance = 1e-3
"#;

/// A directory with a surface in `s/surface.json`; its sweep file is `s.toml`.
fn with_surface(sweep: &str) -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("s.toml"), sweep).expect("written");
    expect_done(directory.path(), &["surface", "s.toml", "-o", "s", "--quiet"]);
    directory
}

/// Runs the program, which must succeed.
#[track_caller]
fn expect_done(directory: &Path, arguments: &[&str]) {
    let said = say(directory, arguments);
    assert_eq!(code(&said), 0, "{arguments:?}: {}", err(&said));
}

/// What only pages with a surface have: their section, their style, their numbers, and their scripts.
const OWN: [&str; 4] = ["<section id=\"live\"", "#live-body {", "id=\"surface-file\"", "readSurface"];

#[test]
fn a_page_has_a_surface_where_its_directory_has_one() {
    let directory = with_surface(LINE);
    let here = directory.path();
    let page = || {
        expect_done(here, &["report", "s"]);
        fs::read_to_string(here.join("s/report.html")).expect("read")
    };
    let has = |page: &str, words: &[&str]| words.iter().map(|words| page.contains(words)).collect::<Vec<_>>();
    let of_sweep = ["<section id=\"cases\"", "id=\"contents\"", "<div class=\"first\""];
    let alone = page();
    assert_eq!((has(&alone, &OWN), has(&alone, &of_sweep)), (vec![true; 4], vec![false; 3]));
    expect_done(here, &["run", "s.toml", "-o", "s", "--quiet"]);
    let both = page();
    assert_eq!((has(&both, &OWN), has(&both, &of_sweep)), (vec![true; 4], vec![true; 3]));
    assert!(both == page(), "the same bytes");
    assert!(!both.contains("another sweep file"));
    let elsewhere = fs::read_to_string(here.join("s/surface.json")).expect("read");
    fs::write(here.join("s/surface.json"), elsewhere.replace("radius = \\\"2 mm", "radius = \\\"3 mm"))
        .expect("written");
    assert!(page().contains("The surface was made from another sweep file"));
    fs::remove_file(here.join("s/surface.json")).expect("removed");
    let without = page();
    assert_eq!((has(&without, &OWN), has(&without, &of_sweep)), (vec![false; 4], vec![true; 3]));
    assert!(!without.contains("live-"), "no byte of it");
}

/// The surface that is built in is the largest that is shipped.
#[test]
fn a_surface_takes_less_than_a_megabyte_of_a_page() {
    let surface = universe();
    let page = surface_page(&surface).html;
    let (_, file) = page.split_once("id=\"surface-file\">").expect("the surface");
    let file = file.split_once("</script>").expect("its end").0;
    assert!(file.len() < 1_000_000, "{} bytes", file.len());
    assert!(stribeck_surface::Surface::parse(file).expect("a surface") == surface, "all its numbers");
}

#[test]
fn a_damaged_or_foreign_surface_has_no_page() {
    let directory = with_surface(LINE);
    let here = directory.path();
    let file = here.join("s/surface.json");
    let good = fs::read_to_string(&file).expect("read");
    let refused = |text: &str, expected: &str| {
        fs::write(&file, text).expect("written");
        let said = say(here, &["report", "s"]);
        assert_eq!(code(&said), 2, "{}", err(&said));
        assert!(err(&said).contains("s/surface.json: ") && err(&said).contains(expected), "{}", err(&said));
        assert!(!here.join("s/report.html").exists());
    };
    let (before, after) = good.split_once("\"values\": [").expect("a check point");
    let damaged = format!("{before}\"values\": [1{}", after.trim_start());
    refused(&damaged, "mu_drag at check point 1 is");
    refused("{\"mine\": 1}", "not a surface: missing field");
    refused(&good.replace("stribeck surface 1", "stribeck surface 9"), "the format is `stribeck surface 9`");
    // Beside results too.
    expect_done(here, &["run", "s.toml", "-o", "s", "--quiet"]);
    refused(&damaged, "the file is damaged, make it again with `stribeck surface`");
    fs::remove_file(here.join("s/results.h5")).expect("removed");
    fs::write(&file, good).expect("written");
    fs::write(here.join("m.csv"), "speed (mm/s),mu\n1,0.1\n").expect("written");
    let said = say(here, &["report", "s", "--measured", "m.csv"]);
    assert_eq!(code(&said), 2);
    assert!(err(&said).contains("--measured would change nothing"), "{}", err(&said));
    expect_done(here, &["report", "s/surface.json", "-o", "page.html"]);
    let said = say(here, &["report", "s", "-o", "s/surface.json"]);
    assert!(code(&said) == 2 && err(&said).contains("which this command reads"), "{}", err(&said));
    assert!(!out(&said).contains("page"));
}

/// Sliders, written values, curves and cuts have the numbers of `stribeck evaluate`; a surface alone, and one beside
/// results, whose first picture is seen as soon as without it.
#[test]
#[ignore = "slow: a browser draws pictures without a graphics processor"]
fn friction_moves_in_the_page_as_the_surface_says() {
    let directories = [PLANE, LINE].map(with_surface);
    expect_done(directories[1].path(), &["run", "s.toml", "-o", "s", "--quiet"]);
    let mut command = file_of_python("tests/python/browse_surface.py");
    command.arg(cargo_bin("stribeck"));
    for directory in &directories {
        expect_done(directory.path(), &["report", "s"]);
        command.args(["report.html", "surface.json"].map(|name| directory.path().join("s").join(name)));
    }
    let said = check(&command.output().expect("Python starts"));
    assert_eq!(said.matches("friction moves as the surface says").count(), directories.len(), "{said}");
    let mut command = file_of_python("tests/python/first_picture.py");
    check(&command.arg(directories[1].path().join("s/report.html")).output().expect("Python starts"));
}
