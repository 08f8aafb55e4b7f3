//! What a campaign tells while it works.

use std::path::Path;

use super::{Pending, Refinement};
use crate::store::{Joined, Warning};

/// Something that happens while a sweep is run or merged, told when it happens, on the thread of the caller.
#[derive(Debug)]
pub enum Event<'a> {
    /// A stored file, or a line of a log, is damaged and not used. Its cases are solved again.
    Damaged(&'a Warning),
    /// The results directory was last run with another sweep file. Cases that both sweeps have are used again.
    OtherSweep {
        /// The results directory.
        directory: &'a Path,
        /// What is left of the present sweep.
        pending: &'a Pending,
        /// Numbers of points that would keep what the other one has.
        refinements: &'a [Refinement],
    },
    /// A run of the whole sweep took over what its parts have solved.
    TookOver(Joined),
    /// Solving begins.
    Solving {
        /// The number of cases that are going to be stored.
        cases: u64,
    },
    /// Cases that were solved are safe on the disk.
    Committed {
        /// How many of them converged.
        converged: u64,
        /// How many of them failed.
        failed: u64,
    },
    /// All cases are stored, and the files for the user are made next.
    Publishing,
}

/// A callback that is told the events of a campaign: `&mut |_| {}` listens to none.
pub type Observer<'a> = dyn FnMut(Event<'_>) + 'a;
