//! `solve`: a list of points, in any order.

use std::num::NonZeroUsize;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use stribeck_input::Quantity;
use stribeck_solver::{FieldSelection, Interrupt, Output, RetardationMode, Substrate, collocation, solve_points};
use stribeck_sweep::campaign::case_entry;
use stribeck_sweep::engine::solver_threads;
use stribeck_sweep::store::{CaseEntry, Point, further_columns};
use stribeck_sweep::{Axes, Dimension, Field, FieldPrecision, Grid, Plan, SolverSettings, Sweep};

use crate::background::{threads, watched};
use crate::errors;
use crate::variables::{Results, dimension, dimension_x};

/// What is asked of a list of points; the arrays have one number for each.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Request<'py> {
    alpha: PyReadonlyArray1<'py, f64>,
    beta: PyReadonlyArray1<'py, f64>,
    f: PyReadonlyArray1<'py, f64>,
    slide_roll: PyReadonlyArray1<'py, f64>,
    /// (share, time) of each mode of the flat.
    modes: Option<Vec<(f64, f64)>>,
    /// Those of the roller.
    roller_modes: Option<Vec<(f64, f64)>>,
    tolerance: f64,
    fields: Vec<String>,
    x: Option<Vec<f64>>,
    sensitivities: bool,
    threads: Option<i64>,
}

/// Solves points: {"dimensions": those that a place may have, "variables": …}.
///
/// # Errors
/// `InputError` if a number or a setting may not be; what a handler of signals raises.
#[pyfunction]
pub fn solve<'py>(py: Python<'py>, request: Request<'py>) -> PyResult<Bound<'py, PyDict>> {
    let places = request.places()?;
    let sweep = request.sweep()?;
    let threads = threads(request.threads)?;
    let plan = Plan::new(&sweep);
    let interrupt = Interrupt::new();
    let entries = watched(
        py,
        &interrupt,
        |_: &dyn Fn(())| solve_all(&sweep, &plan, &places, threads, &interrupt),
        |_, ()| Ok(()),
    )??;
    let output = &sweep.output;
    let point = |(&(slide_roll, numbers), entry): (&Place, &CaseEntry)| {
        let power_of_strength = Grid::power_of_strength(numbers[0], slide_roll, &sweep.substrate);
        Point { slide_roll, power_of_strength, ..Point::new(entry.id, numbers) }
    };
    let points: Vec<Point> = places.iter().zip(&entries).map(point).collect();
    let mut results = Results::new(output, further_columns(points.first(), output), false, points.len());
    for (&point, entry) in points.iter().zip(&entries) {
        results.add(point, entry, None);
    }
    let answer = PyDict::new(py);
    let inputs = [Dimension::slide_roll(&[]), Dimension::strength(&[]), Dimension::alpha(&[]), Dimension::beta(&[])];
    let inputs = inputs.iter().map(|input| dimension(py, input)).collect::<PyResult<Vec<_>>>()?;
    answer.set_item("inputs", PyList::new(py, inputs)?)?;
    answer.set_item("x", dimension_x(py, output)?)?;
    answer.set_item("variables", results.variables(py)?)?;
    Ok(answer)
}

/// S, and f, α and β of a place.
type Place = (f64, [f64; 3]);

impl Request<'_> {
    /// The places, all of which may be.
    fn places(&self) -> PyResult<Vec<Place>> {
        let [alpha, beta, f, slide_roll] = [&self.alpha, &self.beta, &self.f, &self.slide_roll].map(|it| it.as_array());
        let lists = [
            ("alpha", Quantity::SlideTime, alpha),
            ("beta", Quantity::InverseHersey, beta),
            ("f", Quantity::Strength, f),
            ("slide_roll", Quantity::SlideRoll, slide_roll),
        ];
        for (name, quantity, values) in lists {
            if let Some(wrong) = values.iter().find(|value| !quantity.admits(**value)) {
                let (allowed, remedy) = (quantity.allowed(), quantity.remedy());
                return Err(errors::input(format!("a value of {name} must be {allowed}, found {wrong:?}: {remedy}")));
            }
        }
        // −0 is 0
        let place = |i: usize| (slide_roll[i] + 0.0, [f[i] + 0.0, alpha[i] + 0.0, beta[i]]);
        let places: Vec<Place> = (0..alpha.len()).map(place).collect();
        let at_rest = |(slide_roll, [f, alpha, _]): &Place| *slide_roll == -1.0 && *f > 0.0 && alpha.is_finite();
        if self.roller_modes.is_some() && places.iter().any(|(slide_roll, _)| *slide_roll == -1.0) {
            return Err(errors::input(
                "with slide_roll = -1 the flat is at rest, and alpha tells no time of a roller that has roller_modes: \
                 describe both bodies in an Experiment",
            ));
        }
        if places.iter().any(at_rest) {
            return Err(errors::input(
                "with slide_roll = -1 the flat is at rest in the contact and has all the time there is to creep: give \
                 alpha = inf there",
            ));
        }
        Ok(places)
    }

    /// How the points are solved, as a sweep: a case has the id that it has in one.
    fn sweep(&self) -> PyResult<Sweep> {
        let settings = SolverSettings { tolerance: self.tolerance, ..SolverSettings::default() };
        let range = collocation::Settings::TOLERANCE;
        if !range.contains(&self.tolerance) {
            let (least, most) = range.into_inner();
            return Err(errors::input(format!(
                "tolerance is the relative error wanted in mu_v, mu_h and c: it must be from {least:e} to {most:e}, not \
                 {:e}",
                self.tolerance
            )));
        }
        Ok(Sweep {
            title: String::new(),
            grid: Axes { slide_roll: None, f: vec![0.0], alpha: vec![0.0], beta: vec![1.0] }.into(),
            substrate: self.substrate()?,
            solver: settings,
            output: self.output()?,
            field_precision: FieldPrecision::Double,
            text: String::new(),
            name: String::new(),
        })
    }

    /// The modes of both bodies; one time of the flat where none are given.
    fn substrate(&self) -> PyResult<Substrate> {
        let modes = |modes: &Option<Vec<(f64, f64)>>| {
            modes.iter().flatten().map(|&(share, time)| RetardationMode { share, time }).collect()
        };
        match (&self.modes, &self.roller_modes) {
            (None, None) => Ok(Substrate::default()),
            (flat, roller) => Substrate::of_two_bodies(modes(flat), modes(roller)).map_err(|error| {
                errors::input(if roller.is_none() {
                    format!("modes: {error}")
                } else {
                    format!("modes and roller_modes: {error}; the shares of both bodies add up to 1")
                })
            }),
        }
    }

    fn output(&self) -> PyResult<Output> {
        let field = |name: &String| {
            Field::named(name).ok_or_else(|| {
                let known = Field::ALL.map(Field::name).join(", ");
                errors::input(format!("there is no field {name:?}: fields are {known}"))
            })
        };
        let mut fields = Field::selection(self.fields.iter().map(field).collect::<PyResult<Vec<_>>>()?);
        // The shear on a roller that turns follows from the film.
        fields.film_thickness |= fields.shear_traction;
        let mut output = Output { fields, sensitivities: self.sensitivities, ..Output::default() };
        if let Some(x) = &self.x {
            let ascends = x.windows(2).all(|pair| pair[0] < pair[1]);
            let most = stribeck_input::Values::limit(&Quantity::Position);
            if x.is_empty() || x.len() > most || !ascends || !x.iter().all(|x| x.is_finite()) {
                let what = format!("x must be from 1 to {most} finite numbers that ascend, in units of a0");
                return Err(errors::input(what));
            }
            output.x = x.as_slice().into();
        }
        if output.fields == FieldSelection::default() {
            output.x = [].into();
        }
        Ok(output)
    }
}

/// Solves each place, on threads that end with it: a pool that stays would be lost in a process that forks.
fn solve_all(
    sweep: &Sweep,
    plan: &Plan,
    places: &[Place],
    threads: NonZeroUsize,
    interrupt: &Interrupt,
) -> PyResult<Vec<CaseEntry>> {
    let parameters = |&(slide_roll, numbers): &Place| match Grid::case_of(numbers, slide_roll, &sweep.substrate) {
        Ok(parameters) => Ok(Plan::canonical(&parameters)),
        Err(error) => Err(errors::input(format!("roller_modes at slide_roll = {slide_roll:?}: {error}"))),
    };
    let parameters = places.iter().map(parameters).collect::<PyResult<Vec<_>>>()?;
    let pool = solver_threads(threads).map_err(errors::input)?;
    // An interrupted list is never looked at: what interrupts it is raised.
    let cases = pool.install(|| solve_points(&parameters, &sweep.solver_settings(), interrupt)).unwrap_or_default();
    Ok(parameters.iter().zip(cases).map(|(parameters, case)| case_entry(plan, parameters, case)).collect())
}
