//! Where each case is: about 25 bytes per case, and little per shard.

use std::cmp::Reverse;
use std::collections::HashMap;

use super::Status;
use super::log::LogPlace;
use crate::model::CaseId;

/// A shard that is there.
#[derive(Clone, Debug)]
pub(super) struct Shard {
    pub name: Box<str>,
    pub hash: blake3::Hash,
    /// True if it holds all that the store's output asks for.
    pub covers: bool,
    /// Its record in the log, which holds the timings.
    pub record: LogPlace,
}

/// Where a case is, and what became of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Slot {
    pub shard: u32,
    pub row: u16,
    pub status: Status,
}

/// Shards, and the case that counts for each id.
///
/// If several shards hold a case, the one counts that covers what is asked for, then one where it converged, then the
/// one whose name sorts first: a choice that does not depend on the order in which shards were committed.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    shards: Vec<Shard>,
    by_name: HashMap<Box<str>, u32>,
    cases: HashMap<CaseId, Slot>,
}

impl Index {
    /// Adds a shard, or replaces the one of the same name.
    pub(super) fn add_shard(&mut self, shard: Shard) -> u32 {
        if let Some(&number) = self.by_name.get(&shard.name) {
            self.shards[number as usize] = shard;
            return number;
        }
        let number = u32::try_from(self.shards.len()).expect("fewer than 2^32 shards fit on a disk");
        self.by_name.insert(shard.name.clone(), number);
        self.shards.push(shard);
        number
    }

    /// Adds a case of a shard.
    pub(super) fn add_case(&mut self, id: CaseId, slot: Slot) {
        let counts = match self.cases.get(&id) {
            Some(held) => held.shard == slot.shard || self.rank(&slot) > self.rank(held),
            None => true,
        };
        if counts {
            self.cases.insert(id, slot);
        }
    }

    fn rank(&self, slot: &Slot) -> (bool, bool, Reverse<&str>) {
        let shard = self.shard(slot.shard);
        (shard.covers, slot.status == Status::Converged, Reverse(&*shard.name))
    }

    pub(super) fn shard(&self, number: u32) -> &Shard {
        &self.shards[number as usize]
    }

    pub(super) fn shards(&self) -> impl Iterator<Item = (u32, &Shard)> {
        (0..).zip(&self.shards)
    }

    /// Where a case is, whether or not all that is asked for is there.
    pub(super) fn any(&self, id: CaseId) -> Option<Slot> {
        self.cases.get(&id).copied()
    }

    /// Where a case is, if all that is asked for is there.
    pub(super) fn complete(&self, id: CaseId) -> Option<Slot> {
        self.any(id).filter(|slot| self.shard(slot.shard).covers)
    }

    /// How many cases have a status.
    pub(super) fn count(&self, status: Status) -> u64 {
        self.cases.values().filter(|slot| slot.status == status).count() as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_costs_little_memory() {
        assert!(size_of::<(CaseId, Slot)>() <= 16);
    }

    #[test]
    fn the_case_that_counts_does_not_depend_on_the_order() {
        let shard = |name: &str, covers| Shard {
            name: name.into(),
            hash: blake3::hash(name.as_bytes()),
            covers,
            record: LogPlace { log: 1, offset: 0 },
        };
        let candidates = [
            (shard("a", false), Status::Converged),
            (shard("b", true), Status::Failed),
            (shard("c", true), Status::Converged),
            (shard("d", true), Status::Converged),
        ];
        for rotation in 0..candidates.len() {
            for reversed in [false, true] {
                let mut order = candidates.to_vec();
                order.rotate_left(rotation);
                if reversed {
                    order.reverse();
                }
                let mut index = Index::default();
                for (shard, status) in order {
                    let shard = index.add_shard(shard);
                    index.add_case(CaseId(1), Slot { shard, row: 0, status });
                }
                let slot = index.complete(CaseId(1)).unwrap();
                assert_eq!(&*index.shard(slot.shard).name, "c");
            }
        }
    }
}
