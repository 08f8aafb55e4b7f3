//! Takes over what other results directories of the same sweep hold.
//!
//! Shards are immutable and named by their bytes, so joining is linking: a shard gets a second name here (or is copied,
//! where the other directory is on another file system), and its record is written once more. Goes through the other
//! directory shard by shard; memory grows with the cases here alone.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::claims::{open_checked, shard_record};
use super::files::{Staged, synchronise_directory};
use super::index::{Shard, Slot};
use super::open_shards::OpenShards;
use super::record::{Record, ShardRecord};
use super::shard::shard_name;
use super::{Catalog, Contents, Status, Store, StoreError};
use crate::Values;

/// Shards that are taken over with one wait for the disk.
const AT_ONCE: usize = 256;

/// What [`Store::join`] did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Joined {
    /// Shards taken over.
    pub shards: u64,
    /// Cases in them.
    pub cases: u64,
    /// Cases of theirs that were here already.
    pub twice: u64,
}

/// Tells whether two solutions of one case agree within what the solver promises.
pub type Agreement<'a> = dyn Fn(&Values, &Values) -> bool + 'a;

impl Store {
    /// Takes over all shards of another directory that are as they were written.
    ///
    /// A case that is here already is fine if both agree. Of a case in several shards one counts as always
    /// ([`Catalog::holds`]), whatever the order of joining.
    ///
    /// # Errors
    /// [`StoreError::Disagreement`] if a case is here with other numbers, others if a file cannot be read, linked or
    /// written. What was taken over before stays.
    pub fn join(&mut self, other: &Catalog, agree: &Agreement<'_>) -> Result<Joined, StoreError> {
        let (mut joined, mut waiting) = (Joined::default(), Vec::new());
        let here: HashSet<blake3::Hash> = self.index.shards().map(|(_, shard)| shard.hash).collect();
        for (_, shard) in other.index.shards().filter(|(_, shard)| !here.contains(&shard.hash)) {
            let mut record = shard_record(&other.directory, shard.record)?;
            let source = other.directory.shards().join(&*shard.name);
            // Versions before this one named shards otherwise.
            record.file.file = shard_name(&self.directory.shards(), &shard.hash);
            joined.twice += self.compare(&source, &record, agree)?;
            joined.shards += 1;
            joined.cases += record.cases.len() as u64;
            waiting.push((source, record));
            if waiting.len() == AT_ONCE {
                self.take_over(std::mem::take(&mut waiting))?;
            }
        }
        self.take_over(waiting)?;
        Ok(joined)
    }

    /// Compares the cases of a shard with those that are here; how many are.
    fn compare(&self, source: &Path, record: &ShardRecord, agree: &Agreement<'_>) -> Result<u64, StoreError> {
        let (mut theirs, mut ours, mut twice) = (None, OpenShards::new(self), 0);
        for (row, case) in record.cases.iter().enumerate() {
            let Some(slot) = self.index.any(case.case) else { continue };
            twice += 1;
            let theirs = match &theirs {
                Some(theirs) => theirs,
                None => theirs.insert(open_checked(source, record)?),
            };
            let (here, here_row) = ours.case(case.case, slot)?;
            let same = match (here.reader.status(here_row), theirs.status(row)) {
                (Status::Converged, Status::Converged) => agree(&here.reader.values(here_row), &theirs.values(row)),
                (Status::Failed, Status::Failed) => true,
                // Given up on one machine and solved on another is no contradiction.
                (Status::Converged, Status::Failed) => case.time_limit.is_some(),
                (Status::Failed, Status::Converged) => self.index.time_limit(&slot).is_some(),
            };
            if !same {
                let (case, first, second) = (case.case, here.path.clone(), source.to_owned());
                return Err(StoreError::Disagreement { case, first, second });
            }
        }
        Ok(twice)
    }

    /// Gives shards a name here, and then records them.
    fn take_over(&mut self, shards: Vec<(PathBuf, ShardRecord)>) -> Result<(), StoreError> {
        if shards.is_empty() {
            return Ok(());
        }
        let wanted = Contents::of(&self.wanted);
        for (source, record) in &shards {
            link(source, self.directory.shards().join(&record.file.file))?;
        }
        synchronise_directory(&self.directory.shards())?;
        let shards: Vec<ShardRecord> = shards.into_iter().map(|(_, record)| record).collect();
        let records: Vec<Record> = shards.iter().cloned().map(Record::Shard).collect();
        let places = self.append_all(&records)?;
        for (place, record) in places.into_iter().zip(shards) {
            let contents = record.contents().expect("a catalog has known contents only");
            let hash = record.file.blake3.parse().expect("a catalog has well-formed hashes only");
            let (name, covers) = (record.file.file.into(), contents.covers(&wanted));
            let index = &mut self.catalog_mut().index;
            let shard = index.add_shard(Shard { name, hash, contents, covers, record: place });
            for (row, case) in (0..).zip(record.cases) {
                index.add_case(case.case, Slot { shard, row, status: case.status }, case.time_limit);
            }
        }
        Ok(())
    }
}

/// A second name for a file, in place of what has that name; a copy where no link is possible.
fn link(source: &Path, target: PathBuf) -> Result<(), StoreError> {
    let staged = Staged::new(target);
    // What a killed run left under this name is in the way of a link.
    match fs::remove_file(staged.path()) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            return Err(StoreError::file(staged.path(), "remove")(error));
        }
        _ => {}
    }
    if fs::hard_link(source, staged.path()).is_err() {
        fs::copy(source, staged.path()).map_err(StoreError::file(staged.path(), "write"))?;
        staged.synchronise()?;
    }
    staged.rename()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_replaces_what_has_the_name() {
        let directory = tempfile::tempdir().unwrap();
        let (source, target) = (directory.path().join("a"), directory.path().join("b"));
        fs::write(&source, "new").unwrap();
        fs::write(&target, "old").unwrap();
        fs::write(directory.path().join(".b.stribeck-part"), "half").unwrap();
        link(&source, target.clone()).unwrap();
        assert_eq!(fs::read_to_string(target).unwrap(), "new");
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 2);
    }
}
