//! Error against run time: what the chart is given, and what is drawn of it.

mod layout;
mod placement;
mod setting_label;

use crate::ChartError;
use crate::chart::Drawing;
use crate::median::geometric_median;
use crate::paint::scene::Scene;
use crate::paper::Paper;

/// Error against run time on logarithmic axes, one line for each method.
///
/// Single cases are small faint markers. A large marker stands at the median (of the logarithms) of the seconds and
/// errors of the cases of a setting whose errors are known, and a line joins the settings of a method. A case that
/// failed is a × in a band along the upper edge, at its seconds; the label of the setting says how many did. An error
/// of exactly zero lies in a band along the lower edge. A case whose error is not known is drawn nowhere.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkPrecision {
    /// Heading.
    pub title: String,
    /// Second line of the heading; may be empty.
    pub subtitle: String,
    /// Name of the horizontal axis, "seconds for a case".
    pub x_label: String,
    /// Name of the vertical axis, "relative error of μ_v".
    pub y_label: String,
    /// The methods.
    pub lines: Vec<MethodLine>,
}

/// The settings of one method.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodLine {
    /// Name in the legend.
    pub label: String,
    /// One point for each setting, in the order in which the line joins them.
    pub points: Vec<SettingPoint>,
}

/// What became of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// It was solved with this error (≥ 0).
    Error(f64),
    /// It was solved, and there is nothing better to compare it with.
    Unknown,
    /// It was not solved.
    Failed,
}

/// The cases solved with one setting of a method.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingPoint {
    /// Short name of the setting: "801", "1e-5".
    pub label: String,
    /// Seconds (> 0) and outcome of each case.
    pub cases: Vec<(f64, Outcome)>,
}

/// Medians over the cases of a setting whose errors are known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Medians {
    pub(crate) seconds: f64,
    /// Zero if a middle one is.
    pub(crate) error: f64,
}

impl SettingPoint {
    /// Seconds of the cases that failed.
    pub(crate) fn failed(&self) -> impl Iterator<Item = f64> {
        self.cases.iter().filter(|(_, outcome)| *outcome == Outcome::Failed).map(|(seconds, _)| *seconds)
    }

    pub(crate) fn failures(&self) -> usize {
        self.failed().count()
    }

    /// Seconds and error of the cases whose errors are known.
    pub(crate) fn known(&self) -> impl Iterator<Item = (f64, f64)> {
        self.cases.iter().filter_map(|(seconds, outcome)| match outcome {
            Outcome::Error(error) => Some((*seconds, *error)),
            Outcome::Unknown | Outcome::Failed => None,
        })
    }

    /// None if no error is known.
    pub(crate) fn medians(&self) -> Option<Medians> {
        Some(Medians {
            seconds: geometric_median(self.known().map(|pair| pair.0))?,
            error: geometric_median(self.known().map(|pair| pair.1))?,
        })
    }
}

impl Drawing for WorkPrecision {
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError> {
        self.check()?;
        Ok(layout::draw(self, paper, stretch))
    }
}

impl WorkPrecision {
    fn check(&self) -> Result<(), ChartError> {
        let mut cases = 0;
        for line in &self.lines {
            for point in &line.points {
                for (seconds, outcome) in &point.cases {
                    cases += 1;
                    let refused = |what, value, wanted| {
                        let place = format!("setting \"{}\" of \"{}\"", point.label, line.label);
                        ChartError::Value { chart: self.title.clone(), what, value, place, wanted }
                    };
                    if !(seconds.is_finite() && *seconds > 0.0) {
                        return Err(refused("seconds", *seconds, "seconds are finite and above zero"));
                    }
                    if let Outcome::Error(error) = outcome
                        && !(error.is_finite() && *error >= 0.0)
                    {
                        return Err(refused("error", *error, "an error is finite and not negative"));
                    }
                }
            }
        }
        if cases == 0 {
            return Err(ChartError::Empty { chart: self.title.clone(), what: "case" });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;

    fn outcome() -> impl Strategy<Value = Outcome> {
        let error = (1e-12..1.0f64).prop_map(Outcome::Error);
        prop_oneof![4 => error, 1 => Just(Outcome::Unknown), 1 => Just(Outcome::Failed)]
    }

    fn point(cases: Vec<(f64, Outcome)>) -> SettingPoint {
        SettingPoint { label: "one".to_string(), cases }
    }

    laws! {
        seed: 5, cases: 256;

        fn medians_are_those_of_known_errors_and_forget_the_order_of_cases(
            cases in prop::collection::vec((1e-4..1e3f64, outcome()), 1..30),
        ) {
            let one = point(cases.clone());
            let other = point(cases.iter().rev().copied().collect());
            prop_assert_eq!(one.medians(), other.medians());
            let unknown = cases.iter().filter(|case| case.1 == Outcome::Unknown).count();
            let known = one.known().count();
            prop_assert_eq!(known + unknown + one.failures(), cases.len());
            prop_assert_eq!(one.medians().is_some(), known > 0);
        }
    }

    #[test]
    fn half_of_the_errors_zero_make_the_median_zero() {
        let errors = [(1.0, 0.0), (2.0, 0.0), (4.0, 1e-3)].map(|(seconds, error)| (seconds, Outcome::Error(error)));
        let others = [(8.0, Outcome::Failed), (16.0, Outcome::Unknown)];
        let medians = point([&errors[..], &others[..]].concat()).medians().unwrap();
        assert_eq!(medians.error, 0.0);
        assert!((medians.seconds - 2.0).abs() < 1e-12);
        assert_eq!(point(others.to_vec()).medians(), None);
    }
}
