//! Columns and fields with their descriptions, as numpy arrays.

use numpy::{Element, PyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use stribeck_lab::Experiment;
use stribeck_solver::Output;
use stribeck_sweep::store::{CaseEntry, FurtherColumn, PlacedNumbers, Point, Status};
use stribeck_sweep::{CaseId, Column, Dimension, Field, Note, Unit};

/// The results at some places, to which each case is added.
pub struct Results<'o> {
    output: &'o Output,
    in_si: bool,
    further: Vec<FurtherColumn>,
    places: Vec<PlacedCase>,
    /// The fields that are asked for, each with a row for each place.
    fields: Vec<(Field, Vec<f64>)>,
}

/// A case at a place.
struct PlacedCase {
    point: Point,
    numbers: PlacedNumbers,
    status: Status,
    reason: String,
}

impl<'o> Results<'o> {
    /// No place yet, with the columns that only some results have.
    pub fn new(output: &'o Output, further: Vec<FurtherColumn>, in_si: bool, places: usize) -> Self {
        let length = places * output.x.len();
        let fields = Field::selected(output.fields).map(|field| (field, Vec::with_capacity(length))).collect();
        Self { output, in_si, further, places: Vec::with_capacity(places), fields }
    }

    /// Adds a place with its case, and where bodies are swapped with the case there.
    pub fn add(&mut self, point: Point, entry: &CaseEntry, swapped: Option<&CaseEntry>) {
        let swapped = swapped.map(|entry| entry.values.at_slide_roll(-point.slide_roll));
        let numbers = point.numbers_of(
            &entry.values,
            [entry.sensitivities, entry.sensitivity_errors],
            swapped.as_ref(),
            self.output,
        );
        for (field, rows) in &mut self.fields {
            let source = if point.follows_from_film(*field) { Field::FilmThickness } else { *field };
            match source.of(&entry.fields) {
                Some(stored) => {
                    let first = rows.len();
                    rows.extend_from_slice(stored);
                    point.placing(*field, &numbers).apply(&self.output.x, &mut rows[first..]);
                }
                None => rows.extend(self.output.x.iter().map(|_| f64::NAN)),
            }
        }
        self.places.push(PlacedCase { point, numbers, status: entry.outcome, reason: entry.reason.clone() });
    }

    /// All variables, each with its array over the places and its attributes: name → (array, attributes, has x).
    pub fn variables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let variables = Variables::new(py);
        let unit = |scale: &'static str| Some(Unit::of(scale, self.in_si));
        let texts = |text: &dyn Fn(&PlacedCase) -> String| self.places.iter().map(text).collect::<Vec<_>>();
        variables.add("case", texts(&|it| it.point.case.to_string()), describe(py, None, CaseId::LONG_NAME)?)?;

        let status = describe(py, None, Status::LONG_NAME)?;
        status.set_item("flag_values", array(py, Status::ALL.map(Status::code).to_vec()))?;
        status.set_item("flag_meanings", Status::ALL.map(Status::name).join(" "))?;
        variables.add("status", array(py, self.numbers(|it| it.status.code())), status)?;
        let notes = describe(py, None, Note::LONG_NAME)?;
        notes.set_item("flag_masks", array(py, Note::ALL.map(Note::mask).to_vec()))?;
        notes.set_item("flag_meanings", Note::ALL.map(Note::name).join(" "))?;
        variables.add("notes", array(py, self.numbers(|it| it.numbers.notes)), notes)?;
        let reasons = texts(&|it| it.reason.clone());
        variables.add("reason", reasons, describe(py, None, Status::REASON_LONG_NAME)?)?;

        for column in Column::ALL.into_iter().filter(|column| self.output.limits || !column.is_limit()) {
            let attributes = describe(py, unit(column.units()), column.long_name())?;
            variables.add(column.name(), array(py, self.numbers(|it| it.numbers.values[column])), attributes)?;
        }
        for (i, column) in self.further.iter().enumerate() {
            let attributes = describe(py, Some(Unit::ONE), &column.long_name)?;
            variables.add(&column.name, array(py, self.numbers(|it| it.numbers.more[i])), attributes)?;
        }
        for (field, rows) in &self.fields {
            let attributes = describe(py, unit(field.units()), field.long_name())?;
            variables.add_over_x(field.name(), array(py, rows.clone()), attributes)?;
        }
        Ok(variables.0)
    }

    /// What stands beside the variables in laboratory units: α, β and the scales at each place.
    pub fn coordinates<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let coordinates = Variables::new(py);
        for (name, long_name, i) in [("alpha", Dimension::ALPHA, 1), ("beta", Dimension::BETA, 2)] {
            let values = array(py, self.numbers(|it| it.point.numbers[i]));
            coordinates.add(name, values, describe(py, Some(Unit::ONE), long_name)?)?;
        }
        let first = self.places.first().and_then(|place| place.point.experiment);
        for (i, ((name, units, long_name), _)) in first.iter().flat_map(Experiment::variables).enumerate() {
            let value = |it: &PlacedCase| it.point.experiment.and_then(|it| it.variables().nth(i));
            let value = |it: &PlacedCase| value(it).map_or(f64::NAN, |(_, value)| value);
            coordinates.add(
                name,
                array(py, self.numbers(value)),
                describe(py, Some(Unit { units, scale: None }), long_name)?,
            )?;
        }
        Ok(coordinates.0)
    }

    fn numbers<T>(&self, of: impl Fn(&PlacedCase) -> T) -> Vec<T> {
        self.places.iter().map(of).collect()
    }
}

/// Variables by their names.
struct Variables<'py>(Bound<'py, PyDict>);

impl<'py> Variables<'py> {
    fn new(py: Python<'py>) -> Self {
        Self(PyDict::new(py))
    }

    fn add(&self, name: &str, values: impl IntoPyObject<'py>, attributes: Bound<'py, PyDict>) -> PyResult<()> {
        self.insert(name, values, attributes, false)
    }

    /// Adds a variable that has a row over x at each place.
    fn add_over_x(&self, name: &str, values: impl IntoPyObject<'py>, attributes: Bound<'py, PyDict>) -> PyResult<()> {
        self.insert(name, values, attributes, true)
    }

    fn insert(
        &self,
        name: &str,
        values: impl IntoPyObject<'py>,
        attributes: Bound<'py, PyDict>,
        has_x: bool,
    ) -> PyResult<()> {
        let values = values.into_py_any(self.0.py())?;
        self.0.set_item(name, (values, attributes, has_x))
    }
}

/// A dimension: (name, values, attributes).
pub fn dimension<'py>(py: Python<'py>, dimension: &Dimension) -> PyResult<Bound<'py, PyTuple>> {
    let Dimension { name, units, long_name, values } = dimension;
    let attributes = describe(py, None, long_name)?;
    attributes.set_item("units", units)?;
    (name.as_str(), array(py, values.clone()), attributes).into_pyobject(py)
}

/// The dimension x of fields.
pub fn dimension_x<'py>(py: Python<'py>, output: &Output) -> PyResult<Bound<'py, PyTuple>> {
    let attributes = describe(py, Some(Unit::of(Field::X_UNITS, false)), Field::X_LONG_NAME)?;
    ("x", array(py, output.x.to_vec()), attributes).into_pyobject(py)
}

/// The attributes that say what a variable is.
pub fn describe<'py>(py: Python<'py>, unit: Option<Unit>, long_name: &str) -> PyResult<Bound<'py, PyDict>> {
    let attributes = PyDict::new(py);
    if let Some(Unit { units, scale }) = unit {
        attributes.set_item("units", units)?;
        if let Some(scale) = scale {
            attributes.set_item("scale", scale)?;
        }
    }
    attributes.set_item("long_name", long_name)?;
    Ok(attributes)
}

fn array<T: Element>(py: Python<'_>, values: Vec<T>) -> Bound<'_, PyArray1<T>> {
    PyArray1::from_vec(py, values)
}
