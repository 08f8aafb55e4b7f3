//! `stribeck run`: plans, resumes what is there, solves, publishes.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use super::collection::{Collection, Held, part_directory, parts};
use super::destination::{destination, had_other_sweep, read_sweep};
use super::job::{Job, group_wait, publish, queue_length};
use super::merge::join_all;
use super::run_report::{about_other_sweep, how_to_resume, of_part, of_whole};
use super::wording::count;
use super::workload::{Workload, inspection};
use super::{CliError, Exit, console, threads};
use stribeck_solver::continuation::Interrupt;
use stribeck_sweep::engine::{Engine, ProgressStyle, Signals};
use stribeck_sweep::store::{Ending, Holdings, Store};
use stribeck_sweep::{Part, Plan, Sweep};

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck run sweeps/quick.toml                        results in results/quick
  stribeck run sweeps/quick.toml -o /scratch/quick --threads 8
  stribeck run my.toml --quiet 2> run.log               messages only, no progress
  stribeck run my.toml -o /shared/my --shard 3/8        the third of eight parts, for another machine each

Run the same command again to resume a sweep that was interrupted; if nothing is left to do it says so.
Values can be added to the axes of a sweep: what is solved is used again. Ctrl-C stores what is finished
and ends the run with exit code 130; a second Ctrl-C ends it at once, which loses no stored case either.")]
pub struct Arguments {
    /// The sweep file (TOML); docs/sweep-file.md has its keys
    sweep: PathBuf,
    /// Results directory [default: results/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Solver threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse)]
    threads: Option<NonZeroUsize>,
    /// Solve the I-th of N parts only, in DIR/parts; `stribeck merge` publishes them together
    #[arg(long, value_name = "I/N")]
    shard: Option<Part>,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let start = Instant::now();
    let sweep = read_sweep(&arguments.sweep)?;
    let plan = Plan::new(&sweep);
    let directory = destination(arguments.output.as_deref(), &sweep)?;
    let threads = threads::number(arguments.threads);
    let part = arguments.shard;
    let mut engine = Engine::new(threads)?.with_queue(queue_length(threads.get(), part, &sweep.output));
    if let Some(part) = part {
        engine = engine.with_group_wait(group_wait(part));
    }
    let interrupt = Arc::new(Interrupt::new());
    let signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the run", source })?;

    let home = part.map_or_else(|| directory.clone(), |part| part_directory(&directory, part));
    // Before anything is made in it: what a part solves is to be merged there.
    Store::may_take(&directory)?;
    let other_sweep = had_other_sweep(&home, &sweep);
    let mut store = Store::open(&home, &sweep.text, &sweep.output)?.solving_with(recipe(&plan));
    for warning in store.warnings() {
        console::tell(&format!("warning: {warning}"));
    }
    // A part finds cases of the whole and of other splits; those of its own split are other parts' cases. The whole joins
    // what its parts have.
    let mut elsewhere = Collection::default();
    match part {
        Some(part) => {
            let other_split = |other: Part| other.of() != part.of();
            elsewhere = Collection::read_some(&directory, &sweep.output, inspection(false), other_split)?;
        }
        None => join_parts(&directory, &sweep, &mut store)?,
    }
    let elsewhere = elsewhere.all();
    let survey = |store: &Store| Workload::survey(&sweep, &plan, part, &with(store, &elsewhere));
    let workload = survey(&store);
    if other_sweep {
        console::tell(&about_other_sweep(&home, &workload));
    }
    let progress = ProgressStyle::detect(arguments.quiet);
    let job = Job { sweep: &sweep, plan: &plan, workload: &workload, threads, interrupt: &interrupt, progress };
    let ending = job.solve(&engine, &mut store).and_then(|ending| {
        let published = match (ending, part) {
            (Ending::Completed, None) => Some(publish(&sweep, &plan, &mut store)?),
            _ => None,
        };
        Ok((ending, published))
    });
    let seconds = start.elapsed().as_secs_f64();
    match ending {
        Ok((Ending::Interrupted, _)) => {
            let signal = signals.received().map_or_else(String::new, |signal| format!(" by {signal}"));
            console::tell(&format!("interrupted{signal}: {}", how_to_resume(&survey(&store), &home)));
            Ok(Exit::Interrupted)
        }
        Ok((Ending::Completed, Some(published))) => {
            console::print(&of_whole(&plan, &store, &workload, &published, &home, seconds)?)?;
            Ok(if published.failed == 0 { Exit::Success } else { Exit::CasesFailed })
        }
        Ok((Ending::Completed, None)) => {
            let (part, done) = (part.expect("the whole is published"), survey(&store));
            console::print(&of_part(&plan, part, &store, &workload, &done, &directory, seconds)?)?;
            Ok(if done.failed == 0 { Exit::Success } else { Exit::CasesFailed })
        }
        Err(CliError::Store(source)) => {
            Err(CliError::Stopped { source, progress: how_to_resume(&survey(&store), &home) })
        }
        Err(error) => Err(error),
    }
}

/// A store and what is held elsewhere.
fn with<'a>(store: &'a Store, elsewhere: &[&'a Holdings]) -> Held<'a> {
    Held::new(std::iter::once(&**store).chain(elsewhere.iter().copied()).collect())
}

/// What the cases of a plan are solved with, as the store keeps it.
pub fn recipe(plan: &Plan) -> serde_json::Value {
    serde_json::to_value(plan.recipe()).expect("a recipe is made of words and finite numbers")
}

/// Takes over what the parts of a directory have solved.
fn join_parts(directory: &Path, sweep: &Sweep, store: &mut Store) -> Result<(), CliError> {
    let parts: Vec<PathBuf> = parts(directory)?.into_iter().map(|part| part_directory(directory, part)).collect();
    // One that has only just begun holds nothing yet.
    let joined = join_all(parts.iter().filter(|part| part.join("log").is_dir()), sweep, store)?;
    if joined.cases > 0 {
        console::tell(&format!("note: took over {} that parts of it have solved", count(joined.cases, "case")));
    }
    Ok(())
}
