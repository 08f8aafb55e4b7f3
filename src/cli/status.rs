//! `stribeck status`: how far a running or a stopped sweep is.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;

use super::failures::{self, Region};
use super::wording::{count, duration, moment, whole_seconds};
use super::workload::{Workload, inspection};
use super::{CliError, Exit, console};
use crate::engine::rate;
use crate::model::{FieldSelection, Output};
use crate::shown::shown;
use crate::store::{Ending, Holdings, Start, Warning};
use crate::sweep::{Plan, Sweep};

/// Starts that are listed, the last ones.
const LISTED_STARTS: usize = 10;
/// Regions with failures that are listed.
const LISTED_REGIONS: usize = 12;
/// Characters of a reason that are shown.
const LONGEST_REASON: usize = 160;

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck status results/quick
  watch -n 10 stribeck status --quick /scratch/surface  follow a sweep that runs somewhere else

The directory is only read, also while a run works there. Every stored byte is compared with its record, as a run
does before it uses it; --quick looks at the sizes of the files alone.")]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// Look at the sizes of stored files only, not at every byte
    #[arg(long)]
    quick: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let directory = &arguments.directory;
    let sweep = Sweep::read(directory.join("sweep.toml"));
    // Without a sweep nothing is asked for, so that whatever is stored counts.
    let nothing = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    let output = sweep.as_ref().map_or(&nothing, |sweep| &sweep.output);
    let held = Holdings::read(directory, output, inspection(arguments.quick))?;
    let owner = held.owner()?;
    for warning in held.warnings() {
        // The last line of a log may be half written while a run works.
        if owner.is_none() || !matches!(warning, Warning::Record { .. }) {
            console::tell(&format!("warning: {warning}"));
        }
    }
    let mut text = String::new();
    match sweep {
        Ok(sweep) => {
            let plan = Plan::new(&sweep);
            let workload = Workload::survey(&sweep, &plan, Some(&held));
            let published = held.is_published()?;
            text += &of_sweep(arguments, &sweep, &plan, &workload, &held, owner.as_deref(), published);
            text += &starts(&held, owner.is_some());
            text += &failed_regions(&failures::regions(&plan, &held)?);
        }
        Err(error) => {
            console::tell(&format!("warning: how many cases were planned is not known: {error}"));
            let counts = held.counts();
            text += &format!("cases      {} converged, {} failed\n", counts.converged, counts.failed);
            text += &starts(&held, owner.is_some());
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

fn of_sweep(
    arguments: &Arguments,
    sweep: &Sweep,
    plan: &Plan,
    workload: &Workload,
    held: &Holdings,
    owner: Option<&str>,
    published: bool,
) -> String {
    let Workload { converged, failed, .. } = workload;
    let to_do = workload.to_do();
    let state = match (owner, to_do) {
        (Some(owner), _) => format!("running ({owner})"),
        (None, 0) if published => "stopped, all cases were tried".to_owned(),
        (None, 0) => "stopped, all cases were tried, but not yet published; run it again".to_owned(),
        (None, _) => "stopped; the same `stribeck run` command resumes it".to_owned(),
    };
    let mut text = format!("{}: {}\n{state}\n\n", shown(&arguments.directory), sweep.title);
    let mut line = |name: &str, words: String| {
        writeln!(text, "{name:<10} {words}").expect("writing to memory does not fail");
    };
    let places = plan.cases();
    line("planned", format!("{}, at {places} places of the sweep", count(plan.problems() as u64, "case")));
    line("converged", converged.to_string());
    line("failed", failed.to_string());
    line("to do", to_do.to_string());
    for (why, cases) in &workload.stale {
        line("stale", format!("{cases} of them: {why}"));
    }
    let last = held.history().starts().rfind(|(_, start)| start.beginning.is_some());
    if let Some(per_second) = last.and_then(|(_, start)| start.rate()).filter(|&per_second| per_second > 0.0) {
        let left = match (owner, to_do) {
            (Some(_), 1..) => format!(", {} left", duration(to_do as f64 / per_second)),
            _ => String::new(),
        };
        line("rate", format!("{}{left}", rate(per_second)));
    }
    text
}

/// The runs so far, the last ones.
fn starts(held: &Holdings, running: bool) -> String {
    let starts: Vec<(u32, &Start)> = held.history().starts().filter(|(_, start)| start.beginning.is_some()).collect();
    let skipped = starts.len().saturating_sub(LISTED_STARTS);
    let mut text = String::new();
    if !starts.is_empty() {
        text += "\nstarts\n";
    }
    if skipped > 0 {
        text += &format!("  {} before these\n", skipped);
    }
    for (place, (number, start)) in starts.iter().enumerate().skip(skipped) {
        let Some(beginning) = &start.beginning else { continue };
        let ending = match start.ending {
            Some(Ending::Completed) => "completed",
            Some(Ending::Interrupted) => "interrupted",
            None if running && place + 1 == starts.len() => "running",
            None => "killed",
        };
        let (done, asked) = (start.converged + start.failed, beginning.cases);
        let (when, threads) = (moment(beginning.time), count(beginning.threads, "thread"));
        let took = whole_seconds(start.last.saturating_sub(beginning.time));
        text += &format!("  {number:>4}  {when}  {threads}, {done} of {asked} cases in {took}, {ending}\n");
    }
    text
}

fn failed_regions(regions: &[Region]) -> String {
    let mut text = String::new();
    if !regions.is_empty() {
        text += "\nfailures by region\n";
    }
    for region in regions.iter().take(LISTED_REGIONS) {
        let mut reason: String = region.reason.chars().take(LONGEST_REASON).collect();
        if reason.len() < region.reason.len() {
            reason += " …";
        }
        text += &format!("  {region}\n      {} of them like this: {reason}\n", region.alike);
    }
    let more = regions.len().saturating_sub(LISTED_REGIONS);
    if more > 0 {
        text += &format!("  and in {more} more, with fewer failures\n");
    }
    text
}
