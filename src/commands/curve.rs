//! `stribeck curve`: friction against speed, in the terminal and as CSV.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::Args;

use super::at::{self, At};
use super::measured::{self, MeasuredArguments};
use super::output_file::{OutputFiles, or_empty};
use super::run_report::note_line;
use super::terminal_plot::{TextAxis, plot};
use super::{CliError, Exit, console, threads};
use crate::format::{Align, count, filled, filled_list, table_line};
use crate::pictures::{Quantity, Table, nearest};
use stribeck_input::shown;
use stribeck_lab::{Experiment, LaboratoryQuantity, Measured};
use stribeck_solver::{FieldSelection, Interrupt, Output, shortest};
use stribeck_sweep::campaign::{InMemory, read_sweep, solve_in_memory};
use stribeck_sweep::store::{CaseEntry, Status};
use stribeck_sweep::{Column, Extent, Grid, LaboratoryAxes, Note, NoteCounts, Plan, Sweep, Values, range};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck curve sweeps/gel.toml                        friction against speed, drawn and as a table
  stribeck curve sweeps/gel.toml --csv curve.csv        all numbers, in SI units
  stribeck curve sweeps/rubber.toml --at load=500       one of its two loads
  stribeck curve docs/how-to/instrument-files/experiment.toml --at slide_roll_ratio=0.2 \\
      --measured docs/how-to/instrument-files/traction.txt",
    after_help = "\
The sweep file has a section [laboratory] with a speed as an axis (docs/reference/sweep-file.md). Nothing is stored: to
keep fields and numbers run the sweep. Measured points are a table with mu and where it was measured
(docs/reference/laboratory.md). A speed of 0 is in the table and not in the drawing, which is logarithmic."
)]
pub struct Arguments {
    /// The sweep file, with [laboratory]
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// A value of each other axis that has several, as in load=100 or load="100 N/m"; the nearest one is taken
    #[arg(long, value_name = "AXIS=V,…", value_parser = at::parse)]
    at: Vec<At>,
    /// Write all numbers to this file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    #[command(flatten)]
    measured: MeasuredArguments,
    /// Solver threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse)]
    threads: Option<NonZeroUsize>,
}

/// The first columns of the table.
const FIRST_COLUMNS: [&str; 5] = ["status", "reason", "f", "alpha", "beta"];

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let mut sweep = read_sweep(&arguments.sweep)?;
    let axes = laboratory(&sweep, &arguments.sweep)?;
    let measured = arguments.measured.read(sweep.grid.radius())?;
    let has_temperature = axes.given.iter().any(|given| given.quantity == LaboratoryQuantity::Temperature);
    measured.iter().for_each(|measured| {
        measured::note_units(measured, &sweep.grid.dimensions());
        measured::note_temperatures(measured, has_temperature);
    });
    sweep.grid = Grid::Laboratory(choose(axes, &at::all(&arguments.at), Choice::Curve)?);
    sweep.output = Output { fields: FieldSelection::default(), sensitivities: false, ..sweep.output };
    let inputs = arguments.measured.files().chain([arguments.sweep.as_path()]);
    let is_ours = |beginning: &[u8]| beginning.starts_with(FIRST_COLUMNS.join(",").as_bytes());
    let files = OutputFiles::new("curve", inputs);
    let csv = arguments.csv.as_deref().map(|file| files.check(file, or_empty(is_ours))).transpose()?;
    let cases = solve(&sweep, threads::number(arguments.threads))?;
    if let Some(csv) = csv {
        csv.write(&table(&cases).csv())?;
    }
    let mut text = format!("{}\n{}\n", sweep.title, describe(&cases[0].experiment));
    if let Grid::Laboratory(axes) = &sweep.grid {
        let extent = Extent::of(axes);
        text += &format!("{}\n", filled(&extent.to_string(), "  "));
        let cavity = sweep.output.cavity_shear;
        text += &format!("{}\n", filled(&format!("cavity_shear = \"{cavity}\": {}", cavity.meaning()), "  "));
        text += &reach(&cases);
        text += &notes(&cases, axes);
    }
    text += &drawing(&cases, measured.as_ref());
    text += &rows(&cases);
    let failed: Vec<&Solved> = cases.iter().filter(|case| case.entry.outcome == Status::Failed).collect();
    for case in &failed {
        let line = format!("failed at {} m/s: {}", shortest(case.along()), case.entry.reason);
        text += &format!("{}\n", filled(&line, "  "));
    }
    if let Some(file) = &arguments.csv {
        text += &format!("{}: {}\n", shown(file), count(cases.len() as u64, "row"));
    }
    console::print(&text)?;
    Ok(if failed.is_empty() { Exit::Success } else { Exit::CasesFailed })
}

/// The quantities of the laboratory of a sweep.
///
/// # Errors
/// [`CliError::NotLaboratory`] if it is dimensionless.
pub fn laboratory<'s>(sweep: &'s Sweep, path: &Path) -> Result<&'s LaboratoryAxes, CliError> {
    match &sweep.grid {
        Grid::Laboratory(axes) => Ok(axes),
        Grid::Dimensionless(_) => Err(CliError::NotLaboratory { file: path.to_owned() }),
    }
}

/// What is chosen of a sweep over quantities of the laboratory.
#[derive(Clone, Copy, PartialEq)]
pub enum Choice {
    /// A curve along the speed, by values of the sweep.
    Curve,
    /// A case, by any values.
    Case,
}

/// The axes with one value of each; a curve has all speeds.
///
/// # Errors
/// [`CliError`] if an axis has several values and none is asked for, or what is asked for is no axis.
pub fn choose(axes: &LaboratoryAxes, at: &[(String, Vec<f64>)], choice: Choice) -> Result<LaboratoryAxes, CliError> {
    // Each is one of the runs of an instrument that swaps bodies.
    let mut one = LaboratoryAxes { swap: false, ..axes.clone() };
    let (of, chosen) = match choice {
        Choice::Curve => ("a curve", one.given.len() - 1),
        Choice::Case => ("a case", one.given.len()),
    };
    let known: Vec<&str> =
        std::iter::once("f").chain(one.given[..chosen].iter().map(|given| given.quantity.name())).collect();
    if let Some((axis, _)) = at.iter().find(|(axis, _)| !known.contains(&axis.as_str())) {
        let of = if choice == Choice::Curve { "a curve runs along the speed, and" } else { of };
        return Err(CliError::NoSuchAxis { of, axis: axis.clone(), known: known.join(", ") });
    }
    let lists = std::iter::once(("f", &mut one.f))
        .chain(one.given[..chosen].iter_mut().map(|given| (given.quantity.name(), &mut given.values)));
    for (name, values) in lists {
        let wanted: Vec<f64> =
            at.iter().filter(|(axis, _)| axis == name).flat_map(|(_, values)| values.clone()).collect();
        let value = match wanted[..] {
            [] if values.len() == 1 => values[0],
            [wanted] if choice == Choice::Case => wanted,
            [wanted] => values[nearest(name, values, wanted)?],
            [] => return Err(CliError::SeveralCurves { of, axis: name.to_owned(), values: values.len() }),
            _ => return Err(CliError::SeveralAsked { of, axis: name.to_owned() }),
        };
        *values = vec![value];
    }
    Ok(one)
}

/// One speed, solved.
struct Solved {
    experiment: Experiment,
    numbers: [f64; 3],
    entry: CaseEntry,
}

impl Solved {
    /// The speed along which the curve runs.
    fn along(&self) -> f64 {
        self.experiment.motion.along().1
    }

    /// A column in SI units.
    fn value(&self, column: Column) -> f64 {
        self.entry.values[column] * self.experiment.scales().factor(column.units())
    }
}

/// Solves every case of a sweep along the speed, in ascending speed.
fn solve(sweep: &Sweep, threads: NonZeroUsize) -> Result<Vec<Solved>, CliError> {
    let plan = Plan::new(sweep);
    let InMemory::Solved(entries) = solve_in_memory(sweep, threads, &Interrupt::new())? else {
        unreachable!("nobody interrupts");
    };
    let solved = sweep.grid.shape().row(0).map(|place| {
        let entry = entries.get(&plan.case_at(place)).expect("every case is in a chain").clone();
        let experiment = sweep.grid.experiment(place).expect("a sweep over quantities of the laboratory");
        let values = entry.values.at_slide_roll(experiment.motion.slide_roll());
        Solved { experiment, numbers: sweep.grid.numbers(place), entry: CaseEntry { values, ..entry } }
    });
    Ok(solved.collect())
}

/// A number with at most five digits.
fn five_digits(value: f64) -> String {
    shortest(format!("{value:.4e}").parse().expect("{:e} writes a number"))
}

/// The quantities that all cases of a curve have in common.
fn describe(experiment: &Experiment) -> String {
    let (along, _) = experiment.motion.along();
    let given = experiment.given().filter(|quantity| *quantity != along).map(|quantity| {
        let value = five_digits(experiment.value(quantity));
        format!("{} = {value} {}", quantity.name(), quantity.units().trim_start_matches('1')).trim_end().to_owned()
    });
    let strength = format!("f = {}", five_digits(experiment.f));
    filled_list(&given.chain([strength]).collect::<Vec<_>>(), "")
}

/// How far pressure and film of the solutions reach.
fn reach(cases: &[Solved]) -> String {
    let of = |column: Column| {
        let values = cases.iter().map(|case| case.value(column)).filter(|value| !value.is_nan());
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)])
    };
    let [pressure, film] = [Column::PMax, Column::FilmMin].map(of);
    match pressure[0] <= pressure[1] {
        true => format!("solved: p_max {} Pa, film_min {} m\n", range(pressure), range(film)),
        false => String::new(),
    }
}

/// Where solutions are beyond the model.
fn notes(cases: &[Solved], axes: &LaboratoryAxes) -> String {
    let mask = |case: &Solved| {
        let values = Values(Column::ALL.map(|column| case.value(column)));
        Note::of(&values, Some(&case.experiment), &axes.limits).fold(0, |mask, note| mask | note.mask())
    };
    let counts = NoteCounts::of_masks(cases.iter().map(mask));
    counts.iter().map(|(note, count)| note_line(note, count, cases.len() as u64)).collect()
}

/// The curve of the drag, or of the friction that was measured, and measured points of it.
fn drawing(cases: &[Solved], measured: Option<&Measured>) -> String {
    let column = measured.and_then(|measured| Column::named(measured.column)).unwrap_or(Column::MuDrag);
    let line: Vec<(f64, f64)> = cases.iter().map(|case| (case.along(), case.value(column))).collect();
    let along = cases[0].experiment.motion.along().0.name();
    let points: Vec<(f64, f64)> = match measured.and_then(|it| Some((it, it.coordinate(along)?))) {
        Some((measured, speeds)) => {
            let own = (0..speeds.len()).filter(|point| measured.belongs_to(*point, &cases[0].experiment));
            own.map(|point| (speeds[point], measured.friction[point])).collect()
        }
        None => Vec::new(),
    };
    let measured = match measured {
        None => "",
        Some(_) if points.is_empty() => "; no point was measured on this curve",
        Some(_) => "; crosses: measured",
    };
    let (x, y) = (TextAxis { logarithmic: true }, TextAxis { logarithmic: false });
    let quantity = Quantity::from(column).plain_title();
    format!("\n{quantity} against {along} in m/s, logarithmic{measured}\n{}\n", plot(&line, &points, x, y))
}

/// One line for each speed.
fn rows(cases: &[Solved]) -> String {
    let names = ["speed (m/s)", "mu_drag", "mu_v", "mu_shear", "mu_pressure", "film_min (m)", "error"];
    let columns = [11, 9, 9, 9, 11, 12, 6].map(Align::Right);
    let mut text = table_line(&columns, &names);
    let number = |value: f64| if value.is_nan() { "-".to_owned() } else { format!("{value:.3e}") };
    for case in cases {
        let errors =
            [Column::ErrorMuDrag, Column::ErrorMuV, Column::ErrorMuH, Column::ErrorC].map(|column| case.value(column));
        let error =
            if errors.iter().any(|error| error.is_nan()) { f64::NAN } else { errors.into_iter().fold(0.0, f64::max) };
        let values = [Column::MuDrag, Column::MuV, Column::MuShear, Column::MuPressure, Column::FilmMin]
            .map(|column| case.value(column));
        let numbers: Vec<f64> = std::iter::once(case.along()).chain(values).collect();
        let mut cells: Vec<String> = numbers.into_iter().map(number).collect();
        cells.push(match case.entry.outcome {
            Status::Failed => "failed".to_owned(),
            Status::Converged if error.is_nan() => "-".to_owned(),
            Status::Converged => format!("{error:.0e}"),
        });
        text += &table_line(&columns, &cells);
    }
    let slide_roll = cases[0].experiment.motion.slide_roll();
    let along = cases[0].experiment.motion.along().0.name();
    let drag = format!(
        "mu_drag = mu_v + S mu_shear - mu_pressure: what a load cell reads, by hysteresis, shear and pressure flow; \
         S = {} here",
        shortest(slide_roll)
    );
    let error = "error: the largest estimated relative error of mu_drag, mu_v, mu_h and the film c";
    let speed = if along == "speed" { String::new() } else { format!("speed: {along}\n") };
    text + &format!("\n{speed}{}\n{}\n", filled(&drag, "  "), filled(error, "  "))
}

/// All numbers in SI units: what is given, and the columns of the summary.
fn table(cases: &[Solved]) -> Table {
    let quantities: Vec<_> = cases[0].experiment.given().collect();
    let columns: Vec<_> = Column::summary().map(Column::name).collect();
    let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name()).collect();
    let others: Vec<&str> = cases[0].experiment.variables().map(|((name, ..), _)| name).collect();
    let header = [&FIRST_COLUMNS[..], &names[..], &columns[..], &others[..]].concat();
    let mut table = Table::new(&header);
    for case in cases {
        let given = quantities.iter().map(|quantity| case.experiment.value(*quantity));
        let numbers = case.numbers.into_iter().chain(given).chain(Column::summary().map(|column| case.value(column)));
        let numbers = numbers.chain(case.experiment.variables().map(|(_, value)| value));
        table.row(&[case.entry.outcome.name(), &case.entry.reason], &numbers.collect::<Vec<_>>());
    }
    table
}
