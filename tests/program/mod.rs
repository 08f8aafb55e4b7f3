//! Running the program and reading what it says.

#![allow(dead_code)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use assert_cmd::cargo::CommandCargoExt;
use tempfile::{TempDir, tempdir};

/// The program, to be started in a directory.
pub fn stribeck(directory: &Path) -> Command {
    let mut command = Command::cargo_bin("stribeck").expect("the program is built");
    command.current_dir(directory);
    command
}

/// Runs the program in a directory.
pub fn say(directory: &Path, arguments: &[&str]) -> Output {
    stribeck(directory).args(arguments).output().expect("the program starts")
}

pub fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

pub fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("text")
}

pub fn code(output: &Output) -> i32 {
    output.status.code().expect("the program ends by itself")
}

/// Runs a sweep, whose cases may fail, and returns its directory, in which the results are in `results/small`.
pub fn with_results(sweep: &str) -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("small.toml"), sweep).expect("written");
    let run = say(directory.path(), &["run", "small.toml", "--quiet"]);
    assert!([0, 3].contains(&code(&run)), "{}", err(&run));
    directory
}

/// Every path below a directory, sorted.
pub fn paths(directory: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut pending = vec![directory.to_owned()];
    while let Some(directory) = pending.pop() {
        for entry in fs::read_dir(&directory).expect("listed") {
            let path = entry.expect("listed").path();
            if path.is_dir() {
                pending.push(path.clone());
            }
            found.push(path.display().to_string());
        }
    }
    found.sort();
    found
}
