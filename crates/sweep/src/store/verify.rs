//! Reads every byte of a results directory and compares it with what the log says.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::claims::{Claim, Inspection, LogContent, fault, open_checked, read_claims, shard_record};
use super::damage::{Damage, inspect};
use super::directory::Directory;
use super::files::{files_in, temporary_for};
use super::{StoreError, Warning};
use stribeck_input::{printable, shown};

/// A file that is not what the log says.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {what}; {remedy}", shown(file))]
pub struct Problem {
    /// The file.
    pub file: PathBuf,
    /// What is wrong with it.
    pub what: String,
    /// What to do.
    pub remedy: &'static str,
}

/// What [`verify`] found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct VerifyReport {
    /// Shards that the log names; without those that were damaged and replaced by others.
    pub shards: u64,
    /// Cases in them.
    pub cases: u64,
    /// Bytes of the shards read.
    pub bytes: u64,
    /// Published files that are as they were written.
    pub published: u64,
    /// Shards and published files that are not as they were written.
    pub problems: Vec<Problem>,
    /// Damaged lines of logs. They do no harm: what they recorded is solved again by the next run.
    pub warnings: Vec<Warning>,
    /// Files in `shards` that no record names; left by a run that was killed. They do no harm.
    pub unreferenced: Vec<PathBuf>,
    /// Damaged files in `shards` whose cases are all in other shards that are as they were written. They do no harm.
    pub replaced: Vec<PathBuf>,
}

impl VerifyReport {
    /// True if everything that the log names is as it was written.
    pub fn is_sound(&self) -> bool {
        self.problems.is_empty()
    }
}

const SOLVE_AGAIN: &str = "run the sweep that its cases are of again: they are solved anew";
const MAKE_READABLE: &str = "make it readable, or run the sweep again: what it records is solved anew";
const PUBLISH_AGAIN: &str = "run the sweep again: it is rebuilt from the shards";

/// Re-reads every shard against its record (size, checksum, cases, shapes) and the published files against theirs.
///
/// # Errors
/// [`StoreError`] if there is no results directory or it cannot be read. Damage is no error but a problem in the
/// report.
pub fn verify(path: &Path) -> Result<VerifyReport, StoreError> {
    let directory = Directory::new(path);
    directory.must_exist()?;
    let LogContent { warnings, published, claims, .. } = read_claims(&directory)?;
    let (unreadable, warnings): (Vec<_>, Vec<_>) =
        warnings.into_iter().partition(|warning| matches!(warning, Warning::Unreadable { .. }));
    let mut report = VerifyReport { warnings, ..VerifyReport::default() };
    for warning in &unreadable {
        if let Warning::Unreadable { file, line, what } = warning {
            let what = format!("from line {line} on it cannot be read: {what}");
            report.problems.push(Problem { file: file.clone(), what, remedy: MAKE_READABLE });
        }
    }
    let mut named = HashSet::new();
    let path = |claim: &Claim| directory.shards().join(&claim.file.file);
    let (sound, damaged) = inspect(&directory, claims, |claim| shard_fault(&directory, &path(claim), claim))?;
    let (lossy, replaced): (Vec<_>, Vec<_>) = damaged.into_iter().partition(|damage| damage.lost > 0);
    for claim in sound.iter().chain(lossy.iter().map(|damage| &damage.claim)) {
        report.shards += 1;
        report.cases += claim.cases as u64;
        report.bytes += claim.file.bytes;
        named.insert(path(claim));
    }
    for Damage { claim, what, .. } in lossy {
        report.problems.push(Problem { file: path(&claim), what, remedy: SOLVE_AGAIN });
    }
    let replaced: HashSet<_> = replaced.iter().map(|damage| path(&damage.claim)).collect();
    for path in files_in(&directory.shards())? {
        if replaced.contains(&path) {
            report.replaced.push(path);
        } else if unreadable.is_empty() && !named.contains(&path) && temporary_for(&path).is_none() {
            report.unreferenced.push(path);
        }
    }
    for file in published.iter().flat_map(|last| &last.files) {
        let path = directory.published(&file.file);
        match fault(&path, file, Inspection::Bytes) {
            None => report.published += 1,
            Some(what) => report.problems.push(Problem { file: path, what, remedy: PUBLISH_AGAIN }),
        }
    }
    Ok(report)
}

fn shard_fault(directory: &Directory, path: &Path, claim: &Claim) -> Option<String> {
    match shard_record(directory, claim.place).and_then(|record| open_checked(path, &record)) {
        Ok(_) => None,
        Err(StoreError::Damaged { what, .. }) => Some(what),
        Err(StoreError::Hdf5 { source, .. }) => Some(printable(&source.to_string()).into_owned()),
        Err(error) => Some(error.to_string()),
    }
}
