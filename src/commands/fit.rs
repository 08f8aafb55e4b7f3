//! `stribeck fit`: quantities of the laboratory from measured friction.

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;

use super::curve::laboratory;
use super::fit_progress::{time_limit, watched};
use super::fitted_curves::FittedCurves;
use super::fitted_friction::{FittedFriction, LAST_COLUMNS};
use super::measured::{self, ColumnArguments};
use super::number::number;
use super::output_file::{OutputFile, OutputFiles, or_empty};
use super::paper::PaperArguments;
use super::{CliError, Exit, console};
use crate::fit_beginning::searched;
use crate::pictures::{Chart, Format, is_picture};
use stribeck_input::nearest;
use stribeck_lab::{Bounds, FittedCurve, FrictionFit, FrictionFitError, LaboratoryQuantity, Measured, Unknown};
use stribeck_sweep::campaign::read_sweep;
use stribeck_sweep::store::create_directory;
use stribeck_sweep::{friction_task, points_to_fit};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck fit docs/how-to/instrument-files/traction.txt docs/how-to/instrument-files/experiment.toml \\
      --unknown viscosity
  stribeck fit docs/how-to/instrument-files/traction.txt docs/how-to/instrument-files/experiment.toml \\
      --unknown viscosity,retardation_time --bounds viscosity=0.01:1 -o fit
  stribeck fit docs/how-to/instrument-files/traction.txt docs/how-to/instrument-files/experiment.toml \\
      --unknown viscosity --time-limit 5m --json",
    after_help = "\
The points are one table or several, with mu, where it was measured (speed, load, …), and its standard error `error` if
that is known: CSV, exports of instruments, .xlsx. What was understood of them is printed first. The sweep file's
[laboratory] has all else, and the value that each unknown begins at. docs/how-to/fit.md tells how it works
and what the errors mean."
)]
pub struct Arguments {
    /// The measured points, one table or several, and last the sweep file, with [laboratory]
    #[arg(value_name = "DATA… SWEEP", required = true, num_args = 1..)]
    files: Vec<PathBuf>,
    /// What is looked for: f, names of [laboratory], and keys of [roller] as in roller.retardation_time
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', required = true, value_parser = unknown)]
    unknown: Vec<Unknown>,
    /// Where unknowns must stay, in SI units, as in f=0:100; either end may be left out
    #[arg(long, value_name = "NAME=LO:HI,…", value_delimiter = ',', value_parser = bounds)]
    bounds: Vec<Bounds>,
    /// Begin at the best of thousands of values between the bounds, or up to a thousand times off, by the built-in surface:
    /// for one retardation time and a rigid roller that slides
    #[arg(long)]
    search: bool,
    /// End the search after this time, as in 10m or 90s, with the best values so far and exit code 5
    #[arg(long, value_name = "TIME", value_parser = time_limit)]
    time_limit: Option<Duration>,
    /// Find intervals from the profile of the residuals, too: more fits, for errors that differ on both sides
    #[arg(long)]
    profile: bool,
    #[command(flatten)]
    columns: ColumnArguments,
    /// Write pictures and a table to this directory
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Format of the pictures
    #[arg(long, value_enum, default_value_t, requires = "output")]
    format: Format,
    #[command(flatten)]
    paper: PaperArguments,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn unknown(name: &str) -> Result<Unknown, String> {
    Unknown::named(name.trim()).ok_or_else(|| {
        let known: Vec<&str> = Unknown::all().map(Unknown::name).collect();
        let meant = match name.trim().to_lowercase().as_str() {
            "modulus" | "young_modulus" | "e" => Some("relaxed_modulus"),
            name => nearest(name, &known),
        };
        let meant = meant.map_or_else(String::new, |meant| format!("did you mean {meant}? "));
        format!("{meant}give some of {}", known.join(", "))
    })
}

/// The bounds of an unknown.
fn bounds(text: &str) -> Result<Bounds, String> {
    let (name, (least, most)) = text
        .split_once('=')
        .and_then(|(name, ends)| Some((name, ends.split_once(':')?)))
        .ok_or_else(|| "write bounds as in f=0:100, f=0.1: or f=:100".to_owned())?;
    let end = |text: &str| match text.trim() {
        "" => Ok(None),
        text => number(text).map(Some).ok_or_else(|| format!("{text} is no number; bounds are in SI units")),
    };
    Ok(Bounds { unknown: unknown(name)?, least: end(least)?, most: end(most)? })
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let (sweep_file, data) = arguments.files.split_last().expect("one is required");
    // A chart of one plot; before the work begins.
    arguments.paper.paper(&[]).check(1)?;
    arguments.paper.check_drawn(arguments.output.is_some(), "add -o DIR")?;
    let sweep = read_sweep(sweep_file)?;
    if data.is_empty() {
        let what = "there are no measured points; name their files before the sweep file".to_owned();
        return Err(CliError::NoFit { files: vec![sweep_file.clone()], what });
    }
    let refuse = |what: String| CliError::NoFit { files: data.to_vec(), what };
    let is_unknown = arguments.unknown.iter().any(|unknown| unknown.name() == LaboratoryQuantity::Radius.name());
    let radius = sweep.grid.radius().filter(|_| !is_unknown);
    let columns = arguments.columns.choices();
    let parts = data.iter().map(|path| measured::read(path, &columns, radius));
    let measured = Measured::join(parts.collect::<Result<Vec<_>, _>>()?).map_err(refuse)?;
    let measured = points_to_fit(measured, &arguments.unknown);
    laboratory(&sweep, sweep_file)?;
    measured::note_units(&measured, &sweep.grid.dimensions());
    let mut task = friction_task(&sweep, &measured, &arguments.unknown, &arguments.bounds).map_err(refuse)?;
    measured::note_temperatures(&measured, task.experiment.temperature.is_some());
    if arguments.search {
        task.experiment = searched(&task).map_err(refuse)?;
        let values = task.unknowns.iter().map(|it| format!("{} = {:.3e}", it.name(), it.value(&task.experiment)));
        console::tell(&format!("begins at {}", values.collect::<Vec<_>>().join(", ")));
    }
    let directory = arguments.output.as_deref();
    let outputs = directory.map(|directory| outputs(arguments, directory)).transpose()?;
    let (fit, intervals) = watched(&arguments.unknown, arguments.time_limit, |watch| {
        let fit = FrictionFit::watched(&task, watch)?;
        let wanted = arguments.profile && fit.is_minimum;
        match wanted.then(|| fit.intervals(&task, watch)).transpose() {
            Err(FrictionFitError::TimeLimit) => Ok((fit, None)),
            intervals => Ok((fit, intervals?)),
        }
    })
    .map_err(|error: FrictionFitError| match error {
        FrictionFitError::TimeLimit => CliError::TimeIsUp,
        error => refuse(error.to_string()),
    })?;
    let fitted = FittedFriction { fit: &fit, measured: &measured, intervals: intervals.as_deref() };
    let lacks_intervals = arguments.profile && intervals.is_none();
    if let Some(outputs) = outputs {
        write(&fitted, &fit.curves(&task), outputs, arguments)?;
    }
    console::print(&if arguments.json { fitted.json() } else { fitted.text(directory) })?;
    if !fit.is_minimum {
        console::tell(
            "note: the time was up: these are the best values so far, no minimum; begin there, or give more time",
        );
    } else if lacks_intervals {
        console::tell("note: the time was up before all intervals were found: give more time");
    }
    Ok(if fit.is_minimum && !lacks_intervals { Exit::Success } else { Exit::TimeIsUp })
}

/// The files of the table and of the two pictures, before the work begins.
fn outputs(arguments: &Arguments, directory: &Path) -> Result<[OutputFile; 3], CliError> {
    let files = OutputFiles::new("fit", arguments.files.iter().map(PathBuf::as_path));
    let picture = |name: &str| {
        let name = format!("{name}.{}", arguments.format.extension());
        files.check(&directory.join(name), or_empty(is_picture))
    };
    let is_table = |beginning: &[u8]| {
        let header = beginning.split(|byte| *byte == b'\n').next().unwrap_or_default();
        header.ends_with(LAST_COLUMNS.join(",").as_bytes())
    };
    let outputs =
        [files.check(&directory.join("fit.csv"), or_empty(is_table))?, picture("friction")?, picture("residuals")?];
    create_directory(directory)?;
    Ok(outputs)
}

/// Writes a table and two pictures.
fn write(
    fitted: &FittedFriction<'_>,
    curves: &[FittedCurve],
    [table, friction, residuals]: [OutputFile; 3],
    arguments: &Arguments,
) -> Result<(), CliError> {
    table.write(&fitted.table().csv())?;
    let paper = arguments.paper.paper(&[]);
    let curves = FittedCurves { fitted, curves };
    for (file, chart) in [(friction, curves.friction_chart()), (residuals, curves.residual_chart())] {
        let mut chart = Chart::Lines(chart);
        arguments.paper.entitle(&mut chart);
        file.write(&chart.paint(arguments.format, &paper)?)?;
    }
    Ok(())
}
