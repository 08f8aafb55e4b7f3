//! Any bytes between the records of a log: only records whose checksum fits count, and those around survive.

use std::collections::HashMap;
use std::fs;
use std::path::PathBuf;

use serde_json::Value;
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{Catalog, Inspection, Status, Warning, verify};
use tempfile::{TempDir, tempdir};

use crate::synthetic::{chains, open, output};

/// A line that begins so is given the checksum that fits the rest of it: a fuzzer does not guess one.
const SIGNED: &str = "!";

/// A results directory with a few cases, and its log.
struct Store {
    directory: TempDir,
    log: PathBuf,
    lines: Vec<String>,
    cases: HashMap<CaseId, Status>,
}

impl Store {
    fn new() -> Self {
        let directory = tempdir().expect("a temporary directory");
        let mut store = open(directory.path());
        let mut cases = HashMap::new();
        for chain in &chains(&output())[2..4] {
            store.commit(chain).expect("committed");
            cases.extend(chain.iter().map(|entry| (entry.id, entry.outcome)));
        }
        let log = directory.path().join("log/0001.jsonl");
        let text = fs::read_to_string(&log).expect("the log is there");
        Self { directory, log, lines: text.lines().map(str::to_owned).collect(), cases }
    }
}

thread_local! { static STORE: Store = Store::new(); }

/// Panics if a law is broken.
pub fn check(bytes: &[u8]) {
    STORE.with(|store| {
        let (before, after) = store.lines.split_at(store.lines.len() / 2);
        let mut lines: Vec<Vec<u8>> = before.iter().map(|line| line.clone().into_bytes()).collect();
        lines.extend(bytes.split(|byte| *byte == b'\n').map(signed));
        lines.extend(after.iter().map(|line| line.clone().into_bytes()));
        judge(store, &lines);
    });
}

fn signed(line: &[u8]) -> Vec<u8> {
    match line.strip_prefix(SIGNED.as_bytes()) {
        Some(record) => {
            let frame = format!("{{\"crc\":\"{:08x}\",\"record\":", crc32fast::hash(record));
            [frame.as_bytes(), record, b"}"].concat()
        }
        None => line.to_vec(),
    }
}

fn judge(store: &Store, lines: &[Vec<u8>]) {
    fs::write(&store.log, lines.join(&b'\n')).expect("written");
    let held = Catalog::read(store.directory.path(), &output(), Inspection::Bytes).expect("any log is read");

    // Which lines count, found in another way than the program does.
    let records: Vec<Option<&[u8]>> = lines.iter().map(|line| fitting(line)).collect();
    for number in (1..).zip(&records).filter_map(|(number, record)| record.is_none().then_some(number)) {
        assert!(held.warnings().iter().any(|warning| warns_of(warning, number)), "no warning of line {number}");
    }
    let known = |line: &[u8]| store.lines.iter().any(|known| known.as_bytes() == line);
    let strangers: Vec<Value> = lines
        .iter()
        .zip(&records)
        .filter(|(line, _)| !known(line))
        .filter_map(|(_, record)| serde_json::from_slice((*record)?).ok())
        .collect();
    match strangers.is_empty() {
        true => {
            assert_eq!(held.known(), store.cases.len() as u64, "only what was stored is held");
            assert!(store.cases.iter().all(|(&id, &status)| held.holds(id) == Some(status)), "and all of it");
        }
        false => {
            let claimed: Vec<CaseId> = strangers.iter().flat_map(cases).collect();
            assert!(held.known() <= (store.cases.len() + claimed.len()) as u64);
            for id in claimed {
                // What a record says of a shard that holds something else is an error, and no case.
                assert!(held.entry(id).ok().flatten().is_none_or(|entry| entry.id == id));
            }
        }
    }
    held.is_published();
    held.visit_failures(|_, _, _| ()).expect("told");
    verify(store.directory.path()).expect("any log is verified");
}

/// The record in a line whose checksum fits.
fn fitting(line: &[u8]) -> Option<&[u8]> {
    let record = line.strip_prefix(b"{\"crc\":\"")?.get(8..)?.strip_prefix(b"\",\"record\":")?.strip_suffix(b"}")?;
    let checksum = format!("{:08x}", crc32fast::hash(record));
    line[8..16].eq_ignore_ascii_case(checksum.as_bytes()).then_some(record)
}

fn warns_of(warning: &Warning, number: u64) -> bool {
    matches!(warning, Warning::Record { line, more, .. } if (*line..=line + more).contains(&number))
}

/// The cases that a record names.
fn cases(record: &Value) -> Vec<CaseId> {
    let cases = record["cases"].as_array().into_iter().flatten();
    cases.filter_map(|case| case["case"].as_str()?.parse().ok()).collect()
}
