//! Where each case is: about 25 bytes per case, and little per shard.

use std::cmp::Reverse;
use std::collections::HashMap;

use super::log::LogPlace;
use super::{Contents, Status};
use crate::CaseId;

/// A shard that is there.
#[derive(Clone, Debug)]
pub(super) struct Shard {
    pub name: Box<str>,
    pub hash: blake3::Hash,
    pub contents: Contents,
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
/// one that gave it most time, then the one whose hash sorts first: a choice that does not depend on the order in which
/// shards were committed.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    shards: Vec<Shard>,
    by_name: HashMap<Box<str>, u32>,
    cases: HashMap<CaseId, Slot>,
    /// The time limits at which cases were given up, by shard and row. There are few of them.
    time_limits: HashMap<(u32, u16), f64>,
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

    /// Adds a case of a shard, with the time limit at which it was given up, if it was.
    pub(super) fn add_case(&mut self, id: CaseId, slot: Slot, time_limit: Option<f64>) {
        match time_limit {
            Some(limit) => self.time_limits.insert((slot.shard, slot.row), limit),
            None => self.time_limits.remove(&(slot.shard, slot.row)),
        };
        let counts = match self.cases.get(&id) {
            Some(held) => held.shard == slot.shard || self.rank(&slot) > self.rank(held),
            None => true,
        };
        if counts {
            self.cases.insert(id, slot);
        }
    }

    fn rank(&self, slot: &Slot) -> (bool, bool, u64, Reverse<&[u8; 32]>) {
        let shard = self.shard(slot.shard);
        // Numbers above 0 are in the order of their bits; one that ended by itself had all the time it wanted.
        let time = self.time_limit(slot).unwrap_or(f64::INFINITY).to_bits();
        (shard.covers, slot.status == Status::Converged, time, Reverse(shard.hash.as_bytes()))
    }

    /// The time limit at which a case was given up, if it was.
    pub(super) fn time_limit(&self, slot: &Slot) -> Option<f64> {
        self.time_limits.get(&(slot.shard, slot.row)).copied()
    }

    /// The cases, in no order.
    pub(super) fn ids(&self) -> impl Iterator<Item = CaseId> {
        self.cases.keys().copied()
    }

    /// How many cases there are.
    pub(super) fn len(&self) -> usize {
        self.cases.len()
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
            hash: blake3::Hash::from_bytes([name.as_bytes()[0]; 32]),
            contents: Contents::default(),
            covers,
            record: LogPlace { log: 1, offset: 0 },
        };
        let (failed, converged) = (Status::Failed, Status::Converged);
        let failures =
            [(shard("a", true), failed, Some(1.0)), (shard("b", true), failed, None), (shard("c", true), failed, None)];
        let solved = [
            (shard("a", false), converged, None),
            (shard("b", true), failed, None),
            (shard("c", true), converged, None),
            (shard("d", true), converged, None),
        ];
        for (candidates, expected) in [(&failures[..1], "a"), (&failures, "b"), (&solved, "c")] {
            assert_counts(candidates, expected);
        }
    }

    /// The shard of this name is the one that counts, whatever the order of the candidates.
    fn assert_counts(candidates: &[(Shard, Status, Option<f64>)], expected: &str) {
        for rotation in 0..candidates.len() {
            for reversed in [false, true] {
                let mut order = candidates.to_vec();
                order.rotate_left(rotation);
                if reversed {
                    order.reverse();
                }
                let mut index = Index::default();
                for (shard, status, limit) in order {
                    let shard = index.add_shard(shard);
                    index.add_case(CaseId(1), Slot { shard, row: 0, status }, limit);
                }
                let slot = index.complete(CaseId(1)).unwrap();
                assert_eq!(&*index.shard(slot.shard).name, expected);
            }
        }
    }
}
