//! The results directory that a command works in.

use std::path::{Path, PathBuf};

use stribeck_sweep::Sweep;

/// Where a sweep goes: the directory asked for, or `results/<file stem>`.
pub fn destination(asked: Option<&Path>, sweep: &Sweep) -> PathBuf {
    asked.map_or_else(|| Path::new("results").join(&sweep.name), Path::to_owned)
}
