//! `stribeck verify`: re-reads a results directory and compares it with its records.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;

use super::{CliError, Exit, console};
use crate::format::{bytes, count};
use stribeck_input::shown;
use stribeck_sweep::campaign::{VerifyReport, verify};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck verify results/quick",
    after_help = "\
Every byte is read. Exit code 0: all is as it was written; 4: something is not, and what to do is said."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let report = verify(&arguments.directory)?;
    console::print(&text(&report))?;
    Ok(if report.is_sound() { Exit::Success } else { Exit::Damaged })
}

fn text(report: &VerifyReport) -> String {
    let mut text = format!(
        "read {} with {}, {}; {} as written\n",
        count(report.shards, "shard"),
        count(report.cases, "case"),
        bytes(report.bytes),
        count(report.published, "published file"),
    );
    let mut line = |kind: &str, what: String| {
        writeln!(text, "{kind}: {what}").expect("writing to memory does not fail");
    };
    for problem in &report.problems {
        line("problem", problem.to_string());
    }
    for warning in &report.warnings {
        line("warning", warning.to_string());
    }
    for path in &report.unreferenced {
        line("note", format!("{}: no record names it; a killed run left it, it does no harm", shown(path)));
    }
    for path in &report.replaced {
        line("note", format!("{}: damaged, and its cases solved again; it can be deleted", shown(path)));
    }
    match report.problems.len() as u64 {
        0 => text += "sound\n",
        problems => text += &format!("{} found\n", count(problems, "problem")),
    }
    text
}
