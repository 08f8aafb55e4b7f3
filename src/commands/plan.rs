//! `stribeck plan`: what `run` would do, without doing it.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

use super::collection::{Collection, Held};
use super::destination::{destination, had_other_sweep, read_sweep};
use super::expectation::{CaseSeconds, Size};
use super::wording::{bytes, count, duration};
use super::workload::{Workload, inspection};
use super::{CliError, Exit, console, threads};
use stribeck_input::shown;
use stribeck_sweep::store::Store;
use stribeck_sweep::{Grid, Plan, Sweep};

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck plan sweeps/surface.toml
  stribeck plan sweeps/surface.toml -o /scratch/surface --threads 32

Nothing is solved and nothing is written. Cases that the results directory has already are told apart
from new ones, so this also shows what an extended or half finished sweep has left to do. Every stored byte
is compared with its record, as a run does before it uses it; --quick looks at the sizes of the files alone.")]
pub struct Arguments {
    /// The sweep file (TOML); docs/sweep-file.md has its keys
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
    let plan = Plan::new(&sweep);
    let directory = destination(arguments.output.as_deref(), &sweep)?;
    let collection = Collection::read(&directory, &sweep.output, inspection(arguments.quick))?;
    if collection.whole.is_none() {
        Store::may_take(&directory)?;
    }
    let held = collection.held();
    for warning in held.all().iter().flat_map(|held| held.warnings()) {
        console::tell(&format!("warning: {warning}"));
    }
    let workload = Workload::survey(&sweep, &plan, None, &held);

    let dimensions = sweep.grid.dimensions();
    let axes: Vec<String> = dimensions.iter().map(|axis| format!("{} {}", axis.values.len(), axis.name)).collect();
    let state = match () {
        () if collection.is_empty() => "no results yet",
        () if had_other_sweep(&directory, &sweep) => "last run with another sweep file",
        () => "has results",
    };
    let mut text = String::new();
    let mut line = |name: &str, words: String| {
        writeln!(text, "{name:<10} {words}").expect("writing to memory does not fail");
    };
    line("sweep", format!("{} ({})", sweep.title, shown(&arguments.sweep)));
    line("directory", format!("{} ({state})", shown(&directory)));
    line("cases", format!("{} = {}", plan.cases(), axes.join(" x ")));
    let chains = count(plan.chain_count() as u64, "chain");
    let once = match sweep.grid {
        Grid::Dimensionless(_) => "elastic ones are solved once for all alpha",
        Grid::Laboratory(_) => "those with the same f, alpha and beta are solved once",
    };
    line("problems", format!("{} distinct, in {chains}; {once}", plan.problems()));
    let (reused, new, failed) = (workload.converged, workload.new, workload.failed);
    let stale = match workload.stale() {
        0 => String::new(),
        stale => format!(", {stale} stale"),
    };
    line("state", format!("{reused} reused, {new} new{stale}, {failed} failed before"));
    for (why, cases) in &workload.stale {
        line("stale", format!("{cases}: {why}"));
    }
    if workload.others > 0 {
        line("others", format!("{} stored have no place in this sweep; they stay", count(workload.others, "case")));
    }
    if workload.to_do() == 0 {
        line("to do", "nothing to solve".to_owned());
        console::print(&text)?;
        return Ok(Exit::Success);
    }
    let pending = workload.pending.len() as u64;
    let to_do = workload.to_do();
    let seeding = match workload.solved - to_do {
        0 => String::new(),
        others => format!("; {others} of the reused cases are solved again to seed them"),
    };
    line("to do", format!("{} in {}{seeding}", count(to_do, "case"), count(pending, "chain")));
    line("time", expected_time(&sweep, &plan, &workload, &held, arguments));
    let size = Size::of(&sweep, &plan, to_do, pending);
    line("disk", format!("about {} to store, {} published", bytes(size.stored), bytes(size.published)));
    console::print(&text)?;
    Ok(Exit::Success)
}

fn expected_time(sweep: &Sweep, plan: &Plan, workload: &Workload, held: &Held<'_>, arguments: &Arguments) -> String {
    let threads = threads::number(arguments.threads).get();
    let per_case = CaseSeconds::expected(sweep, plan, workload, held);
    let busy = threads.min(workload.pending.len());
    let seconds = per_case.seconds() * workload.solved as f64 / busy as f64;
    let source = match per_case {
        CaseSeconds::Logged(_) => "the mean of what the log has",
        CaseSeconds::Estimated(_) => "estimated on this machine",
    };
    format!(
        "about {} on {}; {} per case, {source}",
        duration(seconds),
        count(threads as u64, "thread"),
        duration(per_case.seconds())
    )
}
