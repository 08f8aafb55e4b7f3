//! `stribeck explain`: why a case is as it is.

use std::path::{Path, PathBuf};

use clap::Args;

use super::at;
use super::number::number;
use super::shell::quoted;
use super::solution::{describe_experiment, numbers};
use super::trace_report::{describe_seed, describe_trace};
use super::{CliError, Exit, console};
use crate::format::{count, duration, entry as entry_line, filled, utc_timestamp};
use stribeck_input::shown;
use stribeck_solver::{Parameters, shortest};
use stribeck_sweep::Method;
use stribeck_sweep::campaign::{
    CaseName, CasePlace, CaseReport, CaseStorage, Comparison, SolvedAgain, StaleReason, explain, solve_command,
};
use stribeck_sweep::store::{CaseEntry, Origin, Status};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck explain results/quick 100,1,1000             the place nearest to these f, alpha and beta
  stribeck explain results/experiment entrainment_speed=\"0.1 m/s\",slide_roll_ratio=1
  stribeck explain results/quick 100,1,1000 --stored    what is stored only; nothing is solved",
    after_help = "\
A case is also known by its id, in the column `case` of summary.csv.

Shows where a case stands in the sweep, what is stored of it and how it came there. Then its chain is solved again up to
it, on one thread, to show how it was reached: every point on the way with its residuals and estimated errors, and
whether the numbers are still the same. The directory is only read, also while a run works there."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// A case: its id, or its place as F,ALPHA,BETA or as AXIS=VALUE,… with units or in SI units
    #[arg(value_name = "CASE", value_parser = case_name, allow_hyphen_values = true)]
    case: CaseName,
    /// Tell what is stored; solve nothing again
    #[arg(long)]
    stored: bool,
}

fn case_name(text: &str) -> Result<CaseName, String> {
    if let Ok(id) = text.parse() {
        return Ok(CaseName::Id(id));
    }
    if text.contains('=') {
        let axes = at::parse(text)?.0.into_iter().map(|(axis, values)| match values[..] {
            [value] => Ok((axis, value)),
            _ => Err(format!("give one value of {axis}: a case has one of each axis")),
        });
        return axes.collect::<Result<_, _>>().map(CaseName::At);
    }
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    match numbers.as_deref() {
        Some(&[f, alpha, beta]) if [f, alpha, beta].iter().all(|number| *number >= 0.0) => {
            Ok(CaseName::Near([f, alpha, beta]))
        }
        _ => Err("give the id of a case (16 hexadecimal digits, as in the column `case` of summary.csv), or f, alpha \
                  and beta with commas between them, as in 100,1,1000, or values of axes, as in speed=0.01,load=100"
            .to_owned()),
    }
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let report = explain(&arguments.directory, &arguments.case)?;
    for warning in &report.warnings {
        console::tell(&format!("warning: {warning}"));
    }
    let mut text = heading(&report);
    text += &report.place.as_ref().map_or_else(String::new, |place| nearest(&arguments.case, place));
    text += &match &report.place {
        Some(place) => describe_place(place),
        None => "  it has no place in the present sweep.toml, so its f, alpha and beta are not known here\n".to_owned(),
    };
    let slide_roll = report.place.as_ref().map_or(1.0, |place| place.slide_roll);
    text += &match &report.storage {
        CaseStorage::Stored { entry, origin, .. } => describe_stored(entry, origin, slide_roll),
        CaseStorage::Missing { worker, stale } => describe_missing(worker.as_deref(), stale.as_ref()),
    };
    console::print(&text)?;
    if let (CaseStorage::Stored { .. }, Some(place)) = (&report.storage, &report.place) {
        if !arguments.stored
            && let Some(again) = report.solve_again()
        {
            console::print(&describe_solved_again(&again, place, report.sweep.solver.method))?;
        }
        console::print(&how_to_repeat(&report, place, &arguments.directory))?;
    }
    Ok(Exit::Success)
}

fn heading(report: &CaseReport) -> String {
    let id = report.id;
    match &report.storage {
        CaseStorage::Stored { entry, lacks, .. } if !lacks.is_empty() => {
            format!("case {id}: {}, but stored without {}\n", entry.outcome.name(), lacks.join(", "))
        }
        CaseStorage::Stored { entry, .. } => format!("case {id}: {}\n", entry.outcome.name()),
        CaseStorage::Missing { .. } => format!("case {id}: not solved yet\n"),
    }
}

/// That the case is not quite the one that was asked for.
fn nearest(asked: &CaseName, place: &CasePlace) -> String {
    const SAME: f64 = 1e-9;
    let [f, alpha, beta] = ["f", "alpha", "beta"].map(str::to_owned);
    let asked = match asked {
        CaseName::Id(_) => return String::new(),
        CaseName::Near(numbers) => [f, alpha, beta].into_iter().zip(*numbers).collect(),
        CaseName::At(wanted) => wanted.clone(),
    };
    let is_there = |(name, wanted): &(String, f64)| {
        place.coordinate(name).is_some_and(|value| value == *wanted || (value - wanted).abs() <= SAME * wanted.abs())
    };
    if asked.iter().all(is_there) {
        return String::new();
    }
    let words: Vec<String> = asked.iter().map(|(name, value)| format!("{name} = {}", shortest(*value))).collect();
    filled(&format!("  the nearest one to {}, which is no place of the sweep", words.join(", ")), "  ") + "\n"
}

/// Where a case is in the sweep, and in its chain.
fn describe_place(place: &CasePlace) -> String {
    let [f, alpha, beta] = place.numbers.map(shortest);
    let experiment =
        place.experiment.map_or_else(String::new, |experiment| format!("{}\n", describe_experiment(&experiment)));
    let same = match place.parameters.is_relaxed_elastic() {
        true => ", solved once for all places of this beta whose substrate is elastic (f = 0 or alpha = inf)",
        false => "",
    };
    let end = |case: Option<&Parameters>| case.map_or_else(String::new, |case| shortest(case.beta));
    let numbers = filled(&format!("  f = {f}, alpha = {alpha}, beta = {beta}{same}"), "  ");
    let number = format!(
        "  number {} of the {} of its chain, beta from {} to {}",
        place.index + 1,
        place.chain.len(),
        end(place.chain.first()),
        end(place.chain.last()),
    );
    format!("{experiment}{numbers}\n{}\n", filled(&number, "  "))
}

/// What is stored of a case, with its numbers at the slide-to-roll ratio S, and how it came there.
fn describe_stored(entry: &CaseEntry, origin: &Origin, slide_roll: f64) -> String {
    let mut text = "\n".to_owned();
    let mut line = |name: &str, words: &str| text += &entry_line(name, words);
    if entry.outcome == Status::Failed {
        line("reason", &entry.reason);
    }
    line("stored", &format!("{}, row {}, as its record says", shown(&origin.shard), origin.row));
    line("solved", &format!("in start {}, before {}", origin.start, utc_timestamp(origin.time)));
    if !origin.recipe.is_null() {
        line("with", &describe_recipe(&origin.recipe));
    }
    let timing = &entry.timing;
    let seed = match timing.seed {
        Some(seed) => format!("{seed}: {}", describe_seed(seed)),
        None => "one of another version of the program".to_owned(),
    };
    line("seed", &seed);
    let factorisations = match timing.factorisations {
        0 => String::new(),
        number => format!("{}, ", count(number, "factorisation")),
    };
    let iterations = count(timing.iterations, "iteration");
    line("cost", &format!("{iterations}, {factorisations}{}", duration(timing.seconds)));
    if let Some(limit) = timing.time_limit {
        line("time limit", &format!("given up at {} s", shortest(limit)));
    }
    let values = entry.values.at_slide_roll(slide_roll);
    if slide_roll != 1.0 {
        let ratio = shortest(2.0 * slide_roll);
        text += &format!("\nnumbers at the slide-to-roll ratio {ratio} of its first place; others share the film\n");
    }
    text + "\n" + &numbers(&CaseEntry { values, ..entry.clone() }, slide_roll, |units| units)
}

/// What becomes of a case that is not stored, and why one of the same problem is of no use.
fn describe_missing(worker: Option<&str>, stale: Option<&StaleReason>) -> String {
    let next = match worker {
        Some(worker) => format!("a run works here ({worker})"),
        None => "`stribeck run` solves it".to_owned(),
    };
    let stale = stale.map_or_else(String::new, |why| entry_line("stale", &format!("it is stored, but {why}")));
    format!("\n{}{stale}", entry_line("to do", &next))
}

/// The keys and values of a recipe.
fn describe_recipe(recipe: &serde_json::Value) -> String {
    let pairs = recipe.as_object().into_iter().flatten();
    let words = |(key, value): (&String, &serde_json::Value)| {
        let value = value.as_f64().map_or_else(|| value.to_string().replace('"', ""), shortest);
        format!("{key} {value}")
    };
    pairs.map(words).collect::<Vec<_>>().join(", ")
}

/// How a case was reached that was solved again, and whether it is what is stored.
fn describe_solved_again(again: &SolvedAgain, place: &CasePlace, method: Method) -> String {
    let before = match place.index {
        0 => "it is the first of its chain".to_owned(),
        others => format!("after the {others} before it in its chain"),
    };
    let residual = match method {
        Method::Collocation => "step over solution",
        Method::Relaxation => "residual",
    };
    let same = describe_comparison(&again.comparison);
    let again_line = filled(&format!("solved again, {before}: {same}"), "  ");
    format!("\n{again_line}\n{}", describe_trace(&again.case, residual))
}

fn describe_comparison(comparison: &Comparison) -> String {
    match comparison {
        Comparison::ConvergesNow => "it converges now".to_owned(),
        Comparison::FailsNow(failure) => format!("it fails now: {failure}"),
        Comparison::FailsAgain => "it fails again".to_owned(),
        Comparison::SameNumbers => "the same numbers to the last bit".to_owned(),
        Comparison::OtherNumbers(differences) => format!(
            "other numbers than those stored ({} of themselves), as after an extension of the sweep, where it had \
             another chain, or on another machine",
            differences.map(|(column, difference)| format!("{} by {difference:.0e}", column.name())).join(", ")
        ),
    }
}

/// The commands that solve the case again.
fn how_to_repeat(report: &CaseReport, place: &CasePlace, directory: &Path) -> String {
    let mut alone = solve_command(report.plan.recipe(), &place.parameters);
    // With modes of the roller the command has a ratio already.
    if place.slide_roll != 1.0 && place.parameters.substrate.of_roller() == 0 {
        alone += &format!(" --slide-roll {}", shortest(place.slide_roll));
    }
    let (directory, id) = (quoted(directory.as_os_str()), report.id);
    format!("\nto solve it again\n  alone          {alone}\n  in its chain   stribeck explain {directory} {id}\n")
}
