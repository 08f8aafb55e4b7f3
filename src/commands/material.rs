//! `stribeck material`: a substrate from measured moduli, or from a Prony series.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, ValueEnum};

use super::fitted_material::FittedMaterial;
use super::measured::{self, Choices, ColumnArguments};
use super::output_file::{OutputFile, OutputFiles, or_empty};
use super::paper::PaperArguments;
use super::prony_material::PronyMaterial;
use super::{CliError, Exit, console, shifted};
use crate::pictures::{Chart, Format, is_picture};
use stribeck_input::shown;
use stribeck_lab::{
    AtOneTemperature, Dimension, MasterCurve, MaterialData, MaterialFile, MaterialOptions, PronySeries, RelaxationFit,
    ShiftFactors, Shifting, TermChoice, VerticalShift, parse_temperature,
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
    /// Relaxation terms offered to the fit, from 1 to 100, or auto: as many as the residuals ask for [default: auto]
    #[arg(long, value_name = "N")]
    terms: Option<Terms>,
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
    /// What columns of the shift factors hold, as in "temperature=#1 (degC),log_shift_factor=#2"
    #[arg(long, value_name = "NAME=COLUMN,…", requires = "shift_factors", value_parser = measured::choices)]
    shift_columns: Vec<Choices>,
    /// Multiply the moduli at T by b_T, too: by what fits the overlaps best, or by rho_0 T_0 / (rho T)
    #[arg(long, value_enum, value_name = "HOW", default_value_t)]
    vertical_shift: Vertical,
    /// Thermal expansion of the volume in 1/K, for the density of --vertical-shift density
    #[arg(long, value_name = "PER_K", value_parser = expansion)]
    expansion: Option<f64>,
    #[command(flatten)]
    columns: ColumnArguments,
    /// A picture of measurements and fit, SVG, PNG or PDF by its extension
    #[arg(short, long, value_name = "FILE", value_parser = picture)]
    output: Option<(PathBuf, Format)>,
    /// A picture of log a_T and its laws over the temperature; one of what they miss it by is NAME-residuals beside it
    #[arg(long, value_name = "FILE", value_parser = picture)]
    shift_picture: Option<(PathBuf, Format)>,
    #[command(flatten)]
    paper: PaperArguments,
    /// JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// How moduli are shifted beside their rates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Vertical {
    /// Not at all
    #[default]
    None,
    /// By the least squares of the overlaps
    Fit,
    /// As for a rubber, by rho_0 T_0 / (rho T)
    Density,
}

fn expansion(text: &str) -> Result<f64, &'static str> {
    let known = text.parse().ok().filter(|it| VerticalShift::EXPANSION.contains(it));
    known.ok_or(VerticalShift::EXPANSION_ALLOWED)
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
    let mut formats = Format::value_variants().iter().copied();
    let format = formats.find(|format| extension.as_deref() == Some(format.extension()));
    format.map(|format| (path, format)).ok_or_else(|| "a file whose name ends in .svg, .png or .pdf".to_owned())
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
    check_options(arguments, &file)?;
    let factors = factors(arguments)?;
    let shifting = Shifting {
        factors: factors.as_ref(),
        reference: arguments.reference_temperature,
        vertical: match arguments.vertical_shift {
            Vertical::None => VerticalShift::None,
            Vertical::Fit => VerticalShift::Overlap,
            Vertical::Density => VerticalShift::Density { expansion: arguments.expansion.unwrap_or(0.0) },
        },
    };
    let refused = |source| CliError::MasterCurve { data: arguments.data.clone(), source };
    match file.data {
        MaterialData::Series(series) => {
            let curve = shifting.of_series().map_err(refused)?;
            converted(arguments, &series, curve.as_ref())
        }
        MaterialData::Moduli(moduli) => {
            fitted(arguments, &AtOneTemperature::of_moduli(moduli, &shifting).map_err(refused)?)
        }
        MaterialData::Isotherms(isotherms) => {
            fitted(arguments, &AtOneTemperature::of_isotherms(&isotherms, &shifting).map_err(refused)?)
        }
    }
}

/// Refuses options that say nothing of this file, or of what is done with it.
fn check_options(arguments: &Arguments, file: &MaterialFile) -> Result<(), CliError> {
    let unused = |option: &'static str, why: &str| Err(CliError::Unused { option, why: why.to_owned() });
    if arguments.terms.is_some() && matches!(file.data, MaterialData::Series(_)) {
        return unused("--terms", "a Prony series is converted and not fitted; leave it out");
    }
    if arguments.poisson_ratio.is_some() && !file.is_of_shear {
        let why = "moduli are taken for Young's; add --shear if they are shear moduli, or leave it out";
        return unused("--poisson-ratio", why);
    }
    if arguments.expansion.is_some() && arguments.vertical_shift != Vertical::Density {
        return unused("--expansion", "no density is known; add --vertical-shift density, or leave it out");
    }
    let is_drawn = arguments.output.is_some() || arguments.shift_picture.is_some();
    arguments.paper.check_drawn(is_drawn, "add -o FILE")
}

/// Prints a series as it stands in the file, and the law of the shift factors beside it.
fn converted(
    arguments: &Arguments,
    series: &PronySeries,
    master_curve: Option<&MasterCurve>,
) -> Result<Exit, CliError> {
    let refused = |source| CliError::Series { file: arguments.data.clone(), source };
    let relaxation = series.relaxation().map_err(refused)?;
    let name = name(arguments);
    let material = PronyMaterial { name: &name, series, relaxation: &relaxation, master_curve };
    finish(arguments, &material.table(), &material.json(), Drawn { chart: material.chart(), master_curve })
}

/// Fits a series to moduli and prints it.
fn fitted(arguments: &Arguments, measured: &AtOneTemperature) -> Result<Exit, CliError> {
    let refused = |source| CliError::Fit { data: arguments.data.clone(), source };
    let (fit, offered, choice) = match arguments.terms {
        Some(Terms::Number(terms)) => {
            (RelaxationFit::new(&measured.measurements, terms).map_err(refused)?, terms, None)
        }
        Some(Terms::Auto) | None => {
            let choice = TermChoice::new(&measured.measurements).map_err(refused)?;
            (choice.fit.clone(), choice.offered, Some(choice))
        }
    };
    let material = FittedMaterial {
        name: &name(arguments),
        measurements: &measured.measurements,
        fit: &fit,
        offered,
        choice: choice.as_ref(),
        master_curve: measured.master_curve.as_ref(),
    };
    let drawn = Drawn { chart: material.chart(), master_curve: measured.master_curve.as_ref() };
    finish(arguments, &material.table(), &material.json(), drawn)
}

/// The name of the file, for titles.
fn name(arguments: &Arguments) -> String {
    arguments.data.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Reads shift factors where they are given, and tells what was understood of them.
fn factors(arguments: &Arguments) -> Result<Option<ShiftFactors>, CliError> {
    let Some(file) = &arguments.shift_factors else { return Ok(None) };
    let (factors, understood) = ShiftFactors::read(file, &measured::all(&arguments.shift_columns))?;
    console::tell(understood.to_string().trim_end());
    Ok(Some(factors))
}

/// What pictures show of a material.
struct Drawn<'a> {
    chart: Chart,
    master_curve: Option<&'a MasterCurve>,
}

/// Prints a material and paints its pictures.
fn finish(arguments: &Arguments, table: &str, json: &str, drawn: Drawn<'_>) -> Result<Exit, CliError> {
    let mut charts = Vec::new();
    if let Some((file, format)) = &arguments.output {
        charts.push((file.clone(), *format, drawn.chart));
    }
    if let Some((file, format)) = &arguments.shift_picture {
        let curve = drawn.master_curve.ok_or_else(|| CliError::NoShifts { data: arguments.data.clone() })?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let beside = file.with_file_name(format!("{name}-residuals.{}", format.extension()));
        charts.push((file.clone(), *format, shifted::factor_chart(curve)));
        charts.push((beside, *format, shifted::residual_chart(curve)));
    }
    let inputs = arguments.shift_factors.iter().chain([&arguments.data]).map(PathBuf::as_path);
    let files = OutputFiles::new("material", inputs);
    let outputs = charts.iter().map(|(file, ..)| files.check(file, or_empty(is_picture)));
    let outputs = outputs.collect::<Result<Vec<OutputFile>, _>>()?;
    let mut text = if arguments.json { json.to_owned() } else { table.to_owned() };
    for (output, (file, format, chart)) in outputs.into_iter().zip(&mut charts) {
        arguments.paper.entitle(chart);
        output.write(&chart.paint(*format, &arguments.paper.paper(&[]))?)?;
        // What reads JSON gets nothing else.
        if !arguments.json {
            text += &format!("\n{}\n", shown(file));
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}
