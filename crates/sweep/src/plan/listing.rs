//! Rows and chains of a sweep whose places may have problems in common.

use std::collections::HashSet;

use super::chain::Chain;
use crate::CaseId;

/// The rows with a problem of their own, and their chains.
#[derive(Clone, Debug)]
pub(super) struct Listing {
    rows: Vec<Row>,
    chains: Vec<Chain>,
}

#[derive(Clone, Debug)]
struct Row {
    i_f: usize,
    i_row: usize,
    /// Places along the row in ascending β: descending, as along the speed.
    along: Vec<u32>,
}

impl Listing {
    /// Lists a grid of the given shape. `id` is the problem at a place, `limit` the most cases of a chain for a place of f.
    ///
    /// A problem belongs to the first place that has it in the order of publication, so that an extension at the end of an axis
    /// leaves the rows before as they were.
    pub(super) fn new(
        [strengths, rows_each, length]: [usize; 3],
        id: impl Fn([usize; 3]) -> CaseId,
        limit: impl Fn(usize) -> usize,
    ) -> Self {
        let mut seen = HashSet::new();
        let mut listing = Self { rows: Vec::new(), chains: Vec::new() };
        for (i_f, i_row) in (0..strengths).flat_map(|i_f| (0..rows_each).map(move |i_row| (i_f, i_row))) {
            let mut along: Vec<u32> =
                (0..length).filter(|&place| seen.insert(id([i_f, i_row, place]))).map(|place| place as u32).collect();
            along.reverse();
            if along.is_empty() {
                continue;
            }
            let (row, cases) = (listing.rows.len(), along.len());
            let pieces = cases.div_ceil(limit(i_f));
            let cut = |piece: usize| piece * cases / pieces;
            listing.chains.extend((0..pieces).map(|piece| Chain { row, cases: cut(piece)..cut(piece + 1) }));
            listing.rows.push(Row { i_f, i_row, along });
        }
        listing
    }

    pub(super) fn problems(&self) -> usize {
        self.rows.iter().map(|row| row.along.len()).sum()
    }

    pub(super) fn rows(&self) -> usize {
        self.rows.len()
    }

    pub(super) fn chains(&self) -> &[Chain] {
        &self.chains
    }

    pub(super) fn place_of_row(&self, row: usize) -> (usize, usize) {
        (self.rows[row].i_f, self.rows[row].i_row)
    }

    pub(super) fn along(&self, row: usize, case: usize) -> usize {
        self.rows[row].along[case] as usize
    }
}
