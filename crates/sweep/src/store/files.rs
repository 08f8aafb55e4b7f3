//! Files that are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

use super::StoreError;

/// Ends the name of a file that is being written. What a killed run leaves under such a name is removed by the next.
const TEMPORARY: &str = ".stribeck-part";

/// True if a file holds this text. A file of another size is not read, and neither is anything but a file.
pub fn holds_text(path: &Path, text: &str) -> bool {
    let alike = path.metadata().is_ok_and(|found| found.is_file() && found.len() == text.len() as u64);
    alike && fs::read(path).is_ok_and(|found| found == text.as_bytes())
}

/// The name that a file of the store is being written for, or was when a run was killed; `None` for any other name.
pub(super) fn temporary_for(path: &Path) -> Option<&str> {
    path.file_name()?.to_str()?.strip_prefix('.')?.strip_suffix(TEMPORARY)
}

/// Opens a file for reading. A pipe or a device, which might never end, is an error.
pub(super) fn open_file(path: &Path) -> io::Result<File> {
    match path.metadata()?.is_file() {
        true => File::open(path),
        false => Err(io::Error::new(ErrorKind::InvalidInput, "it is no file")),
    }
}

/// The files in a directory, sorted by name.
pub(super) fn files_in(directory: &Path) -> Result<Vec<PathBuf>, StoreError> {
    let entries = fs::read_dir(directory).map_err(StoreError::file(directory, "list"))?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.map_err(StoreError::file(directory, "list"))?.path();
        if path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// A file under a temporary name beside its final one; dropped before [`Staged::put_in_place`] it is removed.
pub(super) struct Staged {
    temporary: PathBuf,
    target: PathBuf,
}

impl Staged {
    pub(super) fn new(target: PathBuf) -> Self {
        let name = target.file_name().expect("a staged file has a name").to_string_lossy();
        let temporary = target.with_file_name(format!(".{name}{TEMPORARY}"));
        Self { temporary, target }
    }

    /// Where to write.
    pub(super) fn path(&self) -> &Path {
        &self.temporary
    }

    /// Waits until the content is on the disk; returns its size and hash, read back from the file.
    pub(super) fn synchronise(&self) -> Result<(u64, blake3::Hash), StoreError> {
        let open = OpenOptions::new().read(true).write(true).open(&self.temporary);
        let file = open.map_err(StoreError::file(&self.temporary, "open"))?;
        file.sync_all().map_err(StoreError::file(&self.temporary, "write"))?;
        hash_file(&self.temporary)
    }

    /// Its final name.
    pub(super) fn target(&self) -> &Path {
        &self.target
    }

    /// The same file with another final name.
    pub(super) fn named(self, name: &str) -> Self {
        let mut file = std::mem::ManuallyDrop::new(self);
        let target = file.target.with_file_name(name);
        Self { temporary: std::mem::take(&mut file.temporary), target }
    }

    /// Gives the file its name, in one step. It is for the caller to wait until the directory is on the disk.
    pub(super) fn rename(self) -> Result<(), StoreError> {
        fs::rename(&self.temporary, &self.target).map_err(StoreError::file(&self.target, "replace"))
    }

    /// Gives the file its name and waits until the directory is on the disk.
    pub(super) fn put_in_place(self) -> Result<(), StoreError> {
        let directory = directory_of(&self.target).to_owned();
        self.rename()?;
        synchronise_directory(&directory)
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // Nothing is left there after a rename; if removing fails otherwise, the next start removes it.
        let _ = fs::remove_file(&self.temporary);
    }
}

/// Writes a file whole or not at all: to a temporary name, then to the disk, then in place of what was there.
///
/// # Errors
/// [`StoreError::File`] if the disk does not take it.
pub fn write_whole(target: PathBuf, content: &[u8]) -> Result<(), StoreError> {
    let staged = Staged::new(target);
    fs::write(staged.path(), content).map_err(StoreError::file(staged.path(), "write"))?;
    staged.synchronise()?;
    staged.put_in_place()
}

/// The directory that a path is in.
fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        // A name alone is one in the working directory.
        Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
        Some(parent) => parent,
        None => path,
    }
}

/// Makes a directory with those above it that are missing, and waits until the names of all that it made are on the
/// disk.
///
/// # Errors
/// [`StoreError::File`] if the disk does not take it.
pub fn create_directory(path: &Path) -> Result<(), StoreError> {
    if path.is_dir() {
        return Ok(());
    }
    let above = directory_of(path);
    if above != path {
        create_directory(above)?;
    }
    match fs::create_dir(path) {
        // Another run may have made it just now.
        Err(error) if error.kind() == ErrorKind::AlreadyExists && path.is_dir() => {}
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return Err(StoreError::file(path, "create")(ErrorKind::NotADirectory.into()));
        }
        made => made.map_err(StoreError::file(path, "create"))?,
    }
    match synchronise_directory(above) {
        // A directory that may be written to and not be read cannot be waited for.
        Err(StoreError::File { source, .. }) if source.kind() == ErrorKind::PermissionDenied => Ok(()),
        synchronised => synchronised,
    }
}

/// Waits until the names in a directory are on the disk.
pub(super) fn synchronise_directory(path: &Path) -> Result<(), StoreError> {
    // Only Unix can open a directory to synchronise it; elsewhere a rename is as durable as the system makes it.
    if cfg!(unix) {
        let synchronised = File::open(path).and_then(|directory| directory.sync_all());
        synchronised.map_err(StoreError::file(path, "write"))?;
    }
    Ok(())
}

/// Size and hash of a file; memory does not depend on its size.
pub(super) fn hash_file(path: &Path) -> Result<(u64, blake3::Hash), StoreError> {
    let mut hasher = blake3::Hasher::new();
    let mut file = open_file(path).map_err(StoreError::file(path, "open"))?;
    let mut buffer = vec![0; 1 << 16];
    loop {
        let read = file.read(&mut buffer).map_err(StoreError::file(path, "read"))?;
        if read == 0 {
            return Ok((hasher.count(), hasher.finalize()));
        }
        hasher.update(&buffer[..read]);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Barrier;
    use std::thread;

    use super::*;

    #[test]
    fn all_who_make_a_directory_at_the_same_moment_have_it() {
        let home = tempfile::tempdir().expect("a temporary directory");
        for round in 0..300 {
            let path = home.path().join(format!("{round}/log"));
            let barrier = Barrier::new(4);
            thread::scope(|scope| {
                for _ in 0..4 {
                    scope.spawn(|| {
                        barrier.wait();
                        create_directory(&path).expect("made by one of them");
                    });
                }
            });
        }
    }

    #[test]
    fn a_file_is_no_directory() {
        let home = tempfile::tempdir().expect("a temporary directory");
        let file = home.path().join("file");
        fs::write(&file, "").expect("written");
        for path in [file.clone(), file.join("below")] {
            let error = create_directory(&path).expect_err("there is a file");
            assert!(error.to_string().contains("cannot create"), "{error}");
            assert!(error.to_string().contains("not a directory"), "{error}");
        }
    }
}
