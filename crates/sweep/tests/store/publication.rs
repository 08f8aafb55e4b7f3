//! What is published does not depend on how it came about.

use std::fs;

use super::shards;
use crate::synthetic::{
    ALPHA, BETA, F, SWEEP, chains, finished, open, output, publish, publish_as, published_bytes, reference, row,
};
use stribeck_solver::Output;
use stribeck_sweep::store::{Ending, Store, StoreError};
use tempfile::tempdir;

#[test]
fn published_bytes_do_not_depend_on_order_or_number_of_starts() {
    let reference = reference();
    for rotation in [1, 3, 6] {
        let directory = tempdir().unwrap();
        let mut order = chains(&output());
        order.rotate_left(rotation);
        order.reverse();
        for (i, part) in order.chunks(3).enumerate() {
            let mut store = open(directory.path());
            store.begin("synthetic", 20, i as u64).unwrap();
            for chain in part {
                store.commit(chain).unwrap();
            }
            store.end(Ending::Interrupted).unwrap();
        }
        publish(&mut open(directory.path())).unwrap();
        assert!(published_bytes(directory.path()) == reference, "rotation {rotation}");
    }
}

#[test]
fn chains_committed_in_any_company_publish_the_same_bytes() {
    let reference = reference();
    for (size, reversed) in [(1, true), (2, false), (3, true), (8, false)] {
        let directory = tempdir().unwrap();
        let mut store = open(directory.path());
        let mut chains = chains(&output());
        if reversed {
            chains.reverse();
        }
        for group in chains.chunks(size) {
            store.commit(&group.concat()).unwrap();
        }
        publish(&mut store).unwrap();
        assert_eq!(shards(directory.path()).len(), 8_usize.div_ceil(size));
        assert!(published_bytes(directory.path()) == reference, "groups of {size}");
    }
}

#[test]
fn a_run_again_has_nothing_to_do_and_writes_nothing() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let logs = || fs::read_dir(directory.path().join("log")).unwrap().count();
    let before = (logs(), fs::metadata(directory.path().join("results.h5")).unwrap().modified().unwrap());
    let mut store = open(directory.path());
    assert!(!publish(&mut store).unwrap().rewritten);
    assert_eq!(before, (logs(), fs::metadata(directory.path().join("results.h5")).unwrap().modified().unwrap()));
    fs::remove_file(directory.path().join("summary.csv")).unwrap();
    assert!(publish(&mut store).unwrap().rewritten, "a published file that was removed comes back");
    assert!(published_bytes(directory.path()) == reference());
}

#[test]
fn an_unfinished_sweep_is_not_published() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    for chain in &chains(&output())[1..] {
        store.commit(chain).unwrap();
    }
    // The first chain holds three elastic cases: they stand in all four rows of f = 0 and in the row α = ∞ of f = 100.
    let error = publish(&mut store).unwrap_err();
    assert!(matches!(error, StoreError::Unfinished { missing: 15, places: 40 }), "{error}");
    assert!(!directory.path().join("results.h5").exists() && !directory.path().join("summary.csv").exists());
    store.commit(&chains(&output())[0]).unwrap();
    let published = publish(&mut store).unwrap();
    assert_eq!((published.converged, published.failed), (39, 1));
}

#[test]
fn a_row_of_the_wrong_length_is_refused() {
    let directory = tempdir().unwrap();
    let mut store = finished(directory.path());
    let short = |i_f: usize, i_alpha: usize| row(i_f, i_alpha)[1..].to_vec();
    let published = publish_as(&mut store, ["", ""], [&F, &ALPHA, &BETA], &short);
    assert!(matches!(published, Err(StoreError::Publication { .. })));
}

#[test]
fn limits_that_are_not_asked_for_are_not_published() {
    let published = |outputs: &[&Output]| {
        let directory = tempdir().unwrap();
        for &output in outputs {
            let mut store = Store::open(directory.path(), SWEEP, output).unwrap();
            for chain in chains(output) {
                if store.holds(chain[0].id).is_none() {
                    store.commit(&chain).unwrap();
                }
            }
            publish(&mut store).unwrap();
        }
        let mut reader = csv::Reader::from_path(directory.path().join("summary.csv")).unwrap();
        let header = reader.headers().unwrap().clone();
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        let column = |name: &str| {
            let place = header.iter().position(|column| column == name).unwrap();
            rows.iter().filter(|row| !row[place].is_empty()).count()
        };
        (column("dry_mu_v"), column("approx_mu_h"), column("mu_v"))
    };
    let [with, without] = [true, false].map(|limits| Output { limits, ..output() });
    assert_eq!(published(&[&with]), (39, 39, 39));
    assert_eq!(published(&[&with, &without]), (0, 0, 39));
    assert_eq!(published(&[&with, &without, &with]), (39, 39, 39), "they are still in the shards");
}
