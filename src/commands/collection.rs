//! All that is stored of a sweep: in its results directory, and in the parts below it.

use std::collections::HashMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::CliError;
use stribeck_solver::Output;
use stribeck_sweep::CaseId;
use stribeck_sweep::Part;
use stribeck_sweep::store::{Holdings, Inspection, Status, StoreError};

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

    /// All of them as one.
    pub fn held(&self) -> Held<'_> {
        Held::new(self.all())
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

/// Results directories as one: each case where it is held best.
///
/// Best is where it converged with all that is asked for, then where it failed so; of failures the one that was given most
/// time; then where it is stored at all.
#[derive(Debug)]
pub struct Held<'a> {
    all: Vec<&'a Holdings>,
    /// The place in `all` of the best holder of each case; `None` for a single directory, which is asked itself.
    best: Option<HashMap<CaseId, u32>>,
}

impl<'a> Held<'a> {
    /// Several directories as one. With more than one it takes some 16 bytes for each case.
    pub fn new(all: Vec<&'a Holdings>) -> Self {
        if all.len() <= 1 {
            return Self { all, best: None };
        }
        let mut best: HashMap<CaseId, u32> = HashMap::new();
        for (number, held) in (0..).zip(&all) {
            for id in held.ids() {
                let better = |there: &u32| worth(held, id) > worth(all[*there as usize], id);
                if best.get(&id).is_none_or(better) {
                    best.insert(id, number);
                }
            }
        }
        Self { all, best: Some(best) }
    }

    /// The directories.
    pub fn all(&self) -> &[&'a Holdings] {
        &self.all
    }

    /// Where a case is held best; `None` if it is held nowhere.
    pub fn holder(&self, id: CaseId) -> Option<&'a Holdings> {
        match &self.best {
            Some(best) => best.get(&id).map(|&number| self.all[number as usize]),
            None => self.all.first().copied().filter(|held| held.knows(id)),
        }
    }

    /// What became of a case; `None` if it is nowhere with all that is asked for.
    pub fn holds(&self, id: CaseId) -> Option<Status> {
        self.holder(id)?.holds(id)
    }

    /// How many cases are held, each counted once.
    pub fn known(&self) -> u64 {
        match &self.best {
            Some(best) => best.len() as u64,
            None => self.all.first().map_or(0, |held| held.known()),
        }
    }
}

/// How good it is to have a case from a directory that knows it.
fn worth(held: &Holdings, id: CaseId) -> (bool, bool, u64) {
    let status = held.holds(id);
    // Numbers above 0 are in the order of their bits; one that ended by itself had all the time it wanted.
    let time = held.time_limit(id).unwrap_or(f64::INFINITY).to_bits();
    (status.is_some(), status == Some(Status::Converged), time)
}
