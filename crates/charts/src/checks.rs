//! Checks that charts share.

use crate::ChartError;

/// A list is as long as the axes ask for.
pub(crate) fn count(chart: &str, what: impl Into<String>, found: usize, wanted: usize) -> Result<(), ChartError> {
    if found == wanted {
        return Ok(());
    }
    Err(ChartError::Count { chart: chart.to_string(), what: what.into(), found, wanted })
}

/// The range of an axis or a scale, if there is one, has two ends in order.
pub(crate) fn range(chart: &str, label: &str, range: Option<(f64, f64)>, logarithmic: bool) -> Result<(), ChartError> {
    let Some((low, high)) = range else { return Ok(()) };
    if low < high && low.is_finite() && high.is_finite() && (!logarithmic || low > 0.0) {
        return Ok(());
    }
    Err(ChartError::Value {
        chart: chart.to_string(),
        what: "the upper end",
        value: high,
        place: format!("the range of \"{label}\" from {low}"),
        wanted: "a range goes from a lower to a higher number, both above zero if the scale is logarithmic",
    })
}

/// The values of an axis are finite and increase; above zero if the axis is logarithmic. There are two at least.
pub(crate) fn axis(chart: &str, label: &str, values: &[f64], logarithmic: bool) -> Result<(), ChartError> {
    if values.len() < 2 {
        let what = "axis with two values";
        return Err(ChartError::Empty { chart: chart.to_string(), what });
    }
    for (i, value) in values.iter().enumerate() {
        let increasing = i == 0 || values[i - 1] < *value;
        if !value.is_finite() || !increasing || (logarithmic && *value <= 0.0) {
            return Err(ChartError::Value {
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
