//! The catalog of a results directory: which cases are stored there, and where.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::claims::{Claim, Inspection, LastPublished, LogContent, fault, open_checked, read_claims, shard_record};
use super::damage::{Damage, inspect};
use super::directory::Directory;
use super::index::{Index, Shard, Slot};
use super::log::read_logs;
use super::record::{CaseRecord, FileRecord, ShardRecord};
use super::shard::ShardReader;
use super::{CaseEntry, Contents, History, Status, StoreError, StoredOutput, Warning};
use crate::{CaseId, Values};
use stribeck_solver::Output;

/// The numbers of cases that a directory holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// That converged.
    pub converged: u64,
    /// That failed.
    pub failed: u64,
}

/// The catalog of a results directory, read from its logs.
///
/// It takes some 25 bytes of memory for each case; nothing else grows with the number of cases.
#[derive(Debug)]
pub struct Catalog {
    pub(super) directory: Directory,
    pub(super) wanted: StoredOutput,
    pub(super) index: Index,
    pub(super) history: History,
    pub(super) published: Option<LastPublished>,
    recipes: Vec<Value>,
    inspection: Inspection,
    warnings: Vec<Warning>,
}

/// Where a case is stored, and how it came there.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// The shard.
    pub shard: PathBuf,
    /// Row of the shard, from 0.
    pub row: u16,
    /// Number of the start, and of its log.
    pub start: u32,
    /// When it was committed, in seconds since 1970.
    pub time: u64,
    /// What it was solved with; null if that is not known.
    pub recipe: Value,
}

impl Catalog {
    /// Reads a directory without locking or changing it, also while a run works there.
    ///
    /// `output` is what counts as done: a case whose shard lacks a field or limit it asks for is not held. `inspection`
    /// is how closely shards are looked at: what passes a look at sizes alone may be found damaged by the next run.
    ///
    /// # Errors
    /// [`StoreError::NotResults`] if there is no results directory, others if it cannot be read.
    pub fn read(path: &Path, output: impl Into<StoredOutput>, inspection: Inspection) -> Result<Self, StoreError> {
        let directory = Directory::new(path);
        directory.must_exist()?;
        Self::load(directory, output.into(), inspection)
    }

    pub(super) fn load(directory: Directory, output: StoredOutput, inspection: Inspection) -> Result<Self, StoreError> {
        let wanted = Contents::of(&output);
        let LogContent { mut warnings, history, published, claims } = read_claims(&directory)?;
        let path = |claim: &Claim| directory.shards().join(&claim.file.file);
        let (sound, damaged) = inspect(&directory, claims, |claim| fault(&path(claim), &claim.file, inspection))?;
        for Damage { claim, what, lost: cases } in damaged.into_iter().filter(|damage| damage.lost > 0) {
            warnings.push(Warning::Shard { file: path(&claim), what, cases });
        }
        let (mut index, mut recipes) = (Index::default(), Vec::new());
        for Claim { file, contents, place, .. } in sound {
            let hash = file.blake3.parse().expect("claims have well-formed hashes");
            let (name, covers) = (file.file.into(), contents.covers(&wanted));
            let shard = index.add_shard(Shard { name, hash, contents, covers, record: place });
            let record = shard_record(&directory, place)?;
            for (row, case) in (0..).zip(record.cases) {
                index.add_case(case.case, Slot { shard, row, status: case.status }, case.time_limit);
            }
            if !record.recipe.is_null() && !recipes.contains(&record.recipe) {
                recipes.push(record.recipe);
            }
        }
        Ok(Self { directory, wanted: output, index, history, published, recipes, inspection, warnings })
    }

    /// The name of the sweep that was run last in a directory; `None` if it is not known.
    ///
    /// # Errors
    /// As for [`Catalog::read`].
    pub fn name_of_sweep(path: &Path) -> Result<Option<String>, StoreError> {
        let directory = Directory::new(path);
        directory.must_exist()?;
        let mut history = History::default();
        read_logs(&directory.logs(), &mut Vec::new(), |place, record| history.note(place.log, &record))?;
        Ok(history.sweep().map(str::to_owned))
    }

    /// The directory.
    pub fn path(&self) -> &Path {
        self.directory.root()
    }

    /// The output that a case must have to count as done.
    pub fn output(&self) -> &Output {
        &self.wanted.output
    }

    /// Files and records that are damaged and not used. Show them to the user.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    pub(super) fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }

    /// The status of a case; `None` if the case is not stored with everything that the output asks for.
    pub fn holds(&self, id: CaseId) -> Option<Status> {
        self.index.complete(id).map(|slot| slot.status)
    }

    /// True if a case is stored, whatever fields it has.
    pub fn knows(&self, id: CaseId) -> bool {
        self.index.any(id).is_some()
    }

    /// The ids of all stored cases, in no order.
    pub fn ids(&self) -> impl Iterator<Item = CaseId> {
        self.index.ids()
    }

    /// How many cases are here, whatever fields they have.
    pub fn known(&self) -> u64 {
        self.index.len() as u64
    }

    /// Names what the output asks for and a stored case does not have; empty if it has everything, or is not stored.
    pub fn lacks(&self, id: CaseId) -> Vec<&'static str> {
        let wanted = Contents::of(&self.wanted);
        self.index.any(id).map_or_else(Vec::new, |slot| self.index.shard(slot.shard).contents.lacks(&wanted))
    }

    /// The time limit in seconds at which a case was given up; `None` if it was not, or is not stored.
    pub fn time_limit(&self, id: CaseId) -> Option<f64> {
        self.index.any(id).and_then(|slot| self.index.time_limit(&slot))
    }

    /// The recipes that stored cases were solved with, each once, as it was given to [`super::Store::solving_with`].
    pub fn recipes(&self) -> &[Value] {
        &self.recipes
    }

    /// Who works in the directory, as in `process 4711`; `None` if no one does.
    ///
    /// # Errors
    /// [`StoreError::File`] if the lock cannot be looked at.
    pub fn owner(&self) -> Result<Option<String>, StoreError> {
        self.directory.owner()
    }

    /// True if the published files are there and no case was committed after them. They are looked at as closely as the
    /// shards were.
    pub fn is_published(&self) -> bool {
        let sound = |file: &FileRecord| fault(&self.directory.published(&file.file), file, self.inspection).is_none();
        self.published.as_ref().is_some_and(|last| !self.history.unpublished && last.files.iter().all(sound))
    }

    /// How many cases are here, whatever fields they have.
    pub fn counts(&self) -> Counts {
        Counts { converged: self.index.count(Status::Converged), failed: self.index.count(Status::Failed) }
    }

    /// The history of the runs so far.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Visits each failed case with the name of the kind of its failure, and with its reason.
    ///
    /// # Errors
    /// [`StoreError`] if a log cannot be read any more.
    pub fn visit_failures(&self, mut visit: impl FnMut(CaseId, &str, &str)) -> Result<(), StoreError> {
        for (number, shard) in self.index.shards() {
            for case in &shard_record(&self.directory, shard.record)?.cases {
                let counts = self.index.any(case.case).is_some_and(|slot| slot.shard == number);
                if let Some(kind) = case.failure_kind().filter(|_| counts) {
                    visit(case.case, kind, &case.reason);
                }
            }
        }
        Ok(())
    }

    /// Visits each stored case that has all that the output asks for: its id, its status, its reason and its numbers.
    ///
    /// # Errors
    /// [`StoreError`] if a shard or its record cannot be read.
    pub fn visit(&self, mut visit: impl FnMut(CaseId, Status, &str, Values)) -> Result<(), StoreError> {
        for (number, _) in self.index.shards() {
            let OpenShard { reader, .. } = self.open_shard(number)?;
            for (row, &id) in reader.ids().iter().enumerate() {
                if self.index.complete(id).is_some_and(|slot| slot.shard == number) {
                    visit(id, reader.status(row), reader.reason(row), reader.values(row));
                }
            }
        }
        Ok(())
    }

    /// A case as it was committed, with the fields its shard has; `None` if it is not here.
    ///
    /// # Errors
    /// [`StoreError`] if its shard or its record cannot be read.
    pub fn entry(&self, id: CaseId) -> Result<Option<CaseEntry>, StoreError> {
        let Some(slot) = self.index.any(id) else { return Ok(None) };
        let shard = self.open_shard(slot.shard)?;
        let row = usize::from(slot.row);
        let [sensitivities, sensitivity_errors] = shard.reader.sensitivities(row);
        let entry = CaseEntry {
            id,
            outcome: shard.reader.status(row),
            reason: shard.reader.reason(row).to_owned(),
            failure_kind: shard.cases[row].failure_kind().map(str::to_owned),
            values: shard.reader.values(row),
            fields: shard.reader.all_fields(row)?,
            sensitivities,
            sensitivity_errors,
            timing: shard.cases[row].timing(),
        };
        Ok(Some(entry))
    }

    /// Where a case is stored, and by which start; `None` if it is not here.
    ///
    /// # Errors
    /// [`StoreError`] if its record cannot be read any more.
    pub fn origin(&self, id: CaseId) -> Result<Option<Origin>, StoreError> {
        let Some(slot) = self.index.any(id) else { return Ok(None) };
        let shard = self.index.shard(slot.shard);
        let ShardRecord { recipe, time, .. } = shard_record(&self.directory, shard.record)?;
        let (shard, start) = (self.directory.shards().join(&*shard.name), shard.record.log);
        Ok(Some(Origin { shard, row: slot.row, start, time, recipe }))
    }

    pub(super) fn open_shard(&self, number: u32) -> Result<OpenShard, StoreError> {
        let shard = self.index.shard(number);
        let record = shard_record(&self.directory, shard.record)?;
        let path = self.directory.shards().join(&*shard.name);
        let reader = open_checked(&path, &record)?;
        Ok(OpenShard { path, reader, cases: record.cases })
    }
}

/// A shard with its record.
pub(super) struct OpenShard {
    pub path: PathBuf,
    pub reader: ShardReader,
    pub cases: Vec<CaseRecord>,
}
