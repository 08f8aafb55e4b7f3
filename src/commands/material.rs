//! `stribeck material`: a substrate from measured moduli.

use std::path::PathBuf;

use clap::Args;

use super::fitted_material::FittedMaterial;
use super::{CliError, Exit, console};
use crate::pictures::Format;
use stribeck_input::shown;
use stribeck_lab::{Measurements, RelaxationFit};
use stribeck_sweep::store::write_whole;

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck material rubber.csv --terms 12               the fit, and the lines for a sweep file
  stribeck material rubber.csv --terms 12 -o fit.svg    with a picture of it
  stribeck material rubber.csv --terms 12 --json

The table has columns omega (rad/s) or frequency (Hz), storage and loss (both Pa). Times of the terms are spread over the
measured range; those that the data do not ask for are dropped. docs/materials.md has more.")]
pub struct Arguments {
    /// A table of measured moduli (CSV)
    #[arg(value_name = "DATA")]
    data: PathBuf,
    /// Relaxation terms that are offered to the fit, from 1 to 100
    #[arg(long, value_name = "N")]
    terms: usize,
    /// A picture of measurements and fit, SVG or PNG by its extension
    #[arg(short, long, value_name = "FILE", value_parser = picture)]
    output: Option<(PathBuf, Format)>,
    /// JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// A file whose name tells its format.
fn picture(text: &str) -> Result<(PathBuf, Format), String> {
    let path = PathBuf::from(text);
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let format = [Format::Svg, Format::Png].into_iter().find(|format| extension.as_deref() == Some(format.extension()));
    format.map(|format| (path, format)).ok_or_else(|| "a file whose name ends in .svg or .png".to_owned())
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let measurements = Measurements::read(&arguments.data)?;
    let fit = RelaxationFit::new(&measurements, arguments.terms)
        .map_err(|source| CliError::Fit { data: arguments.data.clone(), source })?;
    let name = arguments.data.file_stem().unwrap_or_default().to_string_lossy();
    let fitted = FittedMaterial { name: &name, measurements: &measurements, fit: &fit, offered: arguments.terms };
    let mut text = if arguments.json { fitted.json() } else { fitted.table() };
    if let Some((file, format)) = &arguments.output {
        write_whole(file.clone(), &fitted.chart().paint(*format)?)?;
        // What reads JSON gets nothing else.
        if !arguments.json {
            text += &format!("\n{}\n", shown(file));
        }
    }
    console::print(&text)?;
    Ok(Exit::Success)
}
