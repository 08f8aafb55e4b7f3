//! All that is stored of a sweep: in its results directory, and in the parts below it.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::CliError;
use crate::model::{CaseId, Output};
use crate::store::{Counts, Holdings, Inspection, Status, StoreError};
use crate::sweep::Part;

/// Where the parts of a sweep are, each a results directory of its own.
const PARTS: &str = "parts";

/// The directory of a part.
pub fn part_directory(directory: &Path, part: Part) -> PathBuf {
    directory.join(PARTS).join(part.name())
}

/// The parts that a results directory has, in their order.
pub fn parts(directory: &Path) -> Result<Vec<Part>, CliError> {
    let path = directory.join(PARTS);
    let failed = |source| CliError::Directory { action: "read", path: path.clone(), source };
    let entries = match fs::read_dir(&path) {
        Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => return Ok(Vec::new()),
        entries => entries.map_err(failed)?,
    };
    let mut parts = Vec::new();
    for entry in entries {
        let entry = entry.map_err(failed)?;
        parts.extend(entry.file_name().to_str().and_then(Part::named).filter(|_| entry.path().is_dir()));
    }
    parts.sort();
    Ok(parts)
}

/// The sweep file as it was run last in a results directory or in one of its parts; where none is there, where it would be.
pub fn sweep_file(directory: &Path) -> Result<PathBuf, CliError> {
    let own = directory.join("sweep.toml");
    let of_parts = parts(directory)?.into_iter().map(|part| part_directory(directory, part).join("sweep.toml"));
    let mut newest = None;
    for path in std::iter::once(own.clone()).chain(of_parts) {
        // Of those that are there: a part that has only just begun has none yet.
        if let Ok(written) = path.metadata().and_then(|metadata| metadata.modified())
            && newest.as_ref().is_none_or(|(last, _)| written >= *last)
        {
            newest = Some((written, path));
        }
    }
    Ok(newest.map_or(own, |(_, path)| path))
}

/// What a results directory and its parts hold.
#[derive(Debug, Default)]
pub struct Collection {
    /// The directory itself, if it has results.
    pub whole: Option<Holdings>,
    /// Its parts.
    pub parts: Vec<(Part, Holdings)>,
}

impl Collection {
    /// Reads a directory and its parts, without locking or changing them.
    ///
    /// # Errors
    /// As for [`Holdings::read`]; that a directory holds no results is none.
    pub fn read(directory: &Path, output: &Output, inspection: Inspection) -> Result<Self, CliError> {
        Self::read_some(directory, output, inspection, |_| true)
    }

    /// The same with some of the parts only.
    pub fn read_some(
        directory: &Path,
        output: &Output,
        inspection: Inspection,
        wanted: impl Fn(Part) -> bool,
    ) -> Result<Self, CliError> {
        let mut held = Vec::new();
        for part in parts(directory)?.into_iter().filter(|part| wanted(*part)) {
            // One that has only just begun is none yet.
            if let Some(holdings) = read(&part_directory(directory, part), output, inspection)? {
                held.push((part, holdings));
            }
        }
        Ok(Self { whole: read(directory, output, inspection)?, parts: held })
    }

    /// True if there are no results at all.
    pub fn is_empty(&self) -> bool {
        self.whole.is_none() && self.parts.is_empty()
    }

    /// The directory itself, then its parts.
    pub fn all(&self) -> Vec<&Holdings> {
        self.whole.iter().chain(self.parts.iter().map(|(_, holdings)| holdings)).collect()
    }

    /// The directory or part that holds a case best: with all that is asked for, or at all; the first one if none does.
    ///
    /// # Panics
    /// If there are no results.
    pub fn best(&self, id: CaseId) -> &Holdings {
        let all = self.all();
        let holds = all.iter().find(|held| held.holds(id).is_some());
        holds.or_else(|| all.iter().find(|held| held.knows(id))).unwrap_or(&all[0])
    }
}

/// What a directory holds; `None` if it has no results.
fn read(directory: &Path, output: &Output, inspection: Inspection) -> Result<Option<Holdings>, CliError> {
    match Holdings::read(directory, output, inspection) {
        Ok(held) => Ok(Some(held)),
        Err(StoreError::NotResults { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// What became of a case, wherever it is held: converged if it is anywhere.
pub fn holds(held: &[&Holdings], id: CaseId) -> Option<Status> {
    let statuses = held.iter().filter_map(|held| held.holds(id));
    statuses.max_by_key(|status| *status == Status::Converged)
}

/// The longest time limit at which a case was given up; `None` if one failure of it is not for that reason.
pub fn time_limit(held: &[&Holdings], id: CaseId) -> Option<f64> {
    let here = held.iter().filter(|held| held.holds(id).is_some());
    let limits: Option<Vec<f64>> = here.map(|held| held.time_limit(id)).collect();
    limits?.into_iter().reduce(f64::max)
}

/// True if nothing is held.
pub fn is_nothing(held: &[&Holdings]) -> bool {
    held.iter().all(|held| held.counts() == Counts::default())
}
