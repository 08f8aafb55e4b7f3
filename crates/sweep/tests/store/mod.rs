//! Laws of the results directory: what is committed comes back bit for bit, what is published does not depend on how it
//! came about, and damage is found, named and repaired by the next run.

mod commit;
mod damage;
mod data_set;
mod directory;
mod outputs;
mod publication;
mod summary;

use std::fs;
use std::path::{Path, PathBuf};

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

fn shards(directory: &Path) -> Vec<PathBuf> {
    let mut files: Vec<_> = fs::read_dir(directory.join("shards")).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    files
}

fn log(directory: &Path, number: u32) -> PathBuf {
    directory.join(format!("log/{number:04}.jsonl"))
}
