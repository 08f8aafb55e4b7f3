//! Axes: lists and ranges of numbers.

use super::entry::{Entry, Section};
use super::error::{Fault, Readings, each};

/// A kind of numbers that a key may have: how one is read, and how many an axis may hold.
pub trait Values {
    /// Reads one value.
    ///
    /// # Errors
    /// [`Fault`] if it is no number of this kind.
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault>;

    /// The most values of an axis.
    fn limit(&self) -> usize {
        1_000_000
    }
}

/// A dimensionless quantity: decides which numbers its key may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// f: finite, at least 0.
    Strength,
    /// α: at least 0, or +∞ in a list.
    SlideTime,
    /// β: finite, above 0.
    InverseHersey,
    /// x of the fields: finite.
    Position,
    /// S: from −1 to 1.
    SlideRoll,
}

/// A number, or an axis of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Varying {
    /// One number.
    Fixed(f64),
    /// An axis: not empty, ascending.
    Axis(Vec<f64>),
}

/// Spacing of a range.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Scale {
    #[default]
    Linear,
    Log,
}

/// The keys of a range.
pub const RANGE_KEYS: [&str; 4] = ["from", "to", "points", "scale"];

/// The scales of a range, the default first.
pub const RANGE_SCALES: [&str; 2] = ["linear", "log"];

impl Quantity {
    /// True for a value that the quantity may have.
    pub fn admits(self, value: f64) -> bool {
        match self {
            Quantity::Strength => value.is_finite() && value >= 0.0,
            Quantity::SlideTime => value >= 0.0,
            Quantity::InverseHersey => value.is_finite() && value > 0.0,
            Quantity::Position => value.is_finite(),
            Quantity::SlideRoll => (-1.0..=1.0).contains(&value),
        }
    }

    /// The values that it may have, in words.
    pub fn allowed(self) -> &'static str {
        match self {
            Quantity::Strength => "finite and at least 0",
            Quantity::SlideTime => "at least 0, or inf",
            Quantity::InverseHersey => "finite and above 0",
            Quantity::Position => "finite",
            Quantity::SlideRoll => "from -1 to 1",
        }
    }

    /// What to do about a value that it may not have.
    pub fn remedy(self) -> &'static str {
        match self {
            Quantity::Strength => "f = E0/Einf - 1 is 0 for an elastic substrate and positive for a viscoelastic one",
            Quantity::SlideTime => {
                "alpha = a0/(V tau) is positive; 0 is the stiff elastic limit (fast), inf the relaxed one (slow)"
            }
            Quantity::InverseHersey => "beta is positive; dry sliding is the limit of large beta: 1e4, say, is near it",
            Quantity::Position => "x is a place in units of a0, as in -3.0",
            Quantity::SlideRoll => {
                "(u2 - u1)/(u1 + u2) of flat and roller: 1 is a roller that does not turn, 0 pure rolling; beyond, the \
                 surfaces would move against each other, and a film of that kind is not computed"
            }
        }
    }
}

impl Values for Quantity {
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault> {
        let value = entry.number()?;
        if self.admits(value) { Ok(value) } else { Err(entry.not_allowed(self.allowed(), self.remedy())) }
    }

    fn limit(&self) -> usize {
        match self {
            Quantity::Position => 10_001,
            _ => 1_000_000,
        }
    }
}

/// Reads an axis: a number, a list or a range.
///
/// # Errors
/// [`Fault`] if the entry is neither, its values do not ascend, or one of them is not allowed.
pub fn read(entry: &Entry<'_>, quantity: impl Values) -> Result<Vec<f64>, Fault> {
    if entry.list().is_some() {
        read_list(entry, &quantity)
    } else if entry.is_section() {
        read_range(&entry.section(&RANGE_KEYS, |_| None)?, entry, &quantity)
    } else if entry.is_number() {
        Ok(vec![quantity.read(entry)?])
    } else {
        let help =
            "write a number, a list as in [10.0, 100.0], or { from = 10.0, to = 1000.0, points = 41, scale = \"log\" }";
        let what = format!("`{}` must be a number, a list or a range {{ from, to, points, scale }}", entry.path());
        Err(entry.fault(what, "neither number nor list nor range", help))
    }
}

/// Reads a number, or an axis.
///
/// # Errors
/// As [`read`] of an axis, and [`Fault`] if a single number is not allowed.
pub fn read_varying(entry: &Entry<'_>, quantity: impl Values) -> Result<Varying, Fault> {
    if entry.list().is_some() || entry.is_section() {
        read(entry, quantity).map(Varying::Axis)
    } else {
        quantity.read(entry).map(Varying::Fixed)
    }
}

fn read_list(entry: &Entry<'_>, quantity: &impl Values) -> Result<Vec<f64>, Fault> {
    let items = || entry.list().into_iter().flatten();
    let number = items().count();
    if number == 0 {
        let what = format!("`{}` must have at least one value", entry.path());
        return Err(entry.fault(what, "empty", "write at least one value, as in [100.0]"));
    }
    if number > quantity.limit() {
        let what = format!("`{}` may have at most {} values, not {number}", entry.path(), quantity.limit());
        return Err(entry.fault(what, "too many values", "split the sweep into several files").unquoted());
    }
    let values = each(items().map(|item| quantity.read(&item)))?;
    let mut pairs = items().skip(1).zip(values.windows(2));
    // The first one alone: in a list of the wrong order each value is below the one before it.
    pairs.try_for_each(|(item, pair)| check_ascent(entry, &item, pair[0], pair[1]))?;
    Ok(values)
}

/// Refuses a value that is not above the one before it.
fn check_ascent(entry: &Entry<'_>, item: &Entry<'_>, last: f64, value: f64) -> Result<(), Fault> {
    if value > last {
        return Ok(());
    }
    Err(match value == last {
        true => {
            let what = format!("a value of `{}` may stand there only once", entry.path());
            item.fault(what, "the same as the value before it", "remove one of the two")
        }
        false => {
            let label = format!("below the value before it, {last:?}");
            let what = format!("the values of `{}` must ascend", entry.path());
            item.fault(what, label, "sort the list, smallest value first")
        }
    })
}

fn read_range(range: &Section<'_>, entry: &Entry<'_>, quantity: &impl Values) -> Result<Vec<f64>, Fault> {
    let help = "a range is { from = 10.0, to = 1000.0, points = 41, scale = \"log\" }";
    let [linear, log] = RANGE_SCALES;
    let choices = [(linear, Scale::Linear), (log, Scale::Log)];
    let end = |key| {
        let end = range.require(key, help)?;
        match quantity.read(&end)? {
            value if value.is_finite() => Ok((end, value)),
            _ => {
                let help = "take finite end points; inf may stand at the end of a list, as in [1.0, 10.0, inf]";
                Err(end.fault(format!("`{}` must be finite", end.path()), "a range cannot reach it", help))
            }
        }
    };
    let points = range.require("points", help).and_then(|points| points.whole(2..=quantity.limit()));
    let scale = range.optional("scale", |scale| scale.choice(&choices));
    let ((from_entry, from), (to_entry, to), points, scale) = (end("from"), end("to"), points, scale).all()?;
    let scale = scale.unwrap_or_default();
    if scale == Scale::Log && from <= 0.0 {
        let what = format!("`{}` must be above 0 on a log scale", from_entry.path());
        let help = "begin above 0, as in 1e-3, or take scale = \"linear\"; a list can hold 0 and any other values";
        return Err(from_entry.fault(what, "has no logarithm", help));
    }
    if from >= to {
        let what = format!("`{}` must be above `{}` = {from:?}", to_entry.path(), from_entry.path());
        let help = "swap the two; for a single value write a list, as in [100.0]";
        return Err(to_entry.fault(what, "not above the start", help));
    }
    let values = range_values(from, to, points, scale == Scale::Log);
    if values.is_sorted_by(|left, right| left < right) && values.iter().all(|value| value.is_finite()) {
        Ok(values)
    } else {
        let what = format!("the {points} points of `{}` are not distinct numbers of double precision", entry.path());
        Err(entry.fault(what, "too many points for this range", "take fewer points or a wider range"))
    }
}

/// `points` ≥ 2 values of a range with exact end points, on a scale of logarithms or a linear one.
///
/// Point i of n stands at the fraction i/(n−1) in lowest terms. So the points that a refined range shares with the
/// range before are the same numbers to the last bit, and their results are reused; logarithm and power are the
/// program's own, not the system's, so that they are also the same on every machine.
pub fn range_values(from: f64, to: f64, points: usize, is_logarithmic: bool) -> Vec<f64> {
    let intervals = points - 1;
    let between = |i: usize| {
        let divisor = greatest_common_divisor(i, intervals);
        let (part, whole) = ((i / divisor) as f64, (intervals / divisor) as f64);
        let interpolate = |a: f64, b: f64| (a * (whole - part) + b * part) / whole;
        match is_logarithmic {
            false => interpolate(from, to),
            true => pxfm::f_exp10(interpolate(pxfm::f_log10(from), pxfm::f_log10(to))),
        }
    };
    let mut values: Vec<f64> = (0..points).map(between).collect();
    values[0] = from;
    values[intervals] = to;
    values
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
