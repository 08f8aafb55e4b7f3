//! The program `stribeck`; everything is in [`stribeck::cli`].

use std::process::ExitCode;

use clap::Parser;
use stribeck::cli::{Cli, execute};

fn main() -> ExitCode {
    execute(&Cli::parse())
}
