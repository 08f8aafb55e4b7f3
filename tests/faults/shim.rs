//! The program under a shim that makes its system calls fail, or records them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::time::Duration;

use tempfile::TempDir;

use crate::program::stribeck;

/// Far longer than any run here takes.
const PATIENCE: Duration = Duration::from_secs(60);

/// A call that fails.
#[derive(Clone, Copy, Debug)]
pub struct Fault {
    /// Name of the call.
    pub call: &'static str,
    /// Which of them, from 1.
    pub number: u64,
    /// The error.
    pub error: Error,
}

/// How a call fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    /// EIO, once.
    Faulty,
    /// ENOSPC, from then on.
    Full,
    /// EDQUOT, from then on.
    Quota,
    /// EINTR, once.
    Interrupted,
    /// Half of the bytes, once; only of reads and writes.
    Short,
    /// ENOSYS, always: a file system that has not got the call.
    Missing,
    /// ENOLCK, always.
    NoLocks,
}

impl Error {
    /// Those of disks.
    pub const ALL: [Self; 5] = [Self::Faulty, Self::Full, Self::Quota, Self::Interrupted, Self::Short];

    /// The number of the error on Linux.
    fn number(self) -> u32 {
        match self {
            Self::Faulty => 5,
            Self::Full => 28,
            Self::Quota => 122,
            Self::Interrupted => 4,
            Self::Short => 0,
            Self::Missing => 38,
            Self::NoLocks => 37,
        }
    }

    /// True if calls of this name can fail so.
    pub fn is_of(self, call: &str) -> bool {
        let moves = ["read", "pread", "write", "pwrite"].contains(&call);
        let takes_room = ["write", "pwrite", "open", "mkdir", "link", "rename", "fsync", "fdatasync", "ftruncate"];
        match self {
            Self::Faulty => true,
            Self::Full | Self::Quota => takes_room.contains(&call),
            Self::Interrupted => moves || call == "open",
            Self::Short => moves,
            Self::Missing | Self::NoLocks => false,
        }
    }
}

/// The shim, built once for all tests.
fn library() -> &'static Path {
    static LIBRARY: OnceLock<(TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = LIBRARY.get_or_init(|| {
        let home = TempDir::with_prefix("stribeck-shim-").expect("a temporary directory");
        let path = home.path().join("shim.so");
        let source = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/faults/shim.c");
        let built = Command::new("cc").args(["-shared", "-fPIC", "-O1", "-Wall", "-o"]).arg(&path).arg(source).output();
        let built = built.expect("a C compiler, which HDF5 needs as well");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        (home, path)
    });
    path
}

/// The program in a directory, under the shim, which looks at paths that begin with `root`.
fn shimmed(directory: &Path, root: &Path, arguments: &[&str]) -> Command {
    let mut command = stribeck(directory);
    command.args(arguments).env("LD_PRELOAD", library()).env("FAULT_ROOT", root);
    command
}

/// Runs the program, which must come to an end by itself.
fn end(command: Command, what: &dyn std::fmt::Debug) -> Output {
    let output = assert_cmd::Command::from_std(command).timeout(PATIENCE).output().expect("the program starts");
    assert!(output.status.code().is_some(), "{what:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Runs the program with a fault.
pub fn with_fault(directory: &Path, root: &Path, fault: Fault, arguments: &[&str]) -> Output {
    let mut command = shimmed(directory, root, arguments);
    command.env("FAULT_CALL", fault.call).env("FAULT_NUMBER", fault.number.to_string());
    command.env("FAULT_ERRNO", fault.error.number().to_string());
    if matches!(fault.error, Error::Full | Error::Quota | Error::Missing | Error::NoLocks) {
        command.env("FAULT_FOREVER", "1");
    }
    end(command, &fault)
}

/// Runs the program, and counts its calls of each kind.
pub fn counts(directory: &Path, root: &Path, arguments: &[&str]) -> BTreeMap<String, u64> {
    let file = directory.join("counts");
    let mut command = shimmed(directory, root, arguments);
    command.env("FAULT_COUNTS", &file);
    let output = end(command, &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let text = fs::read_to_string(file).expect("written at the end");
    let count =
        |line: &str| line.split_once(' ').map(|(name, count)| (name.to_owned(), count.parse().expect("a number")));
    text.lines().filter_map(count).collect()
}

/// Runs the program, and records what it does to its files.
pub fn trace(directory: &Path, root: &Path, arguments: &[&str]) -> Vec<u8> {
    let file = directory.join("trace");
    let mut command = shimmed(directory, root, arguments);
    command.env("FAULT_TRACE", &file);
    let output = end(command, &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    fs::read(file).expect("written")
}
