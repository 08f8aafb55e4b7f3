//! `stribeck run`: plans, resumes what is there, solves, publishes.

use std::fs::File;
use std::io::ErrorKind;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use clap::Args;

use super::destination::destination;
use super::output_file::unwritten;
use super::run_report::{about_fields, about_other_sweep, about_part, about_whole, how_to_resume};
use super::{CliError, Exit, console, threads};
use crate::format::count;
use stribeck_sweep::campaign::{CampaignError, Event, RunOptions, RunOutcome, notes, read_sweep, run};
use stribeck_sweep::engine::{Progress, ProgressStyle, Signals};
use stribeck_sweep::{Extent, Grid, Part};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck run sweeps/quick.toml                        results in results/quick
  stribeck run sweeps/quick.toml -o elsewhere/quick --threads 8
  stribeck run sweeps/gel.toml --quiet 2> gel.log       messages only, no progress
  stribeck run docs/how-to/instrument-files/experiment.toml
  stribeck run sweeps/two-modes.toml -o shared/two-modes --part 1/2
  stribeck run sweeps/two-modes.toml -o shared/two-modes --part 2/2    on another machine",
    after_help = "\
Run the same command again to resume a sweep that was interrupted. If nothing is left to do it says so.
Values can be added to the axes of a sweep: what is solved is used again. Ctrl-C stores what is finished
and ends the run with exit code 130. A second Ctrl-C ends it at once, which loses no stored case either.
`stribeck merge` publishes parts together."
)]
pub struct Arguments {
    /// The sweep file (TOML); docs/reference/sweep-file.md has its keys
    sweep: PathBuf,
    /// Results directory [default: results/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Solver threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse)]
    threads: Option<NonZeroUsize>,
    /// Solve the I-th of N parts only, in DIR/parts; `stribeck merge` publishes them together
    #[arg(long, value_name = "I/N", alias = "shard")]
    part: Option<Part>,
    /// End with 0 also if cases failed, for build systems: what failed is in summary.csv
    #[arg(long)]
    accept_failures: bool,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let start = Instant::now();
    let sweep = read_sweep(&arguments.sweep)?;
    let directory = destination(arguments.output.as_deref(), &sweep.name)?;
    let (threads, part) = (threads::number(arguments.threads), arguments.part);
    let options = RunOptions { threads, part, ..RunOptions::default() };
    let signals = Signals::watch(&options.interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the run", source })?;
    if let Grid::Laboratory(axes) = &sweep.grid
        && let Some(note) = Extent::of(axes).note()
    {
        console::tell(&format!("note: {note}"));
    }
    let fields = about_fields(&sweep).filter(|_| !arguments.quiet);
    let mut display = Display { style: ProgressStyle::detect(arguments.quiet), progress: None, fields };
    let report = run(&sweep, &directory, &options, &mut |event| display.tell(&event));
    drop(display);
    let report = report.map_err(|error| match error {
        CampaignError::Stopped { source, directory, left } => {
            let progress = how_to_resume(&left, &directory, Some(&source));
            CliError::Stopped { source, progress }
        }
        error => error.into(),
    })?;
    let seconds = start.elapsed().as_secs_f64();
    let failed = match &report.outcome {
        RunOutcome::Interrupted { left } => {
            let signal = signals.received().map_or_else(String::new, |signal| format!(" by {signal}"));
            console::tell(&format!("interrupted{signal}: {}", how_to_resume(left, &report.directory, None)));
            return Ok(Exit::Interrupted);
        }
        RunOutcome::Published(published) => {
            if !published.rewritten {
                be_younger(&published.files, &arguments.sweep)?;
            }
            let notes = published.notes.map_or_else(|| notes(&report.directory), Ok)?;
            console::print(&about_whole(&report, published, &notes, seconds))?;
            published.failed
        }
        RunOutcome::PartSolved { part, done } => {
            console::print(&about_part(&report, *part, done, &directory, seconds))?;
            done.failed
        }
    };
    Ok(if failed == 0 || arguments.accept_failures { Exit::Success } else { Exit::CasesFailed })
}

/// Gives published files the present time if the sweep file is younger, though it asks for nothing new: build systems
/// would ask for them again and again.
fn be_younger(published: &[PathBuf], sweep: &Path) -> Result<(), CliError> {
    let time = |path: &Path| path.metadata().and_then(|metadata| metadata.modified()).ok();
    let Some(wanted) = time(sweep) else { return Ok(()) };
    for file in published.iter().filter(|file| time(file).is_some_and(|time| time < wanted)) {
        match File::open(file).and_then(|open| open.set_modified(SystemTime::now())) {
            // Files of somebody else keep their times: they are as they should be all the same.
            Err(error) if error.kind() == ErrorKind::PermissionDenied => {}
            touched => touched.map_err(unwritten(file))?,
        }
    }
    Ok(())
}

/// What a user sees while a sweep runs.
struct Display {
    style: ProgressStyle,
    progress: Option<Progress>,
    /// What is to be said of the fields, if cases are solved.
    fields: Option<String>,
}

impl Display {
    fn tell(&mut self, event: &Event<'_>) {
        match event {
            Event::Damaged(warning) => console::tell(&format!("warning: {warning}")),
            Event::OtherSweep { directory, pending, refinements } => {
                console::tell(&about_other_sweep(directory, pending, refinements));
            }
            Event::TookOver(joined) => {
                console::tell(&format!("note: took over {} that parts of it have solved", count(joined.cases, "case")));
            }
            Event::Solving { cases } => {
                self.fields.take().iter().for_each(|note| console::tell(note));
                match Progress::start(*cases, "cases", self.style) {
                    Ok(progress) => self.progress = Some(progress),
                    // A run that no one can watch is a run all the same.
                    Err(error) => console::tell(&format!("warning: no progress is shown: {error}")),
                }
            }
            Event::Committed { converged, failed } => {
                if let Some(progress) = &self.progress {
                    (0..*converged).for_each(|_| progress.count_case(true));
                    (0..*failed).for_each(|_| progress.count_case(false));
                }
            }
            Event::Publishing => self.progress = None,
        }
    }
}
