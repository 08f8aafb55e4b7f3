//! Any bytes in the place of a shard: they are used if they are those that were written, and not otherwise.

use std::fs;
use std::path::PathBuf;

use stribeck_sweep::store::{CaseEntry, Catalog, Inspection, StoreError, Warning, verify};
use tempfile::{TempDir, tempdir};

use crate::synthetic::{chains, open, output};

/// A results directory with two shards; one of them gets other bytes.
struct Store {
    directory: TempDir,
    victim: PathBuf,
    written: Vec<u8>,
    /// The cases of the victim.
    lost: Vec<CaseEntry>,
    /// The cases of the other shard.
    kept: Vec<CaseEntry>,
}

impl Store {
    fn new() -> Self {
        let directory = tempdir().expect("a temporary directory");
        let [kept, lost] = [2, 4].map(|place| chains(&output()).swap_remove(place));
        let mut store = open(directory.path());
        store.commit(&kept).expect("committed");
        let shards = || -> Vec<PathBuf> {
            let files = fs::read_dir(directory.path().join("shards")).expect("listed");
            files.map(|file| file.expect("listed").path()).collect()
        };
        let before = shards();
        store.commit(&lost).expect("committed");
        let victim = shards().into_iter().find(|path| !before.contains(path)).expect("a second shard");
        let written = fs::read(&victim).expect("read");
        Self { directory, victim, written, lost, kept }
    }
}

thread_local! { static STORE: Store = Store::new(); }

/// The bytes of the shard that [`check`] replaces.
pub fn written() -> Vec<u8> {
    STORE.with(|store| store.written.clone())
}

/// Panics if a law is broken: by the bytes as they are, or by the shard with the bytes in it.
pub fn check(bytes: &[u8]) {
    STORE.with(|store| {
        judge(store, bytes);
        judge(store, &edited(&store.written, bytes));
    });
}

/// The shard, written over with the bytes from the third on, at the place that the first two tell.
fn edited(written: &[u8], bytes: &[u8]) -> Vec<u8> {
    let mut edited = written.to_vec();
    if let [high, low, over @ ..] = bytes {
        let place = usize::from(u16::from_be_bytes([*high, *low])) % written.len();
        let length = over.len().min(written.len() - place);
        edited[place..place + length].copy_from_slice(&over[..length]);
    }
    edited
}

fn judge(store: &Store, bytes: &[u8]) {
    fs::write(&store.victim, bytes).expect("written");
    let sound = bytes == store.written;
    read_closely(store, sound);
    read_by_size(store, sound);
    let report = verify(store.directory.path()).expect("any shard is verified");
    let found: Vec<_> = report.problems.iter().map(|problem| &problem.file).collect();
    assert_eq!(found, if sound { vec![] } else { vec![&store.victim] });
}

/// As a run does: only sound shards count, and each other one is named.
fn read_closely(store: &Store, sound: bool) {
    let held = Catalog::read(store.directory.path(), &output(), Inspection::Bytes).expect("any shard is judged");
    match held.warnings() {
        [] => assert!(sound),
        [Warning::Shard { file, cases, .. }] => {
            assert!(!sound && *file == store.victim && *cases == store.lost.len(), "{:?}", held.warnings());
        }
        others => panic!("{others:?}"),
    }
    assert!(store.kept.iter().all(|case| held.holds(case.id) == Some(case.outcome) && same(&held, case)));
    for case in &store.lost {
        assert_eq!(held.holds(case.id), sound.then_some(case.outcome));
        assert_eq!(same(&held, case), sound);
    }
}

/// As `stribeck plan` does: what is the right size is counted, but not used before it was read.
fn read_by_size(store: &Store, sound: bool) {
    let held = Catalog::read(store.directory.path(), &output(), Inspection::Size).expect("any shard is judged");
    for case in store.lost.iter().filter(|case| held.knows(case.id)) {
        match held.entry(case.id) {
            Ok(_) => assert!(sound && same(&held, case)),
            Err(error) => assert!(!sound && matches!(error, StoreError::Damaged { .. }), "{error}"),
        }
    }
}

/// True if a case comes back with the bits it was stored with.
fn same(held: &Catalog, case: &CaseEntry) -> bool {
    let bits = |values: &[f64]| -> Vec<u64> { values.iter().map(|value| value.to_bits()).collect() };
    let Ok(Some(found)) = held.entry(case.id) else { return false };
    let pressure = |case: &CaseEntry| case.fields.pressure.as_deref().map(bits);
    (found.id, found.outcome, &found.reason) == (case.id, case.outcome, &case.reason)
        && bits(&found.values.0) == bits(&case.values.0)
        && pressure(&found) == pressure(case)
}
