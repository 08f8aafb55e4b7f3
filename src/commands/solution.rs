//! One solved case for people, as a table, and for programs, as JSON.

use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use super::sensitivities;
use crate::format::{Align, count, duration, filled, filled_list, table_line};
use stribeck_lab::{Experiment, si_units};
use stribeck_solver::continuation::{Path, PathPoint, Seed};
use stribeck_solver::{Parameters, Sensitivities, shortest};
use stribeck_sweep::store::{CaseEntry, Status, errors_of_derivatives};
use stribeck_sweep::{Column, Method, SolverSettings};

/// A case as it was asked for, what came of it, and how it was reached.
pub struct SolvedProblem<'a> {
    /// The case as it was asked for; an elastic one keeps the f and α given.
    pub asked: &'a Parameters,
    /// The slide-to-roll ratio S that the numbers belong to.
    pub slide_roll: f64,
    /// How it was to be solved.
    pub settings: &'a SolverSettings,
    /// What came of it.
    pub entry: &'a CaseEntry,
    /// The points that were solved on the way.
    pub path: &'a Path,
    /// Unknowns of its system, or points of its grid; 0 if it failed.
    pub unknowns: usize,
    /// The experiment that it is a case of; then numbers are in SI units.
    pub experiment: Option<Experiment>,
}

/// The unit of a number, by that of dimensionless results.
pub type Units = fn(&'static str) -> &'static str;

/// One row for each quantity of a case, whose values are those at the slide-to-roll ratio S, with its error and its
/// limit for large β; of a failed case the limits.
pub fn numbers(entry: &CaseEntry, slide_roll: f64, units: Units) -> String {
    match entry.outcome {
        Status::Converged => quantities(entry, slide_roll, units),
        Status::Failed => limits(entry, units),
    }
}

fn quantities(entry: &CaseEntry, slide_roll: f64, units: Units) -> String {
    let mut text = String::new();
    let widths = [Align::Left(15), Align::Right(13), Align::Right(8), Align::Right(13), Align::Left(10)];
    text += &table_line(&widths, &["symbol", "value", "error", "large beta", "unit"]);
    let mut names = Vec::new();
    for column in Column::ALL.into_iter().filter(|column| !column.is_error() && !column.is_limit()) {
        let known = |column: Option<Column>| column.and_then(|column| entry.values.known(column));
        let six = |value: f64| format!("{value:.6e}");
        let error = known(column.error()).map_or_else(String::new, |error| format!("{error:.0e}"));
        let limit = known(column.limit()).map_or_else(String::new, six);
        let value = known(Some(column)).map_or_else(|| "-".to_owned(), six);
        text += &table_line(&widths, &[column.name(), &value, &error, &limit, units(column.units())]);
        names.push(format!("{}: {}", column.name(), column.long_name()));
    }
    names.push("error: estimated relative error".to_owned());
    names.push("large beta: friction of dry sliding for mu_v, approximation for mu_h".to_owned());
    text += &format!("\n{}\n", filled(&names.join("; "), ""));
    if let Some(known) = &entry.sensitivities {
        text +=
            &format!("\n{}", sensitivities::table(known, entry.sensitivity_errors.as_ref(), &entry.values, slide_roll));
    }
    text
}

/// What is known of a case that failed.
fn limits(entry: &CaseEntry, units: Units) -> String {
    let mut text = String::new();
    for column in Column::ALL.into_iter().filter(|column| column.is_limit()) {
        let limit = entry.values.known(column).map_or_else(|| "-".to_owned(), |value| format!("{value:.6e}"));
        let widths = [Align::Left(12), Align::Right(13), Align::Left(10), Align::Left(0)];
        text += &table_line(&widths, &[column.name(), &limit, units(column.units()), column.long_name()]);
    }
    text
}

impl SolvedProblem<'_> {
    /// What came of the case, its cost, its path, and one row for each quantity, with its error and what large β has
    /// in its place.
    pub fn table(&self) -> String {
        let (Parameters { f, alpha, beta, .. }, entry) = (self.asked, self.entry);
        let same = if self.asked.is_relaxed_elastic() { " (elastic: depends on beta alone)" } else { "" };
        let rolling = match self.slide_roll {
            1.0 => String::new(),
            slide_roll => format!(", slide-roll {slide_roll}"),
        };
        // Those that follow from quantities of the laboratory have more digits than anybody reads.
        let [f, alpha, beta] = [f, alpha, beta].map(|number| match self.experiment {
            Some(_) => shortest(format!("{number:.5e}").parse().expect("{:e} writes a number")),
            None => number.to_string(),
        });
        let outcome = entry.outcome.name();
        let mut text = format!("f = {f}, alpha = {alpha}, beta = {beta}{rolling}{same}: {outcome}\n");
        if let Some(experiment) = &self.experiment {
            text += &format!("{}\n", describe_experiment(experiment));
        }
        if entry.outcome == Status::Failed {
            text += &format!("{}\n", filled(&format!("  {}", entry.reason), "  "));
        }
        text += &self.cost();
        text += &self.path();
        text += "\n";
        text + &numbers(entry, self.slide_roll, if self.experiment.is_some() { si_units } else { |units| units })
    }

    /// One line: id, seed, effort and time.
    fn cost(&self) -> String {
        let (timing, settings) = (&self.entry.timing, self.settings);
        let (effort, setting) = match settings.method {
            Method::Collocation => {
                let factorisations = count(timing.factorisations, "factorisation");
                let iterations = count(timing.iterations, "iteration");
                let unknowns = match self.entry.outcome {
                    Status::Converged => format!(", {} unknowns", self.unknowns),
                    Status::Failed => String::new(),
                };
                let setting = format!("tolerance {:e}{unknowns}", settings.tolerance);
                (format!("{iterations}, {factorisations}"), setting)
            }
            Method::Relaxation => {
                (format!("{} passes", timing.iterations), format!("{} points", settings.relaxation.points))
            }
        };
        let (id, method, seconds) = (self.entry.id, settings.method, duration(timing.seconds));
        format!(
            "case {id}, {method}, {setting}\n{}\n",
            filled(&format!("seed {}, {effort}, {seconds}", self.seed_in_words()), "  ")
        )
    }

    /// The seed for people: cases on the way have no number in the terms of the field.
    fn seed_in_words(&self) -> String {
        match self.entry.timing.seed {
            Some(Seed::March(cases)) => format!("of thicker films, {}", count(cases as u64, "step")),
            Some(Seed::Intermediate(cases)) => format!("of cases between, {}", count(cases as u64, "step")),
            _ => self.seed(),
        }
    }

    /// The name of the seed.
    fn seed(&self) -> String {
        self.entry.timing.seed.map_or_else(String::new, |seed| seed.to_string())
    }

    /// The path, a line for each point; nothing if the first guess led to the solution.
    fn path(&self) -> String {
        let points = &self.path.points;
        let mut text = String::new();
        if !points.is_empty() {
            text += "\nby way of     alpha          beta             f    iterations\n";
        }
        for PathPoint { alpha, beta, f, iterations, accepted } in points {
            let failed = if *accepted { "" } else { "not solved" };
            let columns = [Align::Right(19), Align::Right(12), Align::Right(12), Align::Right(12), Align::Left(0)];
            let [alpha, beta, f] = [alpha, beta, f].map(|value| short(*value));
            text += &table_line(&columns, &[&alpha, &beta, &f, &iterations.to_string(), failed]);
        }
        text
    }

    /// One object: the columns of the summary, sensitivities if there are any, then seed, effort and path.
    pub fn json(&self) -> String {
        let (Parameters { f, alpha, beta, .. }, entry) = (self.asked, self.entry);
        let reason = if entry.reason.is_empty() { Value::Null } else { Value::from(entry.reason.as_str()) };
        let mut pairs = vec![
            ("case", Value::from(entry.id.to_string())),
            ("f", Value::from(*f)),
            ("alpha", number(*alpha)),
            ("beta", Value::from(*beta)),
            ("slide_roll", Value::from(self.slide_roll)),
            ("status", Value::from(entry.outcome.name())),
            ("reason", reason),
        ];
        if let Some(experiment) = &self.experiment {
            pairs.extend(experiment.given().map(|it| (it.name(), Value::from(experiment.value(it)))));
        }
        pairs.extend(Column::summary().map(|column| (column.name(), Value::from(entry.values[column]))));
        if let Some(known) = &entry.sensitivities {
            let there = Sensitivities { hydrodynamic: known.hydrodynamic_at(self.slide_roll), ..*known };
            pairs.extend(Sensitivities::NAMES.into_iter().zip(there.named().map(Value::from)));
            pairs.extend(entry.sensitivity_errors.map(|errors| ("sensitivity_errors", self.errors_of(&errors))));
        }
        pairs.push(("seed", Value::from(self.seed())));
        let point = |point: &PathPoint| {
            let &PathPoint { alpha, beta, f, iterations, accepted } = point;
            json!({ "alpha": number(alpha), "beta": beta, "f": f, "iterations": iterations, "accepted": accepted })
        };
        pairs.push(("path", self.path.points.iter().map(point).collect()));
        pairs.push(("iterations", Value::from(entry.timing.iterations)));
        pairs.push(("factorisations", Value::from(entry.timing.factorisations)));
        pairs.push(("unknowns", Value::from(self.unknowns)));
        pairs.push(("seconds", Value::from(entry.timing.seconds)));
        serde_json::to_string_pretty(&Object(pairs)).expect("strings and numbers can be written") + "\n"
    }

    /// The errors of the derivatives, by their names.
    fn errors_of(&self, errors: &Sensitivities) -> Value {
        let of = |column| Sensitivities::of_case(errors_of_derivatives(errors, column, self.slide_roll));
        let errors = [Column::MuV, Column::MuH, Column::MuPressure].map(of).concat();
        let named = Sensitivities::NAMES.into_iter().zip(errors);
        named.map(|(name, error)| (name.to_owned(), Value::from(error))).collect::<serde_json::Map<_, _>>().into()
    }
}

/// The quantities of an experiment, in SI units.
pub fn describe_experiment(experiment: &Experiment) -> String {
    let given = experiment.given().map(|quantity| {
        let value = shortest(experiment.value(quantity));
        format!("{} = {value} {}", quantity.name(), quantity.units().trim_start_matches('1')).trim_end().to_owned()
    });
    filled_list(&given.collect::<Vec<_>>(), "  ")
}

/// A number in JSON, which has no infinity; NaN becomes null.
fn number(value: f64) -> Value {
    if value.is_infinite() { Value::from("inf") } else { Value::from(value) }
}

/// A coordinate of a path: as it is if that is short, else with four digits.
fn short(value: f64) -> String {
    let exact = value.to_string();
    if exact.len() <= 6 { exact } else { format!("{value:.3e}") }
}

/// An object whose keys stay in their order.
struct Object(Vec<(&'static str, Value)>);

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}
