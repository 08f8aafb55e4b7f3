//! `results.h5`: one labelled data set in the style of netCDF-4.

use std::ops::Range;
use std::path::Path;

use hdf5::types::VarLenUnicode;
use hdf5::{Dataset, Result};
use ndarray::{Array2, aview1, s};

use super::contents::{FIELDS, places};
use super::dimension_scales::{attach, make_scale};
use super::hdf5_file::{DEFLATE, NewFile, set_text, text};
use super::publication::{Place, Publication};
use super::shard::{CaseText, case_text};
use super::{PROGRAM, Status};
use crate::model::{COLUMNS, Output};

/// `results.h5` while it is written.
pub(super) struct Results {
    columns: Vec<Dataset>,
    case: Dataset,
    status: Dataset,
    reason: Dataset,
    fields: [Option<Dataset>; FIELDS.len()],
    file: NewFile,
}

impl Results {
    /// Lays the file out: coordinates, and every variable with its attributes and still without values.
    pub(super) fn create(path: &Path, publication: &Publication<'_>, output: &Output) -> Result<Self> {
        let mut file = NewFile::create(path)?;
        file.set_text("Conventions", "CF-1.10")?;
        file.set_text("title", publication.title)?;
        file.set_text("history", &format!("{PROGRAM}: run sweep.toml"))?;
        file.set_text(
            "source",
            "numerical solution of the lubricated sliding of a rigid cylinder on a viscoelastic half space",
        )?;
        file.set_text("sweep", publication.sweep_text)?;
        file.set_text("stribeck_version", env!("CARGO_PKG_VERSION"))?;

        let mut grid = vec![
            coordinate(&mut file, "f", "1", "strength of retardation", publication.f)?,
            coordinate(
                &mut file,
                "alpha",
                "1",
                "slide time over a contact length / retardation time",
                publication.alpha,
            )?,
            coordinate(&mut file, "beta", "1", "inverse Hersey number", publication.beta)?,
        ];
        let shape = (publication.f.len(), publication.alpha.len(), publication.beta.len());

        let case = file.keep(file.dataset().empty::<CaseText>().shape(shape).create("case")?);
        describe(&case, None, "id of the case, as in summary.csv", &grid)?;
        let status = file.keep(file.dataset().empty::<i8>().shape(shape).create("status")?);
        describe(&status, None, "what became of the case", &grid)?;
        status.new_attr_builder().with_data(&Status::ALL.map(Status::code)).create("flag_values")?;
        set_text(&status, "flag_meanings", &Status::ALL.map(Status::name).join(" "))?;
        let reason = file.keep(file.dataset().empty::<VarLenUnicode>().shape(shape).create("reason")?);
        describe(&reason, None, "why the case failed; empty if it converged", &grid)?;

        let mut columns = Vec::with_capacity(COLUMNS.len());
        for column in &COLUMNS {
            let variable = file.dataset().fill_value(f64::NAN).empty::<f64>().shape(shape).create(column.name)?;
            let variable = file.keep(variable);
            describe(&variable, Some(column.units), column.long_name, &grid)?;
            set_fill(&variable)?;
            columns.push(variable);
        }

        let mut fields = [const { None }; FIELDS.len()];
        if !output.fields.is_empty() {
            grid.push(coordinate(
                &mut file,
                "x",
                "a0",
                "position along the surface; the inlet is at x > 0",
                &output.x,
            )?);
        }
        for place in places(output.fields) {
            let field = file
                .dataset()
                .chunk((1, 1, 1, output.x.len()))
                .shuffle()
                .deflate(DEFLATE)
                .fill_value(f64::NAN)
                .empty::<f64>()
                .shape((shape.0, shape.1, shape.2, output.x.len()))
                .create(FIELDS[place].name)?;
            let field = file.keep(field);
            describe(&field, Some(FIELDS[place].units), FIELDS[place].long_name, &grid)?;
            set_fill(&field)?;
            fields[place] = Some(field);
        }
        Ok(Self { columns, case, status, reason, fields, file })
    }

    /// Writes all but the fields of neighbouring rows: for each α of a range one place for each β.
    pub(super) fn rows(&mut self, i_f: usize, alphas: Range<usize>, places: &[Place]) -> Result<()> {
        let shape = (alphas.len(), places.len() / alphas.len());
        let slice = s![i_f, alphas, ..];
        for (i, variable) in self.columns.iter().enumerate() {
            let values = places.iter().map(|place| place.values[i]).collect();
            variable.write_slice(&Array2::from_shape_vec(shape, values)?, slice)?;
        }
        let cases = places.iter().map(|place| case_text(place.case)).collect();
        self.case.write_slice(&Array2::from_shape_vec(shape, cases)?, slice)?;
        let statuses = places.iter().map(|place| place.status.code()).collect();
        self.status.write_slice(&Array2::from_shape_vec(shape, statuses)?, slice)?;
        let reasons = places.iter().map(|place| text(&place.reason)).collect::<Result<Vec<_>>>()?;
        self.reason.write_slice(&Array2::from_shape_vec(shape, reasons)?, slice)
    }

    /// Writes a field of one place. Where this is not called the field is NaN.
    pub(super) fn field(&mut self, field: usize, [i_f, i_alpha, i_beta]: [usize; 3], values: &[f64]) -> Result<()> {
        match &self.fields[field] {
            Some(variable) => variable.write_slice(aview1(values), s![i_f, i_alpha, i_beta, ..]),
            None => Err(format!("{} is not part of this publication", FIELDS[field].name).into()),
        }
    }

    /// Brings everything to the file.
    pub(super) fn finish(self) -> Result<()> {
        self.file.finish()
    }
}

/// A coordinate: a one-dimensional variable that is the scale of the dimension of its name.
fn coordinate(file: &mut NewFile, name: &str, units: &str, long_name: &str, values: &[f64]) -> Result<Dataset> {
    let scale = file.write(name, values)?;
    make_scale(&scale, name)?;
    set_text(&scale, "units", units)?;
    set_text(&scale, "long_name", long_name)?;
    Ok(scale)
}

/// Gives a variable its attributes, and each of its dimensions the coordinate that belongs to it.
fn describe(variable: &Dataset, units: Option<&str>, long_name: &str, coordinates: &[Dataset]) -> Result<()> {
    for (dimension, scale) in (0..).zip(coordinates) {
        attach(variable, scale, dimension)?;
    }
    if let Some(units) = units {
        set_text(variable, "units", units)?;
    }
    set_text(variable, "long_name", long_name)
}

/// NaN as the netCDF fill value; the HDF5 fill value of the data set says the same.
fn set_fill(variable: &Dataset) -> Result<()> {
    variable.new_attr_builder().with_data(&[f64::NAN]).create("_FillValue").map(drop)
}
