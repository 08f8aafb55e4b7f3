//! `stribeck material`: a substrate from measured moduli, or from a Prony series.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;

use super::fitted_material::FittedMaterial;
use super::measured::ColumnArguments;
use super::output_file::{OutputFiles, or_empty};
use super::prony_material::PronyMaterial;
use super::{CliError, Exit, console};
use crate::pictures::{Chart, Format, is_picture};
use stribeck_input::shown;
use stribeck_lab::{
    AtOneTemperature, Dimension, MaterialData, MaterialFile, MaterialOptions, RelaxationFit, ShiftFactors, TermChoice,
    parse_temperature,
};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck material docs/how-to/instrument-files/moduli.csv
  stribeck material docs/how-to/instrument-files/moduli.csv --terms 12 -o fit.svg
  stribeck material docs/how-to/instrument-files/moduli.csv --shear --poisson-ratio 0.5 --json
  stribeck material docs/how-to/instrument-files/isotherms.csv --reference-temperature 20degC",
    after_help = "\
Prints the lines for a sweep file. The file is a table of moduli over frequency (storage and loss) or over time
(relaxation), at one temperature or several; or it is a Prony series of Abaqus, Ansys or in a table, which is converted
and not fitted. Times of the terms are spread over the measured range; those that the data do not ask for are dropped.
docs/how-to/materials.md has more."
)]
pub struct Arguments {
    /// A table of measured moduli, or a Prony series
    #[arg(value_name = "DATA")]
    data: PathBuf,
    /// Relaxation terms that are offered to the fit, from 1 to 100, or auto: as many as the residuals ask for
    #[arg(long, value_name = "N", default_value = "auto")]
    terms: Terms,
    /// The moduli are shear moduli: Young's modulus is 2 (1 + nu) times as large
    #[arg(long, requires = "poisson_ratio")]
    shear: bool,
    /// Poisson's ratio, from 0 to 0.5, beside shear moduli
    #[arg(long, value_name = "NU", value_parser = poisson_ratio)]
    poisson_ratio: Option<f64>,
    /// The unit of moduli in a file that names none, as in MPa
    #[arg(long, value_name = "UNIT", value_parser = modulus_unit)]
    modulus_unit: Option<f64>,
    /// Shift moduli at several temperatures to this one, as in "20 degC" or "293 K"
    #[arg(long, value_name = "T", value_parser = temperature, allow_hyphen_values = true)]
    reference_temperature: Option<f64>,
    /// A table of shift factors, by which moduli are shifted, instead of those that are found
    #[arg(long, value_name = "FILE")]
    shift_factors: Option<PathBuf>,
    #[command(flatten)]
    columns: ColumnArguments,
    /// A picture of measurements and fit, SVG or PNG by its extension
    #[arg(short, long, value_name = "FILE", value_parser = picture)]
    output: Option<(PathBuf, Format)>,
    /// JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// The number of terms of a fit.
#[derive(Clone, Copy, Debug)]
enum Terms {
    Auto,
    Number(usize),
}

impl FromStr for Terms {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == "auto" {
            return Ok(Self::Auto);
        }
        text.parse().map(Self::Number).map_err(|_| "a whole number from 1 to 100, or auto")
    }
}

fn poisson_ratio(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|ratio| (0.0..=0.5).contains(ratio)).ok_or("a number from 0 to 0.5; soft solids have 0.5")
}

fn modulus_unit(text: &str) -> Result<f64, &'static str> {
    Dimension::Modulus.conversion(text).map(|unit| unit.in_si(1.0)).ok_or("a unit of a modulus, as in MPa")
}

fn temperature(text: &str) -> Result<f64, &'static str> {
    parse_temperature(text).ok_or("a temperature with its unit, as in \"20 degC\" or \"293 K\"")
}

/// A file whose name tells its format.
fn picture(text: &str) -> Result<(PathBuf, Format), String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = [Format::Svg, Format::Png].into_iter().find(|format| extension.as_deref() == Some(format.extension()));
    format.map(|format| (path, format)).ok_or_else(|| "a file whose name ends in .svg or .png".to_owned())
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let options = MaterialOptions {
        is_shear: arguments.shear,
        poisson_ratio: arguments.poisson_ratio,
        modulus_unit: arguments.modulus_unit,
        columns: arguments.columns.choices(),
    };
    let file = MaterialFile::read(&arguments.data, &options)?;
    console::tell(file.understood.trim_end());
    let name = arguments.data.file_stem().unwrap_or_default().to_string_lossy();
    let measured = match &file.data {
        MaterialData::Series(series) => {
            let refused = |source| CliError::Series { file: arguments.data.clone(), source };
            let relaxation = series.relaxation().map_err(refused)?;
            let material = PronyMaterial { name: &name, series, relaxation: &relaxation };
            return finish(arguments, &material.table(), &material.json(), &material.chart());
        }
        MaterialData::Moduli(measurements) => {
            let measurements = measurements.clone();
            AtOneTemperature::of_moduli(measurements, factors(arguments)?.as_ref(), arguments.reference_temperature)
        }
        MaterialData::Isotherms(isotherms) => {
            AtOneTemperature::of_isotherms(isotherms, factors(arguments)?.as_ref(), arguments.reference_temperature)
        }
    };
    let measured = measured.map_err(|source| CliError::MasterCurve { data: arguments.data.clone(), source })?;
    let fitted = |source| CliError::Fit { data: arguments.data.clone(), source };
    let (fit, offered, choice) = match arguments.terms {
        Terms::Number(terms) => (RelaxationFit::new(&measured.measurements, terms).map_err(fitted)?, terms, None),
        Terms::Auto => {
            let choice = TermChoice::new(&measured.measurements).map_err(fitted)?;
            (choice.fit.clone(), choice.offered, Some(choice))
        }
    };
    let material = FittedMaterial {
        name: &name,
        measurements: &measured.measurements,
        fit: &fit,
        offered,
        choice: choice.as_ref(),
        master_curve: measured.master_curve.as_ref(),
    };
    finish(arguments, &material.table(), &material.json(), &material.chart())
}

/// Reads shift factors where they are given, and tells what was understood of them.
fn factors(arguments: &Arguments) -> Result<Option<ShiftFactors>, CliError> {
    let Some(file) = &arguments.shift_factors else { return Ok(None) };
    let (factors, understood) = ShiftFactors::read(file)?;
    console::tell(understood.to_string().trim_end());
    Ok(Some(factors))
}

/// Prints a material and paints its picture.
fn finish(arguments: &Arguments, table: &str, json: &str, chart: &Chart) -> Result<Exit, CliError> {
    let mut text = if arguments.json { json.to_owned() } else { table.to_owned() };
    if let Some((file, format)) = &arguments.output {
        let inputs = arguments.shift_factors.iter().chain([&arguments.data]).map(PathBuf::as_path);
        OutputFiles::new("material", inputs).check(file, or_empty(is_picture))?.write(&chart.paint(*format)?)?;
        // What reads JSON gets nothing else.
        if !arguments.json {
            text += &format!("\n{}\n", shown(file));
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}
