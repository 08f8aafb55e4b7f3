//! `stribeck plan`: what `run` would do, without doing it.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::Args;

use super::destination::destination;
use super::run_report::about_fields;
use super::{CliError, Exit, console, threads};
use crate::format::{bytes, count, duration, entry};
use stribeck_input::shown;
use stribeck_sweep::campaign::{CaseSeconds, Cost, DirectoryState, PlanOptions, PlanReport, plan, read_sweep};
use stribeck_sweep::store::Inspection;
use stribeck_sweep::{Extent, Grid, Sweep};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck plan sweeps/surface.toml
  stribeck plan sweeps/surface.toml -o elsewhere/surface --threads 32",
    after_help = "\
Nothing is solved and nothing is written. Cases that the results directory has already are told apart
from new ones: this also shows what an extended or half finished sweep has left to do. Every stored byte
is compared with its record, as a run does before it uses it. --quick looks at the sizes of the files alone."
)]
pub struct Arguments {
    /// The sweep file (TOML); docs/reference/sweep-file.md has its keys
    sweep: PathBuf,
    /// Results directory [default: results/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Solver threads that the time is told for [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse)]
    threads: Option<NonZeroUsize>,
    /// Look at the sizes of stored files only, not at every byte
    #[arg(long)]
    quick: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let sweep = read_sweep(&arguments.sweep)?;
    let directory = destination(arguments.output.as_deref(), &sweep.name)?;
    let inspection = if arguments.quick { Inspection::Size } else { Inspection::Bytes };
    let threads = threads::number(arguments.threads);
    let report = plan(&sweep, &directory, &PlanOptions { threads, inspection })?;
    for warning in &report.warnings {
        console::tell(&format!("warning: {warning}"));
    }
    let mut text = describe_sweep(&sweep, &arguments.sweep, &directory, &report);
    text += &describe_pending(&report);
    match &report.cost {
        Some(cost) => {
            text += &describe_cost(cost, threads);
            warn_of_room(cost, report.free);
        }
        None => text += "to do      nothing to solve\n",
    }
    console::print(&text)?;
    if let Some(note) = about_fields(&sweep).filter(|_| report.cost.is_some()) {
        console::tell(&note);
    }
    Ok(Exit::Success)
}

/// The sweep, where it goes, and how many cases it has.
fn describe_sweep(sweep: &Sweep, file: &Path, directory: &Path, report: &PlanReport) -> String {
    let dimensions = sweep.grid.dimensions();
    let axes: Vec<String> = dimensions.iter().map(|axis| format!("{} {}", axis.values.len(), axis.name)).collect();
    let state = match report.directory {
        DirectoryState::Empty => "no results yet",
        DirectoryState::OtherSweep => "last run with another sweep file",
        DirectoryState::SameSweep => "has results",
    };
    let once = match sweep.grid {
        Grid::Dimensionless(_) => "elastic ones are solved once for all alpha",
        Grid::Laboratory(_) => "those with the same f, alpha and beta are solved once",
    };
    let mut text = String::new();
    let mut line = |name: &str, words: String| text += &entry(name, &words);
    line("sweep", format!("{} ({})", sweep.title, shown(file)));
    line("directory", format!("{} ({state})", shown(directory)));
    line("cases", format!("{} = {}", report.plan.cases(), axes.join(" x ")));
    if let Grid::Laboratory(axes) = &sweep.grid {
        let extent = Extent::of(axes);
        line("range", extent.to_string());
        let cavity = sweep.output.cavity_shear;
        line("cavity", format!("{cavity}: {}", cavity.meaning()));
        if let Some(note) = extent.note() {
            line("note", note);
        }
    }
    let chains = count(report.plan.chain_count() as u64, "chain");
    line("problems", format!("{} distinct, in {chains}; {once}", report.plan.problems()));
    text
}

/// What is stored, and what is left.
fn describe_pending(report: &PlanReport) -> String {
    let pending = &report.pending;
    let mut text = String::new();
    let mut line = |name: &str, words: String| text += &entry(name, &words);
    let (reused, new, failed) = (pending.converged, pending.new, pending.failed);
    let stale = match pending.stale_cases() {
        0 => String::new(),
        stale => format!(", {stale} stale"),
    };
    line("state", format!("{reused} reused, {new} new{stale}, {failed} failed before"));
    for stale in &pending.stale {
        line("stale", format!("{}: {}", stale.cases, stale.reason));
    }
    if pending.unplaced > 0 {
        line("others", format!("{} stored have no place in this sweep; they stay", count(pending.unplaced, "case")));
    }
    for refinement in &report.refinements {
        line("refine", format!("{refinement} cases of the sweep before"));
    }
    if pending.to_do() > 0 {
        let (to_do, chains) = (pending.to_do(), pending.chains.len() as u64);
        let seeding = match pending.to_compute - to_do {
            0 => String::new(),
            others => format!("; {others} of the reused cases are solved again to seed them"),
        };
        line("to do", format!("{} in {}{seeding}", count(to_do, "case"), count(chains, "chain")));
    }
    text
}

/// Warns of a sweep that the disk has no room for.
fn warn_of_room(cost: &Cost, free: Option<u64>) {
    let needed = cost.size.stored.saturating_add(cost.size.published);
    if let Some(free) = free.filter(|free| needed > *free) {
        console::tell(&format!(
            "warning: the sweep takes about {}, and the disk has {} left: name another one with -o, or leave fields \
             out (fields = [] in [output])",
            bytes(needed),
            bytes(free)
        ));
    }
}

/// Time and bytes.
fn describe_cost(cost: &Cost, threads: NonZeroUsize) -> String {
    let source = match cost.case {
        CaseSeconds::Logged(_) => "the mean of what the log has",
        CaseSeconds::Estimated(_) => "estimated on this machine",
    };
    let (run, case) = (duration(cost.seconds), duration(cost.case.seconds()));
    let (stored, published) = (bytes(cost.size.stored), bytes(cost.size.published));
    let threads = count(threads.get() as u64, "thread");
    entry("time", &format!("about {run} on {threads}; {case} per case, {source}"))
        + &entry("disk", &format!("about {stored} to store, {published} published"))
}
