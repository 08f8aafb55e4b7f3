//! `stribeck fit`: quantities of the laboratory from measured friction.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};

use super::curve::laboratory;
use super::terminal_plot::{TextAxis, plot};
use super::wording::count;
use super::{CliError, Exit, console};
use crate::pictures::{Chart, Format, Table};
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_input::shown;
use stribeck_lab::Experiment;
use stribeck_lab::Measured;
use stribeck_lab::fit::{Fit, SolverChoice, Task, Unknown, fit};
use stribeck_solver::shortest;
use stribeck_sweep::campaign::read_sweep;
use stribeck_sweep::store::write_whole;
use stribeck_sweep::{LaboratoryAxes, Method};

const IN_MEMORY: &str = "writing to memory does not fail";

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
    /// The measured points (CSV)
    #[arg(value_name = "DATA")]
    data: PathBuf,
    /// The sweep file, with [laboratory]
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// What is looked for: f and names of [laboratory]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', required = true, value_parser = unknown)]
    unknown: Vec<Unknown>,
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
    let measured = Measured::read(&arguments.data)?;
    let refuse = |what: String| CliError::NoFit { file: arguments.data.clone(), what };
    let mut unknowns: Vec<Unknown> = Vec::new();
    for unknown in &arguments.unknown {
        if unknowns.contains(unknown) {
            return Err(refuse(format!("--unknown has {} twice", unknown.name())));
        }
        unknowns.push(*unknown);
    }
    if sweep.solver.method != Method::Collocation {
        return Err(refuse(
            "a fit needs sensitivities, which the collocation method alone has; write method = \"collocation\" in \
                           [solver]"
                .to_owned(),
        ));
    }
    let axes = laboratory(&sweep, &arguments.sweep)?;
    let task = Task {
        measured: &measured,
        experiment: beginning(axes, &measured, &unknowns).map_err(refuse)?,
        substrate: &sweep.substrate,
        cavity_shear: sweep.output.cavity_shear,
        unknowns,
        solver: SolverChoice { tolerance: sweep.solver.tolerance },
    };
    let fit = fit(&task).map_err(|error| refuse(error.to_string()))?;
    if let Some(directory) = &arguments.output {
        write(&fit, &measured, directory, arguments.format)?;
    }
    console::print(&if arguments.json {
        as_json(&fit)
    } else {
        in_words(&fit, &measured, arguments.output.as_deref())
    })?;
    Ok(Exit::Success)
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

/// Values with errors, correlations, residuals.
fn in_words(fit: &Fit, measured: &Measured, directory: Option<&Path>) -> String {
    let mut text = format!(
        "{} of {}, {} solved {} times\n\n",
        count(fit.points.len() as u64, "point"),
        shown(&measured.path),
        if fit.points.len() == 1 { "it was" } else { "all of them were" },
        fit.evaluations
    );
    let mut line = |cells: [&str; 5]| {
        let [name, value, error, unit, start] = cells;
        writeln!(text, "{name:<22} {value:>13} {error:>13}  {unit:<5} {start:>13}").expect(IN_MEMORY);
    };
    line(["unknown", "value", "std. error", "unit", "start"]);
    for estimate in &fit.estimates {
        let [value, error, start] =
            [estimate.value, estimate.error, estimate.start].map(|number| format!("{number:.5e}"));
        line([estimate.unknown.name(), &value, &error, estimate.unknown.units(), &start]);
    }
    if fit.estimates.len() > 1 {
        text += "\ncorrelations\n";
        for (estimate, row) in fit.estimates.iter().zip(&fit.correlation) {
            let row: Vec<String> = row.iter().map(|number| format!("{number:>8.4}")).collect();
            writeln!(text, "{:<22} {}", estimate.unknown.name(), row.join(" ")).expect(IN_MEMORY);
        }
    }
    let degrees = count(fit.degrees_of_freedom as u64, "degree");
    match measured.errors {
        _ if fit.degrees_of_freedom == 0 => {
            writeln!(text, "\nas many points as unknowns: nothing is left to tell whether the model holds")
        }
        Some(_) => writeln!(
            text,
            "\nreduced chi-squared {:.4} with {degrees} of freedom: near 1 where the given errors are right and the model holds",
            fit.reduced_chi_squared
        ),
        None => writeln!(
            text,
            "\nrelative error of a point {:.3} %, from the residuals with {degrees} of freedom",
            100.0 * fit.reduced_chi_squared.sqrt()
        ),
    }
    .expect(IN_MEMORY);
    let points: Vec<(f64, f64)> = fit.points.iter().map(|point| (point.experiment.speed, point.residual)).collect();
    let (from, to) = points.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), at| (low.min(at.0), high.max(at.0)));
    let (x, y) = (TextAxis { logarithmic: true }, TextAxis { logarithmic: false });
    let drawn = plot(&[(from, 0.0), (to, 0.0)], &points, x, y);
    write!(text, "\nresiduals {} against speed in m/s, logarithmic\n{drawn}\n", residual_words(measured))
        .expect(IN_MEMORY);
    text += "\n[laboratory]\n";
    for estimate in &fit.estimates {
        let unit = if estimate.unknown.units() == "1" { "" } else { estimate.unknown.units() };
        let line = format!("{} = {:e}  # {unit}", estimate.unknown.name(), estimate.value);
        writeln!(text, "{}", line.trim_end_matches("  # ")).expect(IN_MEMORY);
    }
    if let Some(directory) = directory {
        writeln!(text, "\nin {}: fit.csv, and pictures of friction and residuals", shown(directory)).expect(IN_MEMORY);
    }
    text
}

fn residual_words(measured: &Measured) -> &'static str {
    match measured.errors {
        Some(_) => "(fitted − measured)/standard error",
        None => "ln(fitted/measured)",
    }
}

fn as_json(fit: &Fit) -> String {
    let estimates: Vec<Value> = fit
        .estimates
        .iter()
        .map(|it| {
            json!({
                "unknown": it.unknown.name(), "units": it.unknown.units(), "start": it.start, "value": it.value,
                "standard_error": it.error
            })
        })
        .collect();
    let points: Vec<Value> = fit
        .points
        .iter()
        .map(|it| json!({ "line": it.line, "measured": it.measured, "fitted": it.fitted, "residual": it.residual }))
        .collect();
    let whole = json!({
        "estimates": estimates,
        "correlation": fit.correlation,
        "degrees_of_freedom": fit.degrees_of_freedom,
        "reduced_chi_squared": fit.reduced_chi_squared,
        "evaluations": fit.evaluations,
        "points": points,
    });
    serde_json::to_string_pretty(&whole).expect("strings and numbers can be written") + "\n"
}

/// Writes a table and two pictures.
fn write(fit: &Fit, measured: &Measured, directory: &Path, format: Format) -> Result<(), CliError> {
    fs::create_dir_all(directory).map_err(|source| CliError::Directory {
        action: "make",
        path: directory.to_owned(),
        source,
    })?;
    write_whole(directory.join("fit.csv"), &table(fit).csv())?;
    for (name, chart) in [("friction", friction(fit, measured)), ("residuals", residuals(fit, measured))] {
        let bytes = Chart::Lines(chart).paint(format)?;
        write_whole(directory.join(format!("{name}.{}", format.extension())), &bytes)?;
    }
    Ok(())
}

/// Every point with what was fitted there.
fn table(fit: &Fit) -> Table {
    let quantities: Vec<_> = fit.points[0].experiment.given().collect();
    let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name()).collect();
    let mut table = Table::new(
        &[&["line"], &names[..], &["f", "alpha", "beta", "measured", "error", "fitted", "residual"]].concat(),
    );
    for point in &fit.points {
        let given = quantities.iter().map(|quantity| point.experiment.value(*quantity));
        let (alpha, beta) = (point.experiment.alpha(), point.experiment.beta());
        let error = point.error.unwrap_or(f64::NAN);
        let rest = [point.experiment.f, alpha, beta, point.measured, error, point.fitted, point.residual];
        table.row(&[&point.line.to_string()], &given.chain(rest).collect::<Vec<_>>());
    }
    table
}

/// Measured and fitted friction over speed.
fn friction(fit: &Fit, measured: &Measured) -> Lines {
    let mut fitted: Vec<(f64, f64)> = fit.points.iter().map(|point| (point.experiment.speed, point.fitted)).collect();
    fitted.sort_by(|one, other| one.0.total_cmp(&other.0));
    // Points that differ in more than their speed are on no common curve.
    let along_speed = measured.coordinates.iter().all(|(name, _)| *name == "speed");
    let mut curves = vec![if along_speed {
        curve("fitted", fitted, Stroke::Solid, Colour::Kind(0), false)
    } else {
        curve("fitted", fitted, Stroke::Points, Colour::Kind(0), true)
    }];
    for point in &fit.points {
        if let Some(error) = point.error {
            let (x, mu) = (point.experiment.speed, point.measured);
            curves.push(curve("", vec![(x, mu - error), (x, mu + error)], Stroke::Solid, Colour::Black, false));
        }
    }
    let points = fit.points.iter().map(|point| (point.experiment.speed, point.measured)).collect();
    curves.push(curve("measured", points, Stroke::Points, Colour::Black, true));
    let found = fit.estimates.iter().map(|it| {
        let (value, error) = (three(it.value), three(it.error));
        let unit = if it.unknown.units() == "1" { "" } else { it.unknown.units() };
        format!("{} = {value} ± {error} {unit}", it.unknown.name()).trim_end().to_owned()
    });
    chart("friction, measured and fitted", found.collect::<Vec<_>>().join(", "), "friction coefficient μ", curves)
}

/// Residuals over speed.
fn residuals(fit: &Fit, measured: &Measured) -> Lines {
    let points: Vec<(f64, f64)> = fit.points.iter().map(|point| (point.experiment.speed, point.residual)).collect();
    let (from, to) = points.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), at| (low.min(at.0), high.max(at.0)));
    let curves = vec![
        curve("", vec![(from, 0.0), (to, 0.0)], Stroke::Dashed, Colour::Black, false),
        curve("residual", points, Stroke::Points, Colour::Kind(0), true),
    ];
    chart("residuals", String::new(), residual_words(measured), curves)
}

fn curve(label: &str, points: Vec<(f64, f64)>, stroke: Stroke, colour: Colour, marked: bool) -> Curve {
    Curve { label: label.to_owned(), points, failed: vec![], stroke, colour, marked }
}

fn chart(title: &str, subtitle: String, y: &str, curves: Vec<Curve>) -> Lines {
    Lines {
        title: title.to_owned(),
        subtitle,
        x: LineAxis { label: "speed V  (m/s)".to_owned(), logarithmic: true, range: None },
        y: LineAxis { label: y.to_owned(), logarithmic: false, range: None },
        curves,
    }
}

/// A number with three digits.
fn three(value: f64) -> String {
    shortest(format!("{value:.2e}").parse().expect("{:e} writes a number"))
}
