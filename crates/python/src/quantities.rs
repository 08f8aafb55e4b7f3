//! Numbers with units, as sweep files have them.

use pyo3::prelude::*;
use stribeck_input::{Fault, Section, Values, document, parse};
use stribeck_lab::{Dimension, LaboratoryQuantity};
use stribeck_sweep::Sweep;

use crate::errors;

/// A value of TOML, a number or a text with a unit, in SI units; `kind` is a quantity of the laboratory, or `modulus`,
/// `time` or `length`.
///
/// # Errors
/// `InputError` if it is no value of that kind.
#[pyfunction]
pub fn si(kind: &str, value: &str) -> PyResult<f64> {
    match (LaboratoryQuantity::named(kind), kind) {
        (Some(quantity), _) => read(kind, value, &quantity),
        (None, "modulus") => read(kind, value, &Dimension::Modulus),
        (None, "time") => read(kind, value, &Dimension::Time),
        (None, "length") => read(kind, value, &Dimension::Length),
        (None, _) => Err(errors::input(format!("there is no quantity {kind}"))),
    }
}

fn read(name: &str, value: &str, values: &dyn Values) -> PyResult<f64> {
    let text = format!("{name} = {value}");
    let interpret = |_: &str, text: &str| -> Result<f64, Fault> {
        let document = document(text)?;
        let root = Section::new("", 0..0, document.get_ref(), &[name], |_| None)?;
        values.read(&root.require(name, "give it a value")?)
    };
    parse("value", &text, interpret).map_err(|fault| errors::value(&fault))
}

/// Checks that a text describes a sweep.
///
/// # Errors
/// `InputError` if it does not.
#[pyfunction]
pub fn check_sweep(name: &str, text: &str) -> PyResult<()> {
    Sweep::parse(name, text).map(drop).map_err(|fault| errors::fault(&fault))
}
