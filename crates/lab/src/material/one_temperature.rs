//! Moduli at one temperature, from what a file has of them.

use super::isotherms::Isotherms;
use super::master_curve::{MasterCurve, MasterCurveError};
use super::measurement::Measurements;
use super::shift_factors::ShiftFactors;
use super::vertical_shift::VerticalShift;

/// How a material is to be brought to one temperature.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shifting<'a> {
    /// Shift factors that are given, in place of those that follow from overlaps.
    pub factors: Option<&'a ShiftFactors>,
    /// The temperature to shift to, in K.
    pub reference: Option<f64>,
    /// How moduli are shifted.
    pub vertical: VerticalShift,
}

impl Shifting<'_> {
    /// What factors tell of a series: their law alone, at its temperature.
    ///
    /// # Errors
    /// [`MasterCurveError`] if something else is asked for, or factors and reference do not go together.
    pub fn of_series(&self) -> Result<Option<MasterCurve>, MasterCurveError> {
        match (self.vertical, self.factors, self.reference) {
            (VerticalShift::None, None, None) => Ok(None),
            (VerticalShift::None, None, Some(_)) => Err(MasterCurveError::SeriesIsNotShifted),
            (VerticalShift::None, Some(factors), reference) => MasterCurve::of_factors(factors, reference).map(Some),
            (VerticalShift::Overlap | VerticalShift::Density { .. }, ..) => Err(MasterCurveError::NothingToLevel),
        }
    }
}

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
    /// [`MasterCurveError`] if there is a reference temperature alone, it does not go with the factors, or moduli are to
    /// be shifted.
    pub fn of_moduli(measurements: Measurements, shifting: &Shifting<'_>) -> Result<Self, MasterCurveError> {
        if shifting.vertical != VerticalShift::None {
            return Err(MasterCurveError::NothingToLevel);
        }
        let master_curve = match (shifting.factors, shifting.reference) {
            (None, None) => None,
            (None, Some(_)) => return Err(MasterCurveError::NoTemperatures),
            (Some(factors), reference) => Some(MasterCurve::of_factors(factors, reference)?),
        };
        Ok(Self { measurements, master_curve })
    }

    /// Isotherms, shifted by given factors or by their overlap; a single one without a reference stays as it is.
    ///
    /// # Errors
    /// [`MasterCurveError`] if there are several without a reference, or they cannot be shifted.
    pub fn of_isotherms(isotherms: &Isotherms, shifting: &Shifting<'_>) -> Result<Self, MasterCurveError> {
        let Shifting { factors, reference, vertical } = *shifting;
        let (curve, measurements) = match (factors, reference, isotherms.all()) {
            (Some(factors), ..) => MasterCurve::by_factors(isotherms, factors, reference, vertical)?,
            (None, Some(reference), _) => MasterCurve::by_overlap(isotherms, reference, vertical)?,
            (None, None, [only]) => return Self::of_moduli(only.measurements.clone(), shifting),
            (None, None, _) => {
                let (from, to) = isotherms.range();
                return Err(MasterCurveError::SeveralTemperatures { from, to });
            }
        };
        Ok(Self { measurements, master_curve: Some(curve) })
    }
}
