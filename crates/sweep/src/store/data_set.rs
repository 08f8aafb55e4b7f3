//! `results.h5` read back, for pictures and pages.

use std::path::{Path, PathBuf};

use hdf5::types::{FixedAscii, TypeDescriptor, VarLenUnicode};
use hdf5::{Dataset, Hyperslab, SliceOrIndex};

use super::claims::{Inspection, LogContent, fault, read_claims};
use super::directory::{Directory, PUBLISHED};
use super::files::open_file;
use super::further_columns::AVERAGES;
use super::hdf5_file::{get_text, open};
use super::results::{DIMENSIONS, PARTIAL};
use super::{Status, StoreError};
use crate::grid_index::indices;
use crate::{Column, Dimension, Field, GridIndex, GridShape};
use stribeck_lab::LaboratoryQuantity;

/// A published data set. Numbers are read when they are asked for, so that memory does not depend on the size of the
/// fields.
///
/// A *place* is a point of the grid ([`GridIndex`]). Places are counted in the order of the plan, as [`GridShape`]
/// does.
#[derive(Debug)]
pub struct DataSet {
    path: PathBuf,
    file: hdf5::File,
    directory: Directory,
    /// Files of earlier versions have none.
    has_notes: bool,
    /// In the order of `fields`. They stay open: what is unpacked of one is forgotten when it is closed.
    field_variables: Vec<Dataset>,
    /// Title of the sweep.
    pub title: String,
    /// The sweep file, whole.
    pub sweep_text: String,
    /// Version of the program that wrote the file.
    pub version: String,
    /// True if cases were stored after the file was published.
    pub outdated: bool,
    /// How many places are not solved yet, in words, of a partial publication.
    pub partial: Option<String>,
    /// The dimensions but x, in their order: f, α and β, or f, quantities of the laboratory and the speed.
    pub dimensions: Vec<Dimension>,
    /// True if numbers are in SI units and quantities of the laboratory given.
    pub laboratory: bool,
    /// True if bodies were swapped, and the averages over both runs are columns.
    pub is_swapped: bool,
    /// The quantities of the laboratory that are no dimension, by their names.
    pub fixed: Vec<(String, f64)>,
    /// Where the fields are given, ascending, over a₀; empty if there are none.
    pub x: Vec<f64>,
    /// The fields that are there, in their order.
    pub fields: Vec<Field>,
}

/// What a place of the grid cost, from `timings.csv`.
#[derive(Clone, Debug, PartialEq, serde::Deserialize)]
pub struct Cost {
    /// Id of the case.
    pub case: String,
    /// Wall-clock time of the case on its thread.
    pub seconds: f64,
    /// Newton iterations or passes.
    pub iterations: u64,
    /// Matrix factorisations.
    pub factorisations: u64,
    /// Where the first guess came from.
    pub seed: String,
}

impl DataSet {
    /// Opens the data set of a results directory.
    ///
    /// Where the log is there, every byte is compared with its record before the HDF5 library sees it. A directory that
    /// has only the published files, as they are passed on to others, is read as it is.
    ///
    /// # Errors
    /// [`StoreError::Unpublished`] if nothing is published there, [`StoreError::Altered`] if it is not as it was
    /// written, others if it cannot be read.
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let directory = Directory::new(path);
        if !path.is_dir() {
            return Err(StoreError::NotResults { path: path.to_owned(), what: "there is no such directory" });
        }
        let results = directory.published(PUBLISHED[0]);
        if !results.exists() {
            return Err(StoreError::Unpublished { path: path.to_owned(), sweep: directory.sweep() });
        }
        let mut outdated = false;
        if directory.logs().is_dir() {
            let LogContent { published, history, warnings, .. } = read_claims(&directory)?;
            outdated = history.unpublished;
            for record in published.iter().flat_map(|last| &last.files).filter(|record| record.file == PUBLISHED[0]) {
                if let Some(what) = fault(&results, record, Inspection::Bytes) {
                    // Its newest record may be in what cannot be read of the log.
                    let what = warnings.first().map_or_else(|| what.clone(), |warning| format!("{what} ({warning})"));
                    return Err(StoreError::Altered { path: results, what, sweep: directory.sweep() });
                }
            }
        }
        Self::read(&results, directory, outdated).map_err(StoreError::hdf5(&results, "read"))
    }

    fn read(path: &Path, directory: Directory, outdated: bool) -> hdf5::Result<Self> {
        let file = open(path)?;
        let axis = |name: &str| -> hdf5::Result<Vec<f64>> {
            let values = file.dataset(name)?.read_raw::<f64>()?;
            if values.is_empty() { Err(format!("its axis {name} is empty").into()) } else { Ok(values) }
        };
        // Asked for once: a single question for a name takes an error of the disk for a no.
        let held = file.member_names()?;
        let has = |name: &str| held.iter().any(|held| held == name);
        let attributes = file.attr_names()?;
        let is_marked = |mark: &str| attributes.iter().any(|name| name == mark);
        let laboratory = is_marked(DIMENSIONS);
        let partial = is_marked(PARTIAL).then(|| get_text(&file, PARTIAL)).transpose()?;
        let names = match laboratory {
            true => get_text(&file, DIMENSIONS)?,
            false if has(Dimension::SLIDE_ROLL) => format!("{} f alpha beta", Dimension::SLIDE_ROLL),
            false => "f alpha beta".to_owned(),
        };
        let dimension = |name: &str| -> hdf5::Result<Dimension> {
            let (values, variable) = (axis(name)?, file.dataset(name)?);
            let [units, long_name] = [get_text(&variable, "units")?, get_text(&variable, "long_name")?];
            Ok(Dimension { name: name.to_owned(), units, long_name, values })
        };
        let dimensions: Vec<Dimension> = names.split_whitespace().map(dimension).collect::<hdf5::Result<_>>()?;
        check_dimensions(&dimensions, laboratory)?;
        let mut fixed = Vec::new();
        if laboratory {
            let is_dimension = |name: &str| dimensions.iter().any(|dimension| dimension.name == name);
            let names = LaboratoryQuantity::ALL.map(LaboratoryQuantity::name).into_iter();
            for name in names.filter(|name| !is_dimension(name) && has(name)) {
                fixed.push((name.to_owned(), file.dataset(name)?.read_scalar::<f64>()?));
            }
        }
        let fields: Vec<Field> = Field::ALL.into_iter().filter(|field| has(field.name())).collect();
        let field_variables = fields.iter().map(|field| file.dataset(field.name())).collect::<hdf5::Result<_>>()?;
        Ok(Self {
            title: get_text(&file, "title")?,
            sweep_text: get_text(&file, "sweep")?,
            version: get_text(&file, "stribeck_version")?,
            outdated,
            partial,
            dimensions,
            laboratory,
            is_swapped: has(AVERAGES[0].name),
            fixed,
            x: if fields.is_empty() { Vec::new() } else { axis("x")? },
            fields,
            field_variables,
            has_notes: has("notes"),
            path: path.to_owned(),
            directory,
            file,
        })
    }

    /// The directory that was opened.
    pub fn directory(&self) -> &Path {
        self.directory.root()
    }

    /// The lengths of the grid.
    pub fn shape(&self) -> GridShape {
        let lengths: Vec<usize> = self.dimensions.iter().map(|dimension| dimension.values.len()).collect();
        let (blocks, [rows @ .., length]) = lengths.split_at(self.outer()) else {
            unreachable!("there are at least two dimensions")
        };
        GridShape { blocks: blocks.iter().product(), rows: rows.iter().product(), length: *length }
    }

    /// How many dimensions make a block of rows: f, behind the slide-to-roll ratio where that is a dimension.
    pub fn outer(&self) -> usize {
        1 + usize::from(self.dimensions[0].name == Dimension::SLIDE_ROLL)
    }

    /// The number of the place with these indices.
    pub fn place(&self, index: impl Into<GridIndex>) -> usize {
        self.shape().place(index.into())
    }

    /// The indices of a place on all dimensions.
    pub fn indices(&self, index: impl Into<GridIndex>) -> Vec<usize> {
        indices(self.dimensions.iter().map(|dimension| dimension.values.len()), self.place(index))
    }

    /// f, α and β of every place, in SI data sets as they follow from the quantities there.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn numbers(&self) -> Result<Vec<[f64; 3]>, StoreError> {
        let shape = self.shape();
        let outer = self.outer();
        let f = &self.dimensions[outer - 1].values;
        let f = |index: GridIndex| f[index.block % f.len()];
        let places = (0..shape.places()).map(|place| (place, shape.index(place)));
        if self.laboratory {
            let (alpha, beta) = (self.variable("alpha")?, self.variable("beta")?);
            return Ok(places.map(|(place, index)| [f(index), alpha[place], beta[place]]).collect());
        }
        let (alpha, beta) = (&self.dimensions[outer].values, &self.dimensions[outer + 1].values);
        Ok(places.map(|(_, index)| [f(index), alpha[index.row], beta[index.along]]).collect())
    }

    /// The values of a column, one for each place; NaN where there is none.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn column(&self, column: Column) -> Result<Vec<f64>, StoreError> {
        self.variable(column.name())
    }

    /// Whether the roller is viscoelastic somewhere: not all of the hysteresis is that of the flat.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn has_hysteresis_of_roller(&self) -> Result<bool, StoreError> {
        let (all, flat) = (self.column(Column::MuV)?, self.column(Column::MuVFlat)?);
        Ok(all.iter().zip(&flat).any(|(all, flat)| (all - flat).abs() > 1e-9 * all.abs()))
    }

    /// The values of a variable of numbers that is no column, one for each place: of the laboratory's `alpha`, `beta`
    /// and scales, or a sensitivity.
    ///
    /// # Errors
    /// [`StoreError`] if the file has no such variable or cannot be read.
    pub fn variable(&self, name: &str) -> Result<Vec<f64>, StoreError> {
        self.on_grid(name, |variable| variable.read_raw())
    }

    /// What became of each place.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read or has an unknown status.
    pub fn statuses(&self) -> Result<Vec<Status>, StoreError> {
        self.on_grid("status", |variable| {
            let known = |code| {
                Status::from_code(code)
                    .ok_or_else(|| hdf5::Error::Internal(format!("it has the unknown status {code}")))
            };
            variable.read_raw::<i8>()?.into_iter().map(known).collect()
        })
    }

    /// The notes on each place, by the [masks](crate::Note::mask) of those that hold.
    ///
    /// `None` in files of earlier versions.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn notes(&self) -> Result<Option<Vec<i32>>, StoreError> {
        match self.has_notes {
            true => self.on_grid("notes", |variable| variable.read_raw()).map(Some),
            false => Ok(None),
        }
    }

    /// Why each place failed; empty where it converged.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn reasons(&self) -> Result<Vec<String>, StoreError> {
        self.on_grid("reason", |variable| {
            Ok(variable.read_raw::<VarLenUnicode>()?.iter().map(|reason| reason.as_str().to_owned()).collect())
        })
    }

    /// The id of the case at each place.
    ///
    /// # Errors
    /// [`StoreError`] if the file cannot be read.
    pub fn cases(&self) -> Result<Vec<String>, StoreError> {
        self.on_grid("case", |variable| {
            // Files of earlier versions have texts of a fixed length.
            if variable.dtype()?.to_descriptor()? == TypeDescriptor::FixedAscii(16) {
                return Ok(variable.read_raw::<FixedAscii<16>>()?.iter().map(ToString::to_string).collect());
            }
            Ok(variable.read_raw::<VarLenUnicode>()?.iter().map(ToString::to_string).collect())
        })
    }

    /// A field on [`DataSet::x`] at the indices of a place; NaN where the case failed.
    ///
    /// # Errors
    /// [`StoreError`] if the file has no such field or cannot be read.
    pub fn field(&self, field: Field, index: impl Into<GridIndex>) -> Result<Vec<f64>, StoreError> {
        let all = SliceOrIndex::SliceCount { start: 0, step: 1, count: self.x.len(), block: 1 };
        let indices = self.indices(index).into_iter().map(SliceOrIndex::Index);
        let selection: Vec<SliceOrIndex> = indices.chain([all]).collect();
        let values: Vec<f64> = match self.fields.iter().position(|&held| held == field) {
            Some(i) => self.field_variables[i].read_slice_1d(Hyperslab::from(selection)).map(|values| values.to_vec()),
            None => Err(format!("there is no field {}", field.name()).into()),
        }
        .map_err(StoreError::hdf5(&self.path, "read"))?;
        self.expect_length(field.name(), values.len(), self.x.len())?;
        Ok(values)
    }

    /// What each place cost; `None` if `timings.csv` is not there.
    ///
    /// # Errors
    /// [`StoreError`] if it is there and cannot be read, or is not of the cases of this data set.
    pub fn costs(&self) -> Result<Option<Vec<Cost>>, StoreError> {
        let path = self.directory.published(PUBLISHED[2]);
        let file = match open_file(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(StoreError::file(&path, "open")(error)),
        };
        let altered = |what: String| StoreError::Altered { path: path.clone(), what, sweep: self.directory.sweep() };
        let rows = csv::Reader::from_reader(file).into_deserialize().collect::<Result<Vec<Cost>, _>>();
        let costs = rows.map_err(|error| altered(error.to_string()))?;
        if !costs.iter().map(|cost| &cost.case).eq(&self.cases()?) {
            return Err(altered("its cases are not those of results.h5".to_owned()));
        }
        Ok(Some(costs))
    }

    /// A variable with one value for each place. A file that was passed on without its log may be anyone's.
    fn on_grid<T>(
        &self,
        name: &str,
        read: impl FnOnce(&Dataset) -> hdf5::Result<Vec<T>>,
    ) -> Result<Vec<T>, StoreError> {
        let values = self.read_variable(name, read)?;
        self.expect_length(name, values.len(), self.shape().places())?;
        Ok(values)
    }

    fn expect_length(&self, name: &str, found: usize, wanted: usize) -> Result<(), StoreError> {
        if found == wanted {
            return Ok(());
        }
        let what = format!("{name} has {found} values, its axes ask for {wanted}");
        Err(StoreError::Altered { path: self.path.clone(), what, sweep: self.directory.sweep() })
    }

    fn read_variable<T>(&self, name: &str, read: impl FnOnce(&Dataset) -> hdf5::Result<T>) -> Result<T, StoreError> {
        self.file.dataset(name).and_then(|variable| read(&variable)).map_err(StoreError::hdf5(&self.path, "read"))
    }
}

/// Most places of a data set: more are none that this program has written.
const MOST_PLACES: usize = 1_000_000_000;

/// Checks that dimensions are some that this program writes: a file that was passed on may be anyone's.
fn check_dimensions(dimensions: &[Dimension], laboratory: bool) -> hdf5::Result<()> {
    let refuse = |what: String| Err(hdf5::Error::Internal(what));
    if laboratory {
        let is_quantity = |dimension: &Dimension| LaboratoryQuantity::named(&dimension.name).is_some();
        let (first, rest) = (dimensions.first().map(|it| it.name.as_str()), dimensions.get(1..).unwrap_or_default());
        let repeated = rest.iter().enumerate().any(|(i, one)| rest[..i].iter().any(|other| other.name == one.name));
        let last = rest.last().map(|it| it.name.as_str());
        let runs_along = ["speed", "entrainment_speed", "flat_speed"];
        let ends_well = last.is_some_and(|last| runs_along.contains(&last));
        if first != Some("f") || !ends_well || repeated || !rest.iter().all(is_quantity) {
            return refuse("its dimensions are not f, quantities of the laboratory and a speed".to_owned());
        }
    }
    for Dimension { name, values, .. } in dimensions {
        let least = match name.as_str() {
            Dimension::SLIDE_ROLL => -1.0,
            name if name == LaboratoryQuantity::SlideRollRatio.name() => -2.0,
            _ => 0.0,
        };
        let ascends = values.is_sorted_by(|a, b| a < b) && values[0] >= least;
        if !ascends {
            return refuse(format!("its axis {name} does not ascend from {least} or above"));
        }
    }
    let places = dimensions.iter().try_fold(1_usize, |places, it| places.checked_mul(it.values.len()));
    match places.filter(|places| *places <= MOST_PLACES) {
        Some(_) => Ok(()),
        None => refuse("its axes have more places than a sweep may have".to_owned()),
    }
}
