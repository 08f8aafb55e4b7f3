//! Measurements sorted by their temperatures.

use super::measurement::{Measurement, Measurements};

/// A step of the temperature, in K, at which a new isotherm begins: more than a thermostat wavers.
const STEP: f64 = 1.0;
/// How far the temperatures of one isotherm may lie apart, in K.
const SPREAD: f64 = 3.0;

/// Measurements at one temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Isotherm {
    /// The mean of their temperatures, in K.
    pub temperature: f64,
    /// The measurements.
    pub measurements: Measurements,
}

/// Measurements at several temperatures, ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct Isotherms(Vec<Isotherm>);

impl Isotherms {
    /// Sorts rows with their temperatures, in K, into isotherms: one ends where the temperature steps by more than 1 K.
    ///
    /// # Errors
    /// [`IsothermsError`] if there is no row, or the rows of an isotherm are at one rate only, or drift by more than
    /// 3 K.
    pub fn new(mut rows: Vec<(f64, Measurement)>) -> Result<Self, IsothermsError> {
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let groups = rows.chunk_by(|a, b| b.0 - a.0 <= STEP);
        let isotherms: Vec<Isotherm> = groups.map(isotherm).collect::<Result<_, _>>()?;
        if isotherms.is_empty() { Err(IsothermsError::Empty) } else { Ok(Self(isotherms)) }
    }

    /// The isotherms, cold ones first.
    pub fn all(&self) -> &[Isotherm] {
        &self.0
    }

    /// The lowest and the highest temperature, in K.
    pub fn range(&self) -> (f64, f64) {
        (self.0[0].temperature, self.0[self.0.len() - 1].temperature)
    }
}

fn isotherm(rows: &[(f64, Measurement)]) -> Result<Isotherm, IsothermsError> {
    let (from, to) = (rows[0].0, rows[rows.len() - 1].0);
    if to - from > SPREAD {
        return Err(IsothermsError::Drift { from, to });
    }
    let temperature = rows.iter().map(|row| row.0).sum::<f64>() / rows.len() as f64;
    let measurements = Measurements::new(rows.iter().map(|row| row.1).collect());
    Ok(Isotherm { temperature, measurements: measurements.ok_or(IsothermsError::OneRate { temperature })? })
}

/// Why rows are no isotherms. Messages have degrees Celsius, as laboratories do.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum IsothermsError {
    /// There are no rows.
    #[error("there are no rows")]
    Empty,
    /// The temperature changes all the time.
    #[error(
        "from {:.1} to {:.1} degC the temperature rises without a step: a ramp, not isotherms. Moduli are shifted from \
         temperature to temperature where several frequencies were measured at each",
        from - 273.15,
        to - 273.15
    )]
    Drift {
        /// The lowest temperature, in K.
        from: f64,
        /// The highest.
        to: f64,
    },
    /// An isotherm has no second frequency.
    #[error(
        "at {:.1} degC the moduli are at one frequency or time only; isotherms have several each. Leave these rows out",
        temperature - 273.15
    )]
    OneRate {
        /// The temperature, in K.
        temperature: f64,
    },
}
