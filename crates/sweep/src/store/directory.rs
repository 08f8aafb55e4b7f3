//! The layout of a results directory, its lock, and writing a file whole or not at all.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::StoreError;
use super::log::log_numbers;
use stribeck_input::printable;

/// Ends the name of a file that is being written. What a killed run leaves under such a name is removed by the next.
const TEMPORARY: &str = ".stribeck-part";

/// The file whose lock its owner holds.
const LOCK: &str = "lock";

/// Most bytes of it that are read, to tell who that is.
const LONGEST_OWNER: u64 = 100;

/// Whoever looks whether a run is at work holds the lock for a moment: that is not to stop a run that starts just then.
const LOCK_ATTEMPTS: u32 = 5;
const LOCK_PAUSE: Duration = Duration::from_millis(20);

/// The published files, in the order in which they are put in place.
pub(super) const PUBLISHED: [&str; 3] = ["results.h5", "summary.csv", "timings.csv"];

/// Paths inside a results directory.
#[derive(Clone, Debug)]
pub(super) struct Directory {
    root: PathBuf,
}

impl Directory {
    pub(super) fn new(root: &Path) -> Self {
        Self { root: root.to_owned() }
    }

    pub(super) fn root(&self) -> &Path {
        &self.root
    }

    pub(super) fn sweep(&self) -> PathBuf {
        self.root.join("sweep.toml")
    }

    pub(super) fn logs(&self) -> PathBuf {
        self.root.join("log")
    }

    pub(super) fn shards(&self) -> PathBuf {
        self.root.join("shards")
    }

    pub(super) fn published(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    /// An error if a run could not write here, or would replace files that no run has written.
    ///
    /// [`Directory::create`] comes before the first file of ours, so a start that was killed at any moment left a log.
    pub(super) fn must_be_ours_or_free(&self) -> Result<(), StoreError> {
        if self.root.to_str().is_none() {
            return Err(StoreError::NotText { path: self.root.clone() });
        }
        let names = ["sweep.toml"].into_iter().chain(PUBLISHED);
        let Some(file) = names.into_iter().find(|name| self.root.join(name).exists()) else { return Ok(()) };
        // Others have a directory `log` as well.
        if self.logs().is_dir() && (self.shards().is_dir() || !log_numbers(&self.logs())?.is_empty()) {
            return Ok(());
        }
        Err(StoreError::Occupied { path: self.root.clone(), file })
    }

    /// Makes the directories that are missing.
    pub(super) fn create(&self) -> Result<(), StoreError> {
        for path in [self.logs(), self.shards()] {
            fs::create_dir_all(&path).map_err(StoreError::file(&path, "create"))?;
        }
        synchronise_directory(&self.root)
    }

    /// An error unless this looks like a results directory.
    pub(super) fn must_exist(&self) -> Result<(), StoreError> {
        let what = if !self.root.is_dir() {
            "there is no such directory"
        } else if !self.logs().is_dir() {
            "it has no directory `log`"
        } else if !self.shards().is_dir() {
            "it has no directory `shards`"
        } else {
            return Ok(());
        };
        Err(StoreError::NotResults { path: self.root.clone(), what })
    }

    /// Takes the directory for this process until the file is dropped.
    ///
    /// The system lets go of the lock when its owner dies, so there is nothing to clean up by hand. The text in the
    /// file only says who to ask; it means nothing without the lock.
    pub(super) fn lock(&self) -> Result<File, StoreError> {
        let path = self.root.join(LOCK);
        let open = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
        let mut file = open.map_err(StoreError::file(&path, "open"))?;
        let mut attempts = LOCK_ATTEMPTS;
        loop {
            attempts -= 1;
            match file.try_lock() {
                Ok(()) => break,
                Err(TryLockError::WouldBlock) if attempts > 0 => std::thread::sleep(LOCK_PAUSE),
                Err(TryLockError::WouldBlock) => {
                    return Err(StoreError::Locked { path: self.root.clone(), owner: owner_in(&mut file) });
                }
                Err(TryLockError::Error(source)) => return Err(StoreError::file(&path, "lock")(source)),
            }
        }
        let owner = format!("process {}\n", std::process::id());
        let written = file.set_len(0).and_then(|()| file.rewind()).and_then(|()| file.write_all(owner.as_bytes()));
        written.map_err(StoreError::file(&path, "write"))?;
        Ok(file)
    }

    /// Who works in the directory; `None` if no one does.
    pub(super) fn owner(&self) -> Result<Option<String>, StoreError> {
        let path = self.root.join(LOCK);
        let mut file = match File::open(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(StoreError::file(&path, "open")(error)),
        };
        // Shared, so that those who look do not see each other, and gone again with `file`.
        match file.try_lock_shared() {
            Ok(()) => Ok(None),
            Err(TryLockError::WouldBlock) => Ok(Some(owner_in(&mut file))),
            Err(TryLockError::Error(source)) => Err(StoreError::file(&path, "lock")(source)),
        }
    }

    /// Removes what killed runs left half written. Only the owner of the lock may call this.
    pub(super) fn remove_leftovers(&self) -> Result<(), StoreError> {
        for directory in [self.root.clone(), self.shards()] {
            for path in files_in(&directory)? {
                if is_temporary(&path) {
                    fs::remove_file(&path).map_err(StoreError::file(&path, "remove"))?;
                }
            }
        }
        Ok(())
    }
}

/// Who a lock file names.
fn owner_in(file: &mut File) -> String {
    let mut owner = String::new();
    let known = file.take(LONGEST_OWNER).read_to_string(&mut owner).is_ok() && !owner.trim().is_empty();
    if known { printable(owner.trim()).into_owned() } else { "process unknown".to_owned() }
}

/// True if a file has this text. One of another size is not read, nor what is no file.
pub fn holds_text(path: &Path, text: &str) -> bool {
    let alike = path.metadata().is_ok_and(|found| found.is_file() && found.len() == text.len() as u64);
    alike && fs::read(path).is_ok_and(|found| found == text.as_bytes())
}

/// True for a file that a run is writing, or left half written.
pub(super) fn is_temporary(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().ends_with(TEMPORARY))
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

    /// Gives the file its name, in one step. It is for the caller to wait until the directory is on the disk.
    pub(super) fn rename(self) -> Result<(), StoreError> {
        fs::rename(&self.temporary, &self.target).map_err(StoreError::file(&self.target, "replace"))
    }

    /// Gives the file its name and waits until the directory is on the disk.
    pub(super) fn put_in_place(self) -> Result<(), StoreError> {
        let directory = match self.target.parent().expect("a file has a directory") {
            // A name alone is one in the working directory.
            parent if parent.as_os_str().is_empty() => Path::new(".").to_owned(),
            parent => parent.to_owned(),
        };
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
    let mut file = File::open(path).map_err(StoreError::file(path, "open"))?;
    let mut buffer = vec![0; 1 << 16];
    loop {
        let read = file.read(&mut buffer).map_err(StoreError::file(path, "read"))?;
        if read == 0 {
            return Ok((hasher.count(), hasher.finalize()));
        }
        hasher.update(&buffer[..read]);
    }
}
