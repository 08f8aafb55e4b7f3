//! What a results directory holds, read as `docs/reference/output.md` describes it, with nothing of the program.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

/// Cases by their ids, each with what became of it.
pub type Cases = BTreeMap<String, String>;

/// A valid record of a shard.
#[derive(Clone, Debug)]
pub struct Commit {
    /// Where the record stands.
    pub place: Line,
    /// The line itself.
    pub line: String,
    /// Name of the shard.
    pub file: String,
    /// What the shard holds beside the columns.
    pub contents: Value,
    /// The cases of the record.
    pub cases: Cases,
    /// True if the shard is there, with the size and checksum of the record.
    pub sound: bool,
}

/// A line of a log, both from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Line {
    /// Number of the log.
    pub log: u32,
    /// Line in it.
    pub line: usize,
}

/// What the log of a start says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Start {
    /// Number of the log.
    pub log: u32,
    /// Cases to be solved, and threads; `None` without a valid first record.
    pub beginning: Option<[u64; 2]>,
    /// Cases committed.
    pub done: usize,
    /// How it ended, if it says so.
    pub ending: Option<String>,
    /// The times of its records, in seconds since 1970.
    pub times: Vec<u64>,
}

/// What a results directory holds.
#[derive(Clone, Debug)]
pub struct Stored {
    /// Valid records of shards, oldest first.
    pub commits: Vec<Commit>,
    /// Lines that are no valid record.
    pub damaged: Vec<Line>,
    /// The starts, oldest first.
    pub starts: Vec<Start>,
    /// True if the newest record of a publication is newer than all shards, and its files are as it says.
    pub published: bool,
}

impl Stored {
    /// Reads a directory. One that is not there yet holds nothing.
    pub fn read(results: &Path) -> Self {
        let mut stored = Self { commits: Vec::new(), damaged: Vec::new(), starts: Vec::new(), published: false };
        for (log, path) in logs(results) {
            stored.starts.push(Start { log, beginning: None, done: 0, ending: None, times: Vec::new() });
            let content = fs::read(&path).expect("a log can be read");
            let whole = content.strip_suffix(b"\n").unwrap_or(&content);
            // An empty log has no line, not an empty one.
            let lines = whole.split(|&byte| byte == b'\n').filter(|_| !content.is_empty());
            for (line, text) in (1..).zip(lines) {
                let place = Line { log, line };
                match record(text) {
                    Some(record) => stored.note(results, place, text, &record),
                    None => stored.damaged.push(place),
                }
            }
        }
        stored
    }

    fn note(&mut self, results: &Path, place: Line, line: &[u8], record: &Value) {
        let start = self.starts.last_mut().expect("its log");
        let number = |key: &str| record[key].as_u64().expect("a number");
        start.times.push(number("time"));
        match record["kind"].as_str().expect("a kind") {
            "start" => start.beginning = Some([number("cases"), number("threads")]),
            "end" => start.ending = Some(text(&record["ending"])),
            "published" => {
                let files = record["files"].as_array().expect("files");
                self.published = files.iter().all(|file| is_as_recorded(results, file));
            }
            "shard" => {
                let cases = record["cases"].as_array().expect("cases").iter();
                let cases: Cases = cases.map(|case| (text(&case["case"]), text(&case["status"]))).collect();
                start.done += cases.len();
                self.published = false;
                self.commits.push(Commit {
                    place,
                    line: String::from_utf8(line.to_owned()).expect("text"),
                    file: text(&record["file"]),
                    contents: json!([record["fields"], record["x"], record["limits"]]),
                    cases,
                    sound: is_as_recorded(&results.join("shards"), record),
                });
            }
            kind => panic!("docs/reference/output.md knows no record of the kind {kind}"),
        }
    }

    /// The cases that are done, of shards with these contents; without what `lost` says of their commits.
    pub fn cases_without(&self, contents: &Value, lost: impl Fn(&Commit) -> bool) -> Cases {
        let commits = self.commits.iter().filter(|commit| commit.sound && commit.contents == *contents);
        commits.filter(|commit| !lost(commit)).flat_map(|commit| commit.cases.clone()).collect()
    }

    /// The cases of all shards that are as they were recorded.
    pub fn sound_cases(&self) -> Cases {
        self.commits.iter().filter(|commit| commit.sound).flat_map(|commit| commit.cases.clone()).collect()
    }

    /// Damaged shards, each with the number of its cases that no sound one holds; those that lost nothing are left out.
    pub fn lossy(&self) -> Vec<(String, usize)> {
        let newest: BTreeMap<&String, &Commit> = self.commits.iter().map(|commit| (&commit.file, commit)).collect();
        let lost = |commit: &Commit| {
            let held = self.cases_without(&commit.contents, |_| false);
            commit.cases.keys().filter(|case| !held.contains_key(*case)).count()
        };
        let damaged = newest.into_values().filter(|commit| !commit.sound);
        damaged.map(|commit| (commit.file.clone(), lost(commit))).filter(|(_, lost)| *lost > 0).collect()
    }

    /// Names of the shards that are there as they were recorded, each once.
    pub fn sound_files(&self) -> BTreeSet<String> {
        let files = self.commits.iter().filter(|commit| commit.sound).map(|commit| commit.file.clone());
        files.collect()
    }
}

/// The logs of a directory, oldest first.
pub fn logs(results: &Path) -> Vec<(u32, PathBuf)> {
    let Ok(entries) = fs::read_dir(results.join("log")) else { return Vec::new() };
    let paths = entries.map(|entry| entry.expect("listed").path());
    let numbered = |path: PathBuf| Some((path.file_name()?.to_str()?.strip_suffix(".jsonl")?.parse().ok()?, path));
    let mut logs: Vec<_> = paths.filter_map(numbered).collect();
    logs.sort();
    logs
}

/// The record of a line `{"crc":"xxxxxxxx","record":{…}}`, if its checksum fits.
fn record(line: &[u8]) -> Option<Value> {
    let line = std::str::from_utf8(line).ok()?;
    let (checksum, record) = line.strip_prefix(r#"{"crc":""#)?.split_once(r#"","record":"#)?;
    let record = record.strip_suffix('}')?;
    let fits = checksum.len() == 8 && u32::from_str_radix(checksum, 16).ok()? == crc32fast::hash(record.as_bytes());
    fits.then(|| serde_json::from_str(record).expect("a record with a checksum that fits is JSON"))
}

/// Whether the file that a record names is there, with the size and checksum of the record.
fn is_as_recorded(directory: &Path, record: &Value) -> bool {
    let Ok(bytes) = fs::read(directory.join(text(&record["file"]))) else { return false };
    Some(bytes.len() as u64) == record["bytes"].as_u64() && blake3::hash(&bytes).to_string() == text(&record["blake3"])
}

fn text(value: &Value) -> String {
    value.as_str().expect("a string").to_owned()
}
