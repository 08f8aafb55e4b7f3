//! Moduli at one temperature, from what a file has of them.

use super::isotherms::Isotherms;
use super::master_curve::{MasterCurve, MasterCurveError};
use super::measurement::Measurements;
use super::shift_factors::ShiftFactors;
use super::vertical_shift::VerticalShift;

/// Moduli at one temperature, and how they came there.
#[derive(Clone, Debug, PartialEq)]
pub struct AtOneTemperature {
    /// The moduli.
    pub measurements: Measurements,
    /// The shift of isotherms, or the factors beside moduli that were shifted before; none for moduli as they are.
    pub master_curve: Option<MasterCurve>,
}

impl AtOneTemperature {
    /// Moduli of which no temperature is told: shift factors beside them give the law alone.
    ///
    /// # Errors
    /// [`MasterCurveError`] if there is a reference temperature alone, or it does not go with the factors.
    pub fn of_moduli(
        measurements: Measurements,
        factors: Option<&ShiftFactors>,
        reference: Option<f64>,
    ) -> Result<Self, MasterCurveError> {
        let master_curve = match (factors, reference) {
            (None, None) => None,
            (None, Some(_)) => return Err(MasterCurveError::NoTemperatures),
            (Some(factors), _) => Some(MasterCurve::of_shifted(measurements.clone(), factors, reference)?),
        };
        Ok(Self { measurements, master_curve })
    }

    /// Isotherms, shifted by given factors or by their overlap; a single one without a reference stays as it is.
    ///
    /// # Errors
    /// [`MasterCurveError`] if there are several without a reference, or they cannot be shifted.
    pub fn of_isotherms(
        isotherms: &Isotherms,
        factors: Option<&ShiftFactors>,
        reference: Option<f64>,
        vertical: VerticalShift,
    ) -> Result<Self, MasterCurveError> {
        let curve = match (factors, reference, isotherms.all()) {
            (Some(factors), ..) => MasterCurve::by_factors(isotherms, factors, reference, vertical)?,
            (None, Some(reference), _) => MasterCurve::by_overlap(isotherms, reference, vertical)?,
            (None, None, [only]) => {
                return Ok(Self { measurements: only.measurements.clone(), master_curve: None });
            }
            (None, None, _) => {
                let (from, to) = isotherms.range();
                return Err(MasterCurveError::SeveralTemperatures { from, to });
            }
        };
        Ok(Self { measurements: curve.measurements.clone(), master_curve: Some(curve) })
    }
}
