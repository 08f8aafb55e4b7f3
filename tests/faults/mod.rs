//! Every system call of a run may fail, and the power at any moment: nothing that was committed is lost, nothing wrong
//! is published, every error is told, and one more run completes the sweep.
//!
//! Disks that are full are in `torture`; here the calls fail one after the other, by a shim that is loaded before the C
//! library.

mod power;
mod shim;

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use tempfile::{TempDir, tempdir};

use crate::program::{code, err, out, say};
use crate::torture::place::copy;
use crate::torture::stored::Stored;
use power::{Change, DiskModel, Loss, restore};
use shim::{Error, Fault, counts, trace, with_fault};

/// Names of the calls that may fail.
const CALLS: [&str; 14] = [
    "open",
    "read",
    "pread",
    "write",
    "pwrite",
    "fsync",
    "fdatasync",
    "rename",
    "link",
    "unlink",
    "close",
    "mkdir",
    "ftruncate",
    "flock",
];

const SWEEP: &str = "\
title = \"small\"
[axes]
f = [0.0, 10.0]
alpha = [1.0]
beta = { from = 10.0, to = 1000.0, points = 3, scale = \"log\" }
[output]
fields = [\"pressure\"]
x = { from = -2.0, to = 2.0, points = 11 }
";

/// The half of it.
fn half() -> String {
    SWEEP.replace("[0.0, 10.0]", "[10.0]")
}

const RUN: [&str; 7] = ["run", "small.toml", "-o", "home/out", "--threads", "1", "--quiet"];

/// A directory with the sweep file, and an empty `home` for results.
fn place() -> TempDir {
    let place = tempdir().expect("a temporary directory");
    fs::write(place.path().join("small.toml"), SWEEP).expect("written");
    fs::create_dir(place.path().join("home")).expect("made");
    place
}

/// A directory in which the half of the sweep was run and published.
fn half_done() -> TempDir {
    let place = place();
    fs::write(place.path().join("small.toml"), half()).expect("written");
    assert_eq!(code(&say(place.path(), &RUN)), 0);
    fs::write(place.path().join("small.toml"), SWEEP).expect("written");
    place
}

/// A directory in which both parts of the sweep are solved.
fn in_parts() -> TempDir {
    let place = place();
    for part in ["1/2", "2/2"] {
        assert_eq!(code(&say(place.path(), &[&RUN[..], &["--part", part]].concat())), 0);
    }
    place
}

fn results(place: &Path) -> PathBuf {
    place.join("home/out")
}

/// The published files that depend on nothing but the sweep.
fn published(place: &Path) -> [Option<Vec<u8>>; 2] {
    ["results.h5", "summary.csv"].map(|name| fs::read(results(place).join(name)).ok())
}

/// The bytes that an undisturbed run publishes.
fn reference() -> [Option<Vec<u8>>; 2] {
    let place = place();
    assert_eq!(code(&say(place.path(), &RUN)), 0);
    published(place.path())
}

/// All cases that a directory and its parts hold.
fn held(place: &Path) -> BTreeSet<String> {
    let parts = ["parts/1-of-2", "parts/2-of-2"].map(|part| results(place).join(part));
    let whole = results(place);
    let all = parts.iter().chain([&whole]).flat_map(|path| Stored::read(path).sound_cases());
    all.map(|(case, _)| case).collect()
}

/// A copy of a place, to be disturbed.
fn copied(from: &Path) -> TempDir {
    let to = tempdir().expect("a temporary directory");
    copy(from, to.path());
    to
}

/// Every call of a command, with one of the ways in which it may fail.
fn faults(calls: &BTreeMap<String, u64>, turn: usize) -> Vec<Fault> {
    let mut faults = Vec::new();
    for call in CALLS {
        let errors: Vec<Error> = Error::ALL.into_iter().filter(|error| error.is_of(call)).collect();
        for number in 1..=calls[call] {
            faults.push(Fault { call, number, error: errors[(number as usize + turn) % errors.len()] });
        }
    }
    faults
}

/// Disturbs a command that publishes the sweep at each of its calls.
fn disturb(prepared: &TempDir, arguments: &[&str], turn: usize) {
    let (reference, before) = (reference(), held(prepared.path()));
    let old = published(prepared.path());
    let undisturbed = copied(prepared.path());
    let calls = counts(undisturbed.path(), &undisturbed.path().join("home"), arguments);
    let faults = faults(&calls, turn);
    faults.par_iter().enumerate().for_each(|(count, &fault)| {
        let place = copied(prepared.path());
        let output = with_fault(place.path(), &place.path().join("home"), fault, arguments);
        let said = err(&output);
        assert!([0, 4].contains(&code(&output)), "{fault:?}: exit {}: {said}", code(&output));
        assert!(!said.contains("panicked"), "{fault:?}: {said}");
        let found = published(place.path());
        if code(&output) == 0 {
            assert!(found == reference, "{fault:?}: what is published is not as it should be: {said}");
        } else {
            assert!(["cannot ", "is damaged"].iter().any(|words| said.contains(words)), "{fault:?}: {said}");
            let told = said.contains("some published files in home/out are new and some of before");
            assert!(found == reference || found == old || told, "{fault:?}: some files are new and some old: {said}");
        }
        assert!(held(place.path()).is_superset(&before), "{fault:?}: lost what was committed");
        let again = say(place.path(), arguments);
        assert_eq!(code(&again), 0, "{fault:?}, then again: {}", err(&again));
        assert!(published(place.path()) == reference, "{fault:?}: not completed as it should be");
        // The run has read every shard already; this one reads the published files as well.
        if count % 4 == 0 {
            let verified = say(place.path(), &["verify", "home/out"]);
            assert_eq!(code(&verified), 0, "{fault:?}: {}", err(&verified));
        }
    });
    println!("{}: {} faults", arguments[0], faults.len());
}

#[test]
fn a_run_survives_a_fault_of_any_call() {
    disturb(&place(), &RUN, 0);
}

#[test]
fn an_extension_survives_a_fault_of_any_call() {
    disturb(&half_done(), &RUN, 1);
}

#[test]
fn a_merge_survives_a_fault_of_any_call() {
    disturb(&in_parts(), &["merge", "home/out"], 2);
}

#[test]
fn a_file_system_without_locks_is_warned_of_and_used() {
    let reference = reference();
    for error in [Error::Missing, Error::NoLocks] {
        let place = place();
        let without_locks = |arguments: &[&str]| {
            let fault = Fault { call: "flock", number: 1, error };
            with_fault(place.path(), &place.path().join("home"), fault, arguments)
        };
        let run = without_locks(&RUN);
        assert_eq!(code(&run), 0, "{}", err(&run));
        assert!(err(&run).starts_with("warning: home/out: this file system keeps no locks"), "{}", err(&run));
        assert!(published(place.path()) == reference);
        assert_eq!(code(&without_locks(&["status", "home/out"])), 0);
    }
}

/// A shard that the disk cannot give any more is as good as damaged, and so is a log.
#[test]
fn what_cannot_be_read_costs_its_own_cases_only() {
    let (prepared, reference) = (half_done(), reference());
    assert_eq!(code(&say(prepared.path(), &RUN)), 0);
    let shards = fs::read_dir(results(prepared.path()).join("shards")).expect("listed");
    let shards = shards.map(|entry| entry.expect("listed").path());
    let unreadable = shards.chain([results(prepared.path()).join("log/0001.jsonl")]);
    for file in unreadable {
        let name = file.strip_prefix(prepared.path()).expect("below it");
        for call in ["open", "read"] {
            let place = copied(prepared.path());
            fs::remove_file(results(place.path()).join("summary.csv")).expect("removed");
            let root = place.path().join(name);
            // A quota error stays; which one it is does not matter here.
            let fault = Fault { call, number: 1, error: Error::Quota };
            for arguments in [&["status", "home/out"][..], &["plan", "small.toml", "-o", "home/out"], &RUN] {
                let output = with_fault(place.path(), &root, fault, arguments);
                assert_eq!(code(&output), 0, "{}: {}", root.display(), err(&output));
                assert!(err(&output).contains("cannot be read: "), "{}: {}", root.display(), err(&output));
            }
            assert!(published(place.path()) == reference);
            let verified = with_fault(place.path(), &root, fault, &["verify", "home/out"]);
            // The cases of a shard are in others now; of a log nobody knows what it says.
            let expected = if root.extension().is_some_and(|extension| extension == "jsonl") { 4 } else { 0 };
            assert_eq!(code(&verified), expected, "{}: {}", root.display(), err(&verified));
            assert!(expected == 0 || !out(&verified).contains("no record names it"), "{}", out(&verified));
        }
    }
}

/// A command that shows what is published leaves its files whole, of before or new, and nothing beside them.
#[test]
fn what_is_drawn_survives_a_fault_of_any_call() {
    let prepared = place();
    assert_eq!(code(&say(prepared.path(), &RUN)), 0);
    for arguments in [&["report", "home/out"][..], &["plot", "home/out", "--what", "curves", "--of", "mu_drag"]] {
        assert_eq!(code(&say(prepared.path(), arguments)), 0);
        let files = |place: &Path| -> BTreeMap<PathBuf, Vec<u8>> {
            let pages = [results(place), results(place).join("figures")];
            let entries = pages.iter().filter_map(|page| fs::read_dir(page).ok()).flatten();
            let files = entries.map(|entry| entry.expect("listed").path()).filter(|path| path.is_file());
            let name = |path: &Path| path.strip_prefix(place).expect("below it").to_owned();
            files.map(|path| (name(&path), fs::read(path).expect("read"))).collect()
        };
        let before = files(prepared.path());
        let undisturbed = copied(prepared.path());
        let calls = counts(undisturbed.path(), &undisturbed.path().join("home"), arguments);
        let faults = faults(&calls, 3);
        println!("{}: {} faults", arguments[0], faults.len());
        faults.par_iter().for_each(|&fault| {
            let place = copied(prepared.path());
            let output = with_fault(place.path(), &place.path().join("home"), fault, arguments);
            let said = err(&output);
            assert!([0, 4].contains(&code(&output)), "{fault:?}: exit {}: {said}", code(&output));
            assert!(!said.contains("panicked"), "{fault:?}: {said}");
            assert!(files(place.path()) == before, "{fault:?}: the files are not those of before: {said}");
        });
    }
}

/// The state of the disk is made for each moment at which the power may fail, and the sweep completed there.
#[test]
fn what_was_committed_survives_a_loss_of_power_at_any_moment() {
    for (prepared, arguments) in [(place(), &RUN[..]), (in_parts(), &["merge", "home/out"])] {
        let reference = reference();
        let recorded = copied(prepared.path());
        let changes = Change::read(&trace(recorded.path(), &recorded.path().join("home"), arguments));
        let states = states(&changes, &prepared, recorded.path());
        states.par_iter().for_each(|State { what, files, committed }| {
            let place = place();
            restore(files, recorded.path(), place.path());
            let held = held(place.path());
            assert!(held.is_superset(committed), "{what}: {committed:?} were committed, and there are {held:?}");
            let again = say(place.path(), arguments);
            assert_eq!(code(&again), 0, "{what}: {}", err(&again));
            assert!(published(place.path()) == reference, "{what}: not completed as it should be");
        });
        assert!(states.len() > 50, "{}", states.len());
        println!("{}: {} states after a loss of power, of {} changes", arguments[0], states.len(), changes.len());
    }
}

/// A disk after a loss of power.
struct State {
    what: String,
    files: BTreeMap<PathBuf, Option<Vec<u8>>>,
    /// The cases whose records somebody had waited for.
    committed: BTreeSet<String>,
}

/// The different states of the disk after a loss of power at each moment.
fn states(changes: &[Change], prepared: &TempDir, recorded: &Path) -> Vec<State> {
    let (mut disk, mut committed) =
        (DiskModel::of(&prepared.path().join("home"), &recorded.join("home")), held(prepared.path()));
    let (mut states, mut seen) = (Vec::new(), HashSet::new());
    for (number, change) in (1..).zip(changes) {
        disk.apply(change);
        if change.synchronises("jsonl") {
            let place = place();
            restore(&disk.after(Loss::Nothing), recorded, place.path());
            committed = held(place.path());
        }
        for loss in [Loss::Everything, Loss::Contents, Loss::Some(number)] {
            let files = disk.after(loss);
            if seen.insert(files.clone()) {
                let what = format!("power lost after change {number} of {}, {loss:?}: {change:?}", changes.len());
                states.push(State { what, files, committed: committed.clone() });
            }
        }
    }
    states
}
