//! Measured friction: to be laid over solutions, and to be fitted.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `fields` | the columns that friction, its error and quantities of the laboratory may stand in |
//! | `reading` | from the tables of a file to points |
//! | `motion` | speeds that instruments write in several forms |
//! | `repeated` | readings at one place, as one point |

mod fields;
mod motion;
mod reading;
mod repeated;

use std::path::{Path, PathBuf};

use crate::table::{ColumnChoice, TableError, TableFile, Understood};
use crate::{Experiment, LaboratoryQuantity};
use stribeck_input::shown;

/// What a file of measured points is called in messages.
const KIND: &str = "measured points";

/// Measured points: a friction coefficient and where it was measured, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The files, for messages.
    pub files: Vec<PathBuf>,
    /// The column of the results that the friction coefficients are compared with.
    pub column: &'static str,
    /// The friction coefficients.
    pub friction: Vec<f64>,
    /// Their standard errors, if they are known.
    pub errors: Option<Vec<f64>>,
    /// Where each point stands: the place of its file in the list, and its line there, from 1.
    pub places: Vec<(usize, u64)>,
    /// Names of the columns that say where a point belongs, each with a value for each point.
    pub coordinates: Vec<(&'static str, Vec<f64>)>,
    /// True if each point is the mean of readings, and its standard error that of the mean.
    pub is_averaged: bool,
    /// True if this program wrote the file: its quantities of the laboratory are those of a computation.
    pub is_computed: bool,
    /// The coordinates whose columns name no unit, with the names of these columns.
    pub without_unit: Vec<(&'static str, String)>,
}

impl Measured {
    /// Reads a table of measured points, and says what was understood of it.
    ///
    /// Columns: one friction coefficient (`mu` or `mu_drag`, what a load cell reads; or the part of it or the paper's
    /// total that the file holds instead, `mu_tot`, `mu_v`, `mu_h`), its standard error `error` if
    /// it is known, and where it was measured: `speed`, `load` and the other names of `[laboratory]`, in SI units or
    /// with the unit behind the name as in `speed (mm/s)`; `f`, `alpha` and `beta` beside dimensionless results. Names
    /// that instruments write for these are known, too; choices say what else a column holds. A `speed` or
    /// `roller_speed` in turns, as in `speed (rpm)`, is multiplied by the radius of the cylinder: the column `radius`, or
    /// else the one that is given (m).
    ///
    /// # Errors
    /// [`TableError`] if the file cannot be read, a column is missing or there twice, or a value is not allowed; if
    /// speeds are in turns, and no radius is known.
    pub fn read(path: &Path, choices: &[ColumnChoice], radius: Option<f64>) -> Result<(Self, Understood), TableError> {
        let file = TableFile::read(KIND, path)?;
        reading::points(&file, choices, radius)
    }

    /// The points in the bytes of a file, likewise.
    ///
    /// # Errors
    /// As [`Measured::read`].
    pub fn of(
        path: &Path,
        bytes: &[u8],
        choices: &[ColumnChoice],
        radius: Option<f64>,
    ) -> Result<(Self, Understood), TableError> {
        reading::points(&TableFile::of(path, bytes)?, choices, radius)
    }

    /// The points of several files together.
    ///
    /// # Errors
    /// What one of the files has and another has not.
    pub fn join(parts: impl IntoIterator<Item = Self>) -> Result<Self, String> {
        let mut parts = parts.into_iter();
        let mut whole = parts.next().ok_or_else(|| "there is no file of measured points".to_owned())?;
        for part in parts {
            let differ = |what: &str| Err(format!("{} and {} {what}", shown(&whole.files[0]), shown(&part.files[0])));
            let names = |it: &Self| it.coordinates.iter().map(|(name, _)| *name).collect::<Vec<_>>();
            let sorted = |mut names: Vec<&'static str>| {
                names.sort_unstable();
                names
            };
            if sorted(names(&whole)) != sorted(names(&part)) {
                let (one, other) = (names(&whole).join(", "), names(&part).join(", "));
                return differ(&format!("have other columns ({one}; {other}); give both the same"));
            }
            if whole.column != part.column {
                return differ(&format!("hold {} and {}; fit them one by one", whole.column, part.column));
            }
            match (&mut whole.errors, &part.errors) {
                (Some(errors), Some(others)) => errors.extend(others),
                (None, None) => {}
                _ => return differ("have standard errors in one of them alone; give both a column `error`, or none"),
            }
            let before = whole.files.len();
            whole.places.extend(part.places.iter().map(|(file, line)| (file + before, *line)));
            for (name, values) in &mut whole.coordinates {
                values.extend(part.coordinate(name).expect("both have the same columns"));
            }
            whole.friction.extend(part.friction);
            whole.files.extend(part.files);
            whole.is_computed &= part.is_computed;
            whole.is_averaged &= part.is_averaged;
        }
        Ok(whole)
    }

    /// Where a point stands, in words.
    pub fn place(&self, point: usize) -> String {
        let (file, line) = self.places[point];
        if self.files.len() == 1 {
            format!("line {line}")
        } else {
            format!("line {line} of {}", shown(&self.files[file]))
        }
    }

    /// True if a point was measured at the quantities of an experiment, the speed along which curves run apart, as far
    /// as the file has them.
    pub fn belongs_to(&self, point: usize, experiment: &Experiment) -> bool {
        let along = experiment.motion.along().0.name();
        self.coordinates.iter().filter(|(name, _)| *name != along).all(|(name, values)| {
            let own = match LaboratoryQuantity::named(name) {
                // an experiment without one is at any temperature
                Some(LaboratoryQuantity::Temperature) if experiment.temperature.is_none() => return true,
                Some(quantity) => experiment.value(quantity),
                None if *name == "f" => experiment.f,
                // these change with the speed
                None => return true,
            };
            Self::is_same(values[point], own)
        })
    }

    /// True for values that differ by less than 1 %.
    pub fn is_same(one: f64, other: f64) -> bool {
        one == other || (one / other).ln().abs() < 0.01
    }

    /// True if residuals are those of the logarithms: where the file has no standard errors of its own, as friction
    /// scatters in proportion to its size. A mean that is not above 0 has no logarithm.
    pub fn is_logarithmic(&self) -> bool {
        self.errors.is_none() || (self.is_averaged && self.friction.iter().all(|mu| *mu > 0.0))
    }

    /// What each residual is multiplied with: 1/σᵢ for μ − μᵢ, or μᵢ/σᵢ for ln(μ/μᵢ), and 1 without standard errors.
    pub(crate) fn weights(&self) -> Vec<f64> {
        let of = |(mu, error): (&f64, &f64)| if self.is_logarithmic() { mu / error } else { 1.0 / error };
        match &self.errors {
            Some(errors) => self.friction.iter().zip(errors).map(of).collect(),
            None => vec![1.0; self.friction.len()],
        }
    }

    /// The difference of a friction coefficient from that of a point, or of their logarithms.
    pub(crate) fn difference(&self, point: usize, friction: f64) -> f64 {
        let measured = self.friction[point];
        if self.is_logarithmic() { (friction / measured).ln() } else { friction - measured }
    }

    /// Leaves out the columns of these names.
    pub fn without(mut self, is_left_out: impl Fn(&str) -> bool) -> Self {
        self.coordinates.retain(|(name, _)| !is_left_out(name));
        self
    }

    /// The values of a coordinate, if the file has it.
    pub fn coordinate(&self, name: &str) -> Option<&[f64]> {
        self.coordinates.iter().find(|(known, _)| *known == name).map(|(_, values)| values.as_slice())
    }
}
