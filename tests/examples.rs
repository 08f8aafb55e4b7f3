//! Every example of every help text runs, in a directory with the files that are shipped beside the program.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use stribeck::commands::{GROUPS, command_line};
use tempfile::tempdir;

/// The examples of a help text, each in one line and without its comment.
pub fn examples(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| *line != "Examples:").skip(1).take_while(|line| line.starts_with("  "));
    let mut examples: Vec<String> = Vec::new();
    let mut goes_on = false;
    for line in lines {
        let (line, more) = match line.strip_suffix(" \\") {
            Some(line) => (line, true),
            None => (line, false),
        };
        let words = line.trim().split("  ").next().unwrap_or_default();
        match examples.last_mut().filter(|_| goes_on) {
            Some(last) => *last = format!("{last} {words}"),
            None => examples.push(words.to_owned()),
        }
        goes_on = more;
    }
    examples
}

/// The examples of the program and of each command, in the order in which help lists the commands.
fn all_examples() -> Vec<(String, Vec<String>)> {
    let all = command_line();
    let commands = GROUPS.iter().flat_map(|(_, names)| *names).map(|name| all.find_subcommand(name).expect(name));
    let of = |command: &clap::Command| {
        let help = command.get_before_help().map(ToString::to_string).unwrap_or_default();
        (command.get_name().to_owned(), examples(&help))
    };
    std::iter::once(of(&all)).chain(commands.map(of)).collect()
}

fn copy_files(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("created");
    for entry in fs::read_dir(from).expect("listed") {
        let path = entry.expect("listed").path();
        fs::copy(&path, to.join(path.file_name().expect("a name"))).expect("copied");
    }
}

#[test]
fn every_command_stands_in_one_group() {
    let mut listed: BTreeMap<&str, usize> = BTreeMap::new();
    for name in GROUPS.iter().flat_map(|(_, names)| *names) {
        *listed.entry(name).or_default() += 1;
    }
    let all = command_line();
    let known: BTreeMap<&str, usize> = all.get_subcommands().map(|command| (command.get_name(), 1)).collect();
    assert_eq!(listed, known);
    let help = command_line().render_help().to_string();
    for command in all.get_subcommands() {
        let begins = format!("  {} ", command.get_name());
        let lines = help.lines().filter(|line| line.starts_with(&begins)).count();
        assert_eq!(lines, 1, "{}: {help}", command.get_name());
        assert!(help.contains(&command.get_about().expect("every command says what it does").to_string()), "{help}");
    }
    let (examples, usage, groups) = (help.find("Examples:"), help.find("Usage:"), help.find("Solve:"));
    assert!(examples < usage && usage < groups && examples.is_some(), "{help}");
}

#[test]
fn every_example_runs() {
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in ["sweeps", "docs/how-to/instrument-files"] {
        copy_files(&root.join(name), &here.join(name));
    }
    let program = Path::new(env!("CARGO_BIN_EXE_stribeck"));
    let path = format!("{}:{}", program.parent().expect("a directory").display(), std::env::var("PATH").expect("set"));
    for (command, examples) in all_examples() {
        assert!(!examples.is_empty(), "the help of {command} has no example");
        for line in examples {
            assert!(line.starts_with("stribeck "), "{line}");
            let run = Command::new("sh").args(["-c", &line]).current_dir(here).env("PATH", &path).output();
            let run = run.expect("sh runs");
            let said = String::from_utf8_lossy(&run.stderr);
            assert!(run.status.success(), "{line}\n{said}");
        }
    }
}
