//! `stribeck fit`: quantities of the laboratory from measured friction.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::curve::laboratory;
use super::fitted_friction::FittedFriction;
use super::measured::{self, ColumnArguments};
use super::{CliError, Exit, console};
use crate::pictures::{Chart, Format};
use stribeck_lab::{Experiment, FrictionFit, FrictionTask, Measured, Unknown};
use stribeck_sweep::campaign::read_sweep;
use stribeck_sweep::store::write_whole;
use stribeck_sweep::{LaboratoryAxes, Method};

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck fit points.csv sweeps/rubber.toml --unknown relaxed_modulus,retardation_time
  stribeck fit points.csv sweeps/rubber.toml --unknown f,viscosity -o fit      pictures and tables in fit/
  stribeck fit points.csv sweeps/rubber.toml --unknown viscosity --json

The points are a CSV with mu, where it was measured (speed, load, …), and its standard error `error` if that is known.
The sweep file's [laboratory] has all else, and the value that each unknown begins at. docs/laboratory.md tells how it
works and what the errors mean.")]
pub struct Arguments {
    /// The measured points: one table or several
    #[arg(value_name = "DATA", required = true, num_args = 1..)]
    data: Vec<PathBuf>,
    /// The sweep file, with [laboratory]; the last one
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// What is looked for: f and names of [laboratory]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', required = true, value_parser = unknown)]
    unknown: Vec<Unknown>,
    #[command(flatten)]
    columns: ColumnArguments,
    /// Write pictures and a table to this directory
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Format of the pictures
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn unknown(name: &str) -> Result<Unknown, String> {
    Unknown::named(name.trim()).ok_or_else(|| {
        let known: Vec<&str> = Unknown::all().map(Unknown::name).collect();
        format!("give some of {}", known.join(", "))
    })
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let sweep = read_sweep(&arguments.sweep)?;
    let refuse = |what: String| CliError::NoFit { files: arguments.data.clone(), what };
    let parts = arguments.data.iter().map(|path| measured::read(path, &arguments.columns));
    let measured = Measured::join(parts.collect::<Result<Vec<_>, _>>()?).map_err(refuse)?;
    if let Some(name) = repeated(&arguments.unknown) {
        return Err(refuse(format!("--unknown has {name} twice")));
    }
    if sweep.solver.method != Method::Collocation {
        let what = "a fit needs sensitivities, which the collocation method alone has; write method = \
                    \"collocation\" in [solver]";
        return Err(refuse(what.to_owned()));
    }
    let axes = laboratory(&sweep, &arguments.sweep)?;
    if !axes.roller.is_rigid() {
        let what = "a fit needs sensitivities, which are those of a rigid roller; [roller] is soft";
        return Err(refuse(what.to_owned()));
    }
    let task = FrictionTask {
        measured: &measured,
        experiment: beginning(axes, &measured, &arguments.unknown).map_err(refuse)?,
        substrate: &sweep.substrate,
        cavity_shear: sweep.output.cavity_shear,
        unknowns: arguments.unknown.clone(),
        tolerance: sweep.solver.tolerance,
    };
    let fit = FrictionFit::new(&task).map_err(|error| refuse(error.to_string()))?;
    let fitted = FittedFriction { fit: &fit, measured: &measured };
    let directory = arguments.output.as_deref();
    if let Some(directory) = directory {
        write(&fitted, directory, arguments.format)?;
    }
    console::print(&if arguments.json { fitted.json() } else { fitted.text(directory) })?;
    Ok(Exit::Success)
}

/// The name of an unknown that stands there twice.
fn repeated(unknowns: &[Unknown]) -> Option<&'static str> {
    let (_, again) = unknowns.iter().enumerate().find(|(place, unknown)| unknowns[..*place].contains(unknown))?;
    Some(again.name())
}

/// Writes a table and two pictures.
fn write(fitted: &FittedFriction<'_>, directory: &Path, format: Format) -> Result<(), CliError> {
    fs::create_dir_all(directory).map_err(|source| CliError::Directory {
        action: "make",
        path: directory.to_owned(),
        source,
    })?;
    write_whole(directory.join("fit.csv"), &fitted.table().csv())?;
    for (name, chart) in [("friction", fitted.friction_chart()), ("residuals", fitted.residual_chart())] {
        let bytes = Chart::Lines(chart).paint(format)?;
        write_whole(directory.join(format!("{name}.{}", format.extension())), &bytes)?;
    }
    Ok(())
}

/// The experiment of the sweep file, where what is neither measured nor looked for has one value.
fn beginning(axes: &LaboratoryAxes, measured: &Measured, unknowns: &[Unknown]) -> Result<Experiment, String> {
    let given = axes.given.iter().map(|given| (given.quantity.name(), given.values.len()));
    for (name, values) in given.chain([("f", axes.f.len())]) {
        if values > 1 && unknowns.iter().any(|unknown| unknown.name() == name) {
            return Err(format!(
                "{name} has {values} values in the sweep file; give it the one that the search begins at"
            ));
        }
        if values > 1 && measured.coordinate(name).is_none() {
            return Err(format!("{name} has {values} values in the sweep file and is no column here; give it one"));
        }
    }
    Ok(axes.experiment([0, 0, 0].into()))
}
