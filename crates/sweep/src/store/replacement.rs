//! Replaces several files together.

use std::fs;
use std::path::{Path, PathBuf};

use super::StoreError;
use super::files::{Staged, synchronise_directory};

/// What the temporary name of a file that is being replaced has behind the name.
pub(super) const BEFORE: &str = ".before";

/// Gives staged files of one directory their names, and waits until these are on the disk. After an error all files are
/// those of before, or the error says that they are not.
///
/// A process that is killed between two of the names leaves new files beside old ones; their record tells.
///
/// # Errors
/// [`StoreError::File`] if the disk does not take a name, [`StoreError::Mixed`] if it takes none back either.
pub(super) fn put_in_place(staged: Vec<Staged>) -> Result<(), StoreError> {
    let Some(directory) = staged.first().and_then(|file| file.target().parent()).map(Path::to_owned) else {
        return Ok(());
    };
    let before = staged.iter().map(|file| Before::keep(file.target())).collect::<Result<Vec<_>, _>>()?;
    for (number, file) in staged.into_iter().enumerate() {
        let Err(error) = file.rename() else { continue };
        return Err(match before[..number].iter().rev().try_for_each(Before::restore) {
            Ok(()) => error,
            Err(_) => StoreError::Mixed { directory, source: Box::new(error) },
        });
    }
    synchronise_directory(&directory)
}

/// A file as it was before it is replaced: its second name, if it was there.
struct Before {
    target: PathBuf,
    kept: Option<Staged>,
}

impl Before {
    fn keep(target: &Path) -> Result<Self, StoreError> {
        let name = target.file_name().expect("a staged file has a name").to_string_lossy();
        let kept = Staged::new(target.with_file_name(format!("{name}{BEFORE}")));
        // What a killed run left under this name is in the way of a link.
        let _ = fs::remove_file(kept.path());
        let there = target.is_file();
        if there && fs::hard_link(target, kept.path()).is_err() {
            fs::copy(target, kept.path()).map_err(StoreError::file(kept.path(), "write"))?;
        }
        Ok(Self { target: target.to_owned(), kept: there.then_some(kept) })
    }

    fn restore(&self) -> Result<(), StoreError> {
        let restored = match &self.kept {
            Some(kept) => fs::rename(kept.path(), &self.target),
            None => fs::remove_file(&self.target),
        };
        restored.map_err(StoreError::file(&self.target, "replace"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_refused_takes_the_others_back() {
        let directory = tempfile::tempdir().unwrap();
        let path = |name: &str| directory.path().join(name);
        let stage = |name: &str| {
            let staged = Staged::new(path(name));
            fs::write(staged.path(), "new").unwrap();
            staged
        };
        fs::write(path("a"), "old").unwrap();
        // No file takes the place of a directory.
        fs::create_dir_all(path("c/d")).unwrap();
        put_in_place(["a", "b", "c"].map(stage).into()).unwrap_err();
        assert_eq!(fs::read_to_string(path("a")).unwrap(), "old");
        assert!(!path("b").exists());
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 2, "nothing else is left");

        put_in_place(["a", "b"].map(stage).into()).unwrap();
        assert_eq!(["a", "b"].map(|name| fs::read_to_string(path(name)).unwrap()), ["new", "new"]);
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 3);
    }
}
