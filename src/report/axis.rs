//! The axes of a page: their names, and the values shown.

use serde::Serialize;

use crate::pictures::AxisWords;

/// A value of an axis.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum AxisValue {
    Number(f64),
    /// The word `inf`, as JSON has no number for ∞.
    Word(&'static str),
}

/// The names of an axis, and what its values stand for.
#[derive(Debug, Serialize)]
pub(super) struct AxisPart {
    name: String,
    symbol: String,
    label: String,
    unit: String,
    /// What each value shown stands for, where several quantities are taken together.
    combinations: Vec<String>,
    /// The same as names and values.
    members: Vec<Vec<(String, f64)>>,
}

impl From<f64> for AxisValue {
    fn from(value: f64) -> Self {
        if value == f64::INFINITY { AxisValue::Word("inf") } else { AxisValue::Number(value) }
    }
}

impl AxisPart {
    /// The axis with the values of these indices.
    pub(super) fn of(axis: &AxisWords, shown: &[usize]) -> Self {
        let AxisWords { name, symbol, label, unit, combinations, members, .. } = axis;
        let [name, symbol, label, unit] = [name, symbol, label, unit].map(Clone::clone);
        let combinations = shown.iter().filter_map(|i| combinations.get(*i).cloned()).collect();
        let members = shown.iter().filter_map(|i| members.get(*i).cloned()).collect();
        Self { name, symbol, label, unit, combinations, members }
    }
}
