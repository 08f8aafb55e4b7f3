//! The shards that were used last, kept open.

use std::collections::VecDeque;

use super::catalog::OpenShard;
use super::index::Slot;
use super::{Catalog, StoreError};
use crate::CaseId;

/// Shards kept open. Who goes through a sweep in its order needs few: a chain runs along β, and a shard holds chains
/// that finished at about the same time, so neighbours.
const OPEN_SHARDS: usize = 32;

/// Cases of the shards kept open, at some hundred bytes each; a single shard may have more.
const OPEN_CASES: usize = 1 << 16;

/// The shards used last, newest at the back.
pub(super) struct OpenShards<'a> {
    store: &'a Catalog,
    shards: VecDeque<(u32, OpenShard)>,
}

impl<'a> OpenShards<'a> {
    /// None open yet.
    pub(super) fn new(store: &'a Catalog) -> Self {
        Self { store, shards: VecDeque::new() }
    }

    /// The shard of a case, and the case's row in it.
    pub(super) fn case(&mut self, id: CaseId, slot: Slot) -> Result<(&OpenShard, usize), StoreError> {
        let held = self.shards.iter().position(|(number, _)| *number == slot.shard);
        let shard = match held.and_then(|place| self.shards.remove(place)) {
            Some((_, shard)) => shard,
            None => self.store.open_shard(slot.shard)?,
        };
        self.shards.push_back((slot.shard, shard));
        let cases =
            |shards: &VecDeque<(u32, OpenShard)>| shards.iter().map(|(_, shard)| shard.cases.len()).sum::<usize>();
        while self.shards.len() > OPEN_SHARDS || (self.shards.len() > 1 && cases(&self.shards) > OPEN_CASES) {
            self.shards.pop_front();
        }
        let (_, shard) = self.shards.back().expect("just put there");
        let row = usize::from(slot.row);
        if shard.reader.ids().get(row) != Some(&id) {
            let what = format!("case {id} is not in its row {row}");
            return Err(StoreError::Damaged { path: shard.path.clone(), what });
        }
        Ok((shard, row))
    }
}
