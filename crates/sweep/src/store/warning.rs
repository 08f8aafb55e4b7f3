//! What the store warns of: what it found damaged and left out, and a directory that it cannot lock.

use std::path::PathBuf;
use stribeck_input::shown;

/// Something to know of a results directory. Cases in damaged files count as not done.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Warning {
    /// A line of a log that is no record, or several in a row.
    #[error(
        "{}, {}: {what}; what stood there is not used, and its cases are solved again",
        shown(file),
        lines(*line, *more)
    )]
    Record {
        /// The log.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// How many lines after it are none either.
        more: u64,
        /// What is wrong with it.
        what: String,
    },
    /// A log that cannot be read, from some line on.
    #[error(
        "{}, line {line}: from here on it cannot be read: {what}; what stands there is not used, and its cases are \
         solved again",
        shown(file)
    )]
    Unreadable {
        /// The log.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// What the system said.
        what: String,
    },
    /// A shard that is not what its record says.
    #[error("{}: {what}; its {cases} cases are not used, and solved again where the sweep has them", shown(file))]
    Shard {
        /// The shard.
        file: PathBuf,
        /// What is wrong with it.
        what: String,
        /// How many cases it held.
        cases: usize,
    },
    /// A file system that has no locks.
    #[error(
        "{}: this file system keeps no locks (flock), so nothing stops a second run from starting there; start only \
         one at a time, and ask for a mount with locks",
        shown(directory)
    )]
    NoLock {
        /// The results directory.
        directory: PathBuf,
    },
}

/// `line 3`, or `lines 3 to 5`.
fn lines(first: u64, more: u64) -> String {
    if more == 0 { format!("line {first}") } else { format!("lines {first} to {}", first + more) }
}
