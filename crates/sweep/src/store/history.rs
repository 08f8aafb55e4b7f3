//! When a directory was worked on, and how far each run came.

use std::collections::BTreeMap;

use super::record::Record;
use super::{Ending, Status};

/// What the logs tell of the runs of a directory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    starts: BTreeMap<u32, Start>,
    /// True if cases were committed after the last publication.
    pub(super) unpublished: bool,
}

/// One run: what its log tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Start {
    /// Who began, to do what; `None` for a run that only published, or whose first line is damaged.
    pub beginning: Option<Beginning>,
    /// Time of the last record, in seconds since 1970.
    pub last: u64,
    /// Cases committed that converged.
    pub converged: u64,
    /// Cases committed that failed.
    pub failed: u64,
    /// Sum of the seconds of the cases committed, over all threads.
    pub case_seconds: f64,
    /// How it ended; `None` if it was killed, or is still running.
    pub ending: Option<Ending>,
}

/// The first record of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beginning {
    /// Program and version.
    pub program: String,
    /// Name of the sweep, which is its title where the sweep file has none; empty if it is not known.
    pub sweep: String,
    /// Cases it set out to solve.
    pub cases: u64,
    /// Threads it used.
    pub threads: u64,
    /// When, in seconds since 1970.
    pub time: u64,
}

impl Start {
    /// Cases per second of wall clock, from the beginning to the last record; `None` before a second has passed.
    pub fn rate(&self) -> Option<f64> {
        let seconds = self.last.checked_sub(self.beginning.as_ref()?.time).filter(|&seconds| seconds > 0)?;
        Some((self.converged + self.failed) as f64 / seconds as f64)
    }
}

impl History {
    /// The name of the sweep that was run last; `None` if it is not known.
    pub fn sweep(&self) -> Option<&str> {
        let beginnings = self.starts.values().rev().filter_map(|start| start.beginning.as_ref());
        beginnings.map(|beginning| beginning.sweep.as_str()).find(|name| !name.is_empty())
    }

    /// The runs, oldest first, each with the number of its log.
    pub fn starts(&self) -> impl DoubleEndedIterator<Item = (u32, &Start)> {
        self.starts.iter().map(|(&number, start)| (number, start))
    }

    pub(super) fn note(&mut self, log: u32, record: &Record) {
        match record {
            Record::Shard(_) => self.unpublished = true,
            Record::Published { .. } => self.unpublished = false,
            Record::Start { .. } | Record::End { .. } => {}
        }
        let start = self.starts.entry(log).or_default();
        let time = match record {
            Record::Start { program, sweep, cases, threads, time } => {
                let (program, sweep) = (program.clone(), sweep.clone());
                let beginning = Beginning { program, sweep, cases: *cases, threads: *threads, time: *time };
                start.beginning = Some(beginning);
                *time
            }
            Record::Shard(shard) => {
                for case in &shard.cases {
                    match case.status {
                        Status::Converged => start.converged += 1,
                        Status::Failed => start.failed += 1,
                    }
                    start.case_seconds += case.seconds;
                }
                shard.time
            }
            Record::Published { time, .. } => *time,
            Record::End { ending, time } => {
                start.ending = Some(*ending);
                *time
            }
        };
        start.last = start.last.max(time);
    }
}
