//! `results.h5`: one labelled data set in the style of netCDF-4.

use std::ops::Range;
use std::path::Path;

use hdf5::types::VarLenUnicode;
use hdf5::{Dataset, H5Type, Hyperslab, Result, SliceOrIndex};
use ndarray::{Array2, arr0};

use super::chunks::Chunks;
use super::dimension_scales::{attach, make_scale};
use super::field_blocks::{FieldBlocks, places_in_block};
use super::further_columns::FurtherColumn;
use super::hdf5_file::{DEFLATE, NewFile, set_text, text};
use super::publication::{Place, Publication};
use super::{Status, StoredOutput, program, version};
use crate::grid_index::indices;
use crate::{CaseId, Column, Dimension, Field, Note, Unit};
use stribeck_lab::Experiment;

/// Attribute of the file with the names of its dimensions but x, the one along rows last; files without it have f,
/// alpha, beta.
pub(super) const DIMENSIONS: &str = "stribeck_dimensions";

/// Attribute of a file that lacks cases: how many.
pub(super) const PARTIAL: &str = "partial";

/// Attribute of a field that is rounded: the bits of the mantissa that are kept, without the first one, which is not
/// written. Name and count are those of CF-1.12.
const KEPT_BITS: &str = "quantization_nsb";

/// The paper whose equations are solved.
const REFERENCES: &str =
    "Wu, Jagota and Hui (2022), Tribology Letters 70:1, https://doi.org/10.1007/s11249-021-01537-4";

/// `results.h5` while it is written.
pub(super) struct Results {
    shape: Vec<usize>,
    variables: Variables,
    file: NewFile,
}

/// Its variables.
struct Variables {
    /// In the order of [`Column::ALL`].
    columns: Vec<Dataset>,
    more: Vec<Dataset>,
    laboratory: Option<LaboratoryVariables>,
    case: Dataset,
    status: Dataset,
    notes: Dataset,
    reason: Dataset,
    fields: FieldBlocks,
}

/// What follows from the quantities of the laboratory at each place.
struct LaboratoryVariables {
    alpha: Dataset,
    beta: Dataset,
    /// As in [`Experiment::variables`].
    others: Vec<Dataset>,
}

impl Results {
    /// Lays the file out: coordinates, and every variable with its attributes and still without values. With an
    /// experiment units are SI.
    pub(super) fn create(
        path: &Path,
        publication: &Publication<'_>,
        experiment: Option<&Experiment>,
        more: &[FurtherColumn],
        wanted: &StoredOutput,
    ) -> Result<Self> {
        let mut file = NewFile::create(path)?;
        describe_file(&file, publication)?;
        file.set_text("cavity_shear", &wanted.output.cavity_shear.to_string())?;
        let names: Vec<&str> = publication.dimensions.iter().map(|dimension| dimension.name.as_str()).collect();
        if experiment.is_some() {
            file.set_text(DIMENSIONS, &names.join(" "))?;
        }

        let mut layout = Layout { shape: publication.shape(), grid: Vec::new(), coordinates: None };
        for Dimension { name, units, long_name, values } in publication.dimensions {
            layout.grid.push(coordinate(&mut file, name, (units, None), long_name, values)?);
        }
        let laboratory = experiment.map(|experiment| layout.laboratory(&mut file, experiment, &names)).transpose()?;
        let unit = |scale: &'static str| Unit::of(scale, experiment.is_some());

        let case = layout.variable::<VarLenUnicode>(&mut file, "case", None, CaseId::LONG_NAME)?;
        let status = layout.variable::<i8>(&mut file, "status", None, Status::LONG_NAME)?;
        status.new_attr_builder().with_data(&Status::ALL.map(Status::code)).create("flag_values")?;
        set_text(&status, "flag_meanings", &Status::ALL.map(Status::name).join(" "))?;
        let notes = layout.variable::<i32>(&mut file, "notes", None, Note::LONG_NAME)?;
        notes.new_attr_builder().with_data(&Note::ALL.map(Note::mask)).create("flag_masks")?;
        set_text(&notes, "flag_meanings", &Note::ALL.map(Note::name).join(" "))?;
        let reason = layout.variable::<VarLenUnicode>(&mut file, "reason", None, Status::REASON_LONG_NAME)?;
        let mut columns = Vec::with_capacity(Column::ALL.len());
        for column in Column::ALL {
            columns.push(layout.number(&mut file, column.name(), unit(column.units()), column.long_name())?);
        }
        let more = more
            .iter()
            .map(|column| layout.number(&mut file, &column.name, Unit::ONE, &column.long_name))
            .collect::<Result<Vec<_>>>()?;

        let fields = layout.fields(&mut file, wanted, unit)?;
        let variables = Variables { columns, more, notes, laboratory, case, status, reason, fields };
        Ok(Self { shape: layout.shape, variables, file })
    }

    /// Writes all but the fields of neighbouring rows: those of a range of the last dimension but one, in a block of
    /// the dimensions before it.
    pub(super) fn rows(&mut self, block: usize, range: Range<usize>, places: &[Place]) -> Result<()> {
        let write = Write { shape: &self.shape, block, range };
        let Variables { columns, more, laboratory, case, status, notes, reason, fields: _ } = &self.variables;
        for (column, variable) in Column::ALL.into_iter().zip(columns) {
            write.to(variable, places.iter().map(|place| place.values[column]))?;
        }
        for (i, variable) in more.iter().enumerate() {
            write.to(variable, places.iter().map(|place| place.more[i]))?;
        }
        if let Some(LaboratoryVariables { alpha, beta, others }) = laboratory {
            write.to(alpha, places.iter().map(|place| place.point.numbers[1]))?;
            write.to(beta, places.iter().map(|place| place.point.numbers[2]))?;
            for (i, variable) in others.iter().enumerate() {
                let value = |place: &Place| place.point.experiment.and_then(|it| it.variables().nth(i));
                write.to(variable, places.iter().map(|place| value(place).map_or(f64::NAN, |(_, value)| value)))?;
            }
        }
        let ids = places.iter().map(|place| text(&place.point.case.to_string())).collect::<Result<Vec<_>>>()?;
        write.to(case, ids.into_iter())?;
        write.to(notes, places.iter().map(|place| place.notes))?;
        write.to(status, places.iter().map(|place| place.status.code()))?;
        // What is not written is read as the empty text, and takes no room where no case has failed.
        if places.iter().all(|place| place.reason.is_empty()) {
            return Ok(());
        }
        let reasons = places.iter().map(|place| text(&place.reason)).collect::<Result<Vec<_>>>()?;
        write.to(reason, reasons.into_iter())
    }

    /// The fields of the publication.
    pub(super) fn fields(&mut self) -> &mut FieldBlocks {
        &mut self.variables.fields
    }

    /// Marks the file as one of a sweep that is not solved to its end.
    pub(super) fn set_partial(&self, what: &str) -> Result<()> {
        self.file.set_text(PARTIAL, what)
    }

    /// Brings everything to the file and closes it.
    pub(super) fn finish(mut self) -> Result<()> {
        self.variables.fields.finish()?;
        drop(self.variables);
        self.file.finish()
    }
}

/// Gives the file its attributes: where its numbers come from.
fn describe_file(file: &NewFile, publication: &Publication<'_>) -> Result<()> {
    file.set_text("Conventions", "CF-1.10")?;
    file.set_text("title", publication.title)?;
    file.set_text("history", &format!("{}: run sweep.toml", program()))?;
    file.set_text(
        "source",
        "numerical solution of the lubricated sliding of a rigid cylinder on a viscoelastic half space",
    )?;
    file.set_text("references", REFERENCES)?;
    file.set_text("method", publication.method)?;
    file.set_number("tolerance", publication.tolerance)?;
    file.set_text("sweep", publication.sweep_text)?;
    file.set_text("stribeck_version", version())
}

/// The dimensions of the variables, and what describes them beside.
struct Layout {
    shape: Vec<usize>,
    /// The scales of the dimensions.
    grid: Vec<Dataset>,
    /// Names of further coordinates, as CF has them in an attribute.
    coordinates: Option<String>,
}

impl Layout {
    /// Lays out what belongs to the quantities of the laboratory: those that are no dimension as numbers, and α, β and
    /// the scales at each place.
    fn laboratory(
        &mut self,
        file: &mut NewFile,
        experiment: &Experiment,
        dimensions: &[&str],
    ) -> Result<LaboratoryVariables> {
        let mut names: Vec<&str> = vec!["alpha", "beta"];
        for quantity in experiment.given().filter(|quantity| !dimensions.contains(&quantity.name())) {
            let number = file.write(quantity.name(), &arr0(experiment.value(quantity)))?;
            set_text(&number, "units", quantity.units())?;
            set_text(&number, "long_name", experiment.long_name(quantity))?;
            names.push(quantity.name());
        }
        let alpha = self.number(file, "alpha", Unit::ONE, Dimension::ALPHA)?;
        let beta = self.number(file, "beta", Unit::ONE, Dimension::BETA)?;
        let mut others = Vec::new();
        for ((name, units, long_name), _) in experiment.variables() {
            others.push(self.number(file, name, Unit { units, scale: None }, long_name)?);
            names.push(name);
        }
        self.coordinates = Some(names.join(" "));
        Ok(LaboratoryVariables { alpha, beta, others })
    }

    /// Lays out the coordinate x and the fields that are asked for, in the order of [`Field::ALL`].
    fn fields(
        &mut self,
        file: &mut NewFile,
        wanted: &StoredOutput,
        unit: impl Fn(&'static str) -> Unit,
    ) -> Result<FieldBlocks> {
        let StoredOutput { output, field_precision } = wanted;
        let mut fields = Vec::new();
        if !output.fields.is_empty() {
            let over = ("1", Some(Field::X_UNITS));
            self.grid.push(coordinate(file, "x", over, Field::X_LONG_NAME, &output.x)?);
        }
        let shape: Vec<usize> = self.shape.iter().copied().chain([output.x.len()]).collect();
        let (width, outer) = (output.x.len(), self.shape.len() - 1);
        let places = places_in_block(self.shape[outer], width);
        let chunk: Vec<usize> = std::iter::repeat_n(1, outer).chain([places, width]).collect();
        for field in Field::selected(output.fields) {
            let variable = file
                .dataset()
                .chunk(chunk.as_slice())
                .shuffle()
                .deflate(DEFLATE)
                .fill_value(f64::NAN)
                .empty::<f64>()
                .shape(shape.as_slice())
                .create(field.name())?;
            let variable = file.keep(variable);
            self.describe(&variable, Some(unit(field.units())), field.long_name())?;
            set_fill(&variable)?;
            if let Some(kept) = field_precision.kept_bits() {
                variable.new_attr::<i32>().create(KEPT_BITS)?.write_scalar(&kept.cast_signed())?;
            }
            fields.push((field, Chunks::new(variable)));
        }
        Ok(FieldBlocks::new(fields, &self.shape, wanted))
    }

    /// A variable of numbers on the grid, NaN where none is written.
    fn number(&self, file: &mut NewFile, name: &str, unit: Unit, long_name: &str) -> Result<Dataset> {
        let variable = file.dataset().fill_value(f64::NAN).empty::<f64>().shape(self.shape.as_slice()).create(name)?;
        let variable = file.keep(variable);
        self.describe(&variable, Some(unit), long_name)?;
        set_fill(&variable)?;
        Ok(variable)
    }

    /// A variable on the grid.
    fn variable<T: H5Type>(
        &self,
        file: &mut NewFile,
        name: &str,
        unit: Option<Unit>,
        long_name: &str,
    ) -> Result<Dataset> {
        let variable = file.keep(file.dataset().empty::<T>().shape(self.shape.as_slice()).create(name)?);
        self.describe(&variable, unit, long_name)?;
        Ok(variable)
    }

    /// Gives a variable its attributes, and each of its dimensions the coordinate that belongs to it.
    fn describe(&self, variable: &Dataset, unit: Option<Unit>, long_name: &str) -> Result<()> {
        for (dimension, scale) in (0..).zip(&self.grid) {
            attach(variable, scale, dimension)?;
        }
        if let Some(Unit { units, scale }) = unit {
            set_unit(variable, units, scale)?;
        }
        if let Some(coordinates) = &self.coordinates {
            set_text(variable, "coordinates", coordinates)?;
        }
        set_text(variable, "long_name", long_name)
    }
}

/// Neighbouring rows of a grid.
struct Write<'a> {
    shape: &'a [usize],
    block: usize,
    range: Range<usize>,
}

impl Write<'_> {
    /// Writes one value for each place.
    fn to<T: H5Type>(&self, variable: &Dataset, values: impl Iterator<Item = T>) -> Result<()> {
        let Self { shape, block, range } = self;
        let (outer, inner) = shape.split_at(shape.len() - 2);
        let rows = SliceOrIndex::SliceCount { start: range.start, step: 1, count: range.len(), block: 1 };
        let selection =
            indices(outer.iter().copied(), *block).into_iter().map(SliceOrIndex::Index).chain([rows, all(inner[1])]);
        let values = Array2::from_shape_vec((range.len(), inner[1]), values.collect())?;
        variable.write_slice(&values, Hyperslab::from(selection.collect::<Vec<_>>()))
    }
}

/// All of a dimension with so many values.
fn all(length: usize) -> SliceOrIndex {
    SliceOrIndex::SliceCount { start: 0, step: 1, count: length, block: 1 }
}

/// A coordinate: a one-dimensional variable that is the scale of the dimension of its name.
fn coordinate(
    file: &mut NewFile,
    name: &str,
    (units, over): (&str, Option<&str>),
    long_name: &str,
    values: &[f64],
) -> Result<Dataset> {
    let scale = file.write(name, values)?;
    make_scale(&scale, name)?;
    set_unit(&scale, units, over)?;
    set_text(&scale, "long_name", long_name)?;
    Ok(scale)
}

/// The unit of a variable, and what a dimensionless number is over. Libraries of units know no a0.
fn set_unit(variable: &Dataset, units: &str, scale: Option<&str>) -> Result<()> {
    set_text(variable, "units", units)?;
    scale.map_or(Ok(()), |scale| set_text(variable, "scale", scale))
}

/// NaN as the netCDF fill value; the HDF5 fill value of the data set says the same.
fn set_fill(variable: &Dataset) -> Result<()> {
    variable.new_attr_builder().with_data(&[f64::NAN]).create("_FillValue").map(drop)
}
