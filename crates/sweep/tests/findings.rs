//! What fuzzing found, and what it found worth keeping: every file in `tests/findings/` keeps the law of its target.

use std::fs;
use std::path::Path;

/// Checks every file of a target.
fn all_keep(target: &str, law: fn(&[u8])) {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/findings").join(target);
    let mut files: Vec<_> =
        fs::read_dir(&directory).expect("listed").map(|file| file.expect("listed").path()).collect();
    files.sort();
    assert!(!files.is_empty(), "no files in {}", directory.display());
    for file in files {
        println!("{}", file.display()); // shown if the law panics
        law(&fs::read(&file).expect("read"));
    }
}

#[test]
fn sweep_files_keep_their_law() {
    all_keep("sweep_file", crate::laws::sweep_file::check);
}

#[test]
fn logs_keep_their_law() {
    all_keep("log", crate::laws::log::check);
}

#[test]
fn shards_keep_their_law() {
    all_keep("shard", crate::laws::shard::check);
    crate::laws::shard::check(&crate::laws::shard::written());
}
