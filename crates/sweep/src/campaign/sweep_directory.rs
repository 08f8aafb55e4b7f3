//! What a results directory and the parts below it hold.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::{CampaignError, MergedCatalog};
use crate::store::{Catalog, Inspection, Store, StoreError, StoredOutput, holds_text};
use crate::{Part, Sweep};
use stribeck_input::InputError;

/// The name of the directory in which the parts of a sweep are, each a results directory of its own.
const PARTS: &str = "parts";

/// The name of the copy of the sweep file in a results directory.
const COPY: &str = "sweep.toml";

/// What the results directory of a sweep and its parts hold.
#[derive(Debug, Default)]
pub struct SweepDirectory {
    /// What the directory itself holds; `None` if it has no results.
    pub whole: Option<Catalog>,
    /// What its parts hold, in the order of the parts.
    pub parts: Vec<(Part, Catalog)>,
}

impl SweepDirectory {
    /// Reads a directory and its parts, without locking or changing them. `output` is what counts as done.
    ///
    /// # Errors
    /// As for [`Catalog::read`]; a directory without results is no error.
    pub fn read(
        directory: &Path,
        output: impl Into<StoredOutput>,
        inspection: Inspection,
    ) -> Result<Self, CampaignError> {
        Self::read_parts(directory, &output.into(), inspection, |_| true)
    }

    /// Reads a directory and those of its parts that are wanted.
    pub(super) fn read_parts(
        directory: &Path,
        output: &StoredOutput,
        inspection: Inspection,
        wanted: impl Fn(Part) -> bool,
    ) -> Result<Self, CampaignError> {
        let mut found = Vec::new();
        for part in parts(directory)?.into_iter().filter(|part| wanted(*part)) {
            // One that has only just begun has no results yet.
            if let Some(catalog) = read(&part_directory(directory, part), output, inspection)? {
                found.push((part, catalog));
            }
        }
        Ok(Self { whole: read(directory, output, inspection)?, parts: found })
    }

    /// Reads a directory that must have results, itself or in its parts.
    pub(super) fn read_existing(
        directory: &Path,
        output: &StoredOutput,
        inspection: Inspection,
    ) -> Result<Self, CampaignError> {
        let mut found = Self::read(directory, output, inspection)?;
        if found.is_empty() {
            found.whole = Some(Catalog::read(directory, output, inspection)?);
        }
        Ok(found)
    }

    /// True if there are no results at all.
    pub fn is_empty(&self) -> bool {
        self.whole.is_none() && self.parts.is_empty()
    }

    /// The catalogs of the directory itself, then of its parts.
    pub fn catalogs(&self) -> Vec<&Catalog> {
        self.whole.iter().chain(self.parts.iter().map(|(_, catalog)| catalog)).collect()
    }

    /// All catalogs as one.
    pub fn merged(&self) -> MergedCatalog<'_> {
        MergedCatalog::new(self.catalogs())
    }
}

/// What a directory holds; `None` if it has no results.
fn read(directory: &Path, output: &StoredOutput, inspection: Inspection) -> Result<Option<Catalog>, CampaignError> {
    match Catalog::read(directory, output, inspection) {
        Ok(catalog) => Ok(Some(catalog)),
        Err(StoreError::NotResults { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// The directory of a part.
pub(super) fn part_directory(directory: &Path, part: Part) -> PathBuf {
    directory.join(PARTS).join(part.name())
}

/// The parts that a results directory has, in their order.
pub(super) fn parts(directory: &Path) -> Result<Vec<Part>, CampaignError> {
    let path = directory.join(PARTS);
    let failed = |source| CampaignError::Parts { path: path.clone(), source };
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

/// The directories of the parts that a results directory has.
pub(super) fn part_directories(directory: &Path) -> Result<Vec<PathBuf>, CampaignError> {
    Ok(parts(directory)?.into_iter().map(|part| part_directory(directory, part)).collect())
}

/// The copy of the sweep file that was run last in a results directory or in one of its parts; where there is none, the
/// path at which it would be.
///
/// # Errors
/// [`CampaignError::Parts`] if the parts cannot be listed.
pub fn sweep_file(directory: &Path) -> Result<PathBuf, CampaignError> {
    let own = directory.join(COPY);
    let of_parts = part_directories(directory)?.into_iter().map(|part| part.join(COPY));
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

/// Reads a sweep file, or the copy of it in a results directory.
///
/// The copy keeps the name under which the sweep was run, which is the title of a sweep whose file gives none.
///
/// # Errors
/// [`CampaignError::Input`] if the file is not a valid sweep, [`CampaignError::Store`] if the log beside a copy cannot
/// be read.
pub fn read_sweep(path: &Path) -> Result<Sweep, CampaignError> {
    let sweep = if path.ends_with(COPY) { read_copy(path)? } else { Sweep::read(path)? };
    let home = path.parent().filter(|home| path.ends_with(COPY) && home.join("log").is_dir());
    let name = match home.map(Catalog::name_of_sweep) {
        Some(Ok(Some(name))) => name,
        // Other directories than those of results have a directory `log` as well.
        Some(Err(StoreError::NotResults { .. }) | Ok(None)) | None => return Ok(sweep),
        Some(Err(error)) => return Err(error.into()),
    };
    Ok(Sweep::parse(&name, &sweep.text)?)
}

/// Reads the copy of a sweep file in a results directory. A pipe or a device in its place might never end.
pub(super) fn read_copy(path: &Path) -> Result<Sweep, InputError> {
    match path.metadata() {
        Ok(metadata) if !metadata.is_file() && !metadata.is_dir() => {
            let cause = io::Error::new(ErrorKind::InvalidInput, "it is no file");
            Err(InputError::Unreadable { kind: "sweep file", path: path.to_owned(), cause })
        }
        _ => Sweep::read(path),
    }
}

/// Checks that a sweep could be run into a directory: it is no file, and holds no files of others that a run would
/// replace.
///
/// # Errors
/// [`CampaignError::NotADirectory`], and [`StoreError::Occupied`] or [`StoreError::NotText`] in
/// [`CampaignError::Store`].
pub fn check_available(directory: &Path) -> Result<(), CampaignError> {
    check_directory(directory)?;
    Ok(Store::check_available(directory)?)
}

/// Checks that a path is no file.
pub(super) fn check_directory(path: &Path) -> Result<(), CampaignError> {
    if path.exists() && !path.is_dir() {
        return Err(CampaignError::NotADirectory { path: path.to_owned() });
    }
    Ok(())
}

/// The sweep that a directory was last run with, if its copy can be read.
pub(super) fn previous_sweep(directory: &Path) -> Option<Sweep> {
    read_copy(&directory.join(COPY)).ok()
}

/// True if a directory was last run with another sweep file.
pub(super) fn had_other_sweep(directory: &Path, sweep: &Sweep) -> bool {
    let previous = directory.join(COPY);
    previous.exists() && !holds_text(&previous, &sweep.text)
}
