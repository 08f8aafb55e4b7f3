//! The program `stribeck`; everything is in [`stribeck::commands`].

use std::process::ExitCode;

use clap::Parser;
use stribeck::commands::{Cli, execute};

fn main() -> ExitCode {
    // Before there is a second thread.
    stribeck_sweep::store::initialise_hdf5();
    execute(&Cli::parse(), &peak_bytes)
}

/// The most bytes that a piece of work has in use at once. Memory is counted by the program's allocator, which is none
/// of the library's business.
fn peak_bytes(work: &mut dyn FnMut()) -> u64 {
    allocation_counter::measure(work).bytes_max
}
