//! What stops the store: always the disk or a file.

use std::io;
use std::path::{Path, PathBuf};

use crate::CaseId;
use stribeck_input::{printable, shown};

/// Why a results directory cannot be read or written. Each text says what happened to which file and what to do next.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// The operating system refused.
    #[error("cannot {action} {}: {source}; {}", shown(path), remedy(source))]
    File {
        /// The file or directory.
        path: PathBuf,
        /// What was tried, as a verb.
        action: &'static str,
        /// What the system said.
        source: io::Error,
    },
    /// Published files of two states.
    #[error(
        "{source}\nsome published files in {} are new and some of before: do not use them until the same command has \
         run again, which replaces them all",
        shown(directory)
    )]
    Mixed {
        /// The results directory.
        directory: PathBuf,
        /// What the system said.
        source: Box<StoreError>,
    },
    /// The HDF5 library refused.
    #[error("cannot {action} {}: {}", shown(path), hdf5_reason(source, *disk_full))]
    Hdf5 {
        /// The HDF5 file.
        path: PathBuf,
        /// What was tried, as a verb.
        action: &'static str,
        /// What the library said.
        source: hdf5::Error,
        /// True if the library reports that no space is left.
        disk_full: bool,
    },
    /// Another process works on the directory.
    #[error(
        "{} is in use by another run ({owner}); wait until it ends or stop it, or choose another directory with -o",
        shown(path)
    )]
    Locked {
        /// The results directory.
        path: PathBuf,
        /// Who holds the lock, as far as known.
        owner: String,
    },
    /// A path that holds no results.
    #[error("{} is not a results directory: {what}; give the directory that `stribeck run` wrote", shown(path))]
    NotResults {
        /// The path given.
        path: PathBuf,
        /// What is missing.
        what: &'static str,
    },
    /// A results directory without published files.
    #[error(
        "{} has no results.h5: nothing is published yet; run `stribeck run {} -o {}` to its end",
        shown(path),
        shown(sweep),
        shown(path)
    )]
    Unpublished {
        /// The results directory.
        path: PathBuf,
        /// Its sweep file.
        sweep: PathBuf,
    },
    /// A published file that is not as it was written.
    #[error(
        "{} is not as it was published: {}; run `stribeck run {}` with the same -o again, which rebuilds it",
        shown(path),
        printable(what),
        shown(sweep)
    )]
    Altered {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: String,
        /// The sweep file of its directory.
        sweep: PathBuf,
    },
    /// A path that HDF5 cannot take.
    #[error(
        "{} has bytes that are no UTF-8 text, and HDF5 opens no file under such a name; choose another directory with \
         -o",
        shown(path)
    )]
    NotText {
        /// The results directory.
        path: PathBuf,
    },
    /// A directory of someone else, whose files a run would replace.
    #[error("{} is not a results directory (it has {file} but no log); choose another directory with -o", shown(path))]
    Occupied {
        /// The directory.
        path: PathBuf,
        /// A file in it that has the name of one of ours.
        file: &'static str,
    },
    /// A lock that is no file of ours.
    #[error("{} is no lock that `stribeck run` wrote; move it away, or choose another directory with -o", shown(path))]
    ForeignLock {
        /// The file.
        path: PathBuf,
    },
    /// A file whose content is not what its record says.
    #[error("{} is damaged: {what}; delete it and run the sweep again, its cases are then solved anew", shown(path))]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// The same case with different numbers in two directories.
    #[error(
        "case {case} is in {} and in {} with numbers that differ by more than the tolerance; one of them is wrong: find \
         out by `stribeck explain`, delete that file, and start again",
        shown(first),
        shown(second)
    )]
    Disagreement {
        /// The case.
        case: CaseId,
        /// The shard that was there.
        first: PathBuf,
        /// The one that was to be joined.
        second: PathBuf,
    },
    /// Publishing an unfinished sweep.
    #[error("{missing} of {places} places of the sweep have no case yet; run the sweep again to finish it")]
    Unfinished {
        /// Places without a case.
        missing: u64,
        /// All places of the sweep.
        places: u64,
    },
    /// A case that cannot be stored as it was given.
    #[error("case {case} cannot be stored: {what}; this is an error of the program, please report it")]
    Entry {
        /// The case.
        case: CaseId,
        /// What is wrong with it.
        what: String,
    },
    /// A publication that contradicts itself.
    #[error("cannot publish: {what}; this is an error of the program, please report it")]
    Publication {
        /// The contradiction.
        what: String,
    },
}

impl StoreError {
    pub(crate) fn file(path: &Path, action: &'static str) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { path: path.to_owned(), action, source }
    }

    pub(super) fn hdf5(path: &Path, action: &'static str) -> impl Fn(hdf5::Error) -> Self {
        move |source| {
            let disk_full = mentions_full_disk(&source);
            Self::Hdf5 { path: path.to_owned(), action, source, disk_full }
        }
    }
}

const MAKE_SPACE: &str = "free some space and run the same command again: all that was committed is kept";

fn remedy(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => MAKE_SPACE,
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "check who may write there, or choose another directory with -o"
        }
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => "check the path",
        _ => "check the disk, then run the same command again: all that was committed is kept",
    }
}

/// HDF5 says much about a full disk (address of the buffer, offset …) that helps no one.
fn hdf5_reason(source: &hdf5::Error, disk_full: bool) -> String {
    if disk_full {
        return format!("no space left on the disk; {MAKE_SPACE}");
    }
    format!("{}; check the disk, and the directory with `stribeck verify`", printable(&source.to_string()))
}

/// HDF5 has no error code for a full disk: it quotes the system's error number in the text of an inner frame.
fn mentions_full_disk(error: &hdf5::Error) -> bool {
    let text = |frame: &hdf5::ErrorFrame| is_full_disk_text(&format!("{} {}", frame.desc(), frame.description()));
    error.stack().is_some_and(|stack| (0..stack.len()).any(|i| stack.get(i).is_some_and(text)))
}

fn is_full_disk_text(text: &str) -> bool {
    text.contains("No space left on device") || text.contains("Disk quota exceeded")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_is_recognised_and_nothing_else() {
        let error = |kind: io::ErrorKind| StoreError::file(Path::new("a"), "write")(kind.into());
        assert!(error(io::ErrorKind::StorageFull).to_string().contains("free some space"));
        assert!(!error(io::ErrorKind::PermissionDenied).to_string().contains("free some space"));
        assert!(is_full_disk_text("file write failed: errno = 28, error message = 'No space left on device'"));
        assert!(!is_full_disk_text("unable to open file: errno = 2, error message = 'No such file or directory'"));
    }
}
