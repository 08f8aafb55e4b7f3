//! Isotherms shifted along the axis of rates until they are one curve.

use super::isotherms::{Isotherm, Isotherms};
use super::measurement::{Measurement, Measurements};
use super::shift_factors::{ShiftFactors, ShiftFactorsError};
use crate::temperature::{ShiftLawFit, least_of};

/// The part of the shorter one of two isotherms, in decades, that lies over the other one at least.
const OVERLAP: f64 = 0.2;
/// Steps in a decade in which a shift is looked for.
const STEPS: f64 = 50.0;

/// Moduli at a reference temperature, from measurements at several.
#[derive(Clone, Debug, PartialEq)]
pub struct MasterCurve {
    /// The reference temperature, in K.
    pub reference: f64,
    /// Where each isotherm went, cold ones first.
    pub shifts: Vec<Shift>,
    /// All measurements, at the rates that they would have at the reference temperature.
    pub measurements: Measurements,
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
    /// Root of the mean square of |ΔE*|/|E*| where it lies over the next colder one; `None` for the coldest.
    pub residual: Option<f64>,
}

impl MasterCurve {
    /// Shifts isotherms to a reference temperature, in K, within their range.
    ///
    /// Each isotherm is shifted against its neighbour until the mean of |ΔE*|²/|E*|² over their overlap is least, with
    /// straight lines between the points on logarithmic scales. Nothing is shifted along the axis of moduli.
    ///
    /// # Errors
    /// [`MasterCurveError`] if the reference lies outside, or two neighbours have no best overlap of a fifth of the
    /// shorter one.
    pub fn by_overlap(isotherms: &Isotherms, reference: f64) -> Result<Self, MasterCurveError> {
        let all = isotherms.all();
        let mut pairs = vec![(all[0].temperature, 0.0)];
        let mut residuals = vec![None];
        for next in all.windows(2) {
            let (step, residual) = overlap(&next[0], &next[1])?;
            pairs.push((next[1].temperature, pairs[pairs.len() - 1].1 + step));
            residuals.push(Some(residual));
        }
        let factors = ShiftFactors::new(pairs)?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, isotherms.range()))?;
        Self::assemble(isotherms, &factors, reference, |i, _| residuals[i])
    }

    /// Shifts isotherms by given factors, to the reference temperature of these or to another one.
    ///
    /// # Errors
    /// [`MasterCurveError`] if a temperature has no factor, or the factors have no reference.
    pub fn by_factors(
        isotherms: &Isotherms,
        factors: &ShiftFactors,
        reference: Option<f64>,
    ) -> Result<Self, MasterCurveError> {
        let reference = reference.or_else(|| factors.reference()).ok_or(MasterCurveError::NoReference)?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, factors.range()))?;
        Self::assemble(isotherms, &factors, reference, |i, steps| {
            let neighbours = isotherms.all().get(i.wrapping_sub(1)..=i)?;
            difference(&neighbours[0], &neighbours[1], steps[i] - steps[i - 1])
        })
    }

    /// Measurements that are at the reference temperature of given factors already, or at another one of theirs.
    ///
    /// # Errors
    /// [`MasterCurveError`] if the factors have no reference.
    pub fn of_shifted(
        measurements: Measurements,
        factors: &ShiftFactors,
        reference: Option<f64>,
    ) -> Result<Self, MasterCurveError> {
        let reference = reference.or_else(|| factors.reference()).ok_or(MasterCurveError::NoReference)?;
        let factors = factors.at_reference(reference).ok_or_else(|| outside(reference, factors.range()))?;
        let shift = |&(temperature, log_factor): &(f64, f64)| Shift { temperature, log_factor, residual: None };
        let laws = ShiftLawFit::all(factors.pairs(), reference);
        Ok(Self { reference, shifts: factors.pairs().iter().map(shift).collect(), measurements, laws })
    }

    /// The curve of shifted isotherms; `residual` is that of an isotherm over the next colder one, given all shifts.
    fn assemble(
        isotherms: &Isotherms,
        factors: &ShiftFactors,
        reference: f64,
        residual: impl Fn(usize, &[f64]) -> Option<f64>,
    ) -> Result<Self, MasterCurveError> {
        let log_factor = |isotherm: &Isotherm| {
            factors.at(isotherm.temperature).ok_or_else(|| outside(isotherm.temperature, factors.range()))
        };
        let logs: Vec<f64> = isotherms.all().iter().map(log_factor).collect::<Result<_, _>>()?;
        let mut rows = Vec::new();
        let mut shifts = Vec::new();
        for (i, isotherm) in isotherms.all().iter().enumerate() {
            rows.extend_from_slice(isotherm.measurements.faster(10_f64.powf(logs[i])).rows());
            let residual = residual(i, &logs);
            shifts.push(Shift { temperature: isotherm.temperature, log_factor: logs[i], residual });
        }
        let laws = ShiftLawFit::all(factors.pairs(), reference);
        let measurements = Measurements::new(rows).expect("each isotherm has two rates");
        Ok(Self { reference, shifts, measurements, laws })
    }
}

fn outside(temperature: f64, (from, to): (f64, f64)) -> MasterCurveError {
    MasterCurveError::Outside { temperature, from, to }
}

/// log₁₀ of the rates, and of the moduli that are above zero, of an isotherm.
struct Curve<'a> {
    rows: &'a [Measurement],
    rates: Vec<f64>,
}

impl<'a> Curve<'a> {
    fn new(isotherm: &'a Isotherm) -> Self {
        let rows = isotherm.measurements.rows();
        Self { rows, rates: rows.iter().map(|row| row.rate().log10()).collect() }
    }

    fn ends(&self) -> (f64, f64) {
        (self.rates[0], self.rates[self.rates.len() - 1])
    }

    /// The moduli at a rate within the ends: on straight lines between the points on logarithmic scales, where both
    /// are above zero.
    fn moduli(&self, rate: f64) -> [f64; 2] {
        let above = self.rates.partition_point(|other| *other < rate).clamp(1, self.rates.len() - 1);
        let (from, to) = (self.rates[above - 1], self.rates[above]);
        let part = if to > from { ((rate - from) / (to - from)).clamp(0.0, 1.0) } else { 0.5 };
        let [low, high] = [self.rows[above - 1].moduli(), self.rows[above].moduli()];
        std::array::from_fn(|i| {
            let straight = low[i] + part * (high[i] - low[i]);
            if low[i] > 0.0 && high[i] > 0.0 { low[i] * (high[i] / low[i]).powf(part) } else { straight }
        })
    }

    /// |ΔE*|²/|E*|² of each row of another curve that lies over this one when it is shifted, in decades.
    fn squares(&self, other: &Self, shift: f64) -> impl Iterator<Item = f64> {
        let (from, to) = self.ends();
        let rows = other.rates.iter().map(move |rate| rate + shift).zip(other.rows);
        let over = rows.filter(move |(rate, _)| (from..=to).contains(rate));
        over.map(|(rate, row)| Measurement::distance(self.moduli(rate), row.moduli()).powi(2))
    }
}

/// The mean of |ΔE*|²/|E*|² over the overlap of two curves, the second one shifted; `None` where none lies over the
/// other.
fn mean_square(fixed: &Curve<'_>, moved: &Curve<'_>, shift: f64) -> Option<f64> {
    let (sum, count) = fixed
        .squares(moved, shift)
        .chain(moved.squares(fixed, -shift))
        .fold((0.0, 0_u32), |(sum, count), square| (sum + square, count + 1));
    (count > 1).then(|| sum / f64::from(count))
}

/// Root of the mean of |ΔE*|²/|E*|² of two isotherms, the second one shifted.
fn difference(cold: &Isotherm, warm: &Isotherm, shift: f64) -> Option<f64> {
    mean_square(&Curve::new(cold), &Curve::new(warm), shift).map(f64::sqrt)
}

/// The decades by which the warmer one of two isotherms lies best over the colder one, and what differs there.
fn overlap(cold: &Isotherm, warm: &Isotherm) -> Result<(f64, f64), MasterCurveError> {
    let none = MasterCurveError::NoOverlap { cold: cold.temperature, warm: warm.temperature };
    let (fixed, moved) = (Curve::new(cold), Curve::new(warm));
    let (fixed_ends, moved_ends) = (fixed.ends(), moved.ends());
    let shared = OVERLAP * (fixed_ends.1 - fixed_ends.0).min(moved_ends.1 - moved_ends.0);
    // from the left end of the cold one to its right end
    let (least, most) = (fixed_ends.0 + shared - moved_ends.1, fixed_ends.1 - shared - moved_ends.0);
    let steps = (STEPS * (most - least)).ceil().max(2.0);
    let at = |step: f64| least + (most - least) * step / steps;
    let square = |step: f64| mean_square(&fixed, &moved, at(step)).unwrap_or(f64::INFINITY);
    let tried = (0..=steps as u32).map(|step| (f64::from(step), square(f64::from(step))));
    let (best, _) = tried.min_by(|a, b| a.1.total_cmp(&b.1)).ok_or(none)?;
    if best == 0.0 || best == steps {
        return Err(none);
    }
    let step = least_of(square, best - 1.0, best + 1.0);
    Ok((at(step), square(step).sqrt()))
}

/// Why isotherms are no master curve. Messages have degrees Celsius, as laboratories do.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MasterCurveError {
    /// Two isotherms that do not overlap.
    #[error(
        "the moduli at {:.1} and {:.1} degC do not overlap by a fifth of their range, so one cannot be shifted onto the \
         other; leave out those beyond the gap, or give shift factors (--shift-factors FILE)",
        cold - 273.15,
        warm - 273.15
    )]
    NoOverlap {
        /// The colder one, in K.
        cold: f64,
        /// The warmer one.
        warm: f64,
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
    /// The factors are none.
    #[error("the isotherms give no shift factors: {0}; give them (--shift-factors FILE)")]
    Factors(#[from] ShiftFactorsError),
}
