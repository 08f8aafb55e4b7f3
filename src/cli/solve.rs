//! `stribeck solve`: one case to the terminal.

use std::fmt::Write;

use clap::{ArgAction, Args};
use serde::{Serialize, Serializer};
use serde_json::Value;

use super::entry::case_entry;
use super::wording::duration;
use super::{CliError, Exit, console};
use crate::continuation::{Interrupt, solve_chain};
use crate::model::{COLUMNS, FieldSelection, Limits, Output, Parameters, Substrate};
use crate::relaxation::{Acceleration, RelaxationSolver, Settings};
use crate::store::{CaseEntry, Status};
use crate::sweep::{Axes, ESTIMATE_POINTS, Method, Plan, SolverSettings, Sweep};

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck solve --alpha 1 --beta 100 --f 10
  stribeck solve --alpha inf --beta 100 --f 10          relaxed: the elastic case, whatever f is
  stribeck solve --alpha 1 --beta 1000 --f 100 --points 1601 --json | jq .mu_tot

Friction coefficients are over a0/R; docs/output.md has all names and units. With --json the keys are the columns of
summary.csv and seed, iterations, seconds; a number that is not known is null, an infinite alpha is \"inf\".
Exit code 3: the case failed.")]
pub struct Arguments {
    /// Slide time over retardation time, at least 0, or inf
    #[arg(long, value_name = "A", value_parser = alpha, allow_negative_numbers = true)]
    alpha: f64,
    /// Inverse Hersey number, above 0
    #[arg(long, value_name = "B", value_parser = beta, allow_negative_numbers = true)]
    beta: f64,
    /// Strength of retardation E0/Einf - 1, at least 0
    #[arg(long, value_name = "F", value_parser = strength, allow_negative_numbers = true)]
    f: f64,
    /// Method of solution
    #[arg(long, default_value = "relaxation", value_parser = method)]
    method: Method,
    /// Points of the uniform grid, odd, 51 to 20001
    #[arg(long, value_name = "N", default_value_t = Settings::default().points, value_parser = points)]
    points: usize,
    /// Residuals of Reynolds' equation and of the load at which the case is converged
    #[arg(long, value_name = "T", default_value = "1e-8", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: f64,
    /// anderson, or none: the paper's plain iteration
    #[arg(long, default_value = "anderson", value_parser = acceleration)]
    acceleration: Acceleration,
    /// Solve on a second grid too, to estimate errors; from 201 points on [default: true where it can]
    #[arg(long, value_name = "true|false", action = ArgAction::Set)]
    estimate: Option<bool>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn number(text: &str, allowed: &str, is_allowed: impl Fn(f64) -> bool) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number| is_allowed(number));
    // −0 is 0
    number.map(|number: f64| number + 0.0).ok_or_else(|| format!("give {allowed}"))
}

fn alpha(text: &str) -> Result<f64, String> {
    number(text, "a number that is at least 0, or inf", |alpha| alpha >= 0.0)
}

fn beta(text: &str) -> Result<f64, String> {
    let allowed = "a finite number above 0; dry sliding is the limit of large beta";
    number(text, allowed, |beta| beta > 0.0 && beta.is_finite())
}

fn strength(text: &str) -> Result<f64, String> {
    let allowed = "a finite number that is at least 0; 0 is an elastic substrate";
    number(text, allowed, |f| f >= 0.0 && f.is_finite())
}

fn tolerance(text: &str) -> Result<f64, String> {
    number(text, "a number from 1e-12 to 1e-2", |tolerance| Settings::TOLERANCE.contains(&tolerance))
}

fn points(text: &str) -> Result<usize, String> {
    let points = text.parse().ok().filter(|points| Settings::POINTS.contains(points) && points % 2 == 1);
    points.ok_or_else(|| "give an odd whole number from 51 to 20001, such as 401, 801 or 1601".to_owned())
}

fn method(text: &str) -> Result<Method, String> {
    match text {
        "relaxation" => Ok(Method::Relaxation),
        "collocation" => Err("it is not in this version; use relaxation".to_owned()),
        _ => Err("the method of this version is relaxation".to_owned()),
    }
}

fn acceleration(text: &str) -> Result<Acceleration, String> {
    match text {
        "anderson" => Ok(Acceleration::Anderson),
        "none" => Ok(Acceleration::None),
        _ => Err("give anderson or none".to_owned()),
    }
}

impl Arguments {
    /// The case as a sweep, so that it is the same as in a sweep, id included.
    fn sweep(&self) -> Sweep {
        let &Self { points, tolerance, acceleration, .. } = self;
        let estimate = self.estimate.unwrap_or(points >= ESTIMATE_POINTS);
        Sweep {
            title: String::new(),
            axes: Axes { f: vec![self.f], alpha: vec![self.alpha], beta: vec![self.beta] },
            substrate: Substrate::default(),
            solver: SolverSettings {
                method: self.method,
                relaxation: Settings { points, tolerance, acceleration, estimate, ..Settings::default() },
                ..SolverSettings::default()
            },
            output: Output { fields: FieldSelection::default(), ..Output::default() },
            text: String::new(),
            name: String::new(),
        }
    }
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    if arguments.points < ESTIMATE_POINTS {
        match arguments.estimate {
            Some(true) => return Err(CliError::Estimate { points: arguments.points }),
            Some(false) => {}
            None => {
                console::tell(&format!("note: no errors are estimated; that takes {ESTIMATE_POINTS} points or more"))
            }
        }
    }
    let sweep = arguments.sweep();
    let plan = Plan::new(&sweep);
    let parameters = plan.parameters_at(0, 0, 0);
    let solver = match sweep.solver.method {
        Method::Relaxation => RelaxationSolver::new(sweep.solver.relaxation),
    };
    let solved = solve_chain(&solver, std::slice::from_ref(&parameters), &sweep.output, &Interrupt::new());
    let case = solved.expect("no one asks this chain to stop").remove(0);
    let entry = case_entry(plan.id(&parameters), case);
    let text = if arguments.json { json(arguments, &entry) } else { table(arguments, &parameters, &entry) };
    console::print(&text)?;
    Ok(match entry.outcome {
        Status::Converged => Exit::Success,
        Status::Failed => Exit::CasesFailed,
    })
}

/// The value of a column.
fn value(entry: &CaseEntry, name: &str) -> Option<f64> {
    let place = COLUMNS.iter().position(|column| column.name == name)?;
    Some(entry.values[place]).filter(|value| !value.is_nan())
}

/// One row for each quantity, with its error and what large β has in its place.
fn table(arguments: &Arguments, parameters: &Parameters, entry: &CaseEntry) -> String {
    let Arguments { f, alpha, beta, points, .. } = arguments;
    let same = if parameters.is_relaxed_elastic() { " (elastic: depends on beta alone)" } else { "" };
    let mut text = format!("f = {f}, alpha = {alpha}, beta = {beta}{same}: {}\n", entry.outcome.name());
    if entry.outcome == Status::Failed {
        text += &format!("  {}\n", entry.reason);
    }
    let timing = &entry.timing;
    text += &format!(
        "case {}, seed {}, {} passes, {}, {points} points\n\n",
        entry.id,
        timing.seed,
        timing.iterations,
        duration(timing.seconds),
    );
    if entry.outcome == Status::Failed {
        // All else is unknown.
        for column in COLUMNS.iter().filter(|column| Limits::COLUMNS.contains(&column.name)) {
            let limit = value(entry, column.name).map_or_else(|| "-".to_owned(), |value| format!("{value:.6e}"));
            text += &format!("{:<13} {limit:>14}  {:<10}  {}\n", column.name, column.units, column.long_name);
        }
        return text;
    }
    let mut row = |symbol: &str, value: &str, error: &str, limit: &str, unit: &str, name: &str| {
        writeln!(text, "{symbol:<13} {value:>14} {error:>9} {limit:>14}  {unit:<10}  {name}")
            .expect("writing to memory does not fail");
    };
    row("symbol", "value", "error", "large beta", "unit", "name");
    for column in &COLUMNS {
        let limit_of = match column.name {
            "mu_v" => "dry_mu_v",
            "mu_h" => "approx_mu_h",
            name if name.starts_with("error_") || name == "dry_mu_v" || name == "approx_mu_h" => continue,
            _ => "",
        };
        let six = |value: f64| format!("{value:.6e}");
        let error = value(entry, &format!("error_{}", column.name)).map_or_else(String::new, |e| format!("{e:.0e}"));
        let limit = value(entry, limit_of).map_or_else(String::new, six);
        let value = value(entry, column.name).map_or_else(|| "-".to_owned(), six);
        row(column.name, &value, &error, &limit, column.units, column.long_name);
    }
    text += "\nerror: estimated relative error; large beta: friction of dry sliding for mu_v, approximation for mu_h\n";
    text
}

/// An object whose keys stay in their order.
struct Object(Vec<(&'static str, Value)>);

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

fn json(arguments: &Arguments, entry: &CaseEntry) -> String {
    // JSON has no infinity, and `Value::from` makes null of NaN.
    let alpha = if arguments.alpha.is_infinite() { Value::from("inf") } else { Value::from(arguments.alpha) };
    let reason = if entry.reason.is_empty() { Value::Null } else { Value::from(entry.reason.as_str()) };
    let mut pairs = vec![
        ("case", Value::from(entry.id.to_string())),
        ("f", Value::from(arguments.f)),
        ("alpha", alpha),
        ("beta", Value::from(arguments.beta)),
        ("status", Value::from(entry.outcome.name())),
        ("reason", reason),
    ];
    let columns = COLUMNS.iter().zip(entry.values).filter(|(column, _)| column.in_summary);
    pairs.extend(columns.map(|(column, value)| (column.name, Value::from(value))));
    pairs.push(("seed", Value::from(entry.timing.seed.as_str())));
    pairs.push(("iterations", Value::from(entry.timing.iterations)));
    pairs.push(("seconds", Value::from(entry.timing.seconds)));
    serde_json::to_string_pretty(&Object(pairs)).expect("strings and numbers can be written") + "\n"
}
