//! A sweep file and its results directory.

use std::path::{Path, PathBuf};

use super::CliError;
use stribeck_sweep::Sweep;
use stribeck_sweep::store::{Holdings, StoreError, holds_text};

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

/// Reads a sweep file. The copy in a results directory keeps the name under which the sweep was run: that is its title where
/// the file gives none.
pub fn read_sweep(path: &Path) -> Result<Sweep, CliError> {
    let sweep = Sweep::read(path)?;
    let home = path.parent().filter(|home| path.ends_with("sweep.toml") && home.join("log").is_dir());
    let name = match home.map(Holdings::name_of_sweep) {
        Some(Ok(Some(name))) => name,
        // A directory `log` is nothing that only results have.
        Some(Err(StoreError::NotResults { .. }) | Ok(None)) | None => return Ok(sweep),
        Some(Err(error)) => return Err(error.into()),
    };
    Ok(Sweep::parse(&name, &sweep.text)?)
}

/// True if the directory was last run with another sweep file.
pub fn had_other_sweep(directory: &Path, sweep: &Sweep) -> bool {
    let previous = directory.join("sweep.toml");
    previous.exists() && !holds_text(&previous, &sweep.text)
}
