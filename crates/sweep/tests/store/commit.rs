//! What is committed comes back bit for bit, or is refused and leaves no trace.

use std::fs;
use std::path::PathBuf;

use super::{bits, shards};
use crate::synthetic::{BETA, chains, entry, finished, open, output};
use stribeck_solver::{Fields, Sensitivities};
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{Catalog, Inspection, Status, StoreError, verify};
use tempfile::tempdir;

#[test]
fn what_is_committed_comes_back_bit_for_bit() {
    let directory = tempdir().unwrap();
    let output = output();
    let mut chain: Vec<_> = BETA.iter().map(|&beta| entry(100.0, 1.0, beta, &output)).collect();
    chain[0].values.0[0] = f64::INFINITY;
    chain[0].values.0[1] = -0.0;
    chain[0].values.0[2] = f64::from_bits(0x7ff8_0000_dead_beef);
    chain[1].fields.pressure.as_mut().unwrap()[3] = f64::NAN;
    chain[1].fields.pressure.as_mut().unwrap()[4] = f64::NEG_INFINITY;
    chain[2] = entry(100.0, 0.1, 1000.0, &output);
    assert_eq!(chain[2].outcome, Status::Failed);
    chain[2].reason = "a reason with ünïcode, \"quotes\", commas".into();
    open(directory.path()).commit(&chain).unwrap();

    let held = Catalog::read(directory.path(), &output, Inspection::Bytes).unwrap();
    assert_eq!(held.warnings(), []);
    for entry in &chain {
        assert_eq!(held.holds(entry.id), Some(entry.outcome));
        let back = held.entry(entry.id).unwrap().unwrap();
        assert_eq!(bits(&back.values.0), bits(&entry.values.0));
        assert_eq!((&back.reason, back.outcome, &back.timing), (&entry.reason, entry.outcome, &entry.timing));
        for (back, field) in [
            (&back.fields.pressure, &entry.fields.pressure),
            (&back.fields.film_thickness, &entry.fields.film_thickness),
            (&back.fields.displacement, &entry.fields.displacement),
        ] {
            assert_eq!(back.as_deref().map(bits), field.as_deref().map(bits));
        }
    }
    assert_eq!(held.holds(CaseId(1)), None);
    assert!(held.entry(CaseId(1)).unwrap().is_none());
}

#[test]
fn a_refused_chain_leaves_no_trace() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let good = entry(100.0, 1.0, 10.0, &output());
    let refused = |change: &dyn Fn(&mut stribeck_sweep::store::CaseEntry)| {
        let mut bad = good.clone();
        change(&mut bad);
        bad
    };
    let chains = [
        vec![good.clone(), good.clone()],
        vec![refused(&|bad| bad.timing.seconds = f64::NAN)],
        vec![refused(&|bad| bad.timing.seconds = -1.0)],
        vec![refused(&|bad| bad.reason = "two\nlines".into())],
        vec![refused(&|bad| bad.fields.pressure = None)],
        vec![refused(&|bad| bad.fields.pressure.as_mut().unwrap().truncate(40))],
        vec![refused(&|bad| bad.outcome = Status::Failed)],
        vec![refused(&|bad| {
            bad.sensitivities = Sensitivities::from_row([0.0; 20]);
            (bad.outcome, bad.fields) = (Status::Failed, Fields::default());
        })],
    ];
    for chain in &chains {
        assert!(matches!(store.commit(chain), Err(StoreError::Entry { .. })), "{chain:?}");
    }
    assert_eq!(shards(directory.path()), Vec::<PathBuf>::new());
    store.commit(&[good]).unwrap();
}

#[test]
fn a_disk_that_fails_is_an_error_and_the_store_goes_on() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let all = chains(&output());
    store.commit(&all[0]).unwrap();
    let (shard_directory, away) = (directory.path().join("shards"), directory.path().join("away"));
    fs::rename(&shard_directory, &away).unwrap();
    let error = store.commit(&all[1]).unwrap_err();
    assert!(error.to_string().contains("shards"), "{error}");
    assert!(!error.to_string().contains("free some space"), "{error}");
    assert_eq!(store.holds(all[1][0].id), None);
    fs::rename(&away, &shard_directory).unwrap();
    store.commit(&all[1]).unwrap();
    drop(store);
    let held = Catalog::read(directory.path(), &output(), Inspection::Bytes).unwrap();
    assert_eq!((held.counts().converged, held.warnings().len()), (5, 0));
}

#[test]
fn shards_are_the_same_files_in_every_run() {
    let [first, second] = [(); 2].map(|()| {
        let directory = tempdir().unwrap();
        finished(directory.path());
        let read = |path: PathBuf| (path.file_name().unwrap().to_owned(), fs::read(path).unwrap());
        shards(directory.path()).into_iter().map(read).collect::<Vec<_>>()
    });
    assert_eq!(first.len(), 8);
    assert!(first == second);
}

/// Other bytes of the same cases, and the bytes of a damaged shard, come into files of their own.
#[test]
fn no_shard_is_ever_replaced() {
    let directory = tempdir().unwrap();
    let chain = &chains(&output())[2];
    open(directory.path()).commit(chain).unwrap();
    let [first] = &shards(directory.path())[..] else { panic!("one shard") };
    let before = fs::read(first).unwrap();

    // The same cases as another processor rounds them.
    let mut other = chain.clone();
    other[0].values.0[0] += 1e-9;
    open(directory.path()).commit(&other).unwrap();
    assert_eq!(shards(directory.path()).len(), 2);
    assert_eq!(fs::read(first).unwrap(), before);

    // The same bytes again are the same file; where that is damaged, the damage stays beside them.
    open(directory.path()).commit(chain).unwrap();
    assert_eq!(shards(directory.path()).len(), 2);
    fs::write(first, b"damaged").unwrap();
    open(directory.path()).commit(chain).unwrap();
    let found = shards(directory.path());
    assert_eq!((found.len(), fs::read(first).unwrap()), (3, b"damaged".to_vec()));
    assert!(found.iter().any(|shard| fs::read(shard).unwrap() == before));
    assert!(verify(directory.path()).unwrap().is_sound());
}
