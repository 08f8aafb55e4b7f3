//! The rounds of a surface in its directory, for those who ask how far it is.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::build::Progress;
use crate::store::{StoreError, write_whole};

/// The file in the directory of a surface.
const FILE: &str = "rounds.json";

/// How far a surface is. It is made anew by each start, which goes through the same rounds as the one before.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Rounds {
    /// Each round.
    pub rounds: Vec<Round>,
    /// Each comparison with random points.
    pub comparisons: Vec<Round>,
}

/// A round of refinement, or a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Round {
    /// The number of cases so far.
    pub cases: usize,
    /// The largest error at the points of the round or comparison, in tolerances.
    pub largest: f64,
}

impl Rounds {
    /// Reads the rounds of a directory; `None` if it is none of a surface.
    ///
    /// # Errors
    /// [`StoreError::File`] if the file is there and cannot be read.
    pub fn read(directory: &Path) -> Result<Option<Self>, StoreError> {
        let path = directory.join(FILE);
        match fs::read(&path) {
            Ok(bytes) => Ok(serde_json::from_slice(&bytes).ok()),
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => Ok(None),
            Err(error) => Err(StoreError::file(&path, "read")(error)),
        }
    }

    /// Begins in a directory, so that it is one of a surface from the start.
    pub(super) fn begin(directory: &Path) -> Result<Self, StoreError> {
        let rounds = Self::default();
        rounds.write(directory).map(|()| rounds)
    }

    /// Takes what is told of the work, and writes it.
    pub(super) fn tell(&mut self, directory: &Path, progress: &Progress) -> Result<(), StoreError> {
        match *progress {
            Progress::Damaged { .. } => return Ok(()),
            Progress::Round { cases, largest, .. } => self.rounds.push(Round { cases, largest }),
            Progress::Compared { cases, largest } => self.comparisons.push(Round { cases, largest }),
        }
        self.write(directory)
    }

    fn write(&self, directory: &Path) -> Result<(), StoreError> {
        let text = serde_json::to_string_pretty(self).expect("numbers become text");
        write_whole(directory.join(FILE), (text + "\n").as_bytes())
    }
}
