//! `stribeck evaluate`: the numbers of a surface at points, and a check of it.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use serde_json::{Map, Value, json};

use super::at::{self, At};
use super::evaluate_points::{self, PointFiles};
use super::{CliError, Exit, console, number, threads};
use crate::universe::universe;
use stribeck_input::shown;
use stribeck_solver::{Interrupt, shortest};
use stribeck_surface::Surface;
use stribeck_sweep::SurfaceSweep;
use stribeck_sweep::engine::Signals;
use stribeck_sweep::surface::{SurfaceBuildError, SurfaceOptions, compare_surface};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck evaluate --alpha 1 --beta 100 --f 100          of the surface that is built in
  stribeck evaluate results/friction/surface.json --alpha 1 --beta 100
  stribeck evaluate results/friction/surface.json --at alpha=1 --at beta=100 --derivatives
  stribeck evaluate results/friction/surface.json --points sweeps/points.csv -o values.csv
  stribeck evaluate results/friction/surface.json --check 1000 --seed 7",
    after_help = "\
A file of points is a CSV with a column for each axis; the output has its columns, the quantities, and `status`:
`inside` or `outside`. Values of the laboratory are in SI units. Nothing is extrapolated. The surface that is built in
is of materials with one retardation mode under a sliding roller: alpha 0 to inf, beta 1 to 1e8, f 0 to 1e4.
Exit codes: 1 the check found an error above the tolerance; 2 bad input; 3 points lie outside."
)]
pub struct Arguments {
    /// The surface, as `stribeck surface` makes it [default: the one that is built in]
    surface: Option<PathBuf>,
    /// α of the point
    #[arg(long, value_name = "A", value_parser = number::parse, allow_negative_numbers = true)]
    alpha: Option<f64>,
    /// β of the point
    #[arg(long, value_name = "B", value_parser = number::parse, allow_negative_numbers = true)]
    beta: Option<f64>,
    /// f of the point
    #[arg(long, value_name = "F", value_parser = number::parse, allow_negative_numbers = true)]
    f: Option<f64>,
    /// Coordinates of the point, as in speed=0.01 or speed="10 mm/s"
    #[arg(long, value_name = "AXIS=V", value_parser = at::parse)]
    at: Vec<At>,
    /// Also the derivatives with respect to the axes
    #[arg(long)]
    derivatives: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Evaluate at the points of a CSV file
    #[arg(long, value_name = "FILE", group = "many", conflicts_with_all = ["alpha", "beta", "f", "at", "derivatives", "json", "check"])]
    points: Option<PathBuf>,
    /// Where the values of the points go [default: standard output]
    #[arg(short, long, value_name = "FILE", requires = "points")]
    output: Option<PathBuf>,
    /// Solve so many fresh random points and compare
    #[arg(long, value_name = "N", group = "many", conflicts_with_all = ["alpha", "beta", "f", "at", "derivatives", "json"])]
    check: Option<NonZeroUsize>,
    /// Seed of the random points
    #[arg(long, value_name = "S", default_value_t = 2, requires = "check")]
    seed: u64,
    /// Threads of the check or of a file of points [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse, requires = "many")]
    threads: Option<NonZeroUsize>,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let surface = match &arguments.surface {
        Some(file) => Surface::read(file).map_err(|source| CliError::Surface { file: file.clone(), source })?,
        None => universe(),
    };
    match (arguments.check, &arguments.points) {
        (Some(points), _) => check(arguments, &surface, points.get()),
        (None, Some(points)) => {
            let files =
                PointFiles { surface: arguments.surface.as_deref(), points, output: arguments.output.as_deref() };
            evaluate_points::evaluate(&surface, &files, threads::number(arguments.threads))
        }
        (None, None) => evaluate_point(arguments, &surface),
    }
}

/// One point, to the terminal.
fn evaluate_point(arguments: &Arguments, surface: &Surface) -> Result<Exit, CliError> {
    let point = point(arguments, surface)?;
    let mut evaluator = surface.evaluator();
    let (values, derivatives) = evaluator.derivatives(&point)?;
    let records = surface.file().quantities.iter().zip(&surface.file().certificate.errors);
    let rows = records.zip(values.iter().zip(derivatives.chunks(point.len())));
    let axes = surface.axes();
    if arguments.json {
        let mut all = Map::new();
        for ((record, errors), (value, slopes)) in rows {
            let mut entry = json!({"value": value, "units": record.units, "largest_error": errors.largest});
            if let Some(scale) = &record.scale {
                entry["scale"] = json!(scale);
            }
            if arguments.derivatives {
                let slopes = axes.iter().zip(slopes).map(|(axis, slope)| (axis.name.clone(), json!(slope)));
                entry["derivatives"] = Value::Object(slopes.collect());
            }
            all.insert(record.name.clone(), entry);
        }
        console::print(&format!("{}\n", Value::Object(all)))?;
        return Ok(Exit::Success);
    }
    let places = axes.iter().zip(&point).map(|(axis, x)| format!("{} = {}", axis.name, shortest(*x)));
    let mut text = format!("{}\n{}\n", surface.file().title, places.collect::<Vec<_>>().join(", "));
    for ((record, errors), (value, slopes)) in rows {
        let unit = record.scale.as_deref().unwrap_or(&record.units);
        let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
        text += &format!("{:<12} {value:.6e}{unit}   largest error measured {:.0e}\n", record.name, errors.largest);
        if arguments.derivatives {
            for (axis, slope) in axes.iter().zip(slopes) {
                text += &format!("  d/d{:<9} {slope:.6e}\n", axis.name);
            }
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

/// The point that the options name.
fn point(arguments: &Arguments, surface: &Surface) -> Result<Vec<f64>, CliError> {
    let named = [("alpha", arguments.alpha), ("beta", arguments.beta), ("f", arguments.f)];
    let mut given: Vec<(String, f64)> =
        named.into_iter().filter_map(|(name, value)| Some((name.to_owned(), value?))).collect();
    for (axis, values) in at::all(&arguments.at) {
        let [value] = values[..] else { return Err(CliError::SeveralAsked { of: "a point", axis }) };
        given.push((axis, value));
    }
    let names: Vec<&str> = surface.axes().iter().map(|axis| axis.name.as_str()).collect();
    for (name, value) in given.iter().filter(|(name, _)| !names.contains(&name.as_str())) {
        check_fixed(surface, name, *value)?;
    }
    let value = |name: &&str| {
        let found = given.iter().find(|(given, _)| given == name);
        found.map(|(_, value)| *value).ok_or_else(|| CliError::NoCoordinate { axis: (*name).to_owned() })
    };
    names.iter().map(value).collect()
}

/// Checks that a coordinate that is no axis has the one value that the surface was made for.
fn check_fixed(surface: &Surface, name: &str, value: f64) -> Result<(), CliError> {
    let sweep = SurfaceSweep::parse("surface", &surface.file().sweep)?;
    let fixed = sweep.sweep.grid.dimensions().into_iter().find(|it| it.name == name && it.values.len() == 1);
    let Some(fixed) = fixed else {
        let names: Vec<&str> = surface.axes().iter().map(|axis| axis.name.as_str()).collect();
        return Err(CliError::NotAnAxis { axis: name.to_owned(), known: names.join(", ") });
    };
    match fixed.values[0] == value {
        true => Ok(()),
        false => Err(CliError::OtherValue { axis: name.to_owned(), made_for: fixed.values[0] }),
    }
}

/// Compares a surface with fresh solutions.
fn check(arguments: &Arguments, surface: &Surface, points: usize) -> Result<Exit, CliError> {
    let sweep = SurfaceSweep::parse("surface", &surface.file().sweep)?;
    let interrupt = Arc::new(Interrupt::new());
    let _signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the run", source })?;
    let options = SurfaceOptions { threads: threads::number(arguments.threads), interrupt };
    let errors = match compare_surface(&sweep, surface, points, arguments.seed, &options) {
        Err(SurfaceBuildError::Interrupted) => return Ok(Exit::Interrupted),
        errors => errors?,
    };
    let mut file = surface.file().clone();
    let tolerance = file.tolerance;
    file.certificate.points = points;
    file.certificate.seed = arguments.seed;
    file.certificate.solver_tolerance = sweep.sweep.solver.tolerance;
    file.certificate.errors = errors;
    let mut text = super::surface::certificate(&file);
    let holds = file.certificate.errors.iter().all(|errors| errors.largest <= tolerance);
    let shown =
        arguments.surface.as_ref().map_or_else(|| "the built-in surface".to_owned(), |file| shown(file).to_string());
    text += &match holds {
        true => format!("{shown}: holds, no error is above the tolerance of {tolerance:e}\n"),
        false => format!("{shown}: DOES NOT HOLD, an error is above the tolerance of {tolerance:e}\n"),
    };
    console::print(&text)?;
    Ok(if holds { Exit::Success } else { Exit::DoesNotHold })
}
