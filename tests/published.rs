//! The published files in the hands of a user: xarray with both of its netCDF engines, and h5dump.
//!
//! Needs Python with the packages of `scripts/requirements.txt` and h5dump; `./scripts/prerequisites` installs both.

mod synthetic;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use stribeck::store::{Publication, Store};
use synthetic::{ALPHA, BETA, F, SWEEP, chains, finished, output, row};
use tempfile::tempdir;

const REMEDY: &str = "run ./scripts/prerequisites, or name a Python that has the packages of scripts/requirements.txt \
                      in STRIBECK_PYTHON";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn python() -> PathBuf {
    let python = std::env::var_os("STRIBECK_PYTHON").map_or_else(|| root().join(".venv/bin/python"), PathBuf::from);
    let imports = Command::new(&python).args(["-c", "import h5netcdf, netCDF4, xarray, pandas, matplotlib"]).output();
    match imports {
        Ok(output) if output.status.success() => python,
        Ok(output) => panic!("{}: {}; {REMEDY}", python.display(), String::from_utf8_lossy(&output.stderr)),
        Err(error) => panic!("{}: {error}; {REMEDY}", python.display()),
    }
}

fn check(output: &Output) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}\n{}", text(&output.stdout), text(&output.stderr));
    text(&output.stdout)
}

fn open_with(engine: &str) {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let script = root().join("tests/python/open_results.py");
    let run = Command::new(python()).arg(script).arg(directory.path()).arg(engine).output().unwrap();
    assert!(check(&run).starts_with(engine));
}

#[test]
fn xarray_opens_results_by_h5netcdf() {
    open_with("h5netcdf");
}

#[test]
fn xarray_opens_results_by_netcdf4() {
    open_with("netcdf4");
}

#[test]
fn h5dump_opens_results_and_shards() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let dump = |file: &Path| {
        let output = Command::new("h5dump").arg("-H").arg("-p").arg(file).output();
        check(&output.unwrap_or_else(|error| panic!("h5dump: {error}; {REMEDY}")))
    };
    let header = dump(&directory.path().join("results.h5"));
    for expected in ["DATASET \"mu_v\"", "DATASET \"pressure\"", "CHUNKED ( 1, 1, 1, 41 )", "SHUFFLE", "DEFLATE"] {
        assert!(header.contains(expected), "{expected} is not in\n{header}");
    }
    for shard in std::fs::read_dir(directory.path().join("shards")).unwrap() {
        assert!(dump(&shard.unwrap().path()).contains("DATASET \"values\""));
    }
}

#[test]
fn a_sweep_file_of_any_length_is_kept_in_the_results() {
    let directory = tempdir().unwrap();
    let long = format!("{SWEEP}# {}\n", "α ".repeat(60_000));
    let mut store = Store::open(directory.path(), &long, &output()).unwrap();
    for chain in chains(&output()) {
        store.commit(&chain).unwrap();
    }
    let publication = Publication { title: "long", sweep_text: &long, f: &F, alpha: &ALPHA, beta: &BETA, cases: &row };
    store.publish(&publication).unwrap();
    let read = "import sys, xarray\n\
                kept = xarray.open_dataset(sys.argv[1] + '/results.h5', engine=sys.argv[2]).attrs['sweep']\n\
                assert kept == open(sys.argv[1] + '/sweep.toml', encoding='utf-8').read()";
    for engine in ["h5netcdf", "netcdf4"] {
        check(&Command::new(python()).args(["-c", read]).arg(directory.path()).arg(engine).output().unwrap());
    }
}

fn surface(results: &Path, picture: &Path) -> Output {
    let script = root().join("scripts/surface.py");
    Command::new(python()).arg(script).arg(results).arg("-o").arg(picture).output().unwrap()
}

#[test]
fn the_surface_script_draws_the_results() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let picture = directory.path().join("picture.png");
    let said = check(&surface(directory.path(), &picture));
    assert!(said.contains("alpha = inf") && said.contains("f = 0"), "what is left out is named: {said}");
    let bytes = std::fs::read(&picture).unwrap();
    assert!(bytes.starts_with(b"\x89PNG") && bytes.len() > 20_000);
}

#[test]
fn the_surface_script_refuses_what_is_no_surface() {
    let directory = tempdir().unwrap();
    let mut store = synthetic::open(directory.path());
    for chain in chains(&output()) {
        store.commit(&chain).unwrap();
    }
    let one_row = |i_f: usize, _: usize| row(i_f, 1);
    let publication =
        Publication { title: "one α", sweep_text: SWEEP, f: &F, alpha: &[1.0], beta: &BETA, cases: &one_row };
    store.publish(&publication).unwrap();
    let picture = directory.path().join("picture.png");
    for (results, expected) in [(directory.path(), "alpha has 1 value"), (Path::new("nowhere"), "no such file")] {
        let run = surface(results, &picture);
        let message = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(!run.status.success() && message.contains(expected), "{message}");
        assert!(!message.contains("Traceback") && !picture.exists());
    }
}
