//! Measured points of the command line: their file, and what its columns are.

use std::path::{Path, PathBuf};

use clap::Args;

use super::{CliError, console};
use stribeck_input::printable;
use stribeck_lab::{ColumnChoice, LaboratoryQuantity, Measured};
use stribeck_sweep::store::DataSet;
use stribeck_sweep::{Dimension, range};

/// So many times a sweep's fastest speed, or a part of its slowest, is far outside of it.
const FAR: f64 = 10.0;
/// Temperatures this far apart, in K, are several.
const APART: f64 = 5.0;

/// Options of commands that lay measured points over solutions.
#[derive(Clone, Debug, Args)]
pub struct MeasuredArguments {
    /// A table of measured points, laid over the curves of friction
    #[arg(long, value_name = "FILE")]
    measured: Option<PathBuf>,
    /// What columns hold whose names do not tell, as in "speed=My V (mm/s),mu=#3"
    #[arg(long = "columns", value_name = "NAME=COLUMN,…", requires = "measured", value_parser = choices)]
    columns: Vec<Choices>,
}

/// What a user says of the columns of a table.
#[derive(Clone, Debug, Args)]
pub struct ColumnArguments {
    /// What columns hold whose names do not tell, as in "speed=My V (mm/s),mu=#3"
    #[arg(long = "columns", value_name = "NAME=COLUMN,…", value_parser = choices)]
    columns: Vec<Choices>,
}

/// The choices of one option.
#[derive(Clone, Debug)]
pub struct Choices(Vec<ColumnChoice>);

/// The choices of a text.
pub fn choices(text: &str) -> Result<Choices, String> {
    ColumnChoice::list(text).map(Choices)
}

impl ColumnArguments {
    /// All choices.
    pub fn choices(&self) -> Vec<ColumnChoice> {
        all(&self.columns)
    }
}

/// The choices of an option that is given once or several times.
pub fn all(options: &[Choices]) -> Vec<ColumnChoice> {
    options.iter().flat_map(|choices| choices.0.clone()).collect()
}

impl MeasuredArguments {
    /// The file of the points, if there is one.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.measured.iter().map(PathBuf::as_path)
    }

    /// Reads the points, if there are some, and tells what was understood; speeds in turns need the radius of the
    /// cylinder (m).
    pub fn read(&self, radius: Option<f64>) -> Result<Option<Measured>, CliError> {
        self.measured.as_deref().map(|path| read(path, &all(&self.columns), radius)).transpose()
    }
}

/// Says on stderr if speeds whose unit nobody named are far outside of those of a sweep.
pub fn note_units(measured: &Measured, sweep: &[Dimension]) {
    for (name, heading) in &measured.without_unit {
        if let Some(values) = measured.coordinate(name) {
            note_far(&format!("column `{}`", printable(heading)), name, values, sweep);
        }
    }
}

/// The same of values on the command line.
pub fn note_value(axis: &str, values: &[f64], sweep: &[Dimension]) {
    note_far(&printable(axis), axis, values, sweep);
}

fn note_far(what: &str, axis: &str, values: &[f64], sweep: &[Dimension]) {
    let ends = |values: &[f64]| {
        let above_0 = values.iter().copied().filter(|value| *value > 0.0);
        above_0.fold([f64::INFINITY, 0.0], |[least, most], value| [f64::min(least, value), f64::max(most, value)])
    };
    let Some(of_sweep) = sweep.iter().find(|it| it.name == axis && it.units == "m/s") else { return };
    let ([least, most], [slowest, fastest]) = (ends(values), ends(&of_sweep.values));
    if most == 0.0 || (least <= FAR * fastest && most >= slowest / FAR) {
        return;
    }
    let in_mm = least / 1000.0 <= FAR * fastest && most / 1000.0 >= slowest / FAR;
    let remedy = if in_mm { "did you mean mm/s?" } else { "which unit did you mean?" };
    let mm = range([1000.0 * slowest, 1000.0 * fastest]);
    console::tell(&format!(
        "note: {what}, {}, is read as m/s; the sweep has {mm} mm/s; {remedy} Write the unit behind the name or the number",
        range([least, most])
    ));
}

/// Says on stderr that points at several temperatures are taken for points at one, where the sweep has none.
pub fn note_temperatures(measured: &Measured, sweep_has_one: bool) {
    let values = measured.coordinate(LaboratoryQuantity::Temperature.name()).unwrap_or_default();
    let ends = |(least, most): (f64, f64), it: &f64| (least.min(*it), most.max(*it));
    let (least, most) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), ends);
    if most - least > APART && !sweep_has_one {
        let [least, most] = [least, most].map(|kelvins| kelvins - 273.15);
        console::tell(&format!(
            "note: the points are from {least:.1} to {most:.1} degC, and the sweep has no temperature: viscosity and \
             times are taken to be the same at all of them"
        ));
    }
}

/// True if a published sweep has a temperature.
pub fn has_temperature(data: &DataSet) -> bool {
    let mut names = data.fixed.iter().map(|(name, _)| name).chain(data.dimensions.iter().map(|it| &it.name));
    names.any(|name| name == LaboratoryQuantity::Temperature.name())
}

/// Reads measured points, and tells on stderr what was understood of them.
pub fn read(path: &Path, columns: &[ColumnChoice], radius: Option<f64>) -> Result<Measured, CliError> {
    let (measured, understood) = Measured::read(path, columns, radius)?;
    console::tell(understood.to_string().trim_end());
    Ok(measured)
}

/// The radius of the cylinder of a published sweep (m), where it has one value.
pub fn radius(data: &DataSet) -> Option<f64> {
    let name = LaboratoryQuantity::Radius.name();
    let axis = data.dimensions.iter().find(|dimension| dimension.name == name).filter(|it| it.values.len() == 1);
    let fixed = data.fixed.iter().find(|(fixed, _)| fixed == name).map(|(_, value)| *value);
    fixed.or_else(|| axis.map(|axis| axis.values[0]))
}
