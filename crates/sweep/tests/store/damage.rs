//! Damage, and what a killed run leaves, is found, named and repaired by the next run.

use std::fs;
use std::path::{Path, PathBuf};

use super::{log, shards};
use crate::synthetic::{SWEEP, chains, finished, open, output, publish, published_bytes, reference, resume};
use stribeck_solver::{FieldSelection, Output};
use stribeck_sweep::store::{Store, Warning, verify};
use tempfile::tempdir;

#[test]
fn what_a_killed_run_leaves_is_recovered() {
    let reference = reference();
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    store.begin("synthetic", 20, 2).unwrap();
    for chain in &chains(&output())[..5] {
        store.commit(chain).unwrap();
    }
    drop(store);
    // Killed while writing a shard, the published files and a log line; and after renaming a shard, before its record.
    fs::write(directory.path().join("shards/.shard.stribeck-part"), b"half").unwrap();
    fs::write(directory.path().join("shards/.draft.stribeck-part"), b"a user's").unwrap();
    fs::write(directory.path().join(".results.h5.stribeck-part"), b"half").unwrap();
    let text = fs::read(log(directory.path(), 1)).unwrap();
    fs::write(log(directory.path(), 1), &text[..text.len() - 40]).unwrap();

    let store = open(directory.path());
    assert_eq!(store.warnings().len(), 1, "{:?}", store.warnings());
    assert!(matches!(&store.warnings()[0], Warning::Record { line: 6, .. }));
    drop(store);
    assert!(!directory.path().join("shards/.shard.stribeck-part").exists());
    assert!(directory.path().join("shards/.draft.stribeck-part").exists(), "no file of ours has that name");
    assert!(!directory.path().join(".results.h5.stribeck-part").exists());
    assert_eq!(resume(directory.path()), 4, "three chains never committed and the one whose record is torn");
    assert!(published_bytes(directory.path()) == reference);
    assert!(verify(directory.path()).unwrap().is_sound());
}

#[test]
fn a_first_start_killed_before_its_first_record_is_resumed() {
    let reference = reference();
    let directories = ["log", "shards"];
    for killed_after in 0..=directories.len() {
        let directory = tempdir().unwrap();
        for name in &directories[..killed_after] {
            fs::create_dir(directory.path().join(name)).unwrap();
        }
        assert_eq!(resume(directory.path()), 8);
        assert!(published_bytes(directory.path()) == reference);
    }
    let directory = tempdir().unwrap();
    drop(open(directory.path()));
    assert_eq!(fs::read_dir(directory.path().join("log")).unwrap().count(), 0, "no record yet");
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), SWEEP);
    assert_eq!(resume(directory.path()), 8);
    assert!(published_bytes(directory.path()) == reference);
}

#[test]
fn a_damaged_line_costs_its_own_cases_only() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let mut text = fs::read(log(directory.path(), 1)).unwrap();
    let third_line = text.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(1).unwrap().0 + 1;
    text[third_line + 60] ^= 1;
    fs::write(log(directory.path(), 1), &text).unwrap();

    let store = open(directory.path());
    let lost = chains(&output()).iter().flatten().filter(|entry| store.holds(entry.id).is_none()).count();
    assert_eq!(lost, 2, "the second chain has two cases");
    assert!(matches!(&store.warnings(), [Warning::Record { line: 3, .. }]));
    drop(store);
    let report = verify(directory.path()).unwrap();
    assert_eq!((report.warnings.len(), report.unreferenced.len(), report.shards), (1, 1, 7));
    assert_eq!(resume(directory.path()), 1);
    assert!(published_bytes(directory.path()) == reference());
    assert_eq!(verify(directory.path()).unwrap().unreferenced, Vec::<PathBuf>::new());
}

#[test]
fn damaged_shards_are_found_named_and_solved_again() {
    let truncate = |path: &Path| {
        let bytes = fs::read(path).unwrap();
        fs::write(path, &bytes[..bytes.len() / 2]).unwrap();
    };
    let flip = |path: &Path| {
        let mut bytes = fs::read(path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 0x10;
        fs::write(path, bytes).unwrap();
    };
    let delete = |path: &Path| fs::remove_file(path).unwrap();
    type Damage<'a> = (&'a str, &'a dyn Fn(&Path));
    let damages: [Damage<'_>; 3] = [("bytes", &truncate), ("checksum", &flip), ("missing", &delete)];
    let reference = reference();
    for (what, damage) in damages {
        let directory = tempdir().unwrap();
        drop(finished(directory.path()));
        let victim = shards(directory.path())[4].clone();
        damage(&victim);

        let report = verify(directory.path()).unwrap();
        assert!(!report.is_sound());
        assert_eq!(report.problems.len(), 1);
        assert_eq!(report.problems[0].file, victim);
        assert!(report.problems[0].what.contains(what), "{}", report.problems[0]);

        let store = open(directory.path());
        assert!(matches!(store.warnings(), [Warning::Shard { file, .. }] if *file == victim), "{:?}", store.warnings());
        drop(store);
        assert_eq!(resume(directory.path()), 1);
        assert!(verify(directory.path()).unwrap().is_sound());
        assert!(published_bytes(directory.path()) == reference);
    }
}

#[test]
fn a_damaged_shard_is_of_no_concern_once_others_hold_its_cases() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let victim = shards(directory.path())[4].clone();
    let held: Vec<_> = chains(&output()).concat();
    fs::write(&victim, "damaged").unwrap();

    let mut store = open(directory.path());
    let lost: Vec<_> = held.iter().filter(|entry| store.holds(entry.id).is_none()).cloned().collect();
    let told = |store: &Store| store.warnings().iter().map(ToString::to_string).collect::<String>();
    assert!(told(&store).contains(&format!("its {} cases are not used", lost.len())), "{}", told(&store));
    // Some of them are solved again, in other company than before.
    store.commit(&lost[..1]).unwrap();
    drop(store);
    let mut store = open(directory.path());
    assert!(told(&store).contains(&format!("its {} cases are not used", lost.len() - 1)), "{}", told(&store));
    assert!(!verify(directory.path()).unwrap().is_sound());
    // Now all; but a shard without the fields is no replacement.
    let bare = Output { fields: FieldSelection::default(), ..output() };
    drop(store);
    let mut other = Store::open(directory.path(), SWEEP, &bare).unwrap();
    other.commit(&lost[1..]).unwrap();
    drop(other);
    assert!(!verify(directory.path()).unwrap().is_sound());
    store = open(directory.path());
    store.commit(&lost[1..]).unwrap();
    drop(store);

    let report = verify(directory.path()).unwrap();
    assert!(report.is_sound());
    assert_eq!((report.replaced, report.unreferenced), (vec![victim], Vec::new()));
    let mut store = open(directory.path());
    assert_eq!(told(&store), "");
    publish(&mut store).unwrap();
    assert!(published_bytes(directory.path()) == reference());
}

#[test]
fn a_changed_published_file_is_found() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    assert_eq!(verify(directory.path()).unwrap().published, 3);
    let summary = directory.path().join("summary.csv");
    let text = fs::read_to_string(&summary).unwrap();
    fs::write(&summary, text.replacen('1', "2", 1)).unwrap();
    let report = verify(directory.path()).unwrap();
    assert_eq!((report.published, report.problems.len()), (2, 1));
    assert_eq!(report.problems[0].file, summary);
}

#[test]
fn a_published_file_that_was_changed_is_written_again() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    for name in ["results.h5", "summary.csv", "timings.csv"] {
        let path = directory.path().join(name);
        let whole = fs::read(&path).unwrap();
        let mut bytes = whole.clone();
        *bytes.last_mut().unwrap() ^= 1;
        fs::write(&path, &bytes).unwrap();
        let mut store = open(directory.path());
        assert!(publish(&mut store).unwrap().rewritten, "{name}");
        assert!(fs::read(&path).unwrap() == whole, "{name}");
        assert!(!publish(&mut store).unwrap().rewritten, "{name}");
    }
}
