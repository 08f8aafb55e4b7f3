//! Files that describe a material, whatever wrote them.

use std::path::Path;

use super::{Isotherms, Measurements, PronyFile, PronySeries};
use crate::Modulus;
use stribeck_input::{Fault, InputError};

/// What kind of file it is.
const KIND: &str = "table of measurements";

/// What a user says of a file that the file does not.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MaterialOptions {
    /// Poisson's ratio, if the moduli are shear moduli.
    pub shear_with: Option<f64>,
    /// Pascals in the unit of moduli for which the file names none.
    pub modulus_unit: Option<f64>,
}

/// What a file says of a material.
#[derive(Clone, Debug, PartialEq)]
pub enum MaterialData {
    /// A Prony series.
    Series(PronySeries),
    /// Moduli, of which no temperature is told.
    Moduli(Measurements),
    /// Moduli at temperatures.
    Isotherms(Isotherms),
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialFile {
    /// Its content.
    pub data: MaterialData,
    /// How it was understood, in lines for the user.
    pub read: Vec<String>,
}

impl MaterialFile {
    /// Reads an input file of Abaqus or Ansys with a Prony series, or a table.
    ///
    /// # Errors
    /// [`InputError`] with the place if the file cannot be read or describes no material.
    pub fn read(path: &Path, options: &MaterialOptions) -> Result<Self, InputError> {
        stribeck_input::read(KIND, path, |_, text| match PronyFile::interpret(text)? {
            Some(file) => Ok(Self::of_series(file, options)),
            None => Self::of_table(text, options),
        })
    }

    fn of_series(file: PronyFile, options: &MaterialOptions) -> Self {
        let mut read =
            vec![format!("a Prony series of {}; fractions of the instantaneous modulus, times in s", file.program)];
        read.extend(file.notes.iter().map(|note| format!("  note: {note}")));
        let series = match (file.modulus, options.modulus_unit) {
            (Some(_), Some(unit)) => file.with_modulus_in(unit),
            (Some(Modulus::Relaxed(value) | Modulus::Instantaneous(value)), None) => {
                let which = if matches!(file.modulus, Some(Modulus::Relaxed(_))) { "relaxed" } else { "instantaneous" };
                read.push(format!(
                    "  note: its {which} modulus, {value}, has no unit there and is left out; give it (--modulus-unit MPa)"
                ));
                file.series
            }
            (None, _) => file.series,
        };
        Self { data: MaterialData::Series(series), read }
    }

    fn of_table(text: &str, options: &MaterialOptions) -> Result<Self, Fault> {
        let measurements = Measurements::interpret(text)?;
        let factor = options.shear_with.map_or(1.0, |ratio| super::ModulusKind::Shear.young_factor(ratio));
        Ok(Self { data: MaterialData::Moduli(measurements.stiffer(factor)), read: Vec::new() })
    }
}
