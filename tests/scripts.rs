//! The Python scripts on results with failed cases, an elastic row (f = 0) and an infinite α: what they say and draw.
//!
//! Needs Python with the packages of `scripts/requirements.txt`; `./scripts/prerequisites --tests` installs them.

use std::path::Path;
use std::process::{Command, Output};

use crate::in_python::{check, file_of_python, run_python};
use crate::synthetic::{ALPHA, BETA, F, SWEEP, case_id, chains, finished, output, publish_as, row};
use stribeck_sweep::store::{CaseEntry, Status};
use stribeck_sweep::{Column, Values};
use tempfile::{TempDir, tempdir};

/// The synthetic results.
fn results() -> TempDir {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    directory
}

/// The synthetic results, each case changed as told.
fn changed(change: impl Fn(&mut CaseEntry)) -> TempDir {
    let directory = tempdir().unwrap();
    let mut store = crate::synthetic::open(directory.path());
    for mut chain in chains(&output()) {
        chain.iter_mut().for_each(&change);
        store.commit(&chain).unwrap();
    }
    crate::synthetic::publish(&mut store).unwrap();
    directory
}

fn script(name: &str, results: &[&Path], options: &[&str]) -> Output {
    let results = results.iter().map(|path| path.to_str().unwrap());
    run_python(&format!("scripts/{name}.py"), &results.chain(options.iter().copied()).collect::<Vec<_>>())
}

/// Runs a script that draws a picture; returns what it says.
fn draws(name: &str, results: &[&Path], options: &[&str]) -> String {
    let directory = tempdir().unwrap();
    let picture = directory.path().join("picture.png");
    let mut options = options.to_vec();
    options.extend(["-o", picture.to_str().unwrap()]);
    let run = script(name, results, &options);
    expect_picture(&run, &picture)
}

/// Returns what a run said that has drawn a picture without a warning: a PNG with more than a few colours.
fn expect_picture(run: &Output, path: &Path) -> String {
    let said = check(run);
    let warnings = String::from_utf8_lossy(&run.stderr);
    assert!(!warnings.contains("Warning"), "{warnings}");
    let bytes = std::fs::read(path).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let size = reader.next_frame(&mut pixels).unwrap();
    assert!(size.width > 800 && size.height > 600, "{} × {} pixels", size.width, size.height);
    let colours: std::collections::HashSet<_> = pixels.chunks_exact(size.color_type.samples()).collect();
    assert!(colours.len() > 50, "only {} colours", colours.len());
    said
}

/// Runs a script on what it cannot work with; returns its message, which must be one for users.
fn refuses(name: &str, results: &[&Path], options: &[&str]) -> String {
    let run = script(name, results, options);
    let message = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(2), "{message}");
    assert!(!message.contains("Traceback"), "{message}");
    message
}

#[test]
fn scripts_run_in_any_directory_by_an_interpreter_of_their_own() {
    let directory = results();
    let mut command = file_of_python("scripts/compare.py");
    let run = command.args([".", ".", "-o", "same.png"]).current_dir(directory.path()).output().unwrap();
    let said = expect_picture(&run, &directory.path().join("same.png"));
    assert!(said.contains("all places that both have are equal") && said.ends_with("wrote same.png\n"), "{said}");
}

#[test]
fn what_is_no_results_directory_is_refused_with_a_remedy() {
    let directory = results();
    let damaged = tempdir().unwrap();
    std::fs::write(damaged.path().join("results.h5"), "not HDF5").unwrap();
    let nowhere = Path::new("nowhere");
    let with = |other, picture| refuses("compare", &[directory.path(), other], &["-o", picture]);
    let message = with(nowhere, "never.png");
    assert!(message.contains("nowhere/results.h5: no such file") && message.contains("stribeck run"), "{message}");
    let message = with(damaged.path(), "never.png");
    assert!(message.contains("not readable") && message.contains("stribeck verify"), "{message}");
    let message = with(directory.path(), "picture.xyz");
    assert!(message.contains("end its name in .png, .pdf or .svg"), "{message}");
    let message = with(directory.path(), "nowhere/picture.png");
    assert!(message.contains("name a file in a directory that exists"), "{message}");
}

#[test]
fn every_script_names_the_packages_that_it_imports() {
    let said = check(&run_python("tests/python/inline_metadata.py", &[]));
    for name in ["compare.py", "audit.py", "fit_film.py", "reference_dry.py"] {
        assert!(said.contains(name), "{name} was not looked at: {said}");
    }
}

#[test]
fn a_sweep_compared_with_itself_is_equal() {
    let directory = results();
    let said = draws("compare", &[directory.path(), directory.path()], &["--tolerance", "1e-15"]);
    for expected in [
        "places: 40 in both, 0 in A alone, 0 in B alone",
        "39 converged in both, 1 failed in both, 0 failed in one alone",
        "sweep file: the same text",
        "all places that both have are equal",
        "within the tolerance",
    ] {
        assert!(said.contains(expected), "{expected} is not in\n{said}");
    }
}

#[test]
fn a_changed_number_and_a_changed_status_are_found() {
    let directory = results();
    let other = changed(|entry| {
        if entry.id == case_id(100.0, 10.0, BETA[1]) {
            entry.values[Column::PMax] *= 1.01;
        } else if entry.id == case_id(100.0, 1.0, BETA[0]) {
            entry.outcome = Status::Failed;
            entry.reason = "made to fail".into();
            entry.values = Values::UNKNOWN;
            entry.fields = Default::default();
        }
    });
    let said = draws("compare", &[directory.path(), other.path()], &["--quantity", "p_max"]);
    assert!(said.contains("1 failed in one alone\n  f = 100, α = 1, β = 10 failed in B: made to fail"), "{said}");
    let line = said.lines().find(|line| line.starts_with("p_max")).unwrap();
    assert!(line.contains(" 38     37 ") && line.ends_with("f = 100, α = 10, β = 31.6228"), "{line}");
    assert!(line.contains(" 1.0e-02 "), "{line}");
    // A failure in one alone is beyond any tolerance.
    let run = script("compare", &[directory.path(), other.path()], &["--tolerance", "0.5"]);
    assert_eq!(run.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&run.stdout).contains("1 case failed in one alone"));
}

#[test]
fn places_that_one_sweep_has_alone_are_listed() {
    let (directory, fewer, table) = (results(), tempdir().unwrap(), tempdir().unwrap());
    let mut store = crate::synthetic::open(fewer.path());
    for chain in chains(&output()) {
        store.commit(&chain).unwrap();
    }
    let some = |i_f: usize, i_alpha: usize| row(i_f, i_alpha)[1..].to_vec();
    publish_as(&mut store, ["fewer β", "other"], [&F, &ALPHA, &BETA[1..]], &some).unwrap();
    let file = table.path().join("all.csv");
    let run = script("compare", &[directory.path(), fewer.path()], &["--csv", file.to_str().unwrap()]);
    let said = check(&run);
    assert!(said.contains("32 in both, 8 in A alone, 0 in B alone\n  A alone has β = 10\n"), "{said}");
    assert!(said.contains("sweep file: differs"), "{said}");
    let text = std::fs::read_to_string(file).unwrap();
    assert_eq!(text.lines().count(), 1 + 40);
    assert_eq!(text.lines().filter(|line| line.contains(",10.0,A,converged,,")).count(), 8, "{text}");
    let disjoint = tempdir().unwrap();
    let mut store = crate::synthetic::open(disjoint.path());
    for chain in chains(&output()) {
        store.commit(&chain).unwrap();
    }
    let last = |i_f: usize, i_alpha: usize| row(i_f, i_alpha)[..1].to_vec();
    publish_as(&mut store, ["β = 10", SWEEP], [&F, &ALPHA, &BETA[..1]], &last).unwrap();
    let message = refuses("compare", &[fewer.path(), disjoint.path()], &[]);
    assert!(message.contains("no place in common: no value of beta is in both"), "{message}");
}

/// Solves a small sweep to a tolerance.
fn solved(tolerance: &str) -> TempDir {
    solved_as(&format!(
        "title = \"small\"\n[axes]\nf = [0.0, 100.0]\nalpha = [0.1, 1.0, 10.0, inf]\n\
         beta = {{ from = 10.0, to = 300.0, points = 5, scale = \"log\" }}\n\
         [solver]\ntolerance = {tolerance}\n[output]\nfields = []\n"
    ))
}

/// Solves the sweep of a sweep file.
fn solved_as(text: &str) -> TempDir {
    let directory = tempdir().unwrap();
    let sweep = directory.path().join("small.toml");
    std::fs::write(&sweep, text).unwrap();
    let mut run = Command::new(env!("CARGO_BIN_EXE_stribeck"));
    run.arg("run").arg(&sweep).arg("-o").arg(directory.path().join("results")).args(["--quiet", "--threads", "1"]);
    check(&run.output().unwrap());
    directory
}

#[test]
fn two_tolerances_differ_by_what_they_estimate() {
    let (coarse, fine, table) = (solved("1e-4"), solved("1e-7"), tempdir().unwrap());
    let directories = [coarse.path().join("results"), fine.path().join("results")];
    let directories: Vec<&Path> = directories.iter().map(|path| path.as_path()).collect();
    let file = table.path().join("all.csv");
    let options = ["--tolerance", "1e-4", "--csv", file.to_str().unwrap()];
    let said = draws("compare", &directories, &options);
    assert!(said.contains("-tolerance = 1e-4\n  +tolerance = 1e-7"), "{said}");
    assert!(said.contains("40 converged in both") && !said.contains("are equal"), "{said}");
    assert_eq!(script("compare", &directories, &["--tolerance", "1e-12"]).status.code(), Some(1));

    let mut reader = csv::Reader::from_path(file).unwrap();
    let names = reader.headers().unwrap().clone();
    let column = |name: String| names.iter().position(|header| header == name).unwrap();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 40);
    let (mut judged, mut differing) = (0, 0);
    for quantity in ["mu_v", "mu_h", "mu_tot", "c"] {
        let pair = [column(format!("difference_{quantity}")), column(format!("estimate_{quantity}"))];
        for row in &rows {
            let [difference, estimate] = pair.map(|index| row[index].parse::<f64>().unwrap());
            differing += usize::from(difference > 0.0);
            // An estimate is no bound: far below the tolerance it may be too small by orders of magnitude.
            if estimate > 1e-6 {
                assert!(difference < 1.5 * estimate, "{quantity}: {difference} beside {estimate}");
                judged += 1;
            }
            assert!(difference < 1e-4, "{quantity}: {difference}");
        }
    }
    assert!(judged > 5 && differing > 60, "{judged} judged, {differing} differ");
}

#[test]
fn an_audit_explains_what_was_solved_and_finds_a_pressure_that_was_changed() {
    let directory = solved_as(
        "title = \"small\"\n[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 30.0]\n\
         [output]\nx = { from = -3.0, to = 3.0, points = 301 }\n",
    );
    let results = directory.path().join("results");
    let said = check(&script("audit", &[results.as_path()], &[]));
    assert!(said.contains("2 cases audited") && said.contains("every deviation is explained"), "{said}");

    let file = results.join("results.h5");
    check(&run_python("tests/python/scale_pressure.py", &[file.to_str().unwrap(), "1.001"]));
    let run = script("audit", &[results.as_path()], &[]);
    let said = String::from_utf8_lossy(&run.stdout);
    assert_eq!(run.status.code(), Some(1), "{said}");
    for quantity in ["load", "film", "flow", "mu_drag", "energy"] {
        assert!(said.contains(&format!("not explained: {quantity} deviates")), "{quantity} in {said}");
    }
    let mut lines = said.lines().filter(|line| line.starts_with("not explained"));
    assert!(lines.all(|line| line.ends_with("beta = 30")), "the case that was not changed is explained: {said}");
}

#[test]
fn an_audit_needs_pressure_and_film() {
    let directory = solved("1e-2");
    let message = refuses("audit", &[directory.path().join("results").as_path()], &[]);
    assert!(message.contains("no pressure or no film_thickness") && message.contains("output.fields"), "{message}");
}

#[test]
fn another_method_agrees_within_its_own_error() {
    let options = ["--stribeck", env!("CARGO_BIN_EXE_stribeck"), "--case", "1,100,10", "--points", "48"];
    let said = check(&script("second_opinion", &[], &options));
    assert!(said.contains("all differences are below the errors") && said.lines().count() == 7, "{said}");
}
