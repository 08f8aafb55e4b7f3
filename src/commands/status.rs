//! `stribeck status`: how far a running or a stopped sweep is.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use super::run_report::note_line;
use super::{CliError, Exit, console};
use crate::format::{count, duration, entry, filled, utc_timestamp, whole_seconds};
use stribeck_input::shown;
use stribeck_sweep::campaign::{FailureRegion, PartActivity, PartState, PlannedStatus, StatusReport, status};
use stribeck_sweep::engine::rate;
use stribeck_sweep::store::{Ending, Inspection, Start};
use stribeck_sweep::surface::Rounds;
use stribeck_sweep::{NoteCounts, SurfaceSweep};

const IN_MEMORY: &str = "writing to memory does not fail";

/// Starts that are listed, the last ones.
const LISTED_STARTS: usize = 10;
/// Parts that are listed one by one.
const LISTED_PARTS: usize = 10;
/// Regions with failures that are listed.
const LISTED_REGIONS: usize = 12;
/// Characters of a reason that are shown.
const LONGEST_REASON: usize = 160;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck status results/quick
  stribeck status results/friction                      of a surface: rounds, error, cases
  stribeck status results/quick --quick                 fast enough for `watch -n 10`, to follow a run",
    after_help = "\
The directory is only read, also while a run works there. Every stored byte is compared with its record, as a run
does before it uses it. --quick looks at the sizes of the files alone."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// Look at the sizes of stored files only, not at every byte
    #[arg(long)]
    quick: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let inspection = if arguments.quick { Inspection::Size } else { Inspection::Bytes };
    let report = status(&arguments.directory, inspection)?;
    for warning in &report.warnings {
        console::tell(&format!("warning: {warning}"));
    }
    let mut text = String::new();
    if let Some(rounds) = Rounds::read(&arguments.directory)? {
        text += &describe_surface(&arguments.directory, &rounds, &report);
        text += &describe_starts(&report);
        console::print(&text)?;
        return Ok(Exit::Success);
    }
    match &report.cases {
        Ok(planned) => {
            let heading = format!("{}: {}", shown(&arguments.directory), planned.sweep.title);
            text += &format!("{}\n", filled(&heading, "  "));
            text += &describe_cases(planned, &report);
            if !planned.parts.is_empty() {
                text += &format!("\n{}", describe_parts(&planned.parts));
            }
            text += &describe_starts(&report);
            text += &describe_notes(&planned.notes, planned.places as u64);
            text += &describe_failures(&planned.failures);
        }
        Err(unplanned) => {
            console::tell(&format!("warning: how many cases were planned is not known: {}", unplanned.error));
            let (converged, failed) = (report.stored.converged, report.stored.failed);
            text += &format!("cases      {converged} converged, {failed} failed\n");
            text += &describe_starts(&report);
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

/// How far a surface is: its rounds, the error that it has reached, and its cases.
fn describe_surface(directory: &Path, rounds: &Rounds, report: &StatusReport) -> String {
    let file = directory.join("surface.json");
    let sweep = SurfaceSweep::read(directory.join("sweep.toml"));
    let title = sweep.as_ref().map_or("a surface", |surface| &surface.sweep.title);
    let state = match (report.workers.as_slice(), file.is_file()) {
        ([worker, ..], _) => format!("running ({worker})"),
        ([], true) => format!("finished: {}", shown(&file)),
        ([], false) => "stopped; the same `stribeck surface` command goes on".to_owned(),
    };
    let heading = filled(&format!("{}: {title}", shown(directory)), "  ");
    let mut text = format!("{heading}\n{state}\n\n");
    let mut line = |name: &str, words: String| text += &entry(name, &words);
    let cases = rounds.rounds.iter().chain(&rounds.comparisons).map(|round| round.cases).max().unwrap_or(0);
    line("rounds", format!("{}, {cases} cases", rounds.rounds.len()));
    let tolerance = sweep.as_ref().map(|surface| surface.settings.tolerance);
    match (rounds.comparisons.last(), &tolerance) {
        (Some(compared), Ok(tolerance)) => {
            line(
                "error",
                format!(
                    "at most {:.1e} at random points; the tolerance is {tolerance:e}",
                    compared.largest * tolerance
                ),
            );
        }
        (Some(compared), Err(_)) => {
            line("error", format!("at most {:.2} tolerances at random points", compared.largest))
        }
        (None, _) => line("error", "not compared with random points yet".to_owned()),
    }
    line("cases", format!("{} converged, {} failed", report.stored.converged, report.stored.failed));
    text
}

/// Whether someone works here, and how many cases are done.
fn describe_cases(planned: &PlannedStatus, report: &StatusReport) -> String {
    let (pending, running) = (&planned.pending, !report.workers.is_empty());
    let state = match (report.workers.as_slice(), pending.to_do()) {
        ([worker], _) => format!("running ({worker})"),
        ([_, ..], _) => format!("running ({} processes)", report.workers.len()),
        ([], 0) if planned.published => "stopped, all cases were tried".to_owned(),
        ([], 0) if !planned.parts.is_empty() => {
            "stopped, all cases were tried, but not yet published; `stribeck merge` does that".to_owned()
        }
        ([], 0) => "stopped, all cases were tried, but not yet published; run it again".to_owned(),
        ([], _) => "stopped; the same `stribeck run` command resumes it".to_owned(),
    };
    let mut text = format!("{state}\n\n");
    let mut line = |name: &str, words: String| text += &entry(name, &words);
    let (problems, places) = (count(planned.problems as u64, "case"), planned.places);
    line("planned", format!("{problems}, at {places} places of the sweep"));
    line("converged", pending.converged.to_string());
    line("failed", (pending.failed + pending.given_up()).to_string());
    line("to do", pending.to_do().to_string());
    for stale in &pending.stale {
        line("stale", format!("{} of them: {}", stale.cases, stale.reason));
    }
    if let Some(per_second) = report.rate {
        let left = match pending.to_do() {
            to_do @ 1.. if running => format!(", {} left", duration(to_do as f64 / per_second)),
            _ => String::new(),
        };
        line("rate", format!("{}{left}", rate(per_second)));
    }
    text
}

/// A line of counts, and a line for each part that lacks something, the first ones.
fn describe_parts(parts: &[PartState]) -> String {
    let incomplete: Vec<&PartState> = parts.iter().filter(|state| state.missing > 0).collect();
    let number = |is: fn(&PartActivity) -> bool| incomplete.iter().filter(|state| is(&state.activity)).count();
    let mut text = format!(
        "{}: {} complete, {} running, {} stopped, {} not started\n",
        count(parts.len() as u64, "part"),
        parts.len() - incomplete.len(),
        number(|activity| matches!(activity, PartActivity::Running(_))),
        number(|activity| *activity == PartActivity::Stopped),
        number(|activity| *activity == PartActivity::NotStarted),
    );
    for PartState { part, cases, missing, activity } in incomplete.iter().take(LISTED_PARTS) {
        let activity = match activity {
            PartActivity::NotStarted => "not started".to_owned(),
            PartActivity::Running(worker) => format!("running ({worker})"),
            PartActivity::Stopped => "stopped".to_owned(),
        };
        let left = count(*missing, "case");
        writeln!(text, "  {:<9} {left} of {cases} missing, {activity}", part.to_string()).expect(IN_MEMORY);
    }
    if incomplete.len() > LISTED_PARTS {
        writeln!(text, "  and {} more", incomplete.len() - LISTED_PARTS).expect(IN_MEMORY);
    }
    text
}

/// The runs in the directory itself, the last ones; those of its parts are too many to be listed.
fn describe_starts(report: &StatusReport) -> String {
    let starts: Vec<&(u32, Start)> = report.starts.iter().filter(|(_, start)| start.beginning.is_some()).collect();
    let skipped = starts.len().saturating_sub(LISTED_STARTS);
    let mut text = String::new();
    if !starts.is_empty() {
        text += "\nstarts (UTC)\n";
    }
    if skipped > 0 {
        text += &format!("  {skipped} before these\n");
    }
    for (place, (number, start)) in starts.iter().enumerate().skip(skipped) {
        let Some(beginning) = &start.beginning else { continue };
        let ending = match start.ending {
            Some(Ending::Completed) => "completed",
            Some(Ending::Interrupted) => "interrupted",
            None if report.running && place + 1 == starts.len() => "running",
            None => "killed",
        };
        let (done, asked) = (start.converged + start.failed, beginning.cases);
        let (when, took) = (utc_timestamp(beginning.time), whole_seconds(start.last.saturating_sub(beginning.time)));
        // A merge solves nothing.
        let work = match beginning.threads {
            0 => format!("joined {}", count(done, "case")),
            threads => format!("{}, {done} of {asked} cases", count(threads, "thread")),
        };
        let line = format!("{number:>4} {} {work} in {took}, {ending}", when.trim_end_matches(" UTC"));
        text += &filled(&line, "     ");
        text.push('\n');
    }
    text
}

/// A line for each note that published places have.
fn describe_notes(notes: &NoteCounts, places: u64) -> String {
    let lines: String = notes.iter().map(|(note, count)| note_line(note, count, places)).collect();
    if lines.is_empty() { lines } else { format!("\n{lines}") }
}

fn describe_failures(regions: &[FailureRegion]) -> String {
    let mut text = String::new();
    if !regions.is_empty() {
        text += "\nfailures by region\n";
    }
    for region in regions.iter().take(LISTED_REGIONS) {
        let (cases, example) = (region.commonest.cases, &region.commonest.example);
        let mut reason: String = example.chars().take(LONGEST_REASON).collect();
        if reason.len() < example.len() {
            reason += " …";
        }
        let like = filled(&format!("      {cases} of them like this: {reason}"), "      ");
        text += &format!("{}\n{like}\n", filled(&format!("  {region}"), "    "));
    }
    let more = regions.len().saturating_sub(LISTED_REGIONS);
    if more > 0 {
        text += &format!("  and in {more} more, with fewer failures\n");
    }
    text
}
