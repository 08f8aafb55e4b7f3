//! Chains: the unit of work.

use std::ops::Range;

/// The most cases that a chain may have, whatever the method.
pub const MAX_CHAIN: usize = 64;

/// Neighbouring cases of one row, each seeding the next: the unit of work.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Chain {
    /// The row, below [`Plan::rows`](super::Plan::rows).
    pub row: usize,
    /// Which cases of the row, in ascending β. Along the speed that is descending.
    pub cases: Range<usize>,
}
