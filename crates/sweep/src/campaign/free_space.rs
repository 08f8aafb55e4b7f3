//! The room that is left on a disk.

use std::path::Path;

/// Bytes that a user may still write to the disk of a directory that is there or is to be made; `None` where the system
/// does not tell.
pub(super) fn free_space(directory: &Path) -> Option<u64> {
    let absolute = std::path::absolute(directory).ok()?;
    let existing = absolute.ancestors().find(|path| path.is_dir())?;
    on_disk_of(existing)
}

#[cfg(unix)]
fn on_disk_of(existing: &Path) -> Option<u64> {
    let disk = rustix::fs::statvfs(existing).ok()?;
    disk.f_bavail.checked_mul(disk.f_frsize)
}

#[cfg(not(unix))]
fn on_disk_of(_existing: &Path) -> Option<u64> {
    None
}
