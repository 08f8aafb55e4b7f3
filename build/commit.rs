//! The version of the program with the commit that it is built from, where that is known.
//!
//! It is known in a clone of the repository, or where a packager gives it in the variable `STRIBECK_COMMIT`. Elsewhere
//! the version stands alone. It is the last commit that changed the sources: the same sources give the same program,
//! and what is published with it.

use std::env;
use std::path::Path;
use std::process::Command;

/// What the program is made of.
const SOURCES: [&str; 9] = [
    "src",
    "crates/*/src",
    "crates/*/build.rs",
    "crates/*/Cargo.toml",
    "assets",
    "build",
    "build.rs",
    "Cargo.toml",
    "Cargo.lock",
];

/// Hands the version to the crate as `STRIBECK_VERSION`, as in `0.1.0 (1a2b3c4d5e6f)`.
pub fn hand_over() {
    println!("cargo::rerun-if-env-changed=STRIBECK_COMMIT");
    let version = env::var("CARGO_PKG_VERSION").expect("cargo names it");
    let text = match env::var("STRIBECK_COMMIT").ok().or_else(of_repository) {
        Some(commit) if !commit.is_empty() => format!("{version} ({commit})"),
        _ => version,
    };
    println!("cargo::rustc-env=STRIBECK_VERSION={text}");
}

/// The commit of the repository that this is the root of.
fn of_repository() -> Option<String> {
    let root = Path::new(&git(&["rev-parse", "--show-toplevel"])?).canonicalize().ok()?;
    if root != env::current_dir().ok()?.canonicalize().ok()? {
        return None;
    }
    for name in ["HEAD", "refs/heads", "packed-refs"] {
        watch(Path::new(&git(&["rev-parse", "--git-path", name])?));
    }
    // Whether something is changed since the commit is to be seen again after each change.
    SOURCES.into_iter().filter(|name| !name.contains('*')).for_each(|name| watch(Path::new(name)));
    for member in Path::new("crates").read_dir().ok()?.flatten() {
        ["src", "build.rs", "Cargo.toml"].into_iter().for_each(|name| watch(&member.path().join(name)));
    }
    let sources = SOURCES.map(|name| format!(":(glob){name}{}", if name.contains('.') { "" } else { "/**" }));
    let question = ["status", "--porcelain", "--"].into_iter().chain(sources.iter().map(String::as_str));
    let changed = git(&question.collect::<Vec<_>>())?;
    let last = ["log", "-1", "--format=%h", "--abbrev=12", "--"].into_iter();
    let commit = git(&last.chain(sources.iter().map(String::as_str)).collect::<Vec<_>>())?;
    Some(if changed.is_empty() { commit } else { format!("{commit}, modified") })
}

/// Builds again when a file or something in a directory changes.
fn watch(path: &Path) {
    if path.exists() {
        println!("cargo::rerun-if-changed={}", path.display());
    }
}

/// What git says; nothing if it is not there or finds no repository.
fn git(arguments: &[&str]) -> Option<String> {
    // `status` would take the lock of another git to note what it has seen.
    let output = Command::new("git").env("GIT_OPTIONAL_LOCKS", "0").args(arguments).output().ok()?;
    let said = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| said.trim().to_owned())
}
