//! Materials: from a Prony series, or from a file of whatever wrote it.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_lab::{
    ColumnChoice, MasterCurve, MaterialData, MaterialFile, MaterialFileError, MaterialOptions, Measurement,
    Measurements, Modulus, ModulusKind, PronyParts, PronySeries, Relaxation, RelaxationFit, TermChoice, VerticalShift,
    parse_temperature,
};

use crate::errors;

/// A material from (E_i or g_i, τ_i) and one of its moduli.
///
/// # Errors
/// `InputError` if these are none of a solid.
#[pyfunction]
pub fn prony<'py>(
    py: Python<'py>,
    are_fractions: bool,
    terms: Vec<(f64, f64)>,
    is_relaxed: bool,
    modulus: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let parts = if are_fractions { PronyParts::Fractions } else { PronyParts::Moduli };
    let modulus = Some(if is_relaxed { Modulus::Relaxed(modulus) } else { Modulus::Instantaneous(modulus) });
    let series = PronySeries { parts, terms, modulus, kind: ModulusKind::Young };
    describe(py, &series.relaxation().map_err(errors::input)?)
}

/// What a person says of a file.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct FileOptions {
    /// The number of terms of a fit; none for as many as the residuals ask for.
    terms: Option<usize>,
    shear: bool,
    poisson_ratio: Option<f64>,
    /// Pascals in the unit of moduli.
    modulus_unit: Option<f64>,
    reference_temperature: Option<String>,
    columns: Option<String>,
}

/// A material from a file: that of [`prony`], with `understood`, and `measured` and `rms_residual` if it was fitted.
///
/// # Errors
/// `InputError` if the file describes no material.
#[pyfunction]
pub fn material_file<'py>(py: Python<'py>, path: PathBuf, options: FileOptions) -> PyResult<Bound<'py, PyDict>> {
    let columns = options.columns.as_deref().map(ColumnChoice::list).transpose().map_err(errors::input)?;
    let read = MaterialOptions {
        is_shear: options.shear,
        poisson_ratio: options.poisson_ratio,
        modulus_unit: options.modulus_unit,
        columns: columns.unwrap_or_default(),
    };
    let file = MaterialFile::read(&path, &read).map_err(|error| match error {
        MaterialFileError::Series(fault) => errors::fault(&fault),
        error => errors::input(error),
    })?;
    let refused = |what: String| errors::input(format!("{}: {what}", stribeck_input::shown(&path)));
    let measurements = match &file.data {
        MaterialData::Series(series) => {
            let relaxation = series.relaxation().map_err(|error| refused(error.to_string()))?;
            let material = describe(py, &relaxation)?;
            material.set_item("understood", &file.understood)?;
            return Ok(material);
        }
        data => at_one_temperature(data, options.reference_temperature.as_deref()).map_err(refused)?,
    };
    let fit = match options.terms {
        Some(terms) => RelaxationFit::new(&measurements, terms),
        None => TermChoice::new(&measurements).map(|choice| choice.fit),
    };
    let fit = fit.map_err(|error| refused(error.to_string()))?;
    let material = describe(py, &fit.relaxation)?;
    material.set_item("understood", &file.understood)?;
    material.set_item("rms_residual", fit.rms_residual)?;
    material.set_item("measured", measurements.rows().iter().map(row).collect::<Vec<_>>())?;
    Ok(material)
}

/// Moduli of one material: at one temperature, or shifted there by their overlap.
fn at_one_temperature(data: &MaterialData, reference: Option<&str>) -> Result<Measurements, String> {
    let reference = match reference {
        None => None,
        Some(text) => Some(parse_temperature(text).ok_or_else(|| {
            format!(
                "reference_temperature is a temperature with its unit, as in \"20 degC\" or \"293 K\", not {text:?}"
            )
        })?),
    };
    match (data, reference) {
        (MaterialData::Moduli(measurements), None) => Ok(measurements.clone()),
        (MaterialData::Isotherms(isotherms), Some(reference)) => {
            let curve = MasterCurve::by_overlap(isotherms, reference, VerticalShift::None);
            curve.map(|it| it.measurements).map_err(|error| error.to_string())
        }
        (MaterialData::Isotherms(isotherms), None) => match isotherms.all() {
            [only] => Ok(only.measurements.clone()),
            _ => {
                let (from, to) = isotherms.range();
                Err(format!(
                    "the moduli are at temperatures from {from:.1} K to {to:.1} K and no one material; give \
                     reference_temperature=\"20 degC\", say, to which they are shifted"
                ))
            }
        },
        _ => {
            Err("no column has a temperature, so nothing can be shifted; leave reference_temperature out, or name the \
                  column, as in columns=\"temperature=#4\""
                .to_owned())
        }
    }
}

/// (ω or t, storage or E(t), loss or NaN).
fn row(measurement: &Measurement) -> (f64, f64, f64) {
    match *measurement {
        Measurement::Oscillation { omega, storage, loss } => (omega, storage, loss),
        Measurement::Relaxation { time, modulus } => (time, modulus, f64::NAN),
    }
}

/// The numbers of a material: by its relaxation, and by its creep.
fn describe<'py>(py: Python<'py>, relaxation: &Relaxation) -> PyResult<Bound<'py, PyDict>> {
    let creep = relaxation.material();
    let numbers = PyDict::new(py);
    numbers.set_item("relaxed_modulus", relaxation.relaxed_modulus())?;
    numbers.set_item("instantaneous_modulus", relaxation.instantaneous_modulus())?;
    numbers.set_item("f", creep.f)?;
    numbers.set_item("retardation_time", creep.retardation_time)?;
    let terms = relaxation.terms().iter().map(|term| (term.modulus, term.time));
    numbers.set_item("terms", terms.collect::<Vec<_>>())?;
    let modes = creep.substrate.modes().iter().map(|mode| (mode.share, mode.time));
    numbers.set_item("modes", modes.collect::<Vec<_>>())?;
    Ok(numbers)
}
