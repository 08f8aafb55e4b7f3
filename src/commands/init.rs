//! `stribeck init`: a sweep file to start from.

use std::path::PathBuf;

use clap::Args;

use super::output_file::{OutputFiles, or_empty};
use super::shell::quoted;
use super::{CliError, Exit, console};
use stribeck_input::shown;

/// A sweep over α, β and f.
const SWEEP: &str = include_str!("beginners/sweep.toml");
/// A sweep over quantities with units.
const LABORATORY: &str = include_str!("beginners/laboratory.toml");
/// Ranges that a surface is made over.
const SURFACE: &str = include_str!("beginners/surface.toml");

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck init                                         prints a sweep over alpha, beta and f
  stribeck init -o first.toml                           writes it; then stribeck run first.toml
  stribeck init --laboratory -o experiment.toml         quantities with units, in place of alpha and beta
  stribeck init --surface -o my-surface.toml            for stribeck surface my-surface.toml",
    after_help = "\
Every key has a comment; docs/reference/sweep-file.md has the keys that are not there. A file that is there already is
never written over, unless it is empty."
)]
pub struct Arguments {
    /// An experiment: radius, load, moduli, viscosity and speeds
    #[arg(long, conflicts_with = "surface")]
    laboratory: bool,
    /// A surface: friction as a function of alpha and beta
    #[arg(long)]
    surface: bool,
    /// Write the file, in place of printing it
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let (text, command) = match (arguments.laboratory, arguments.surface) {
        (true, _) => (LABORATORY, "curve"),
        (_, true) => (SURFACE, "surface"),
        _ => (SWEEP, "run"),
    };
    let Some(path) = &arguments.output else {
        console::print(text)?;
        return Ok(Exit::Success);
    };
    // Through a link too: what is there may be a sweep file that took its user a while.
    if path.metadata().is_ok_and(|there| there.is_file() && there.len() > 0) {
        return Err(CliError::IsThere { file: path.clone() });
    }
    OutputFiles::new("init", []).check(path, or_empty(|_| false))?.write(text.as_bytes())?;
    console::print(&format!("wrote {}; next: stribeck {command} {}\n", shown(path), quoted(path.as_os_str())))?;
    Ok(Exit::Success)
}
