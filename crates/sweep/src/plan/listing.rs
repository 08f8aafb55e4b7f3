//! Rows and chains of a sweep whose places may have problems in common.

use std::collections::HashSet;

use super::chain::Chain;
use crate::{CaseId, GridIndex, GridShape};

/// The rows with a problem of their own, and their chains.
#[derive(Clone, Debug)]
pub(super) struct Listing {
    rows: Vec<Row>,
    chains: Vec<Chain>,
}

#[derive(Clone, Debug)]
struct Row {
    block: usize,
    row: usize,
    /// Places along the row in ascending β: backwards along the speed.
    along: Vec<u32>,
}

impl Listing {
    /// Lists a grid of the given shape, whose β falls along rows if `backwards`.
    ///
    /// `id` is the problem at a place, `limit` the most cases of a chain in the row that begins at a place.
    ///
    /// A problem belongs to the first place that has it in the order of publication, so that an extension at the end of
    /// an axis leaves the rows before as they were.
    pub(super) fn new(
        shape: GridShape,
        backwards: bool,
        id: impl Fn(GridIndex) -> CaseId,
        limit: impl Fn(GridIndex) -> usize,
    ) -> Self {
        let mut seen = HashSet::new();
        let mut listing = Self { rows: Vec::new(), chains: Vec::new() };
        for row in 0..shape.blocks * shape.rows {
            let places = shape.row(row);
            let mut along: Vec<u32> =
                places.filter(|&place| seen.insert(id(place))).map(|place| place.along as u32).collect();
            if backwards {
                along.reverse();
            }
            if along.is_empty() {
                continue;
            }
            let first = GridIndex { block: row / shape.rows, row: row % shape.rows, along: 0 };
            let (row, cases) = (listing.rows.len(), along.len());
            let pieces = cases.div_ceil(limit(first));
            let cut = |piece: usize| piece * cases / pieces;
            listing.chains.extend((0..pieces).map(|piece| Chain { row, cases: cut(piece)..cut(piece + 1) }));
            listing.rows.push(Row { block: first.block, row: first.row, along });
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

    /// The place of a case of a row.
    pub(super) fn place(&self, row: usize, case: usize) -> GridIndex {
        let Row { block, row, along } = &self.rows[row];
        GridIndex { block: *block, row: *row, along: along[case] as usize }
    }
}
