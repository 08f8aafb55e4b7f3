//! A logarithmic axis whose ends follow from what it shows.

use crate::axes::place;
use crate::axes::ticks::{self, Ticks};

/// From positive numbers to shares of the axis's length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LogAxis {
    /// Decimal logarithms of the ends, low < high.
    low: f64,
    high: f64,
    /// The ends as numbers, where logarithms tell too little.
    narrow: Option<(f64, f64)>,
}

impl LogAxis {
    /// The axis that shows all these values with some room beside them, a decade at least; none if there are no values.
    pub(crate) fn around(values: impl Iterator<Item = f64>) -> Option<Self> {
        /// Room at each end, over the whole range.
        const ROOM: f64 = 0.05;
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value.log10()), high.max(value.log10()))
        });
        if low > high {
            return None;
        }
        let lacking = (0.5 * (1.0 - (high - low))).max(ROOM * (high - low));
        Some(LogAxis { low: low - lacking, high: high + lacking, narrow: None })
    }

    /// The axis from one positive number to a larger one.
    pub(crate) fn between(low: f64, high: f64) -> Self {
        let (start, end) = (low.log10(), high.log10());
        LogAxis { low: start, high: end, narrow: place::is_narrow(start, end).then_some((low, high)) }
    }

    /// 0 at the lower end, 1 at the upper.
    pub(crate) fn share(&self, value: f64) -> f64 {
        match self.narrow {
            Some((low, high)) => place::linear(value, low, high),
            None => place::linear(value.log10(), self.low, self.high),
        }
    }

    /// At most `most` labels.
    pub(crate) fn ticks(&self, most: usize) -> Ticks {
        // A decade at the very end must not be lost to rounding.
        const SLACK: f64 = 1e-9;
        let numbers = || place::numbers_between(self.low - SLACK, self.high + SLACK);
        let (low, high) = self.narrow.unwrap_or_else(numbers);
        ticks::logarithmic(low, high, most)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::{any_positive, range_of};

    laws! {
        seed: 33, cases: 256;

        fn any_numbers_have_an_axis(
            (low, high) in range_of(any_positive()), values in prop::collection::vec(any_positive(), 1..9),
        ) {
            let around = LogAxis::around(values.iter().copied()).unwrap();
            prop_assert!(values.iter().all(|value| (0.0..=1.0).contains(&around.share(*value))), "{around:?}");
            for axis in [around, LogAxis::between(low, high)] {
                let shares: Vec<f64> = axis.ticks(9).major.iter().map(|tick| axis.share(tick.value)).collect();
                prop_assert!(shares.len() >= 2 && shares.windows(2).all(|pair| pair[0] < pair[1]), "{axis:?}");
                prop_assert!(shares.iter().all(|share| (-0.01..=1.01).contains(share)), "{axis:?}: {shares:?}");
            }
        }
    }

    #[test]
    fn places_grow_with_the_value_and_stay_inside() {
        let values = [1e-12, 3e-9, 3.1e-9, 1.0, 40.0];
        let axis = LogAxis::around(values.into_iter()).unwrap();
        let shares = values.map(|value| axis.share(value));
        assert!(shares.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(shares.iter().all(|share| (0.0..=1.0).contains(share)));
    }

    #[test]
    fn the_ends_of_an_axis_are_labelled() {
        for (low, high) in [(1e-3, 1e3), (10.0, 1000.0), (1e-7, 1e5)] {
            let axis = LogAxis::between(low, high);
            assert_eq!((axis.share(low), axis.share(high)), (0.0, 1.0));
            let ticks = axis.ticks(13);
            assert_eq!((ticks.major[0].value, ticks.major[ticks.major.len() - 1].value), (low, high));
        }
    }

    #[test]
    fn one_value_stands_in_the_middle_of_a_decade() {
        let axis = LogAxis::around([2e-5, 2e-5].into_iter()).unwrap();
        assert!((axis.share(2e-5) - 0.5).abs() < 1e-12);
        assert!((axis.share(2e-4) - axis.share(2e-5) - 1.0).abs() < 1e-12);
        assert!(LogAxis::around(std::iter::empty()).is_none());
    }
}
