//! An axis of a chart of curves: from numbers to shares of its length.

use crate::axes::ticks::{self, Tick, Ticks};
use crate::axes::{Axis, place};

/// A linear or a logarithmic axis; a logarithmic one may have places for 0 and ∞ beyond its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ScaledAxis {
    logarithmic: bool,
    /// The ends, as numbers.
    low: f64,
    high: f64,
    /// The part of the length that belongs to the numbers between the ends.
    span: (f64, f64),
    zero: bool,
    infinity: bool,
}

/// What a place for 0 or ∞ takes of the length.
const SPECIAL: f64 = 0.07;

impl ScaledAxis {
    /// The axis that shows these values, or this range. `room` is what is left free at each end, over the whole range.
    pub(crate) fn new(
        values: impl Iterator<Item = f64>,
        logarithmic: bool,
        range: Option<(f64, f64)>,
        room: f64,
    ) -> Self {
        let (mut least, mut most, mut zero, mut infinity) = (f64::INFINITY, f64::NEG_INFINITY, false, false);
        for value in values {
            if logarithmic && value == 0.0 {
                zero = true;
            } else if value == f64::INFINITY {
                infinity = true;
            } else {
                (least, most) = (least.min(value), most.max(value));
            }
        }
        let (low, high) = range.unwrap_or_else(|| place::ends(around(least, most, logarithmic, room), logarithmic));
        let span = (if zero { SPECIAL } else { 0.0 }, if infinity { 1.0 - SPECIAL } else { 1.0 });
        Self { logarithmic, low, high, span, zero, infinity }
    }

    /// The same of numbers that are not negative, beginning at 0 unless all are far from it.
    pub(crate) fn begun_at_zero(self, values: impl Iterator<Item = f64>) -> Self {
        let least = values.fold(f64::INFINITY, f64::min);
        if !self.logarithmic && least >= 0.0 && self.low < 0.5 * self.high { Self { low: 0.0, ..self } } else { self }
    }

    /// Whether a number is one of those beyond the ends.
    pub(crate) fn is_special(&self, value: f64) -> bool {
        self.logarithmic && (value == 0.0 || value == f64::INFINITY)
    }

    /// The part of the length between the ends.
    pub(crate) fn span(&self) -> (f64, f64) {
        self.span
    }
}

impl Axis for ScaledAxis {
    /// 0 at the lower end, 1 at the upper; beyond for numbers that are not between the ends.
    fn share(&self, value: f64) -> f64 {
        if self.is_special(value) {
            return if value == 0.0 { 0.5 * (self.span.0 - 0.01) } else { 1.0 - 0.5 * (1.0 - self.span.1 - 0.01) };
        }
        let share = if self.logarithmic { place::logarithmic } else { place::linear };
        self.span.0 + (self.span.1 - self.span.0) * share(value, self.low, self.high)
    }

    /// The ticks of an axis of `length` pixels, whose labels (of font size `em`) lie along it or, `upright`, across it.
    fn ticks(&self, length: f64, em: f64, upright: bool) -> Ticks {
        let extent = ticks::extent(|value| self.share(value), length, em, upright);
        let special = [(self.zero, 0.0, "0"), (self.infinity, f64::INFINITY, "∞")];
        let with_special = |mut ticks: Ticks| {
            let there = special.iter().filter(|(there, ..)| *there);
            ticks.major.extend(there.map(|(_, value, label)| Tick { value: *value, label: (*label).to_string() }));
            ticks
        };
        let candidates = |most| {
            with_special(if self.logarithmic {
                ticks::logarithmic(self.low, self.high, most)
            } else {
                ticks::linear(self.low, self.high, most)
            })
        };
        ticks::fitting_or_fewer(candidates, extent, if upright { 0.4 * em } else { 0.6 * em })
    }
}

/// Ends around the values from `least` to `most`, which may be one number or none. They may be beyond all numbers.
fn around(least: f64, most: f64, logarithmic: bool, room: f64) -> (f64, f64) {
    if least > most {
        return if logarithmic { (0.1, 10.0) } else { (0.0, 1.0) };
    }
    if logarithmic {
        let (low, high) = (least.log10(), most.log10());
        // A logarithmic axis is no help below a factor of two.
        let room = (0.5 * (0.3 - (high - low))).max(room * (high - low));
        return (10_f64.powf(low - room), 10_f64.powf(high + room));
    }
    let size = least.abs().max(most.abs());
    if most - least <= 1e-9 * size || size == 0.0 {
        let half = if size == 0.0 { 1.0 } else { 0.5 * size };
        return (least - half, most + half);
    }
    let width = most - least;
    let room = if width.is_finite() { room * width } else { room * most - room * least };
    (least - room, most + room)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::any_number;

    laws! {
        seed: 8, cases: 256;

        fn places_grow_with_the_value_and_stay_inside(
            tenths in prop::collection::btree_set(-80..80i32, 1..9),
            zero: bool,
            infinity: bool,
            logarithmic: bool,
            upright: bool,
        ) {
            let mut values: Vec<f64> = (zero && logarithmic).then_some(0.0).into_iter().collect();
            values.extend(tenths.into_iter().map(|tenths| 10f64.powf(0.1 * f64::from(tenths))));
            values.extend((infinity && logarithmic).then_some(f64::INFINITY));
            let axis = ScaledAxis::new(values.iter().copied(), logarithmic, None, 0.02);
            let shares: Vec<f64> = values.iter().map(|value| axis.share(*value)).collect();
            prop_assert!(shares.windows(2).all(|pair| pair[0] < pair[1]), "{shares:?}");
            prop_assert!(shares.iter().all(|share| (-1e-9..=1.0 + 1e-9).contains(share)), "{shares:?}");
            let ticks = axis.ticks(1000.0, 40.0, upright);
            let inside = |tick: &Tick| (-1e-9..=1.0 + 1e-9).contains(&axis.share(tick.value));
            prop_assert!(ticks.major.len() >= 2 && ticks.major.iter().all(inside), "{ticks:?}");
        }

        fn any_numbers_have_an_axis_around_them(
            mut values in prop::collection::vec(any_number(), 1..9), logarithmic: bool, from_zero: bool, marked: bool,
        ) {
            if logarithmic {
                values.iter_mut().for_each(|value| *value = value.abs());
            }
            values.sort_by(f64::total_cmp);
            let room = if marked { 0.02 } else { 0.0 };
            let axis = ScaledAxis::new(values.iter().copied(), logarithmic, None, room);
            let axis = if from_zero { axis.begun_at_zero(values.iter().copied()) } else { axis };
            let shares: Vec<f64> = values.iter().map(|value| axis.share(*value)).collect();
            prop_assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]), "{shares:?}");
            prop_assert!(shares.iter().all(|share| (-1e-9..=1.0 + 1e-9).contains(share)), "{shares:?}");
            prop_assert!(axis.ticks(1000.0, 40.0, true).major.len() >= 2);
        }
    }

    #[test]
    fn one_number_has_an_axis_around_it() {
        for (value, logarithmic) in [(0.0, false), (3.0, false), (-2e-9, false), (5.0, true)] {
            let axis = ScaledAxis::new([value, value].into_iter(), logarithmic, None, 0.02);
            assert!((axis.share(value) - 0.5).abs() < 1e-9);
        }
    }
}
