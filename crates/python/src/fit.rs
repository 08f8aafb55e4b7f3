//! `fit`: quantities of the laboratory from measured friction.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck::fit_beginning::searched;
use stribeck_lab::{
    Bounds, ColumnChoice, FrictionFit, FrictionFitError, FrictionTask, LaboratoryQuantity, Measured, Unknown, Watch,
};
use stribeck_solver::Interrupt;
use stribeck_sweep::campaign::read_sweep;
use stribeck_sweep::engine::solver_threads;
use stribeck_sweep::{Sweep, friction_task, points_to_fit};

use crate::background::{threads, watched};
use crate::errors;

/// What is fitted to what.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Request {
    /// Files of measured points; one without content is read.
    files: Vec<(PathBuf, Option<Vec<u8>>)>,
    columns: Option<String>,
    /// The path of a sweep file, or no path and its text.
    sweep: Option<PathBuf>,
    text: String,
    unknown: Vec<String>,
    /// (unknown, least, most).
    bounds: Vec<(String, Option<f64>, Option<f64>)>,
    search: bool,
    profile: bool,
    threads: Option<i64>,
}

/// A fit, and the intervals of its unknowns if they were asked for.
type Fitted = (FrictionFit, Option<Vec<[Option<f64>; 2]>>);

/// Fits unknowns to measured friction.
///
/// # Errors
/// `InputError` if points and unknowns do not go together, `FitError` if no minimum is found; what a handler of signals
/// raises.
#[pyfunction]
pub fn fit(py: Python<'_>, request: Request) -> PyResult<Bound<'_, PyDict>> {
    let sweep = match &request.sweep {
        Some(path) => read_sweep(path).map_err(|error| errors::campaign(&error))?,
        None => Sweep::parse("Experiment", &request.text).map_err(|fault| errors::fault(&fault))?,
    };
    let unknowns = request.unknown.iter().map(|name| unknown(name)).collect::<PyResult<Vec<_>>>()?;
    let bounds = request
        .bounds
        .iter()
        .map(|(name, least, most)| unknown(name).map(|unknown| Bounds { unknown, least: *least, most: *most }));
    let bounds = bounds.collect::<PyResult<Vec<_>>>()?;
    let is_unknown = unknowns.iter().any(|unknown| unknown.name() == LaboratoryQuantity::Radius.name());
    let radius = sweep.grid.radius().filter(|_| !is_unknown);
    let (measured, understood) = request.measured(radius)?;
    let measured = points_to_fit(measured, &unknowns);
    let mut task = friction_task(&sweep, &measured, &unknowns, &bounds).map_err(errors::input)?;
    if request.search {
        task.experiment = py.detach(|| searched(&task)).map_err(errors::input)?;
    }
    let (threads, interrupt) = (threads(request.threads)?, Interrupt::new());
    let work = || -> Result<Fitted, FrictionFitError> {
        let watch = Watch { interrupt: &interrupt, evaluated: &|_, _| {} };
        let fit = FrictionFit::watched(&task, &watch)?;
        let intervals = request.profile.then(|| fit.intervals(&task, &watch)).transpose()?;
        Ok((fit, intervals))
    };
    let fitted = watched(
        py,
        &interrupt,
        |_: &dyn Fn(())| solver_threads(threads).map_err(errors::input).map(|pool| pool.install(work)),
        |_, ()| Ok(()),
    )??;
    let (fit, intervals) = fitted.map_err(|error| match error {
        FrictionFitError::Task { .. } => errors::input(error),
        error => errors::fit(error),
    })?;
    let answer = describe(py, &fit, &task)?;
    answer.set_item("intervals", intervals)?;
    answer.set_item("understood", understood)?;
    Ok(answer)
}

fn unknown(name: &str) -> PyResult<Unknown> {
    Unknown::named(name).ok_or_else(|| {
        let known: Vec<&str> = Unknown::all().map(Unknown::name).collect();
        errors::input(format!("there is no unknown {name:?}: give some of {}", known.join(", ")))
    })
}

impl Request {
    /// The measured points of all files, and what was understood of them.
    fn measured(&self, radius: Option<f64>) -> PyResult<(Measured, String)> {
        let choices = self.columns.as_deref().map(ColumnChoice::list).transpose().map_err(errors::input)?;
        let choices = choices.unwrap_or_default();
        let (mut parts, mut told) = (Vec::new(), String::new());
        for (path, content) in &self.files {
            let read = match content {
                Some(bytes) => Measured::of(path, bytes, &choices, radius),
                None => Measured::read(path, &choices, radius),
            };
            let (part, understood) = read.map_err(|error| errors::table(&error))?;
            told += &errors::with_keywords(&understood.to_string());
            parts.push(part);
        }
        Ok((Measured::join(parts).map_err(errors::input)?, told))
    }
}

/// The numbers of a fit.
fn describe<'py>(py: Python<'py>, fit: &FrictionFit, task: &FrictionTask<'_>) -> PyResult<Bound<'py, PyDict>> {
    let answer = PyDict::new(py);
    let estimates = fit
        .estimates
        .iter()
        .map(|it| (it.unknown.name(), it.unknown.units(), it.value, it.error, it.start, it.at_bound));
    answer.set_item("estimates", estimates.collect::<Vec<_>>())?;
    answer.set_item("correlation", &fit.correlation)?;
    answer.set_item("degrees_of_freedom", fit.degrees_of_freedom)?;
    answer.set_item("reduced_chi_squared", fit.reduced_chi_squared)?;
    answer.set_item("evaluations", fit.evaluations)?;
    let points = PyDict::new(py);
    let along = fit.points.first().map_or(LaboratoryQuantity::Speed, |point| point.experiment.motion.along().0);
    let speeds: Vec<f64> = fit.points.iter().map(|point| point.experiment.motion.along().1).collect();
    points.set_item(along.name(), speeds)?;
    for (name, values) in task.measured.coordinates.iter().filter(|(name, _)| *name != along.name()) {
        points.set_item(name, values)?;
    }
    points.set_item("measured", fit.points.iter().map(|it| it.measured).collect::<Vec<_>>())?;
    points.set_item("error", fit.points.iter().map(|it| it.error.unwrap_or(f64::NAN)).collect::<Vec<_>>())?;
    points.set_item("fitted", fit.points.iter().map(|it| it.fitted).collect::<Vec<_>>())?;
    points.set_item("residual", fit.points.iter().map(|it| it.residual).collect::<Vec<_>>())?;
    answer.set_item("along", along.name())?;
    answer.set_item("points", points)?;
    Ok(answer)
}
