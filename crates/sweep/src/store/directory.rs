//! The layout of a results directory, and its lock.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::StoreError;
use super::files::{files_in, is_temporary, synchronise_directory};
use super::log::log_numbers;
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

    /// Checks that a run can write here without replacing files that no run has written.
    ///
    /// [`Directory::create`] comes before the first file of ours, so a start that was killed at any moment left a log.
    pub(super) fn check_available(&self) -> Result<(), StoreError> {
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
