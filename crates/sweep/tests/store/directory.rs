//! Whose a directory is, what it keeps beside the cases, and what it tells of its starts.

use std::fs;

use crate::synthetic::{SWEEP, chains, entry, finished, open, output, published_bytes, reference};
use stribeck_sweep::store::{Catalog, Ending, Inspection, Store, StoreError, verify};
use tempfile::tempdir;

#[test]
fn a_second_opener_is_told_who_holds_the_directory() {
    let directory = tempdir().unwrap();
    let first = open(directory.path());
    let error = Store::open(directory.path(), SWEEP, &output()).unwrap_err();
    assert!(matches!(error, StoreError::Locked { .. }));
    assert!(error.to_string().contains(&std::process::id().to_string()), "{error}");
    Catalog::read(directory.path(), &output(), Inspection::Bytes).expect("reading needs no lock");
    drop(first);
    open(directory.path());
}

#[test]
fn a_path_without_results_is_refused() {
    let directory = tempdir().unwrap();
    for path in [directory.path().to_owned(), directory.path().join("nowhere")] {
        assert!(matches!(Catalog::read(&path, &output(), Inspection::Bytes), Err(StoreError::NotResults { .. })));
        assert!(matches!(verify(&path), Err(StoreError::NotResults { .. })));
    }
    assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 0, "reading writes nothing");
}

#[test]
fn the_files_of_others_are_left_alone() {
    for name in ["sweep.toml", "results.h5", "summary.csv", "timings.csv"] {
        let directory = tempdir().unwrap();
        fs::write(directory.path().join(name), "not ours").unwrap();
        let refused = |there: usize| {
            let error = Store::open(directory.path(), SWEEP, &output()).unwrap_err();
            assert!(matches!(error, StoreError::Occupied { .. }), "{error}");
            assert!(error.to_string().contains(&format!("it has {name} but no log")), "{error}");
            assert_eq!(fs::read_to_string(directory.path().join(name)).unwrap(), "not ours");
            assert_eq!(fs::read_dir(directory.path()).unwrap().count(), there, "nothing is added");
        };
        refused(1);
        fs::create_dir(directory.path().join("log")).unwrap();
        fs::write(directory.path().join("log/today.txt"), "").unwrap();
        refused(2);
    }
    let directory = tempdir().unwrap();
    fs::write(directory.path().join("notes.txt"), "").unwrap();
    finished(directory.path());
    assert!(published_bytes(directory.path()) == reference(), "files of other names do not matter");
}

#[test]
fn the_sweep_file_is_kept_as_it_was_run() {
    let directory = tempdir().unwrap();
    drop(open(directory.path()));
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), SWEEP);
    drop(Store::open(directory.path(), "title = \"other\"\n", &output()).unwrap());
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), "title = \"other\"\n");
}

#[test]
fn the_history_tells_of_every_start() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let all = chains(&output());
    store.begin("synthetic", 20, 2).unwrap();
    for chain in &all[..3] {
        store.commit(chain).unwrap();
    }
    store.end(Ending::Interrupted).unwrap();
    drop(store);
    let mut store = open(directory.path());
    store.begin("synthetic", 12, 1).unwrap();
    for chain in &all[3..] {
        store.commit(chain).unwrap();
    }
    let live = store.history().clone();
    drop(store);

    let held = Catalog::read(directory.path(), &output(), Inspection::Bytes).unwrap();
    assert_eq!(&live, held.history(), "the running store and a reader tell the same");
    let starts: Vec<_> = held.history().starts().map(|(_, start)| start.clone()).collect();
    assert_eq!(starts.iter().map(|start| start.ending).collect::<Vec<_>>(), [Some(Ending::Interrupted), None]);
    assert_eq!(starts.iter().map(|start| (start.converged, start.failed)).collect::<Vec<_>>(), [(8, 0), (11, 1)]);
    let expected: f64 = all.iter().flatten().map(|entry| entry.timing.seconds).sum();
    let seconds: f64 = starts.iter().map(|start| start.case_seconds).sum();
    assert!((seconds / expected - 1.0).abs() < 1e-12);
    let mut failures = Vec::new();
    held.visit_failures(|id, kind, reason| failures.push((id, Some(kind.to_owned()), reason.to_owned()))).unwrap();
    let failed = entry(100.0, 0.1, 1000.0, &output());
    assert_eq!(failures, [(failed.id, failed.failure_kind, failed.reason)]);
}
