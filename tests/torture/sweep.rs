//! The sweeps that are tortured, and what an undisturbed run makes of each.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use crate::torture::place::Place;
use crate::torture::stored::{Cases, Commit, Stored};

/// A sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sweep {
    /// About half a second of work on one thread, in several commits. All cases converge.
    Converging,
    /// The same with another tolerance, so that no case is one of the other sweep, and with cases that fail.
    Failing,
    /// As little as fills a page of the log.
    Small,
}

/// What a run leaves that nothing disturbs.
pub struct Undisturbed {
    /// `summary.csv` and `results.h5`.
    pub bytes: [Vec<u8>; 2],
    /// Exit code.
    pub code: i32,
    /// What became of each case.
    pub cases: Cases,
    /// The case at each place of the sweep, by f, alpha and beta as the summary has them.
    pub places: BTreeMap<[String; 3], String>,
    /// What a shard of the sweep holds beside the columns, as its record says it.
    pub contents: serde_json::Value,
    /// How long it took on one thread.
    pub duration: Duration,
    /// Its shards: name, bytes, and the line of the log.
    pub shards: Vec<(String, Vec<u8>, String)>,
}

/// The published files that are the same in every run.
pub const SAME_IN_EVERY_RUN: [&str; 2] = ["summary.csv", "results.h5"];

impl Sweep {
    /// The sweep file.
    pub fn text(self) -> String {
        let (alpha, points, tolerance, fields) = match self {
            Self::Converging => ("[1.0, 10.0, 100.0]", 450, "1e-8", r#"["pressure", "film_thickness"]"#),
            // No case with such an alpha can be solved.
            Self::Failing => ("[1.0, 10.0, 1e60]", 450, "1e-7", r#"["pressure", "film_thickness"]"#),
            Self::Small => ("[1.0, 100.0]", 20, "1e-4", "[]"),
        };
        format!(
            r#"title = "Tortured"
[axes]
f = [0.0, 10.0]
alpha = {alpha}
beta = {{ from = 10.0, to = 100.0, points = {points}, scale = "log" }}
[solver]
tolerance = {tolerance}
[output]
fields = {fields}
x = {{ from = -2.0, to = 2.0, points = 81 }}
"#
        )
    }

    /// A sweep of the same shape and none of the same cases.
    pub fn other(self) -> Self {
        match self {
            Self::Converging | Self::Small => Self::Failing,
            Self::Failing => Self::Converging,
        }
    }

    /// What an undisturbed run makes of it on one thread; run once in this process.
    pub fn undisturbed(self) -> &'static Undisturbed {
        static RUNS: [OnceLock<Undisturbed>; 3] = [const { OnceLock::new() }; 3];
        RUNS[self as usize].get_or_init(|| Undisturbed::run(self))
    }
}

impl Undisturbed {
    fn run(sweep: Sweep) -> Self {
        let place = Place::fresh(sweep);
        let start = Instant::now();
        let end = place.run(1);
        let duration = start.elapsed();
        let code = end.code.unwrap_or_else(|| panic!("the undisturbed run was killed: {}", end.err));
        assert_eq!(code, if sweep == Sweep::Failing { 3 } else { 0 }, "{}", end.err);

        let bytes = SAME_IN_EVERY_RUN.map(|name| fs::read(place.results().join(name)).expect("published"));
        let mut rows = csv::Reader::from_reader(&bytes[0][..]);
        let header = rows.headers().expect("a header").clone();
        let column = |name| header.iter().position(|column| column == name).expect("a column");
        let (case, status, parameters) = (column("case"), column("status"), ["f", "alpha", "beta"].map(column));
        let rows: Vec<_> = rows.records().map(|row| row.expect("a row")).collect();
        let cases: Cases = rows.iter().map(|row| (row[case].to_owned(), row[status].to_owned())).collect();

        let stored = Stored::read(&place.results());
        let held: BTreeSet<&String> = stored.commits.iter().flat_map(|commit| commit.cases.keys()).collect();
        assert!(held.into_iter().eq(cases.keys()), "the log and the summary have the same cases");
        let shard = |commit: &Commit| {
            let bytes = fs::read(place.results().join("shards").join(&commit.file)).expect("a shard");
            (commit.file.clone(), bytes, commit.line.clone())
        };
        Self {
            code,
            places: rows
                .iter()
                .map(|row| (parameters.map(|name| row[name].to_owned()), row[case].to_owned()))
                .collect(),
            cases,
            contents: stored.commits[0].contents.clone(),
            duration,
            shards: stored.commits.iter().map(shard).collect(),
            bytes,
        }
    }
}
