//! `stribeck merge`: joins what parts and other runs of a sweep have solved, and publishes.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use super::shell::quoted;
use super::{CliError, Exit, console};
use crate::format::count;
use stribeck_input::shown;
use stribeck_sweep::Part;
use stribeck_sweep::campaign::{Event, IncompletePart, MergeOutcome, Missing, PartState, merge, sweep_file};
use stribeck_sweep::store::Joined;

const IN_MEMORY: &str = "writing to memory does not fail";

/// Missing parts that are named with the command that finishes them.
const LISTED: usize = 10;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck merge shared/two-modes                       the parts that `run --part` left there
  stribeck merge results/quick elsewhere/quick -o joined",
    after_help = "\
Shards are linked, or copied from another file system. So the result is a directory like any other: it can be
resumed, extended and verified, and those it was made of may be deleted. Start again after an interruption. A case that
is there twice has to agree within the tolerance. If cases are missing nothing is published. The message names the
parts they are in with the commands that finish them; exit code 4."
)]
pub struct Arguments {
    /// Results directories of one sweep; their parts are joined with them
    #[arg(value_name = "DIR", required = true)]
    sources: Vec<PathBuf>,
    /// Results directory to join them in [default: DIR, if there is one]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let target = match (&arguments.output, arguments.sources.as_slice()) {
        (Some(target), _) => target,
        (None, [only]) => only,
        (None, _) => return Err(CliError::NoTarget),
    };
    let report = merge(&arguments.sources, target, &mut |event| {
        if let Event::Damaged(warning) = event {
            console::tell(&format!("warning: {warning}"));
        }
    })?;
    let published = match report.outcome {
        MergeOutcome::Published(published) => published,
        MergeOutcome::Incomplete(missing) => {
            return Err(CliError::Incomplete { missing: what_is_missing(&missing, target)? });
        }
    };
    let (converged, failed) = (published.converged, published.failed);
    let Joined { shards, cases, twice } = report.joined;
    let mut text = format!("{}: {converged} converged, {failed} failed\n", count(converged + failed, "case"));
    writeln!(text, "joined {} in {}; {twice} were there already", count(cases, "case"), count(shards, "shard"))
        .expect(IN_MEMORY);
    writeln!(text, "results in {}: results.h5, summary.csv, timings.csv", shown(target)).expect(IN_MEMORY);
    console::print(&text)?;
    Ok(if failed == 0 { Exit::Success } else { Exit::CasesFailed })
}

/// What is missing, by parts if there are any, with the commands that finish it.
fn what_is_missing(missing: &Missing, target: &Path) -> Result<String, CliError> {
    let mut text = format!("{} of the sweep missing", count(missing.cases, "case"));
    if missing.parts.is_empty() {
        write!(text, "; this solves them and publishes:\n    {}", run_command(target, None)?).expect(IN_MEMORY);
        return Ok(text);
    }
    write!(text, ", in {}:", count(missing.parts.len() as u64, "part")).expect(IN_MEMORY);
    for IncompletePart { directory, state } in missing.parts.iter().take(LISTED) {
        let PartState { part, missing, cases, .. } = state;
        let (cases, command) = (count(*cases, "case"), run_command(directory, Some(*part))?);
        write!(text, "\n  part {part} lacks {missing} of {cases}; this finishes it:\n    {command}").expect(IN_MEMORY);
    }
    if missing.parts.len() > LISTED {
        write!(text, "\n  and {} more parts", missing.parts.len() - LISTED).expect(IN_MEMORY);
    }
    Ok(text + "\nthen merge again")
}

/// The command that solves what is left of the sweep of a directory, or of a part of it.
fn run_command(directory: &Path, part: Option<Part>) -> Result<String, CliError> {
    let file = sweep_file(directory)?;
    let part = part.map_or_else(String::new, |part| format!(" --part {part}"));
    let (file, directory) = (quoted(file.as_os_str()), quoted(directory.as_os_str()));
    Ok(format!("stribeck run {file} -o {directory}{part}"))
}
