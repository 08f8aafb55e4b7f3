//! Isotherms shifted along the axis of rates until they are one curve.

use super::isotherms::{Isotherm, Isotherms};
use super::measurement::Measurements;
use super::overlap::Overlap;
use super::shift_factors::{ShiftFactors, ShiftFactorsError, between};
use super::vertical_shift::VerticalShift;
use crate::temperature::ShiftLawFit;

/// How moduli at several temperatures became one curve at a reference temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct MasterCurve {
    /// The reference temperature, in K.
    pub reference: f64,
    /// Where each isotherm went, cold ones first.
    pub shifts: Vec<Shift>,
    /// How moduli were shifted.
    pub vertical: VerticalShift,
    /// The laws that the shift factors follow, the better one first.
    pub laws: Vec<ShiftLawFit>,
}

/// How far an isotherm was shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    /// Its temperature, in K.
    pub temperature: f64,
    /// log₁₀ a_T: decades of rate to the right.
    pub log_factor: f64,
    /// log₁₀ b_T: decades of modulus upwards.
    pub log_vertical: f64,
    /// Root of the mean square of |ΔE*|/|E*| where it lies over the next colder one; `None` for the coldest.
    pub residual: Option<f64>,
}

impl MasterCurve {
    /// Shifts isotherms to a reference temperature, in K, within their range. Beside the curve it has all measurements,
    /// at the rates that they would have there.
    ///
    /// Each isotherm is shifted against its neighbour until the mean of |ΔE*|²/|E*|² over their overlap is least, with
    /// straight lines between the points on logarithmic scales. Where moduli are shifted by their overlap as well, it is
    /// least of both together.
    ///
    /// # Errors
    /// [`MasterCurveError`] if the reference lies outside, or two neighbours have no best overlap of a fifth of the
    /// shorter one.
    pub fn by_overlap(
        isotherms: &Isotherms,
        reference: f64,
        vertical: VerticalShift,
    ) -> Result<(Self, Measurements), MasterCurveError> {
        let is_free = vertical == VerticalShift::Overlap;
        let levelled = vertical.levelled(isotherms, reference);
        let laid = match vertical {
            VerticalShift::None => Laid::AlongRates,
            VerticalShift::Overlap => Laid::Freely,
            VerticalShift::Density { .. } => Laid::AsRubber,
        };
        let pairs = levelled
            .windows(2)
            .map(|pair| Overlap::best(&pair[0], &pair[1], is_free).ok_or_else(|| no_overlap(&pair[0], &pair[1], laid)));
        let overlaps = pairs.collect::<Result<Vec<_>, _>>()?;
        let factors = ShiftFactors::new(running(isotherms, overlaps.iter().map(|overlap| overlap.step)))?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, isotherms.range()))?;
        Self::assemble(isotherms, &factors, (reference, vertical), &overlaps)
    }

    /// Shifts isotherms by given factors, to the reference temperature of these or to another one; likewise.
    ///
    /// # Errors
    /// [`MasterCurveError`] if a temperature has no factor, or the factors have no reference.
    pub fn by_factors(
        isotherms: &Isotherms,
        factors: &ShiftFactors,
        reference: Option<f64>,
        vertical: VerticalShift,
    ) -> Result<(Self, Measurements), MasterCurveError> {
        let reference = reference.or_else(|| factors.reference()).ok_or(MasterCurveError::NoReference)?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, factors.range()))?;
        let is_free = vertical == VerticalShift::Overlap;
        let levelled = vertical.levelled(isotherms, reference);
        let logs = logs(isotherms, &factors)?;
        let pairs = levelled.windows(2).zip(logs.windows(2));
        let overlaps = pairs.map(|(pair, logs)| {
            let overlap = Overlap::at(&pair[0], &pair[1], logs[1] - logs[0], is_free);
            overlap.ok_or_else(|| no_overlap(&pair[0], &pair[1], Laid::ByFactors))
        });
        Self::assemble(isotherms, &factors, (reference, vertical), &overlaps.collect::<Result<Vec<_>, _>>()?)
    }

    /// The factors of a material that is at their reference temperature already, or at another one of theirs.
    ///
    /// # Errors
    /// [`MasterCurveError`] if the factors have no reference, or the other one lies outside.
    pub fn of_factors(factors: &ShiftFactors, reference: Option<f64>) -> Result<Self, MasterCurveError> {
        let reference = reference.or_else(|| factors.reference()).ok_or(MasterCurveError::NoReference)?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, factors.range()))?;
        let shift = |&(temperature, log_factor): &(f64, f64)| Shift {
            temperature,
            log_factor,
            log_vertical: 0.0,
            residual: None,
        };
        let laws = ShiftLawFit::all(factors.pairs(), reference);
        let shifts = factors.pairs().iter().map(shift).collect();
        Ok(Self { reference, shifts, vertical: VerticalShift::None, laws })
    }

    /// The curve of shifted isotherms, from the overlaps of neighbours.
    fn assemble(
        isotherms: &Isotherms,
        factors: &ShiftFactors,
        (reference, vertical): (f64, VerticalShift),
        overlaps: &[Overlap],
    ) -> Result<(Self, Measurements), MasterCurveError> {
        let logs = logs(isotherms, factors)?;
        let levels = running(isotherms, overlaps.iter().map(|overlap| overlap.level));
        let residuals = std::iter::once(None).chain(overlaps.iter().map(|overlap| overlap.residual));
        let mut rows = Vec::new();
        let mut shifts = Vec::new();
        for ((Isotherm { temperature, measurements }, residual), (i, log_factor)) in
            isotherms.all().iter().zip(residuals).zip(logs.into_iter().enumerate())
        {
            let log_vertical = match vertical {
                VerticalShift::Overlap => levels[i].1 - between(&levels, reference),
                other => other.log_factor(*temperature, reference),
            };
            let moved = measurements.faster(10_f64.powf(log_factor)).stiffer(10_f64.powf(log_vertical));
            rows.extend_from_slice(moved.rows());
            shifts.push(Shift { temperature: *temperature, log_factor, log_vertical, residual });
        }
        let laws = ShiftLawFit::all(factors.pairs(), reference);
        let measurements = Measurements::new(rows).expect("each isotherm has two rates");
        Ok((Self { reference, shifts, vertical, laws }, measurements))
    }
}

/// log₁₀ a_T of each isotherm.
fn logs(isotherms: &Isotherms, factors: &ShiftFactors) -> Result<Vec<f64>, MasterCurveError> {
    let log = |isotherm: &Isotherm| {
        factors.at(isotherm.temperature).ok_or_else(|| outside(isotherm.temperature, factors.range()))
    };
    isotherms.all().iter().map(log).collect()
}

/// Temperatures of isotherms with the sums of the steps from the coldest one on.
fn running(isotherms: &Isotherms, steps: impl Iterator<Item = f64>) -> Vec<(f64, f64)> {
    let sums = std::iter::once(0.0).chain(steps).scan(0.0, |sum, step| {
        *sum += step;
        Some(*sum)
    });
    isotherms.all().iter().map(|isotherm| isotherm.temperature).zip(sums).collect()
}

fn no_overlap(cold: &Isotherm, warm: &Isotherm, laid: Laid) -> MasterCurveError {
    MasterCurveError::NoOverlap { cold: cold.temperature, warm: warm.temperature, laid }
}

fn outside(temperature: f64, (from, to): (f64, f64)) -> MasterCurveError {
    MasterCurveError::Outside { temperature, from, to }
}

/// How two isotherms that do not overlap were to be laid over one another; as text it says why they do not, and what to
/// do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Laid {
    /// Along the rates.
    #[error(
        "do not overlap by a fifth of their range, so one cannot be shifted onto the other; leave out those beyond the \
         gap, or give shift factors (--shift-factors FILE)"
    )]
    AlongRates,
    /// Along rates and moduli.
    #[error(
        "fit best where less than a fifth of their range overlaps: a shift of rates cannot be told from one of moduli \
         there. Leave out --vertical-shift fit, or give shift factors (--shift-factors FILE)"
    )]
    Freely,
    /// Along the rates, with the moduli of a rubber.
    #[error(
        "do not overlap by a fifth of their range when they are multiplied by rho_0 T_0/(rho T), as those of a rubber; \
         those of a glass do not follow that. Leave out --vertical-shift density, or the isotherms of the glass"
    )]
    AsRubber,
    /// Along moduli, with given shift factors.
    #[error(
        "do not overlap where the shift factors lay them, so nothing says what moduli are to be multiplied by; leave out \
         --vertical-shift fit"
    )]
    ByFactors,
}

/// Why isotherms are no master curve. Messages have degrees Celsius, as laboratories do.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MasterCurveError {
    /// Two isotherms that do not overlap.
    #[error("the moduli at {:.1} and {:.1} degC {laid}", cold - 273.15, warm - 273.15)]
    NoOverlap {
        /// The colder one, in K.
        cold: f64,
        /// The warmer one.
        warm: f64,
        /// How they were to be laid over one another.
        laid: Laid,
    },
    /// A temperature without a shift factor.
    #[error(
        "{:.1} degC lies outside of the shift factors, which go from {:.1} to {:.1} degC; choose a temperature within, or \
         leave out the rows beyond",
        temperature - 273.15,
        from - 273.15,
        to - 273.15
    )]
    Outside {
        /// The temperature, in K.
        temperature: f64,
        /// The lowest with a factor.
        from: f64,
        /// The highest.
        to: f64,
    },
    /// Given factors of which none is 1.
    #[error(
        "no shift factor is 1, so their reference temperature is not known; give it, as in --reference-temperature \"20 \
         degC\""
    )]
    NoReference,
    /// Moduli at several temperatures, and none to shift them to.
    #[error(
        "the moduli are at temperatures from {:.1} to {:.1} degC and no one material; say to which temperature they are \
         to be shifted, as in --reference-temperature \"20 degC\"",
        from - 273.15,
        to - 273.15
    )]
    SeveralTemperatures {
        /// The lowest, in K.
        from: f64,
        /// The highest.
        to: f64,
    },
    /// A temperature to shift moduli to that have none.
    #[error(
        "no column has a temperature, so the moduli cannot be shifted to the reference temperature; leave this out, or \
         name the column, as in --columns \"temperature=#4\""
    )]
    NoTemperatures,
    /// A temperature to shift a series to.
    #[error(
        "a Prony series is at one temperature and is not shifted; leave out --reference-temperature T, or give \
         --shift-factors FILE beside it, which tell the law"
    )]
    SeriesIsNotShifted,
    /// Moduli of which none is shifted onto another one.
    #[error(
        "there are no isotherms here whose moduli could be shifted, but a series, or moduli at one temperature or none; \
         leave out --vertical-shift HOW"
    )]
    NothingToLevel,
    /// The factors are none.
    #[error("the isotherms give no shift factors: {0}; give them (--shift-factors FILE)")]
    Factors(#[from] ShiftFactorsError),
}
