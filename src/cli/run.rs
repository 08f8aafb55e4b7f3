//! `stribeck run`: plans, resumes what is there, solves, publishes.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use super::destination::{destination, had_other_sweep};
use super::entry::{case_entry, panicked};
use super::solver::Solver;
use super::wording::{count, duration};
use super::workload::Workload;
use super::{CliError, Exit, console, failures, shell, threads};
use crate::continuation::Interrupt;
use crate::engine::{Engine, Finished, Progress, ProgressStyle, Report, Signals, rate};
use crate::model::{Output, Parameters};
use crate::shown::shown;
use crate::store::{Ending, Publication, Published, Store, StoreError};
use crate::sweep::{MAX_CHAIN, Plan, Sweep};

/// Failed cases that are listed at the end of a run.
const LISTED_FAILURES: usize = 5;

/// Finished chains that may wait to be written, for each thread: some tenths of a second where chains are quick.
const WAITING_CHAINS: usize = 8;

/// Values of fields that may wait to be written: 32 MB.
const WAITING_FIELD_VALUES: usize = 1 << 22;

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck run sweeps/quick.toml                        results in results/quick
  stribeck run sweeps/quick.toml -o /scratch/quick --threads 8
  stribeck run my.toml --quiet 2> run.log               messages only, no progress

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
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let start = Instant::now();
    let sweep = Sweep::read(&arguments.sweep)?;
    let plan = Plan::new(&sweep);
    let directory = destination(arguments.output.as_deref(), &sweep)?;
    let threads = threads::number(arguments.threads);
    let engine = Engine::new(threads)?.with_queue(queue_length(threads.get(), &sweep.output));
    let interrupt = Arc::new(Interrupt::new());
    let signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the run", source })?;

    let other_sweep = had_other_sweep(&directory, &sweep);
    let recipe = serde_json::to_value(plan.recipe()).expect("a recipe is made of words and finite numbers");
    let mut store = Store::open(&directory, &sweep.text, &sweep.output)?.solving_with(recipe);
    for warning in store.warnings() {
        console::tell(&format!("warning: {warning}"));
    }
    let workload = Workload::survey(&sweep, &plan, Some(&store));
    if other_sweep {
        console::tell(&about_other_sweep(&directory, &workload));
    }
    let job =
        Job { sweep: &sweep, plan: &plan, workload: &workload, engine: &engine, interrupt: &interrupt, arguments };
    match job.solve_and_publish(&mut store) {
        Ok(Some(published)) => {
            let seconds = start.elapsed().as_secs_f64();
            console::print(&summary(&plan, &store, &workload, &published, &directory, seconds)?)?;
            Ok(if published.failed == 0 { Exit::Success } else { Exit::CasesFailed })
        }
        Ok(None) => {
            let signal = signals.received().map_or_else(String::new, |signal| format!(" by {signal}"));
            console::tell(&format!("interrupted{signal}: {}", how_to_resume(&sweep, &plan, &store, &directory)));
            Ok(Exit::Interrupted)
        }
        Err(CliError::Store(source)) => {
            let progress = how_to_resume(&sweep, &plan, &store, &directory);
            Err(CliError::Stopped { source, progress })
        }
        Err(error) => Err(error),
    }
}

/// What a run has to do, and with what.
struct Job<'a> {
    sweep: &'a Sweep,
    plan: &'a Plan,
    workload: &'a Workload,
    engine: &'a Engine,
    interrupt: &'a Interrupt,
    arguments: &'a Arguments,
}

impl Job<'_> {
    /// Solves what is pending and publishes; `None` if the user stopped it before.
    fn solve_and_publish(&self, store: &mut Store) -> Result<Option<Published>, CliError> {
        if !self.workload.pending.is_empty() {
            if self.solve(store)?.interrupted {
                store.end(Ending::Interrupted)?;
                return Ok(None);
            }
            store.end(Ending::Completed)?;
        }
        Ok(Some(publish(self.sweep, self.plan, store)?))
    }

    /// Solves the pending chains and commits them soon after they finish.
    fn solve(&self, store: &mut Store) -> Result<Report, CliError> {
        let Self { sweep, plan, workload, engine, interrupt, arguments } = *self;
        store.begin(workload.to_do(), threads::number(arguments.threads).get() as u64)?;
        let solver = Solver::new(&sweep.solver);
        let output = &sweep.output;
        let cases = |&index: &u32| -> Vec<Parameters> {
            let chain = plan.parameters(&plan.chain(index as usize));
            workload.places(plan, index).into_iter().map(|place| chain[place].clone()).collect()
        };
        let progress = Progress::start(workload.to_do(), "cases", ProgressStyle::detect(arguments.quiet))
            .map_err(|source| CliError::System { action: "start the thread that shows progress", source })?;
        let report = engine.run(
            &workload.pending,
            interrupt,
            |index, interrupt| solver.solve_chain(&cases(index), output, interrupt),
            |index, message| panicked(&cases(index), output, message),
            |group| -> Result<(), StoreError> {
                let mut entries = Vec::new();
                for Finished { chain: &index, cases: solved, .. } in group {
                    let chain = plan.parameters(&plan.chain(index as usize));
                    for (place, case) in workload.places(plan, index).into_iter().zip(solved) {
                        // Cases that are held seeded the others; they keep the bytes they have.
                        if workload.is_missing(index, place) {
                            progress.count_case(case.outcome.is_ok());
                            entries.push(case_entry(plan, &chain[place], case));
                        }
                    }
                }
                store.commit(&entries)
            },
        )?;
        Ok(report)
    }
}

/// Finished chains that may wait for a slow disk: some for each thread, fewer where their fields would take much memory.
fn queue_length(threads: usize, output: &Output) -> usize {
    let field_values = MAX_CHAIN * output.fields.names().len() * output.x.len();
    (WAITING_CHAINS * threads).min(WAITING_FIELD_VALUES / field_values.max(1))
}

fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    let row = |i_f, i_alpha| (0..sweep.axes.beta.len()).map(|i_beta| plan.case_at(i_f, i_alpha, i_beta)).collect();
    store.publish(&Publication {
        title: &sweep.title,
        sweep_text: &sweep.text,
        f: &sweep.axes.f,
        alpha: &sweep.axes.alpha,
        beta: &sweep.axes.beta,
        cases: &row,
    })
}

fn about_other_sweep(directory: &Path, workload: &Workload) -> String {
    let (reused, new) = (workload.reused(), workload.new);
    let stale: String = workload.stale.iter().map(|(why, cases)| format!(", {cases} stale ({why})")).collect();
    format!(
        "note: {} was last run with another sweep file. Of the {} of this one {reused} are there and used again, {new} \
         are new{stale}. Cases that only the other one has stay stored, but are not published.",
        shown(directory),
        count(reused + workload.to_do(), "case"),
    )
}

fn how_to_resume(sweep: &Sweep, plan: &Plan, store: &Store, directory: &Path) -> String {
    let left = Workload::survey(sweep, plan, Some(store));
    let (saved, place, command) = (count(left.reused(), "case"), shown(directory), shell::own_command());
    let published = match (left.to_do(), directory.join("results.h5").exists()) {
        (0, false) => ", but not published",
        (_, true) => "; what is published there is of an earlier state",
        (_, false) => "",
    };
    format!("{saved} saved in {place}, {} left{published}; resume with\n    {command}", left.to_do())
}

fn summary(
    plan: &Plan,
    store: &Store,
    workload: &Workload,
    published: &Published,
    directory: &Path,
    seconds: f64,
) -> Result<String, CliError> {
    let cases = count(published.converged + published.failed, "case");
    let mut text = format!("{cases}: {} converged, {} failed\n", published.converged, published.failed);
    let written = "writing to memory does not fail";
    match workload.to_do() {
        0 if published.rewritten => text += "nothing to solve; published again\n",
        0 => text += "nothing to do: all of it is solved and published\n",
        solved => {
            let reused = match workload.reused() {
                0 => String::new(),
                reused => format!(" ({reused} more were there already)"),
            };
            let (cases, rate) = (count(solved, "case"), rate(solved as f64 / seconds));
            writeln!(text, "solved {cases}{reused} in {}, {rate}", duration(seconds)).expect(written);
        }
    }
    writeln!(text, "results in {}: results.h5, summary.csv, timings.csv", shown(directory)).expect(written);
    if published.failed > 0 {
        let list = failures::first(plan, store, LISTED_FAILURES)?;
        writeln!(text, "failed cases, the first {}:", list.len()).expect(written);
        for (parameters, reason) in list {
            writeln!(text, "  {}: {reason}", failures::place(&parameters)).expect(written);
        }
        let summary = directory.join("summary.csv");
        writeln!(text, "all of them: {}, columns `status` and `reason`", shown(&summary)).expect(written);
    }
    Ok(text)
}
