//! What the store survives: a process that is killed, and a disk that takes no more.
//!
//! Both need a process of their own, which is this test binary again, told to run one ignored test. Such a test has
//! nothing to do, and passes, when it is run without the directory that its parent names: so does `--ignored`.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::synthetic::{SWEEP, chains, entry, open, output, publish, published_bytes, reference, resume};
use stribeck_solver::Output;
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{CaseEntry, Store, StoreError, Warning, verify};
use tempfile::tempdir;

const DIRECTORY: &str = "STRIBECK_TEST_DIRECTORY";

/// Not a law: the process that `a_run_killed_at_any_moment_loses_no_committed_chain` starts and kills.
#[test]
#[ignore = "started and killed by another test"]
fn victim() {
    let Some(directory) = std::env::var_os(DIRECTORY).map(PathBuf::from) else { return };
    let mut store = open(&directory);
    store.begin("synthetic", 20, 1).unwrap();
    for chain in chains(&output()) {
        if chain.iter().any(|entry| store.holds(entry.id).is_none()) {
            store.commit(&chain).unwrap();
            println!("committed {}", chain[0].id);
        }
    }
    loop {
        publish(&mut store).unwrap();
        println!("published");
        fs::remove_file(directory.join("summary.csv")).unwrap();
    }
}

/// A start is killed while it works on what follows its first announcements, however slow the machine is. It commits
/// what starts before it did not, so that later ones are killed while they publish.
#[test]
fn a_run_killed_at_any_moment_loses_no_committed_chain() {
    let directory = tempdir().unwrap();
    let mut announced = Vec::new();
    for attempt in 0..12_u64 {
        let mut victim = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "survival::victim", "--ignored", "--nocapture"])
            .env(DIRECTORY, directory.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(victim.stdout.take().unwrap()).lines().map(Result::unwrap);
        let moments = lines.by_ref().filter(|line| is_moment(line)).take(1 + (attempt % 3) as usize);
        announced.extend(moments.filter_map(|line| case_of(&line)));
        // However long this lasts, the victim works on: it only spreads the kills over what follows.
        std::thread::sleep(Duration::from_millis(attempt));
        victim.kill().unwrap();
        // What was announced before the signal came counts as well.
        announced.extend(lines.filter_map(|line| case_of(&line)));
        assert_eq!(victim.wait().unwrap().code(), None, "killed by the signal, not ended by itself");
    }
    let store = open(directory.path());
    assert!(announced.len() >= 3, "the first chains were announced");
    for id in announced {
        assert!(store.holds(id).is_some(), "case {id} was committed");
    }
    assert!(store.warnings().iter().all(|warning| matches!(warning, Warning::Record { .. })), "{:?}", store.warnings());
    drop(store);
    resume(directory.path());
    assert!(published_bytes(directory.path()) == reference());
    assert!(verify(directory.path()).unwrap().is_sound());
}

/// The case that a line of `victim` announces.
fn case_of(line: &str) -> Option<CaseId> {
    // Libtest writes the name of the test before the first announcement, on the same line.
    line.split_once("committed ")?.1.parse().ok()
}

/// True for a line after which `victim` may be killed.
fn is_moment(line: &str) -> bool {
    case_of(line).is_some() || line.ends_with("published")
}

/// A chain whose fields do not compress.
fn bulky(output: &Output) -> Vec<CaseEntry> {
    let mut state = 1_u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64
    };
    let mut chain: Vec<_> = (20..60).map(|beta| entry(100.0, 1.0, f64::from(beta), output)).collect();
    for entry in &mut chain {
        entry.fields.pressure.as_mut().unwrap().fill_with(&mut noise);
    }
    chain
}

/// Not a law: the process of `a_write_that_fails_half_way_is_an_error_and_no_crash`; it may not write large files.
#[test]
#[ignore = "started with a limit by another test"]
fn limited() {
    let Some(directory) = std::env::var_os(DIRECTORY).map(PathBuf::from) else { return };
    let output = Output { x: (0..900).map(f64::from).collect(), ..Output::default() };
    let mut store = Store::open(&directory, SWEEP, &output).unwrap();
    for _ in 0..5 {
        let error = store.commit(&bulky(&output)).unwrap_err();
        assert!(matches!(error, StoreError::Hdf5 { .. }), "{error}");
        assert!(store.holds(bulky(&output)[0].id).is_none());
    }
    drop(store);
    let mut store = open(&directory);
    for chain in chains(&crate::synthetic::output()) {
        store.commit(&chain).unwrap();
    }
    publish(&mut store).unwrap();
}

#[cfg(unix)]
#[test]
fn a_write_that_fails_half_way_is_an_error_and_no_crash() {
    let directory = tempdir().unwrap();
    let binary = std::env::current_exe().unwrap();
    // 170 to 210 kB: more than any file of the small sweep, less than one bulky shard (280 kB).
    for blocks in [340, 360, 380, 400, 420] {
        let run = Command::new("sh")
            .arg("-c")
            .arg(format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" --exact survival::limited --ignored"))
            .arg(&binary)
            .env(DIRECTORY, directory.path())
            .output()
            .unwrap();
        assert!(run.status.success(), "{}\n{}", run.status, String::from_utf8_lossy(&run.stdout));
        assert!(String::from_utf8_lossy(&run.stdout).contains("1 passed"));
        assert!(published_bytes(directory.path()) == reference());
    }
    assert!(verify(directory.path()).unwrap().is_sound());
}
