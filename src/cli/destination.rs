//! The results directory of a sweep.

use std::path::{Path, PathBuf};

use super::CliError;
use crate::store::holds_text;
use crate::sweep::Sweep;

/// Where a sweep goes: the directory asked for, or `results/<file stem>`.
///
/// # Errors
/// [`CliError::NotADirectory`] if a file is there.
pub fn destination(asked: Option<&Path>, sweep: &Sweep) -> Result<PathBuf, CliError> {
    let path = asked.map_or_else(|| Path::new("results").join(&sweep.name), Path::to_owned);
    if path.exists() && !path.is_dir() {
        return Err(CliError::NotADirectory { path });
    }
    Ok(path)
}

/// True if the directory was last run with another sweep file.
pub fn had_other_sweep(directory: &Path, sweep: &Sweep) -> bool {
    let previous = directory.join("sweep.toml");
    previous.exists() && !holds_text(&previous, &sweep.text)
}
