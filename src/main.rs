//! The program `stribeck`; everything is in [`stribeck::commands`].

use std::process::ExitCode;

use stribeck::VERSION;
use stribeck::commands::{execute, parse};

fn main() -> ExitCode {
    // Before there is a second thread.
    stribeck_sweep::store::initialise_hdf5();
    stribeck_sweep::store::sign_as(VERSION);
    let cli = parse(std::env::args_os()).unwrap_or_else(|error| error.exit());
    execute(&cli, &peak_bytes)
}

/// The most bytes that a piece of work has in use at once. Memory is counted by the program's allocator, which is none
/// of the library's business.
fn peak_bytes(work: &mut dyn FnMut()) -> u64 {
    allocation_counter::measure(work).bytes_max
}
