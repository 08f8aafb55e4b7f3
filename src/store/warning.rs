//! What the store found damaged and left out.

use std::path::PathBuf;

/// Something of a results directory that is not used. The cases concerned count as not done.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Warning {
    /// A line of a log that is no record.
    #[error("{}, line {line}: {what}; the record is not used, and its cases are solved again", file.display())]
    Record {
        /// The log.
        file: PathBuf,
        /// Line, from 1.
        line: u64,
        /// What is wrong with it.
        what: String,
    },
    /// A shard that is not what its record says.
    #[error("{}: {what}; its {cases} cases are not used, and solved again", file.display())]
    Shard {
        /// The shard.
        file: PathBuf,
        /// What is wrong with it.
        what: String,
        /// How many cases it held.
        cases: usize,
    },
}
