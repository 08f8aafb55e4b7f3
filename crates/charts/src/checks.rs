//! Checks that charts share.

use super::FigureError;

/// A list is as long as the axes ask for.
pub(super) fn count(chart: &str, what: impl Into<String>, found: usize, wanted: usize) -> Result<(), FigureError> {
    if found == wanted {
        return Ok(());
    }
    Err(FigureError::Count { chart: chart.to_string(), what: what.into(), found, wanted })
}

/// The range of an axis or a scale, if there is one, has two ends in order.
pub(super) fn range(chart: &str, label: &str, range: Option<(f64, f64)>, logarithmic: bool) -> Result<(), FigureError> {
    let Some((low, high)) = range else { return Ok(()) };
    if low < high && low.is_finite() && high.is_finite() && (!logarithmic || low > 0.0) {
        return Ok(());
    }
    Err(FigureError::Value {
        chart: chart.to_string(),
        what: "the upper end",
        value: high,
        place: format!("the range of \"{label}\" from {low}"),
        wanted: "a range goes from a lower to a higher number, both above zero if the scale is logarithmic",
    })
}

/// The values of an axis are finite and increase; above zero if the axis is logarithmic. There are two at least.
pub(super) fn axis(chart: &str, label: &str, values: &[f64], logarithmic: bool) -> Result<(), FigureError> {
    if values.len() < 2 {
        let what = "axis with two values";
        return Err(FigureError::Empty { chart: chart.to_string(), what });
    }
    for (i, value) in values.iter().enumerate() {
        let increasing = i == 0 || values[i - 1] < *value;
        if !value.is_finite() || !increasing || (logarithmic && *value <= 0.0) {
            return Err(FigureError::Value {
                chart: chart.to_string(),
                what: "a value",
                value: *value,
                place: format!("the axis {label}"),
                wanted: "values are finite and increase, and are above zero if the axis is logarithmic",
            });
        }
    }
    Ok(())
}
