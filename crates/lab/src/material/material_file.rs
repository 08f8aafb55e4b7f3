//! Files that describe a material, whatever wrote them.

use std::path::Path;

use super::material_table;
use super::{Isotherms, Measurements, ModulusKind, PronyFile, PronySeries};
use crate::Modulus;
use crate::table::{ColumnChoice, TableError, TableFile, bytes, decode};
use stribeck_input::{Fault, InputError, shown};

/// What a file is called in messages.
const KIND: &str = "file of a material";

/// What a user says of a file that the file does not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaterialOptions {
    /// True if moduli are shear moduli though their names do not say so.
    pub is_shear: bool,
    /// Poisson's ratio, which shear moduli need.
    pub poisson_ratio: Option<f64>,
    /// Pascals in the unit of moduli for which the file names none.
    pub modulus_unit: Option<f64>,
    /// What columns hold.
    pub columns: Vec<ColumnChoice>,
}

/// What a file says of a material. Moduli are Young's.
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
    /// True if its moduli were shear moduli, which Poisson's ratio made Young's.
    pub is_of_shear: bool,
    /// How it was understood, in lines for the user.
    pub understood: String,
}

/// Why a file describes no material.
#[derive(Debug, thiserror::Error)]
pub enum MaterialFileError {
    /// A table that is none of a material, or no file.
    #[error(transparent)]
    Table(#[from] TableError),
    /// An input file of a program without a series.
    #[error(transparent)]
    Series(#[from] InputError),
}

impl MaterialOptions {
    /// Young's modulus over moduli of a kind; all are shear moduli if the user says so.
    ///
    /// # Errors
    /// What to give, if Poisson's ratio is needed.
    pub(super) fn young_factor(&self, kind: ModulusKind) -> Result<f64, String> {
        let kind = if self.is_shear { ModulusKind::Shear } else { kind };
        match (kind, self.poisson_ratio) {
            (ModulusKind::Young, _) => Ok(1.0),
            (kind, Some(ratio)) => Ok(kind.young_factor(ratio)),
            (_, None) => Err("its moduli are shear moduli, and a substrate has Young's modulus, 2 (1 + nu) times as \
                              large; give Poisson's ratio (--poisson-ratio 0.5)"
                .to_owned()),
        }
    }

    /// Refuses what says nothing of a file of a finite-element program: nothing is left out in silence.
    ///
    /// # Errors
    /// What to leave out.
    fn go_with(&self, file: &PronyFile) -> Result<(), String> {
        let program = file.program;
        if self.is_shear {
            return Err(format!(
                "the modulus in an input file of {program} is Young's, and fractions of either modulus are the same; \
                 leave out --shear"
            ));
        }
        if self.modulus_unit.is_some() && file.modulus.is_none() {
            return Err(format!(
                "this input file of {program} holds no modulus; leave out its unit (--modulus-unit MPa)"
            ));
        }
        if !self.columns.is_empty() {
            let what = "has no columns; leave out --columns \"tau=#1\" and the like";
            return Err(format!("an input file of {program} {what}"));
        }
        Ok(())
    }
}

impl MaterialFile {
    /// Reads an input file of Abaqus or Ansys with a Prony series, or a table.
    ///
    /// # Errors
    /// [`MaterialFileError`] if the file cannot be read or describes no material.
    pub fn read(path: &Path, options: &MaterialOptions) -> Result<Self, MaterialFileError> {
        Self::of(path, &bytes(KIND, path)?, options)
    }

    /// The material in the bytes of a file.
    ///
    /// # Errors
    /// As [`MaterialFile::read`].
    pub fn of(path: &Path, bytes: &[u8], options: &MaterialOptions) -> Result<Self, MaterialFileError> {
        // what is no text may be a workbook
        if let Ok(decoded) = decode(bytes) {
            let located = |fault: Fault| fault.located(&shown(path), &decoded.text);
            if let Some(file) = PronyFile::interpret(&decoded.text).map_err(located)? {
                options.go_with(&file).map_err(|what| TableError::NotATable { path: path.to_owned(), what })?;
                return Ok(Self::of_series(path, file, options.modulus_unit));
            }
        }
        Ok(material_table::read(&TableFile::of(path, bytes)?, options)?)
    }

    fn of_series(path: &Path, file: PronyFile, unit: Option<f64>) -> Self {
        let (path, program) = (shown(path), file.program);
        let mut understood =
            format!("{path}: a Prony series of {program}, fractions of the modulus at once; times in s\n");
        for note in &file.notes {
            understood += &format!("  note: {note}\n");
        }
        let series = match (file.modulus, unit) {
            (Some(_), Some(unit)) => file.with_modulus_in(unit),
            (Some(modulus), None) => {
                let (which, value) = match modulus {
                    Modulus::Relaxed(value) => ("relaxed", value),
                    Modulus::Instantaneous(value) => ("instantaneous", value),
                };
                understood += &format!(
                    "  note: its {which} modulus, {value}, has no unit there and is left out; give the unit of moduli, MPa say\n"
                );
                file.series
            }
            (None, _) => file.series,
        };
        Self { data: MaterialData::Series(series), is_of_shear: false, understood }
    }
}
