//! `stribeck status`: how far a running or a stopped sweep is.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;

use super::collection::{Collection, sweep_file};
use super::destination::read_sweep;
use super::failures::{self, Region};
use super::parts::{in_words, states};
use super::wording::{count, duration, moment, whole_seconds};
use super::workload::{Workload, inspection};
use super::{CliError, Exit, console};
use stribeck_input::shown;
use stribeck_solver::{FieldSelection, Output};
use stribeck_sweep::engine::rate;
use stribeck_sweep::store::{Ending, Holdings, Start, Warning};
use stribeck_sweep::{Plan, Sweep};

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
    let sweep = read_sweep(&sweep_file(directory)?);
    // Without a sweep nothing is asked for, so that whatever is stored counts.
    let nothing = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    let output = sweep.as_ref().map_or(&nothing, |sweep| &sweep.output);
    let inspection = inspection(arguments.quick);
    let mut collection = Collection::read(directory, output, inspection)?;
    if collection.is_empty() {
        collection.whole = Some(Holdings::read(directory, output, inspection)?);
    }
    let runs = Runs::of(&collection)?;
    for (held, running) in collection.all().into_iter().zip(&runs.owners) {
        for warning in held.warnings() {
            // The last line of a log may be half written while a run works.
            if running.is_none() || !matches!(warning, Warning::Record { .. }) {
                console::tell(&format!("warning: {warning}"));
            }
        }
    }
    let mut text = String::new();
    match sweep {
        Ok(sweep) => {
            let plan = Plan::new(&sweep);
            let held = collection.held();
            let workload = Workload::survey(&sweep, &plan, None, &held);
            let published = collection.whole.as_ref().map_or(Ok(false), Holdings::is_published)?;
            text += &of_sweep(arguments, &sweep, &plan, &workload, &runs, published);
            if !collection.parts.is_empty() {
                text += &format!("\n{}", in_words(&states(&plan, &collection, &held)?));
            }
            text += &runs.starts();
            text += &failed_regions(&failures::regions(&plan, &held)?);
        }
        Err(error) => {
            console::tell(&format!("warning: how many cases were planned is not known: {error}"));
            let counts = collection.all().into_iter().map(Holdings::counts);
            let [converged, failed] =
                counts.fold([0, 0], |sums, counts| [sums[0] + counts.converged, sums[1] + counts.failed]);
            text += &format!("cases      {converged} converged, {failed} failed\n");
            text += &runs.starts();
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

/// The runs of a directory and of its parts.
struct Runs<'a> {
    whole: Option<&'a Holdings>,
    parts: Vec<&'a Holdings>,
    /// Who works in each, the directory itself first.
    owners: Vec<Option<String>>,
}

impl<'a> Runs<'a> {
    fn of(collection: &'a Collection) -> Result<Self, CliError> {
        let owners = collection.all().into_iter().map(Holdings::owner).collect::<Result<_, _>>()?;
        let parts = collection.parts.iter().map(|(_, held)| held).collect();
        Ok(Self { whole: collection.whole.as_ref(), parts, owners })
    }

    /// Who works here, in words.
    fn at_work(&self) -> Option<String> {
        let owners: Vec<&String> = self.owners.iter().flatten().collect();
        match owners.as_slice() {
            [] => None,
            [owner] => Some((*owner).clone()),
            owners => Some(format!("{} processes", owners.len())),
        }
    }

    /// Cases per second: of those who work here together, else of the last start.
    fn rate(&self) -> Option<f64> {
        let solves = |start: &Start| start.beginning.as_ref().is_some_and(|beginning| beginning.threads > 0);
        let last = |held: &Holdings| held.history().starts().rfind(|(_, start)| solves(start))?.1.rate();
        let all = self.whole.iter().chain(&self.parts);
        let running = all.clone().zip(&self.owners).filter(|(_, owner)| owner.is_some());
        let rates: Vec<f64> = running.filter_map(|(held, _)| last(held)).collect();
        let rate = match rates.is_empty() {
            true => all.filter_map(|held| last(held)).next_back()?,
            false => rates.iter().sum(),
        };
        Some(rate).filter(|&rate| rate > 0.0)
    }

    /// The starts in the directory itself; those of its parts are too many to be listed.
    fn starts(&self) -> String {
        let running = self.owners.first().is_some_and(Option::is_some);
        self.whole.map_or_else(String::new, |held| starts(held, running))
    }
}

fn of_sweep(
    arguments: &Arguments,
    sweep: &Sweep,
    plan: &Plan,
    workload: &Workload,
    runs: &Runs<'_>,
    published: bool,
) -> String {
    let Workload { converged, failed, .. } = workload;
    let (to_do, parts) = (workload.to_do(), !runs.parts.is_empty());
    let state = match (runs.at_work(), to_do) {
        (Some(owner), _) => format!("running ({owner})"),
        (None, 0) if published => "stopped, all cases were tried".to_owned(),
        (None, 0) if parts => {
            "stopped, all cases were tried, but not yet published; `stribeck merge` does that".to_owned()
        }
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
    if let Some(per_second) = runs.rate() {
        let left = match (runs.at_work(), to_do) {
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
        let (when, took) = (moment(beginning.time), whole_seconds(start.last.saturating_sub(beginning.time)));
        // A merge solves nothing.
        let work = match beginning.threads {
            0 => format!("joined {}", count(done, "case")),
            threads => format!("{}, {done} of {asked} cases", count(threads, "thread")),
        };
        text += &format!("  {number:>4}  {when}  {work} in {took}, {ending}\n");
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
