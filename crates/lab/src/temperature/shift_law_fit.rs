//! Laws of temperature from measured shift factors.

use super::shift_law::{GAS_CONSTANT, ShiftLaw};

/// Steps in which c₂ is looked for.
const STEPS: u32 = 200;
/// c₂ above the least that the temperatures allow, in K: from where to where it is looked for.
const ROOM: (f64, f64) = (0.1, 1e4);

/// A residual, in decades, that no measurement of shifts goes below.
const GOOD_ENOUGH: f64 = 0.01;
/// Residual over that of a law with one more constant, up to which it is as good.
const AS_GOOD: f64 = 1.1;

/// A law fitted to shift factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShiftLawFit {
    /// The law.
    pub law: ShiftLaw,
    /// Root of the mean square of log₁₀ a_T less that of the law, in decades.
    pub rms_residual: f64,
    /// The largest of these differences, in decades.
    pub largest_residual: f64,
}

impl ShiftLawFit {
    /// The laws that pairs (T in K, log₁₀ a_T) at a reference temperature follow. That of Arrhenius, which has one
    /// constant less, is the first one where its residual is a hundredth of a decade or less, or within a tenth of the
    /// other one; else it is the last.
    ///
    /// Both have the least sum of squares of log₁₀ a_T. A law is left out where the pairs do not tell its constants: with
    /// fewer temperatures beside the reference than it has constants, with a constant below zero, or, for that of
    /// Williams, Landel and Ferry, on a straight line, on which c₁ and c₂ may have any size.
    pub fn all(pairs: &[(f64, f64)], reference: f64) -> Vec<Self> {
        let [simple, other] =
            [arrhenius(pairs, reference), wlf(pairs, reference)].map(|law| law.and_then(|law| Self::of(law, pairs)));
        let is_as_good =
            |simple: &Self, other: &Self| simple.rms_residual <= (AS_GOOD * other.rms_residual).max(GOOD_ENOUGH);
        let both = match (simple, other) {
            (Some(simple), Some(other)) if !is_as_good(&simple, &other) => [Some(other), Some(simple)],
            either => either.into(),
        };
        both.into_iter().flatten().collect()
    }

    fn of(law: ShiftLaw, pairs: &[(f64, f64)]) -> Option<Self> {
        let difference = |&(temperature, log): &(f64, f64)| Some((log - law.log_shift_factor(temperature)?).abs());
        let differences: Vec<f64> = pairs.iter().map(difference).collect::<Option<_>>()?;
        let squares: f64 = differences.iter().map(|difference| difference * difference).sum();
        Some(Self {
            law,
            rms_residual: (squares / pairs.len() as f64).sqrt(),
            largest_residual: differences.into_iter().fold(0.0, f64::max),
        })
    }
}

/// Temperatures that differ from the reference.
fn count(pairs: &[(f64, f64)], reference: f64) -> usize {
    pairs.iter().filter(|(temperature, _)| (temperature - reference).abs() > 1e-6).count()
}

/// The factor of least squares of y = factor · x, and the sum of squares that it leaves.
fn line(points: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64) {
    let product: f64 = points.clone().map(|(x, y)| x * y).sum();
    let square: f64 = points.clone().map(|(x, _)| x * x).sum();
    let factor = product / square;
    (factor, points.map(|(x, y)| (y - factor * x).powi(2)).sum())
}

fn arrhenius(pairs: &[(f64, f64)], reference: f64) -> Option<ShiftLaw> {
    if count(pairs, reference) < 1 {
        return None;
    }
    let unit = std::f64::consts::LOG10_E / GAS_CONSTANT;
    let points = pairs.iter().map(|(temperature, log)| (unit * (1.0 / temperature - 1.0 / reference), *log));
    let (activation_energy, _) = line(points);
    (activation_energy > 0.0).then_some(ShiftLaw::Arrhenius { activation_energy, reference })
}

/// For each c₂ the best c₁ is that of a line; so c₂ alone is looked for.
fn wlf(pairs: &[(f64, f64)], reference: f64) -> Option<ShiftLaw> {
    if count(pairs, reference) < 2 {
        return None;
    }
    let least = pairs.iter().map(|(temperature, _)| reference - temperature).fold(0.0, f64::max);
    let at = |step: f64| least + ROOM.0 * (ROOM.1 / ROOM.0).powf(step / f64::from(STEPS));
    let fit = |step: f64| {
        let c2 = at(step);
        line(pairs.iter().map(move |(temperature, log)| {
            let above = temperature - reference;
            (-above / (c2 + above), *log)
        }))
    };
    let (best, _) = (0..=STEPS).map(|step| (step, fit(f64::from(step)).1)).min_by(|a, b| a.1.total_cmp(&b.1))?;
    if best == 0 || best == STEPS {
        return None;
    }
    let step = least_of(|step| fit(step).1, f64::from(best) - 1.0, f64::from(best) + 1.0);
    let (c1, _) = fit(step);
    (c1 > 0.0).then_some(ShiftLaw::Wlf { c1, c2: at(step), reference })
}

/// Where a function with one minimum between two ends has it, by the golden section.
pub(crate) fn least_of(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let part = (5_f64.sqrt() - 1.0) / 2.0;
    let (mut left, mut right) = (high - part * (high - low), low + part * (high - low));
    let (mut at_left, mut at_right) = (function(left), function(right));
    // each step keeps 0.618 of the interval: 60 leave 3e-13 of it
    for _ in 0..60 {
        if at_left <= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - part * (high - low);
            at_left = function(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + part * (high - low);
            at_right = function(right);
        }
    }
    0.5 * (low + high)
}
