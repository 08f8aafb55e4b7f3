//! Materials: from a Prony series, or from a file of whatever wrote it.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use stribeck_lab::{
    AtOneTemperature, ColumnChoice, Doubt, MasterCurve, MaterialData, MaterialFile, MaterialFileError, MaterialOptions,
    Measurement, Measurements, Modulus, ModulusKind, PronyParts, PronySeries, Relaxation, RelaxationFit,
    RelaxationFitError, ShiftFactors, ShiftLaw, ShiftLawFit, Shifting, TermChoice, VerticalShift,
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
    terms: Option<i64>,
    shear: bool,
    poisson_ratio: Option<f64>,
    /// Pascals in the unit of moduli.
    modulus_unit: Option<f64>,
    /// In K.
    reference_temperature: Option<f64>,
    shift_factors: Option<PathBuf>,
    /// How moduli are shifted beside their rates: none, fit or density.
    vertical_shift: String,
    /// Thermal expansion of the volume in 1/K, beside the shift by the density.
    expansion: Option<f64>,
    columns: Option<String>,
}

impl FileOptions {
    /// How the file is read.
    fn of_file(&self) -> PyResult<MaterialOptions> {
        let columns = self.columns.as_deref().map(ColumnChoice::list).transpose().map_err(errors::input)?;
        Ok(MaterialOptions {
            is_shear: self.shear,
            poisson_ratio: self.poisson_ratio,
            modulus_unit: self.modulus_unit,
            columns: columns.unwrap_or_default(),
        })
    }

    /// How moduli are shifted.
    fn vertical(&self) -> PyResult<VerticalShift> {
        if let Some(wrong) = self.expansion.filter(|it| !VerticalShift::EXPANSION.contains(it)) {
            let allowed = VerticalShift::EXPANSION_ALLOWED;
            return Err(errors::input(format!("expansion must be {allowed}, found {wrong:?}")));
        }
        match (self.vertical_shift.as_str(), self.expansion) {
            ("density", expansion) => Ok(VerticalShift::Density { expansion: expansion.unwrap_or(0.0) }),
            ("none", None) => Ok(VerticalShift::None),
            ("fit", None) => Ok(VerticalShift::Overlap),
            ("none" | "fit", Some(_)) => Err(errors::input(
                "expansion would change nothing: no density is known; add --vertical-shift density, or leave it out",
            )),
            (wrong, _) => {
                Err(errors::input(format!("vertical_shift must be \"none\", \"fit\" or \"density\", found {wrong:?}")))
            }
        }
    }

    /// The fit to moduli.
    fn fit(&self, measurements: &Measurements) -> Result<RelaxationFit, RelaxationFitError> {
        match self.terms {
            // What is below zero is refused as 0 is.
            Some(terms) => RelaxationFit::new(measurements, usize::try_from(terms).unwrap_or_default()),
            None => TermChoice::new(measurements).map(|choice| choice.fit),
        }
    }
}

/// A material from a file: that of [`prony`] with `understood`; if it was fitted also `measured`, `rms_residual` and
/// `doubt`; of isotherms `shifts`, their `reference` and the `law` that they follow.
///
/// # Errors
/// `InputError` if the file describes no material, `StorageError` if the disk does not give it.
#[pyfunction]
pub fn material_file<'py>(py: Python<'py>, path: PathBuf, options: FileOptions) -> PyResult<Bound<'py, PyDict>> {
    let vertical = options.vertical()?;
    let file = MaterialFile::read(&path, &options.of_file()?).map_err(|error| match error {
        MaterialFileError::Series(fault) => errors::fault(&fault),
        MaterialFileError::Table(error) => errors::table(&error),
    })?;
    let refused = |what: String| errors::input(format!("{}: {what}", stribeck_input::shown(&path)));
    let (factors, mut understood) = (options.shift_factors.as_deref(), file.understood);
    let factors =
        factors.map(|file| ShiftFactors::read(file, &[])).transpose().map_err(|error| errors::table(&error))?;
    understood += &factors.as_ref().map(|(_, understood)| understood.to_string()).unwrap_or_default();
    let shifting = Shifting {
        factors: factors.as_ref().map(|(factors, _)| factors),
        reference: options.reference_temperature,
        vertical,
    };
    let measured = match file.data {
        MaterialData::Series(_) if options.terms.is_some() => {
            return Err(refused("a Prony series is not fitted; leave out --terms N".to_owned()));
        }
        MaterialData::Series(series) => {
            let curve = shifting.of_series().map_err(|error| refused(error.to_string()))?;
            let material = describe(py, &series.relaxation().map_err(|error| refused(error.to_string()))?)?;
            material.set_item("understood", errors::with_keywords(&understood))?;
            curve.iter().try_for_each(|curve| describe_shifts(&material, curve))?;
            return Ok(material);
        }
        MaterialData::Moduli(measurements) => AtOneTemperature::of_moduli(measurements, &shifting),
        MaterialData::Isotherms(isotherms) => AtOneTemperature::of_isotherms(&isotherms, &shifting),
    };
    let measured = measured.map_err(|error| refused(error.to_string()))?;
    let fit = options.fit(&measured.measurements).map_err(|error| refused(error.to_string()))?;
    let material = describe(py, &fit.relaxation)?;
    material.set_item("understood", errors::with_keywords(&understood))?;
    material.set_item("rms_residual", fit.rms_residual)?;
    let doubt = Doubt::about(&fit.relaxation, &measured.measurements);
    material.set_item("doubt", doubt.map(|doubt| doubt.to_string()))?;
    material.set_item("measured", measured.measurements.rows().iter().map(row).collect::<Vec<_>>())?;
    if let Some(curve) = &measured.master_curve {
        describe_shifts(&material, curve)?;
    }
    Ok(material)
}

/// Adds where isotherms went, and the better one of the laws that this follows.
fn describe_shifts(material: &Bound<'_, PyDict>, curve: &MasterCurve) -> PyResult<()> {
    let shifts = curve.shifts.iter().map(|it| (it.temperature, it.log_factor, it.residual.unwrap_or(f64::NAN)));
    material.set_item("shifts", shifts.collect::<Vec<_>>())?;
    let vertical = curve.shifts.iter().map(|it| 10_f64.powf(it.log_vertical));
    material.set_item("vertical_shift_factors", vertical.collect::<Vec<_>>())?;
    let Some(ShiftLawFit { law, rms_residual, .. }) = curve.laws.first() else { return Ok(()) };
    let numbers = PyDict::new(material.py());
    numbers.set_item("law", law.name())?;
    match law {
        ShiftLaw::Wlf { c1, c2, .. } => {
            numbers.set_item("c1", c1)?;
            numbers.set_item("c2", c2)?;
        }
        ShiftLaw::Arrhenius { activation_energy, .. } => numbers.set_item("activation_energy", activation_energy)?,
    }
    numbers.set_item("reference", law.reference())?;
    material.set_item("law", (numbers, rms_residual))
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
