//! What ends a campaign.

use std::io;
use std::path::PathBuf;

use super::Pending;
use crate::engine::ThreadsError;
use crate::store::StoreError;
use stribeck_input::{InputError, shown};

/// Why a sweep could not be run, merged or looked at. A case that fails is no error but a result.
#[derive(Debug, thiserror::Error)]
pub enum CampaignError {
    /// A sweep file is not valid.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A results directory cannot be read or written.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The system does not start as many threads as wanted.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// A file stands where the results directory would be.
    #[error("{} is a file, and results need a directory", shown(path))]
    NotADirectory {
        /// The file.
        path: PathBuf,
    },
    /// The directory of the parts cannot be listed.
    #[error("cannot read the directory {}: {source}", shown(path))]
    Parts {
        /// The directory.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The disk or a file ended a run.
    #[error(
        "{source}; {} cases are saved in {}, {} are left: run the sweep again to resume it",
        left.reused(), shown(directory), left.to_do()
    )]
    Stopped {
        /// What happened.
        source: StoreError,
        /// The directory in which the run worked.
        directory: PathBuf,
        /// What is done, and what is left.
        left: Box<Pending>,
    },
    /// No directory was named from which to merge.
    #[error("there is nothing to merge; name at least one results directory")]
    NothingToMerge,
    /// Directories that were to be merged belong to different sweeps.
    #[error(
        "{} and {} are not of the same sweep: only runs of one sweep file can be joined; merge the parts of an \
         earlier one and delete them first",
        shown(first),
        shown(other)
    )]
    OtherSweep {
        /// A sweep file.
        first: PathBuf,
        /// One that differs.
        other: PathBuf,
    },
    /// An axis that a sweep has not got.
    #[error("the sweep has no axis {name:?}; name axes of it, with values in SI units, as in speed=0.01,load=100")]
    NoSuchAxis {
        /// The name.
        name: String,
    },
    /// A results directory does not know a case.
    #[error(
        "{} has no case of this id: ids stand in the column `case` of summary.csv; or give f, alpha and beta, as in \
         100,1,1000",
        shown(directory)
    )]
    NoSuchCase {
        /// The results directory.
        directory: PathBuf,
    },
}
