//! `stribeck surface`: friction as a function in a file.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use super::destination::destination;
use super::output_file::OutputFiles;
use super::{CliError, Exit, console, threads};
use crate::format::{count, filled};
use stribeck_input::shown;
use stribeck_solver::Interrupt;
use stribeck_surface::{FORMAT, SurfaceFile};
use stribeck_sweep::SurfaceSweep;
use stribeck_sweep::engine::Signals;
use stribeck_sweep::surface::{Progress, SurfaceBuildError, SurfaceOptions, build};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck init --surface -o friction.toml
  stribeck surface friction.toml                        in results/friction
  stribeck surface friction.toml --quiet --threads 8    again: solved cases are used",
    after_help = "\
The sweep file has one to three axes that are ranges, and may have a section [surface] with the tolerance and
the quantities (docs/how-to/surface.md). `stribeck evaluate` reads the surface. Run the same command again after
an interruption: solved cases are used again.
Exit code 3 means that a case failed, or that the surface was written without reaching its tolerance."
)]
pub struct Arguments {
    /// The sweep file, whose axes are ranges
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
    let sweep = SurfaceSweep::read(&arguments.sweep)?;
    let directory = destination(arguments.output.as_deref(), &sweep.sweep.name)?;
    let file = directory.join("surface.json");
    let is_ours = |beginning: &[u8]| String::from_utf8_lossy(beginning).contains(FORMAT);
    OutputFiles::new("surface", [arguments.sweep.as_path()]).check(&file, is_ours)?;
    let interrupt = Arc::new(Interrupt::new());
    let _signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the run", source })?;
    let options = SurfaceOptions { threads: threads::number(arguments.threads), interrupt };
    let quiet = arguments.quiet;
    let made = build(&sweep, &directory, &options, &mut |progress| {
        if !quiet || matches!(progress, Progress::Damaged { .. }) {
            console::tell(&line(&progress));
        }
    });
    let report = match made {
        Err(SurfaceBuildError::Interrupted) => {
            console::tell(&format!("interrupted: what is solved is saved in {}; run it again", shown(&directory)));
            return Ok(Exit::Interrupted);
        }
        made => made?,
    };
    let file = report.surface.file();
    let bytes = std::fs::metadata(&report.file).map_or(0, |metadata| metadata.len());
    let made = format!(
        "{}: {} kB from {} ({} solved now), {:.1} s",
        shown(&report.file),
        bytes.div_ceil(1000),
        count(file.certificate.cases as u64, "case"),
        report.solved,
        start.elapsed().as_secs_f64()
    );
    let mut text = filled(&made, "  ") + "\n" + &certificate(file);
    if !report.holds {
        text += &format!(
            "the largest error is above the tolerance of {:e} where the refinement ended: narrow the \
             ranges, or leave out quantities with kinks (film_min, p_max, x_p_max)\n",
            file.tolerance
        );
    }
    console::print(&text)?;
    Ok(if report.holds { Exit::Success } else { Exit::CasesFailed })
}

fn line(progress: &Progress) -> String {
    match progress {
        Progress::Damaged { what } => format!("warning: {what}"),
        Progress::Round { number, cases, largest } => {
            format!("round {number}: {cases} cases, largest error {largest:.2} tolerances at the points that lead it")
        }
        Progress::Compared { cases, largest } => {
            format!("made from {cases} cases: largest error {largest:.2} tolerances at fresh random points")
        }
    }
}

/// The measured errors of a surface as a table.
pub fn certificate(file: &SurfaceFile) -> String {
    let certificate = &file.certificate;
    let heading = format!(
        "errors at {} random points (seed {}), solved at a tolerance of {:e}; measured, not proved:",
        certificate.points, certificate.seed, certificate.solver_tolerance
    );
    let mut text = filled(&heading, "  ");
    text += &format!("\n{:<16}{:>10}{:>10}{:>10}\n", "quantity", "largest", "99 %", "median");
    for (quantity, errors) in file.quantities.iter().zip(&certificate.errors) {
        let [largest, most, median] =
            [errors.largest, errors.percentile_99, errors.median].map(|it| format!("{it:.1e}"));
        text += &format!("{:<16}{largest:>10}{most:>10}{median:>10}\n", quantity.name);
    }
    text
}
