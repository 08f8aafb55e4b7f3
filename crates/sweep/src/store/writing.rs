//! The store of a running sweep: the one process that adds to a results directory.

use std::collections::HashSet;
use std::ops::Deref;
use std::path::Path;

use serde_json::Value;

use super::claims::Inspection;
use super::directory::{Directory, Lock};
use super::files::{Staged, holds_text, write_whole};
use super::index::{Shard, Slot};
use super::log::{Log, LogPlace, synchronise_logs};
use super::record::{CaseRecord, FileRecord, Record, ShardRecord};
use super::shard::{check_shard, shard_name, write_shard};
use super::{CaseEntry, Catalog, Contents, Ending, PackedCase, Status, StoreError, StoredOutput, Warning};
use super::{clock, program};
use crate::Field;

/// A results directory opened for writing. All that [`Catalog`] tells is here as well.
#[derive(Debug)]
pub struct Store {
    catalog: Catalog,
    /// The log of this start; made with its first record.
    log: Option<Log>,
    /// What the cases that are committed are solved with.
    recipe: Value,
    /// Held until the store is dropped.
    _lock: Lock,
}

impl Deref for Store {
    type Target = Catalog;

    fn deref(&self) -> &Catalog {
        &self.catalog
    }
}

impl Store {
    /// Opens a results directory, making it if it is not there, and takes it for this process.
    ///
    /// Removes what a killed run left half written, writes `sweep.toml`, and compares every shard with its record, byte
    /// by byte. What is damaged is not used and listed in [`Catalog::warnings`]. `output` is what each case must have.
    ///
    /// # Errors
    /// [`StoreError::Locked`] if another process works there, [`StoreError::Occupied`] if files are there that would be
    /// replaced and no run has written, [`StoreError::NotText`] if HDF5 cannot take the path (nothing is changed then),
    /// others if the directory cannot be read or written.
    pub fn open(path: &Path, sweep_text: &str, output: impl Into<StoredOutput>) -> Result<Self, StoreError> {
        let directory = Directory::new(path);
        directory.check_available()?;
        directory.create()?;
        let lock = directory.lock()?;
        // Without a lock what looks left over may be at work.
        if lock.is_kept {
            directory.remove_leftovers()?;
        }
        if !holds_text(&directory.sweep(), sweep_text) {
            write_whole(directory.sweep(), sweep_text.as_bytes())?;
        }
        synchronise_logs(&directory.logs())?;
        let mut catalog = Catalog::load(directory, output.into(), Inspection::Bytes)?;
        if !lock.is_kept {
            catalog.warn(Warning::NoLock { directory: path.to_owned() });
        }
        Ok(Self { catalog, log: None, recipe: Value::Null, _lock: lock })
    }

    /// The store with a description of what the cases that are committed from now on are solved with. It is kept with
    /// them for those who plan: to the store it means nothing.
    #[must_use]
    pub fn solving_with(self, recipe: Value) -> Self {
        Self { recipe, ..self }
    }

    /// Checks that [`Store::open`] could use a directory that holds no results yet. Changes nothing.
    ///
    /// # Errors
    /// [`StoreError::Occupied`] and [`StoreError::NotText`] as for [`Store::open`].
    pub fn check_available(path: &Path) -> Result<(), StoreError> {
        Directory::new(path).check_available()
    }

    /// Records that a run of the sweep of this name begins, which sets out to solve so many cases.
    ///
    /// # Errors
    /// [`StoreError::File`] if the log cannot be written.
    pub fn begin(&mut self, sweep: &str, cases: u64, threads: u64) -> Result<(), StoreError> {
        let (program, sweep) = (program(), sweep.to_owned());
        self.append(&Record::Start { program, sweep, cases, threads, time: clock() }).map(drop)
    }

    /// Records how the run ended.
    ///
    /// # Errors
    /// [`StoreError::File`] if the log cannot be written.
    pub fn end(&mut self, ending: Ending) -> Result<(), StoreError> {
        self.append(&Record::End { ending, time: clock() }).map(drop)
    }

    /// Commits finished chains as one shard: when this returns, their cases survive whatever happens to the process or
    /// the power. It takes about as long for one case as for a thousand, most of it waiting for the disk.
    ///
    /// Fields and sensitivities that the output does not ask for are left out.
    ///
    /// # Errors
    /// [`StoreError::Entry`] for an entry that cannot be stored (nothing is written then), others if the disk fails.
    /// After an error nothing is committed, and the store can be used further.
    pub fn commit(&mut self, cases: &[CaseEntry]) -> Result<(), StoreError> {
        let contents = Contents::of(&self.wanted);
        let packed: Vec<PackedCase> = cases.iter().map(|case| PackedCase::new(case.clone(), &contents)).collect();
        self.commit_packed(&packed)
    }

    /// Commits cases with their fields packed, as [`Store::commit`] does.
    ///
    /// # Errors
    /// As [`Store::commit`].
    pub fn commit_packed(&mut self, cases: &[PackedCase]) -> Result<(), StoreError> {
        if cases.is_empty() {
            return Ok(());
        }
        let contents = Contents::of(&self.wanted);
        check(cases, &contents, &self.wanted.output.x)?;
        let staged = Staged::new(self.directory.new_shard());
        write_shard(staged.path(), &contents, &self.wanted.output.x, cases)
            .map_err(StoreError::hdf5(staged.path(), "write"))?;
        check_shard(staged.path(), &contents, cases)?;
        let (bytes, hash) = staged.synchronise()?;
        let name = shard_name(&self.directory.shards(), &hash);
        staged.named(&name).put_in_place()?;

        let file = FileRecord { file: name.clone(), bytes, blake3: hash.to_hex().to_string() };
        let entries = || cases.iter().map(PackedCase::entry);
        let records = entries().map(CaseRecord::of).collect();
        let place =
            self.append(&Record::Shard(ShardRecord::new(file, &contents, self.recipe.clone(), clock(), records)))?;
        let index = &mut self.catalog.index;
        let shard = index.add_shard(Shard { name: name.into(), hash, contents, covers: true, record: place });
        for (row, entry) in (0..).zip(entries()) {
            index.add_case(entry.id, Slot { shard, row, status: entry.outcome }, entry.timing.time_limit);
        }
        Ok(())
    }

    pub(super) fn append(&mut self, record: &Record) -> Result<LogPlace, StoreError> {
        Ok(self.append_all(std::slice::from_ref(record))?.remove(0))
    }

    /// Appends records in their order and tells where each stands.
    pub(super) fn append_all(&mut self, records: &[Record]) -> Result<Vec<LogPlace>, StoreError> {
        // A log whose last line may be torn is given up: the next record goes to a new one.
        let mut log = match self.log.take() {
            Some(log) => log,
            None => Log::create(&self.directory.logs())?,
        };
        let places = log.append(records)?;
        self.log = Some(log);
        for (place, record) in places.iter().zip(records) {
            self.catalog.history.note(place.log, record);
        }
        Ok(places)
    }

    pub(super) fn catalog_mut(&mut self) -> &mut Catalog {
        &mut self.catalog
    }
}

/// Refuses what would not come back as it was given.
fn check(cases: &[PackedCase], contents: &Contents, x: &[f64]) -> Result<(), StoreError> {
    let mut seen = HashSet::new();
    for case in cases {
        let entry = case.entry();
        let refuse = |what: String| Err(StoreError::Entry { case: entry.id, what });
        if cases.len() > usize::from(u16::MAX) {
            return refuse(format!("{} cases are too many for a shard", cases.len()));
        }
        if !seen.insert(entry.id) {
            return refuse("it is twice among those committed".to_owned());
        }
        let seconds = entry.timing.seconds;
        if !(seconds.is_finite() && seconds >= 0.0) {
            return refuse(format!("it took {seconds} seconds"));
        }
        if entry.timing.time_limit.is_some_and(|limit| !(limit.is_finite() && limit > 0.0)) {
            return refuse(format!("it was given up at {:?} seconds", entry.timing.time_limit));
        }
        if entry.reason.chars().any(char::is_control) {
            return refuse(format!("its reason is not one line: {:?}", entry.reason));
        }
        match (&entry.sensitivities, entry.outcome) {
            (None, Status::Converged) if contents.sensitivities => {
                return refuse("it converged and has no sensitivities".to_owned());
            }
            (Some(_), Status::Failed) => return refuse("it failed and has sensitivities".to_owned()),
            _ => {}
        }
        for field in Field::selected(contents.fields) {
            let name = field.name();
            match (case.field(field), entry.outcome) {
                (Some(values), Status::Converged) if values.count == x.len() => {}
                (Some(values), Status::Converged) => {
                    return refuse(format!("{name} has {} values on {} points", values.count, x.len()));
                }
                (None, Status::Converged) => return refuse(format!("it converged and has no {name}")),
                (Some(_), Status::Failed) => return refuse(format!("it failed and has a {name}")),
                (None, Status::Failed) => {}
            }
        }
    }
    Ok(())
}
