//! The layout of a results directory, and its lock.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::StoreError;
use super::files::{create_directory, files_in, open_file, synchronise_directory, temporary_for};
use super::log::log_numbers;
use super::replacement::BEFORE;
use super::shard::SHARD_DIGITS;
use stribeck_input::printable;

/// The file whose lock its owner holds.
const LOCK: &str = "lock";

/// Most bytes of it that are read, to tell who that is.
const LONGEST_OWNER: u64 = 100;

/// Whoever looks whether a run is at work holds the lock for a moment: that is not to stop a run that starts just then.
const LOCK_ATTEMPTS: u32 = 5;
const LOCK_PAUSE: Duration = Duration::from_millis(20);

/// The published files, in the order in which they are put in place.
pub(super) const PUBLISHED: [&str; 3] = ["results.h5", "summary.csv", "timings.csv"];

/// The other files of the directory itself.
const OTHERS: [&str; 2] = ["sweep.toml", "surface.json"];

/// The name under which a shard is written until it has its own.
const NEW_SHARD: &str = "shard";

/// How the text of a lock file begins.
const OWNER: &str = "process ";

/// The lock of a results directory, held until it is dropped.
#[derive(Debug)]
pub(super) struct Lock {
    _file: File,
    /// False on a file system that has no locks.
    pub is_kept: bool,
}

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

    /// Where a shard is staged that has no name yet.
    pub(super) fn new_shard(&self) -> PathBuf {
        // Of this process: where there are no locks, another one may be at work.
        self.shards().join(format!("{NEW_SHARD}-{}", std::process::id()))
    }

    pub(super) fn published(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }

    /// Checks that a run can write here without replacing files that no run has written.
    ///
    /// [`Directory::create`] comes before the first file of ours, so a start that was killed at any moment left a log.
    pub(super) fn check_available(&self) -> Result<(), StoreError> {
        if self.root.to_str().is_none() {
            return Err(StoreError::NotText { path: self.root.clone() });
        }
        // Others have a directory `log` as well.
        if self.logs().is_dir() && (self.shards().is_dir() || !log_numbers(&self.logs())?.is_empty()) {
            return Ok(());
        }
        let names = ["sweep.toml"].into_iter().chain(PUBLISHED);
        match names.into_iter().find(|name| self.root.join(name).symlink_metadata().is_ok()) {
            Some(file) => Err(StoreError::Occupied { path: self.root.clone(), file }),
            None => self.check_lock(),
        }
    }

    /// Checks that a file `lock`, if there is one, was written by a run.
    fn check_lock(&self) -> Result<(), StoreError> {
        let path = self.root.join(LOCK);
        let mut text = String::new();
        let read = match path.symlink_metadata() {
            Err(_) => return Ok(()),
            Ok(metadata) if !metadata.is_file() => Err(ErrorKind::InvalidInput.into()),
            Ok(_) => File::open(&path).and_then(|file| file.take(LONGEST_OWNER).read_to_string(&mut text)),
        };
        match read {
            // A run that was killed at once leaves an empty one.
            Ok(_) if text.is_empty() || text.starts_with(OWNER) => Ok(()),
            _ => Err(StoreError::ForeignLock { path }),
        }
    }

    /// Makes the directories that are missing.
    pub(super) fn create(&self) -> Result<(), StoreError> {
        create_directory(&self.logs())?;
        create_directory(&self.shards())?;
        // A start that was killed may have made them without waiting for the disk.
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

    /// Takes the directory for this process until the lock is dropped.
    ///
    /// The system lets go of the lock when its owner dies, so there is nothing to clean up by hand. The text in the
    /// file only says who to ask; it means nothing without the lock.
    pub(super) fn lock(&self) -> Result<Lock, StoreError> {
        let path = self.root.join(LOCK);
        let mut file = open_lock(&path).map_err(StoreError::file(&path, "open"))?;
        if !file.metadata().is_ok_and(|metadata| metadata.is_file()) {
            return Err(StoreError::ForeignLock { path });
        }
        let mut attempts = LOCK_ATTEMPTS;
        let is_kept = loop {
            attempts -= 1;
            match file.try_lock() {
                Ok(()) => break true,
                Err(TryLockError::WouldBlock) if attempts > 0 => std::thread::sleep(LOCK_PAUSE),
                Err(TryLockError::WouldBlock) => {
                    return Err(StoreError::Locked { path: self.root.clone(), owner: owner_in(&mut file) });
                }
                // A lock server may be busy for a moment.
                Err(TryLockError::Error(source)) if has_no_locks(&source) && attempts > 0 => {
                    std::thread::sleep(LOCK_PAUSE);
                }
                Err(TryLockError::Error(source)) if has_no_locks(&source) => break false,
                Err(TryLockError::Error(source)) => return Err(StoreError::file(&path, "lock")(source)),
            }
        };
        let owner = format!("{OWNER}{}\n", std::process::id());
        let written = file.set_len(0).and_then(|()| file.rewind()).and_then(|()| file.write_all(owner.as_bytes()));
        written.map_err(StoreError::file(&path, "write"))?;
        Ok(Lock { _file: file, is_kept })
    }

    /// Who works in the directory; `None` if no one does, or if the file system has no locks to tell.
    pub(super) fn owner(&self) -> Result<Option<String>, StoreError> {
        let path = self.root.join(LOCK);
        let mut file = match open_file(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(StoreError::file(&path, "open")(error)),
        };
        // Shared, so that those who look do not see each other, and gone again with `file`.
        match file.try_lock_shared() {
            Ok(()) => Ok(None),
            Err(TryLockError::WouldBlock) => Ok(Some(owner_in(&mut file))),
            Err(TryLockError::Error(source)) if has_no_locks(&source) => Ok(None),
            Err(TryLockError::Error(source)) => Err(StoreError::file(&path, "lock")(source)),
        }
    }

    /// Removes what killed runs left half written. Only the owner of the lock may call this.
    pub(super) fn remove_leftovers(&self) -> Result<(), StoreError> {
        let published = |name: &str| {
            let name = name.strip_suffix(BEFORE).unwrap_or(name);
            PUBLISHED.contains(&name) || OTHERS.contains(&name)
        };
        let shard = |name: &str| {
            let stem = name.strip_suffix(".h5").unwrap_or_default();
            name.starts_with(NEW_SHARD)
                || (stem.len() == SHARD_DIGITS && stem.bytes().all(|byte| byte.is_ascii_hexdigit()))
        };
        remove_temporary(&self.root, published)?;
        remove_temporary(&self.shards(), shard)
    }
}

/// Removes the temporary files of a directory that were to become files with certain names. Others may be a user's.
fn remove_temporary(directory: &Path, is_ours: impl Fn(&str) -> bool) -> Result<(), StoreError> {
    for path in files_in(directory)? {
        if temporary_for(&path).is_some_and(&is_ours) {
            fs::remove_file(&path).map_err(StoreError::file(&path, "remove"))?;
        }
    }
    Ok(())
}

/// Opens a lock file, and makes it if it is not there. A link is an error, and a pipe is not waited for.
fn open_lock(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags((OFlags::NOFOLLOW | OFlags::NONBLOCK).bits() as i32);
    }
    options.open(path)
}

/// True for what a file system says that has no locks: Lustre mounted without them, NFS without its lock server, some
/// file systems of user space.
fn has_no_locks(error: &io::Error) -> bool {
    #[cfg(unix)]
    if error.raw_os_error() == Some(rustix::io::Errno::NOLCK.raw_os_error()) {
        return true;
    }
    error.kind() == ErrorKind::Unsupported
}

/// Who a lock file names.
fn owner_in(file: &mut File) -> String {
    let mut owner = String::new();
    let known = file.take(LONGEST_OWNER).read_to_string(&mut owner).is_ok() && !owner.trim().is_empty();
    if known { printable(owner.trim()).into_owned() } else { "process unknown".to_owned() }
}
