//! Files that a command replaces only if it wrote them.

use std::io::{self, ErrorKind};
use std::path::Path;

use super::CliError;
use stribeck_sweep::store::StoreError;

/// Refuses to replace a file that a command has not written; `remedy` says what else to do.
///
/// `is_ours` recognises a file of the command; a file that is not there or ends too early decides itself.
///
/// # Errors
/// [`CliError::Foreign`] if the file is there and not ours, [`StoreError::File`] if it cannot be read.
pub fn check(
    file: &Path,
    command: &'static str,
    remedy: &'static str,
    is_ours: impl FnOnce() -> io::Result<bool>,
) -> Result<(), CliError> {
    let foreign = || Err(CliError::Foreign { file: file.to_owned(), command, remedy });
    match is_ours() {
        Ok(true) => Ok(()),
        Ok(false) => foreign(),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => foreign(),
        Err(source) => Err(StoreError::File { path: file.to_owned(), action: "open", source }.into()),
    }
}
