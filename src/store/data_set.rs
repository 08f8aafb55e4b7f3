//! `results.h5` read back, for pictures and pages.

use std::fs::File;
use std::path::{Path, PathBuf};

use hdf5::Dataset;
use hdf5::types::{FixedAscii, VarLenUnicode};
use ndarray::s;

use super::contents::FIELDS;
use super::directory::{Directory, PUBLISHED};
use super::hdf5_file::{get_text, open};
use super::holdings::{Inspection, LogContent, fault, read_claims};
use super::{Status, StoreError};

/// A published data set. Numbers are read when they are asked for, so that memory does not depend on the size of the fields.
///
/// A *place* is a point of the grid over (f, α, β); places are counted in the order of the plan, β fastest.
#[derive(Debug)]
pub struct DataSet {
    path: PathBuf,
    file: hdf5::File,
    directory: Directory,
    /// Title of the sweep.
    pub title: String,
    /// The sweep file, whole.
    pub sweep_text: String,
    /// Version of the program that wrote the file.
    pub version: String,
    /// True if cases were stored after the file was published.
    pub outdated: bool,
    /// Values of f, ascending.
    pub f: Vec<f64>,
    /// Values of α, ascending; the last may be +∞.
    pub alpha: Vec<f64>,
    /// Values of β, ascending.
    pub beta: Vec<f64>,
    /// Where the fields are given, ascending, over a₀; empty if there are none.
    pub x: Vec<f64>,
    /// Names of the fields that are there.
    pub fields: Vec<&'static str>,
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
    /// Where the log is there, every byte is compared with its record before the HDF5 library sees it. A directory that has
    /// only the published files, as they are passed on to others, is read as it is.
    ///
    /// # Errors
    /// [`StoreError::Unpublished`] if nothing is published there, [`StoreError::Altered`] if it is not as it was written,
    /// others if it cannot be read.
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
            let LogContent { published, history, .. } = read_claims(&directory)?;
            outdated = history.unpublished;
            for record in published.iter().flat_map(|last| &last.files).filter(|record| record.file == PUBLISHED[0]) {
                if let Some(what) = fault(&results, record, Inspection::Bytes)? {
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
        let fields: Vec<&'static str> =
            FIELDS.iter().map(|field| field.name).filter(|name| file.link_exists(name)).collect();
        Ok(Self {
            title: get_text(&file, "title")?,
            sweep_text: get_text(&file, "sweep")?,
            version: get_text(&file, "stribeck_version")?,
            outdated,
            f: axis("f")?,
            alpha: axis("alpha")?,
            beta: axis("beta")?,
            x: if fields.is_empty() { Vec::new() } else { axis("x")? },
            fields,
            path: path.to_owned(),
            directory,
            file,
        })
    }

    /// The directory that was opened.
    pub fn directory(&self) -> &Path {
        self.directory.root()
    }

    /// Numbers of values of f, α and β.
    pub fn shape(&self) -> [usize; 3] {
        [self.f.len(), self.alpha.len(), self.beta.len()]
    }

    /// The place with these indices on the axes f, α and β.
    pub fn place(&self, [i_f, i_alpha, i_beta]: [usize; 3]) -> usize {
        (i_f * self.alpha.len() + i_alpha) * self.beta.len() + i_beta
    }

    /// The values of a column, one for each place; NaN where there is none.
    ///
    /// # Errors
    /// [`StoreError`] if the file has no such column or cannot be read.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, StoreError> {
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
            Ok(variable.read_raw::<FixedAscii<16>>()?.iter().map(|case| case.as_str().to_owned()).collect())
        })
    }

    /// A field on [`DataSet::x`] at the indices of f, α and β; NaN where the case failed.
    ///
    /// # Errors
    /// [`StoreError`] if the file has no such field or cannot be read.
    pub fn field(&self, name: &str, [i_f, i_alpha, i_beta]: [usize; 3]) -> Result<Vec<f64>, StoreError> {
        let values: Vec<f64> =
            self.variable(name, |variable| Ok(variable.read_slice_1d(s![i_f, i_alpha, i_beta, ..])?.to_vec()))?;
        self.expect_length(name, values.len(), self.x.len())?;
        Ok(values)
    }

    /// What each place cost; `None` if `timings.csv` is not there.
    ///
    /// # Errors
    /// [`StoreError`] if it is there and cannot be read, or is not of the cases of this data set.
    pub fn costs(&self) -> Result<Option<Vec<Cost>>, StoreError> {
        let path = self.directory.published(PUBLISHED[2]);
        let file = match File::open(&path) {
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
        let values = self.variable(name, read)?;
        self.expect_length(name, values.len(), self.shape().iter().product())?;
        Ok(values)
    }

    fn expect_length(&self, name: &str, found: usize, wanted: usize) -> Result<(), StoreError> {
        if found == wanted {
            return Ok(());
        }
        let what = format!("{name} has {found} values, its axes ask for {wanted}");
        Err(StoreError::Altered { path: self.path.clone(), what, sweep: self.directory.sweep() })
    }

    fn variable<T>(&self, name: &str, read: impl FnOnce(&Dataset) -> hdf5::Result<T>) -> Result<T, StoreError> {
        self.file.dataset(name).and_then(|variable| read(&variable)).map_err(StoreError::hdf5(&self.path, "read"))
    }
}
