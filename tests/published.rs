//! The published files in the hands of a user: xarray with both of its netCDF engines, and h5dump.
//!
//! Needs Python with the packages of `scripts/requirements.txt` and h5dump; `./scripts/prerequisites` installs both.

use std::path::Path;
use std::process::Command;

use crate::in_python::{REMEDY, check, file_of_python, python};
use crate::synthetic::{ALPHA, BETA, F, SWEEP, chains, finished, output, publish_as, row};
use stribeck_sweep::store::Store;
use tempfile::tempdir;

fn open_with(engine: &str) {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let run = file_of_python("tests/python/open_results.py").arg(directory.path()).arg(engine).output().unwrap();
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
    for expected in ["DATASET \"mu_v\"", "DATASET \"pressure\"", "CHUNKED ( 1, 1, 5, 41 )", "SHUFFLE", "DEFLATE"] {
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
    publish_as(&mut store, ["long", &long], [&F, &ALPHA, &BETA], &row).unwrap();
    let read = "import sys, xarray\n\
                kept = xarray.open_dataset(sys.argv[1] + '/results.h5', engine=sys.argv[2]).attrs['sweep']\n\
                assert kept == open(sys.argv[1] + '/sweep.toml', encoding='utf-8').read()";
    for engine in ["h5netcdf", "netcdf4"] {
        check(&Command::new(python()).args(["-c", read]).arg(directory.path()).arg(engine).output().unwrap());
    }
}
