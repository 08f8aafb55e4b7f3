//! `solve_sweep`: a sweep whose results are kept in memory.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use stribeck_input::InputError;
use stribeck_solver::Interrupt;
use stribeck_sweep::campaign::{InMemory, published_point, solve_in_memory};
use stribeck_sweep::store::further_columns;
use stribeck_sweep::{Grid, Plan, Sweep, Unit};

use crate::background::{threads, watched};
use crate::errors;
use crate::variables::{Results, describe, dimension, dimension_x};

/// Solves the sweep that a text describes, as a sweep file does: {"title", "dimensions", "x", "variables",
/// "coordinates", "quantities"}.
///
/// # Errors
/// `InputError` if the text is no sweep; what a handler of signals raises.
#[pyfunction]
pub fn solve_sweep<'py>(py: Python<'py>, name: &str, text: &str, asked: Option<i64>) -> PyResult<Bound<'py, PyDict>> {
    let sweep = Sweep::parse(name, text).map_err(|error: InputError| errors::fault(&error))?;
    let (plan, threads, interrupt) = (Plan::new(&sweep), threads(asked)?, Interrupt::new());
    let solved =
        watched(py, &interrupt, |_: &dyn Fn(())| solve_in_memory(&sweep, threads, &interrupt), |_, ()| Ok(()))?;
    let entries = match solved.map_err(|error| errors::campaign(&error))? {
        InMemory::Solved(entries) => entries,
        InMemory::Interrupted => unreachable!("what interrupts it is raised"),
    };
    let shape = sweep.grid.shape();
    let points: Vec<_> = (0..shape.places()).map(|place| published_point(&sweep, &plan, shape.index(place))).collect();
    let in_si = matches!(sweep.grid, Grid::Laboratory(_));
    let further = further_columns(points.first(), &sweep.output);
    let mut results = Results::new(&sweep.output, further, in_si, points.len());
    for &point in &points {
        results.add(point, &entries[&point.case], point.swapped.map(|case| &entries[&case]));
    }

    let answer = PyDict::new(py);
    answer.set_item("title", &sweep.title)?;
    let dimensions = sweep.grid.dimensions();
    let given = dimensions.iter().map(|it| dimension(py, it)).collect::<PyResult<Vec<_>>>()?;
    answer.set_item("dimensions", PyList::new(py, given)?)?;
    answer.set_item("x", dimension_x(py, &sweep.output)?)?;
    answer.set_item("variables", results.variables(py)?)?;
    if let (true, Some(experiment)) = (in_si, points.first().and_then(|point| point.experiment)) {
        answer.set_item("coordinates", results.coordinates(py)?)?;
        let quantities = PyDict::new(py);
        for quantity in experiment.given().filter(|it| dimensions.iter().all(|axis| axis.name != it.name())) {
            let attributes = describe(py, Some(Unit { units: quantity.units(), scale: None }), quantity.long_name())?;
            quantities.set_item(quantity.name(), (experiment.value(quantity), attributes))?;
        }
        answer.set_item("quantities", quantities)?;
    }
    Ok(answer)
}
