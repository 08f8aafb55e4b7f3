//! The results directory that a command works in.

use std::path::{Path, PathBuf};

use super::CliError;

/// Where results go: the directory asked for, or `results/<file stem>`.
///
/// # Errors
/// [`CliError::NoName`] if the file has a stem that names another directory.
pub fn destination(asked: Option<&Path>, stem: &str) -> Result<PathBuf, CliError> {
    match (asked, stem) {
        (Some(asked), _) => Ok(asked.to_owned()),
        // `results/..` is where the user is.
        (None, "" | "." | "..") => Err(CliError::NoName { stem: stem.to_owned() }),
        (None, stem) => Ok(Path::new("results").join(stem)),
    }
}
