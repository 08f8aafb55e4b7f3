//! `stribeck solve --batch`: a list of cases, to the rows of a summary.

use std::io;
use std::path::Path;
use std::sync::Arc;

use super::number::number;
use super::solve::{Modes, modes};
use super::{CliError, Exit, console};
use stribeck_input::printable;
use stribeck_solver::{Interrupt, Parameters, Substrate, solve_points};
use stribeck_sweep::campaign::case_entry;
use stribeck_sweep::engine::Signals;
use stribeck_sweep::store::Status;
use stribeck_sweep::{Column, Grid, Plan, Sweep};

/// The columns of a list that must be there.
const REQUIRED: [&str; 3] = ["f", "alpha", "beta"];

/// A list of cases as it stands in a file.
struct Batch {
    cases: Vec<Parameters>,
    /// f, α and β of each, as they are written.
    numbers: Vec<[f64; 3]>,
    /// The slide-to-sum ratio of each; none if the file has no such column.
    slide_roll: Option<Vec<f64>>,
}

/// Solves the cases of a file and prints the rows of a summary, in the order of the file.
pub fn execute(file: &Path, sweep: &Sweep, default_ratio: f64) -> Result<Exit, CliError> {
    if default_ratio == -1.0 && sweep.substrate.of_roller() > 0 {
        return Err(CliError::RollerOverFlatAtRest);
    }
    let batch = read(file, &sweep.substrate, default_ratio)?;
    let slides = |[f, alpha, _]: &[f64; 3]| *f > 0.0 && *alpha != f64::INFINITY;
    if batch.slide_roll.is_none() && default_ratio == -1.0 && batch.numbers.iter().any(slides) {
        return Err(CliError::FlatAtRest);
    }
    let interrupt = Arc::new(Interrupt::new());
    let _signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the work", source })?;
    let Ok(solved) = solve_points(&batch.cases, &sweep.solver_settings(), &interrupt) else {
        console::tell("interrupted: nothing is kept of a list; start again");
        return Ok(Exit::Interrupted);
    };
    let plan = Plan::new(sweep);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let write_failed = |error: csv::Error| CliError::System { action: "write a row", source: io::Error::other(error) };
    let ratio_name = batch.slide_roll.as_ref().map(|_| "slide_roll");
    let header = ["case"].into_iter().chain(ratio_name).chain(REQUIRED).chain(["status", "reason"]);
    writer.write_record(header.chain(Column::summary().map(Column::name))).map_err(write_failed)?;
    let mut failed = false;
    for (place, (parameters, case)) in batch.cases.iter().zip(solved).enumerate() {
        let ratio = batch.slide_roll.as_ref().map(|ratios| ratios[place]);
        let entry = case_entry(&plan, parameters, case);
        let values = entry.values.at_slide_roll(ratio.unwrap_or(default_ratio));
        // As summary.csv has them.
        let text = |value: f64| if value.is_nan() { String::new() } else { format!("{value:?}") };
        let mut row = vec![entry.id.to_string()];
        row.extend(ratio.map(text));
        row.extend(batch.numbers[place].map(text));
        row.extend([entry.outcome.name().to_owned(), entry.reason]);
        row.extend(Column::summary().map(|column| text(values[column])));
        writer.write_record(row).map_err(write_failed)?;
        failed |= entry.outcome == Status::Failed;
    }
    let bytes = writer.into_inner().map_err(|error| write_failed(error.into_error().into()))?;
    console::print(&String::from_utf8_lossy(&bytes))?;
    Ok(if failed { Exit::CasesFailed } else { Exit::Success })
}

/// Reads a list: a CSV with f, alpha and beta, and where it has them modes and slide_roll. Others are no part of it.
fn read(file: &Path, substrate: &Substrate, default_ratio: f64) -> Result<Batch, CliError> {
    let refused = |what: String| CliError::Points { file: file.to_owned(), what };
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_path(file)
        .map_err(|error| refused(format!("{error}; check the path")))?;
    let header = reader.headers().map_err(|error| refused(error.to_string()))?.clone();
    let place = |wanted: &str| header.iter().position(|name| name == wanted);
    let required = REQUIRED.map(|name| {
        place(name).ok_or_else(|| refused(format!("it has no column `{name}`; name one so in the first line")))
    });
    let [f, alpha, beta] = required;
    let (f, alpha, beta, own_modes, ratio) = (f?, alpha?, beta?, place("modes"), place("slide_roll"));
    let (mut cases, mut numbers_of_cases, mut ratios) = (Vec::new(), Vec::new(), Vec::new());
    for row in reader.records() {
        let row = row.map_err(|error| refused(error.to_string()))?;
        let line = row.position().map_or(0, csv::Position::line);
        let cell = |column: usize, allowed: &str, is_allowed: &dyn Fn(f64) -> bool| {
            number(&row[column]).filter(|value| is_allowed(*value)).ok_or_else(|| {
                let (name, found) = (&header[column], printable(&row[column]));
                refused(format!("line {line}: `{name}` must be {allowed}, found `{found}`"))
            })
        };
        let substrate = match own_modes.map(|column| &row[column]).filter(|text| !text.is_empty()) {
            None => substrate.clone(),
            Some(text) => {
                let Modes(modes) =
                    modes(text).map_err(|allowed| refused(format!("line {line}: `modes`: {allowed}")))?;
                Substrate::new(modes).map_err(|error| refused(format!("line {line}: `modes`: {error}")))?
            }
        };
        let numbers = [
            cell(f, "a finite number that is at least 0", &|f| f >= 0.0 && f.is_finite())?,
            cell(alpha, "a number that is at least 0, or inf", &|alpha| alpha >= 0.0)?,
            cell(beta, "a finite number above 0", &|beta| beta > 0.0 && beta.is_finite())?,
        ];
        if let Some(column) = ratio {
            ratios.push(cell(column, "a number above -1, up to 1", &|ratio| ratio > -1.0 && ratio <= 1.0)?);
        }
        let slide_roll = ratios.last().copied().unwrap_or(default_ratio);
        let case = Grid::case_of(numbers, slide_roll, &substrate)
            .map_err(|error| refused(format!("line {line}: modes of the roller at this slide_roll: {error}")))?;
        cases.push(case);
        numbers_of_cases.push(numbers);
    }
    if cases.is_empty() {
        return Err(refused("it has no case below its first line".to_owned()));
    }
    Ok(Batch { cases, numbers: numbers_of_cases, slide_roll: ratio.map(|_| ratios) })
}
