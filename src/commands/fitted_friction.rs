//! A fit to measured friction as a table, as JSON and as charts.

use std::path::Path;

use serde_json::{Value, json};

use super::short_value::short;
use super::terminal_plot::{TextAxis, plot};
use crate::format::{Align, count, filled, table_line};
use crate::pictures::Table;
use stribeck_input::shown;
use stribeck_lab::{Estimate, FrictionFit, Measured, Unknown};

/// The last columns of the table.
pub const LAST_COLUMNS: [&str; 4] = ["measured", "error", "fitted", "residual"];

/// A fit and the points that it was made from.
pub struct FittedFriction<'a> {
    pub fit: &'a FrictionFit,
    pub measured: &'a Measured,
    /// The interval of each unknown from the profile of the residuals, if it was asked for.
    pub intervals: Option<&'a [[Option<f64>; 2]]>,
}

impl FittedFriction<'_> {
    /// Values with errors, correlations, residuals, and the lines for a sweep file; `directory` has the files written.
    pub fn text(&self, directory: Option<&Path>) -> String {
        let mut text = self.heading() + &self.estimates() + &self.correlations() + &self.goodness() + &self.plot();
        text += &self.section("laboratory");
        text += &self.section("roller");
        if let Some(directory) = directory {
            text += &format!("\nin {}: fit.csv, and pictures of friction and residuals\n", shown(directory));
        }
        text
    }

    /// The lines for a section of a sweep file, if it has unknowns.
    fn section(&self, section: &str) -> String {
        let lines = self.fit.estimates.iter().filter_map(|Estimate { unknown, value, .. }| {
            let (of, key) = unknown.name().split_once('.').unwrap_or(("laboratory", unknown.name()));
            let best = if self.fit.is_minimum { "" } else { "the best so far" };
            let line = format!("{key} = {value:e}  # {}", format!("{} {best}", unit(*unknown)).trim());
            (of == section).then(|| format!("{}\n", line.trim_end_matches("  # ")))
        });
        let lines: String = lines.collect();
        if lines.is_empty() { lines } else { format!("\n[{section}]\n{lines}") }
    }

    fn heading(&self) -> String {
        let FrictionFit { points, evaluations, .. } = self.fit;
        let names: Vec<String> = self.measured.files.iter().map(|file| shown(file)).collect();
        let heading = format!(
            "{} of {}, {} solved {evaluations} times",
            count(points.len() as u64, "point"),
            names.join(" and "),
            if points.len() == 1 { "it was" } else { "all of them were" },
        );
        let best = if self.fit.is_minimum {
            ""
        } else {
            "NO MINIMUM: the time was up; the best values so far, without errors\n"
        };
        format!("{}\n{best}\n", filled(&heading, ""))
    }

    fn estimates(&self) -> String {
        let columns =
            [Align::Left(21), Align::Right(10), Align::Right(10), Align::Left(4), Align::Right(10), Align::Left(0)];
        let mut text = table_line(&columns, &["unknown", "value", "std. error", "unit", "start", "in short"]);
        let number = |number: f64| if number.is_nan() { "-".to_owned() } else { format!("{number:.4e}") };
        for (i, Estimate { unknown, value, error, start, at_bound }) in self.fit.estimates.iter().enumerate() {
            let [value_text, error_text, start] = [*value, *error, *start].map(number);
            let bound = if *at_bound { " at its bound" } else { "" };
            let short = short(*value, *error, unknown.units()) + bound;
            let cells = [unknown.name(), &value_text, &error_text, unknown.units(), &start, &short];
            text += &table_line(&columns, &cells);
            if let Some(intervals) = self.intervals {
                let [from, to] = intervals[i].map(|end| end.map_or("?".to_owned(), |end| format!("{end:.4e}")));
                text += &format!("  interval {from} to {to}\n");
            }
        }
        text
    }

    fn correlations(&self) -> String {
        if self.fit.estimates.len() == 1 || !self.fit.is_minimum {
            return String::new();
        }
        let mut text = "\ncorrelations\n".to_owned();
        for (estimate, row) in self.fit.estimates.iter().zip(&self.fit.correlation) {
            let row: Vec<String> = row.iter().map(|number| format!("{number:>8.4}")).collect();
            text += &format!("{:<22} {}\n", estimate.unknown.name(), row.join(" "));
        }
        text
    }

    /// How well the fit agrees with the points.
    fn goodness(&self) -> String {
        let FrictionFit { reduced_chi_squared, degrees_of_freedom, .. } = *self.fit;
        let degrees = count(degrees_of_freedom as u64, "degree");
        match self.measured.errors {
            _ if degrees_of_freedom == 0 => {
                "\nas many points as unknowns: nothing is left to tell whether the model holds\n".to_owned()
            }
            Some(_) => {
                let words = format!(
                    "reduced chi-squared {reduced_chi_squared:.4} with {degrees} of freedom: near 1 where the given \
                     errors are right and the model holds"
                );
                format!("\n{}\n", filled(&words, "  "))
            }
            None => format!(
                "\nrelative error of a point {:.3} %, from the residuals with {degrees} of freedom\n",
                100.0 * reduced_chi_squared.sqrt()
            ),
        }
    }

    /// The residuals, drawn for the terminal.
    fn plot(&self) -> String {
        let (points, (from, to)) = self.residuals();
        let (x, y) = (TextAxis { logarithmic: true }, TextAxis { logarithmic: false });
        let drawn = plot(&[(from, 0.0), (to, 0.0)], &points, x, y);
        let label = format!("residuals {} against {} in m/s, logarithmic", self.residual_label(), self.along());
        format!("\n{}\n{drawn}\n", filled(&label, "  "))
    }

    /// The name of the speed that points are drawn over.
    pub fn along(&self) -> &'static str {
        self.fit.points[0].experiment.motion.along().0.name()
    }

    /// The residuals over speed, and the range of the speeds above 0.
    pub fn residuals(&self) -> (Vec<(f64, f64)>, (f64, f64)) {
        let points: Vec<(f64, f64)> =
            self.fit.points.iter().map(|point| (point.experiment.motion.along().1, point.residual)).collect();
        let speeds = || points.iter().map(|(speed, _)| *speed).filter(|speed| *speed > 0.0);
        let range = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
        (points, range)
    }

    /// What residuals are.
    pub fn residual_label(&self) -> &'static str {
        match self.measured.errors {
            Some(_) if self.measured.is_logarithmic() => "ln(fitted/measured)/relative standard error",
            Some(_) => "(fitted − measured)/standard error",
            None => "ln(fitted/measured)",
        }
    }

    /// All numbers as one JSON object.
    pub fn json(&self) -> String {
        let fit = self.fit;
        let estimates: Vec<Value> = fit
            .estimates
            .iter()
            .map(|it| {
                json!({
                    "unknown": it.unknown.name(), "units": it.unknown.units(), "start": it.start, "value": it.value,
                    "standard_error": it.error, "at_bound": it.at_bound,
                })
            })
            .collect();
        let points: Vec<Value> = fit
            .points
            .iter()
            .map(|it| json!({ "file": it.place.0, "line": it.place.1, "measured": it.measured, "fitted": it.fitted, "residual": it.residual }))
            .collect();
        let whole = json!({
            "estimates": estimates,
            "correlation": fit.correlation,
            "degrees_of_freedom": fit.degrees_of_freedom,
            "reduced_chi_squared": fit.reduced_chi_squared,
            "evaluations": fit.evaluations,
            "is_minimum": fit.is_minimum,
            "intervals": self.intervals,
            "points": points,
        });
        serde_json::to_string_pretty(&whole).expect("strings and numbers can be written") + "\n"
    }

    /// Every point with its fitted friction.
    pub fn table(&self) -> Table {
        let fit = self.fit;
        let quantities: Vec<_> = fit.points[0].experiment.given().collect();
        let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name()).collect();
        let several = self.measured.files.len() > 1;
        let place = if several { &["file", "line"][..] } else { &["line"] };
        let mut table = Table::new(&[place, &names[..], &["f", "alpha", "beta"], &LAST_COLUMNS].concat());
        for point in &fit.points {
            let given = quantities.iter().map(|quantity| point.experiment.value(*quantity));
            let (alpha, beta) = (point.experiment.alpha(), point.experiment.beta());
            let error = point.error.unwrap_or(f64::NAN);
            let rest = [point.experiment.f, alpha, beta, point.measured, error, point.fitted, point.residual];
            let (file, line) = point.place;
            let place = [shown(&self.measured.files[file]), line.to_string()];
            let place: Vec<&str> = place.iter().skip(usize::from(!several)).map(String::as_str).collect();
            table.row(&place, &given.chain(rest).collect::<Vec<_>>());
        }
        table
    }
}

/// The unit of an unknown, to stand behind its value; nothing for f.
fn unit(unknown: Unknown) -> &'static str {
    if unknown.units() == "1" { "" } else { unknown.units() }
}
