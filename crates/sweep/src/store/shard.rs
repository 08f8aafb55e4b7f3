//! A shard: the cases that were committed together, in one immutable HDF5 file.

use std::path::{Path, PathBuf};

use hdf5::Result;
use hdf5::types::{FixedAscii, VarLenUnicode};
use ndarray::{Array2, ArrayView2};

use super::chunks::Chunks;
use super::contents::{column_names, x_key};
use super::files::hash_file;
use super::hdf5_file::{DEFLATE, NewFile, get_text, open, text};
use super::packed::Packed;
use super::{CaseEntry, Contents, PackedCase, Status, StoreError};
use crate::{CaseId, Column, Field, Values};
use stribeck_solver::{Fields, Sensitivities};

/// A case id in an HDF5 file: 16 characters.
pub(super) type CaseText = FixedAscii<16>;

/// Numbers of the sensitivities of a case, and how many of them the cases of a shard without a soft roller have.
const SENSITIVITIES: [usize; 2] = [20, Sensitivities::OF_FLAT];

/// The characters of a case id.
pub(super) fn case_text(id: CaseId) -> CaseText {
    CaseText::from_ascii(&id.to_string()).expect("a case id is 16 hexadecimal digits")
}

/// Hexadecimal digits in the name of a shard.
pub(super) const SHARD_DIGITS: usize = 32;

/// The name of a new shard with these bytes in a directory: it follows from the bytes, so that no shard ever takes the
/// place of another one. Where a damaged file has the name, or one that cannot be read, the name is the next one.
pub(super) fn shard_name(directory: &Path, hash: &blake3::Hash) -> String {
    let mut digest = *hash;
    loop {
        let mut name = digest.to_hex().to_string();
        name.truncate(SHARD_DIGITS);
        name += ".h5";
        let path = directory.join(&name);
        if path.symlink_metadata().is_err() || hash_file(&path).is_ok_and(|(_, found)| found == *hash) {
            return name;
        }
        digest = blake3::hash(digest.as_bytes());
    }
}

/// Writes a shard. The entries must have been checked: a converged one has each field asked for on all of `x`.
pub(super) fn write_shard(path: &Path, contents: &Contents, x: &[f64], cases: &[PackedCase]) -> Result<()> {
    let mut file = NewFile::create(path)?;
    file.set_text("format", "stribeck shard 1")?;
    file.set_text("columns", &column_names())?;
    file.set_text("limits", if contents.limits { "yes" } else { "no" })?;

    let entries = || cases.iter().map(PackedCase::entry);
    let ids: Vec<CaseText> = entries().map(|entry| case_text(entry.id)).collect();
    file.write("case", &ids)?;
    let statuses: Vec<i8> = entries().map(|entry| entry.outcome.code()).collect();
    file.write("status", &statuses)?;
    let reasons = entries().map(|entry| text(&entry.reason)).collect::<Result<Vec<_>>>()?;
    file.write("reason", &reasons)?;
    let values: Vec<f64> = entries().flat_map(|entry| entry.values.0).collect();
    file.write("values", ArrayView2::from_shape((cases.len(), Column::ALL.len()), &values)?)?;
    if contents.sensitivities {
        let row = |known: Option<Sensitivities>| known.map_or([f64::NAN; SENSITIVITIES[0]], |known| known.row());
        let both = |entry: &CaseEntry| [row(entry.sensitivities), row(entry.sensitivity_errors)];
        let of_roller = |row: [f64; SENSITIVITIES[0]]| row[SENSITIVITIES[1]..].iter().any(|it| it.abs() > 0.0);
        let width = SENSITIVITIES[usize::from(!entries().any(|entry| both(entry).into_iter().any(of_roller)))];
        let rows = entries().flat_map(|entry| both(entry).map(|row| row[..width].to_vec()));
        let values: Vec<f64> = rows.flatten().collect();
        file.write("sensitivities", ArrayView2::from_shape((cases.len(), 2 * width), &values)?)?;
    }

    if !contents.fields.is_empty() {
        file.write("x", x)?;
    }
    for field in Field::selected(contents.fields) {
        let matrix = file
            .dataset()
            .chunk((1, x.len()))
            .shuffle()
            .deflate(DEFLATE)
            .fill_value(f64::NAN)
            .empty::<f64>()
            .shape((cases.len(), x.len()))
            .create(field.name())?;
        let chunks = Chunks::new(file.keep(matrix));
        for (row, case) in cases.iter().enumerate() {
            if let Some(values) = case.field(field) {
                chunks.write(&[row, 0], values)?;
            }
        }
    }
    file.finish()
}

/// Checks that a shard that was just written has the numbers of these cases.
pub(super) fn check_shard(path: &Path, contents: &Contents, cases: &[PackedCase]) -> Result<(), StoreError> {
    let shard = ShardReader::open(path, contents)?;
    let same = |(row, entry): (usize, &CaseEntry)| {
        let bits = |values: Values| values.0.map(f64::to_bits);
        shard.ids[row] == entry.id && bits(shard.values(row)) == bits(entry.values) && shard.reason(row) == entry.reason
    };
    if shard.ids.len() == cases.len() && cases.iter().map(PackedCase::entry).enumerate().all(same) {
        return Ok(());
    }
    Err(StoreError::Damaged { path: path.to_owned(), what: "it is not what was just written to it".to_owned() })
}

/// A shard opened for reading: all but its fields are in memory.
pub(super) struct ShardReader {
    path: PathBuf,
    ids: Vec<CaseId>,
    statuses: Vec<Status>,
    reasons: Vec<VarLenUnicode>,
    values: Array2<f64>,
    /// Rows of [`Sensitivities`], each with that of their errors behind it, if the shard has them.
    sensitivities: Option<Array2<f64>>,
    /// In the order of [`Field::ALL`].
    fields: [Option<Chunks>; Field::ALL.len()],
}

impl ShardReader {
    /// Opens a shard and checks that its parts fit together and are what `contents` says.
    pub(super) fn open(path: &Path, contents: &Contents) -> Result<Self, StoreError> {
        let read = || -> Result<(Self, Option<String>)> {
            let file = open(path)?;
            let case_texts = file.dataset("case")?.read_1d::<CaseText>()?;
            let codes = file.dataset("status")?.read_1d::<i8>()?;
            let ids: Vec<CaseId> = case_texts.iter().filter_map(|id| id.as_str().parse().ok()).collect();
            let statuses: Vec<Status> = codes.iter().filter_map(|&code| Status::from_code(code)).collect();
            let reasons = file.dataset("reason")?.read_raw::<VarLenUnicode>()?;
            let values = file.dataset("values")?.read_2d::<f64>()?;
            let mut fields = [const { None }; Field::ALL.len()];
            let (cases, mut width) = (case_texts.len(), 0);
            let mut fault = None;
            let mut sensitivities = None;
            if contents.sensitivities {
                let rows = file.dataset("sensitivities")?.read_2d::<f64>()?;
                // Those of earlier versions have no errors.
                let [most, fewest] = SENSITIVITIES;
                if ![fewest, 2 * fewest, 2 * most].map(|width| (cases, width)).contains(&rows.dim()) {
                    fault = Some(format!("sensitivities has the shape {:?}", rows.shape()));
                }
                sensitivities = Some(rows);
            }
            if !contents.fields.is_empty() {
                let x = file.dataset("x")?.read_raw::<f64>()?;
                width = x.len();
                if x_key(&x) != contents.x {
                    fault = Some("its x is not the one of its record".to_owned());
                }
            }
            for field in Field::selected(contents.fields) {
                let matrix = file.dataset(field.name())?;
                if matrix.shape() != [cases, width] || matrix.chunk() != Some(vec![1, width]) {
                    let (shape, chunk) = (matrix.shape(), matrix.chunk());
                    fault = Some(format!("{} has the shape {shape:?} and chunks of {chunk:?}", field.name()));
                }
                fields[field as usize] = Some(Chunks::new(matrix));
            }
            if get_text(&file, "columns")? != column_names() {
                fault = Some("its columns are those of another version of the program".to_owned());
            }
            if [ids.len(), statuses.len(), reasons.len(), values.nrows()] != [cases; 4] {
                fault = Some("its data sets do not have one row per case".to_owned());
            }
            Ok((Self { path: path.to_owned(), ids, statuses, reasons, values, sensitivities, fields }, fault))
        };
        let (shard, fault) = read().map_err(StoreError::hdf5(path, "read"))?;
        match fault {
            None => Ok(shard),
            Some(what) => Err(StoreError::Damaged { path: path.to_owned(), what }),
        }
    }

    pub(super) fn ids(&self) -> &[CaseId] {
        &self.ids
    }

    pub(super) fn status(&self, row: usize) -> Status {
        self.statuses[row]
    }

    pub(super) fn reason(&self, row: usize) -> &str {
        self.reasons[row].as_str()
    }

    pub(super) fn values(&self, row: usize) -> Values {
        Values(std::array::from_fn(|column| self.values[(row, column)]))
    }

    /// How friction of a case changes with the parameters, and the errors of that; `None` if the shard has it not, or
    /// the case failed.
    pub(super) fn sensitivities(&self, row: usize) -> [Option<Sensitivities>; 2] {
        let [most, fewest] = SENSITIVITIES;
        let width = if self.sensitivities.as_ref().is_some_and(|values| values.ncols() > most) { most } else { fewest };
        let part = |first: usize| {
            let values = self.sensitivities.as_ref().filter(|values| first < values.ncols())?;
            let at = |column: usize| if column < width { values[(row, first + column)] } else { 0.0 };
            Sensitivities::from_row(std::array::from_fn(at))
        };
        [part(0), part(width)]
    }

    /// A field of a case as it is packed; `None` if the shard has it not, or the case failed.
    pub(super) fn packed_field(&self, field: Field, row: usize) -> Result<Option<Packed>, StoreError> {
        match &self.fields[field as usize] {
            Some(chunks) if self.status(row) == Status::Converged => {
                chunks.read(&[row, 0]).map(Some).map_err(StoreError::hdf5(&self.path, "read"))
            }
            _ => Ok(None),
        }
    }

    /// A field of a case; `None` if the shard has it not, or the case failed.
    fn field(&self, field: Field, row: usize) -> Result<Option<Vec<f64>>, StoreError> {
        let packed = self.packed_field(field, row)?;
        packed.map(|packed| packed.unpack().map_err(StoreError::hdf5(&self.path, "read"))).transpose()
    }

    /// All fields of a case.
    pub(super) fn all_fields(&self, row: usize) -> Result<Fields, StoreError> {
        Ok(Fields {
            pressure: self.field(Field::Pressure, row)?,
            film_thickness: self.field(Field::FilmThickness, row)?,
            displacement: self.field(Field::Displacement, row)?,
            shear_traction: self.field(Field::ShearTraction, row)?,
            hysteresis_traction: self.field(Field::HysteresisTraction, row)?,
        })
    }
}
