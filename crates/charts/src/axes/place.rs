//! Where a number lies between two others, however large, small or near to each other these are.

/// Shares are cut here, so that pixels reckoned from them are numbers.
const FARTHEST: f64 = 1e300;
/// A logarithmic scale narrower than this, in decades, is linear to less than a millionth of its width. Logarithms have
/// too few digits for it.
const NARROW: f64 = 1e-6;

/// The way from `low` to a value as a share of that from `low` to `high`, which differ. A finite number for any value.
pub(crate) fn linear(value: f64, low: f64, high: f64) -> f64 {
    let (part, whole) = (value - low, high - low);
    // A quarter of each where differences are beyond the largest number.
    let quarters = || (0.25 * value - 0.25 * low) / (0.25 * high - 0.25 * low);
    let share = if part.is_finite() && whole.is_finite() { part / whole } else { quarters() };
    share.clamp(-FARTHEST, FARTHEST)
}

/// The same on a logarithmic scale, on which all three are above zero.
pub(crate) fn logarithmic(value: f64, low: f64, high: f64) -> f64 {
    let (start, end) = (low.log10(), high.log10());
    if is_narrow(start, end) { linear(value, low, high) } else { linear(value.log10(), start, end) }
}

/// Whether logarithms tell too little about a scale between decimal logarithms.
pub(crate) fn is_narrow(start: f64, end: f64) -> bool {
    end - start < NARROW
}

/// The ends of a scale: finite, above zero if it is logarithmic, and the first below the second.
pub(crate) fn ends((low, high): (f64, f64), logarithmic: bool) -> (f64, f64) {
    let least = if logarithmic { 0.0_f64.next_up() } else { f64::MIN };
    let low = low.clamp(least, f64::MAX.next_down());
    (low, high.clamp(low.next_up(), f64::MAX))
}

/// The numbers at the ends of a logarithmic scale between decimal logarithms. The smallest numbers, which are few, are
/// not outside.
pub(crate) fn numbers_between(start: f64, end: f64) -> (f64, f64) {
    let (low, high) = ends((10f64.powf(start), 10f64.powf(end)), true);
    let low = if low.log10() < start - NARROW { low.next_up() } else { low };
    (low, if high.log10() > end + NARROW { high.next_down() } else { high })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::{any_number, any_positive, range_of};

    fn check(share: fn(f64, f64, f64) -> f64, (low, high): (f64, f64), mut values: Vec<f64>) {
        values.extend([low, high]);
        values.sort_by(f64::total_cmp);
        let shares: Vec<f64> = values.iter().map(|value| share(*value, low, high)).collect();
        assert_eq!((share(low, low, high), share(high, low, high)), (0.0, 1.0));
        assert!(shares.iter().all(|share| share.is_finite()), "{values:?}: {shares:?}");
        assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]), "{values:?}: {shares:?}");
    }

    laws! {
        seed: 31, cases: 512;

        fn shares_are_finite_and_in_the_order_of_values(
            ends in range_of(any_number()), values in prop::collection::vec(any_number(), 1..9),
        ) {
            check(linear, ends, values);
        }

        fn shares_of_a_logarithmic_scale_are_as_well(
            ends in range_of(any_positive()), values in prop::collection::vec(any_positive(), 1..9),
        ) {
            check(logarithmic, ends, values);
        }

        fn ends_are_a_range(low in any_number(), high in any_number(), logarithmic: bool) {
            let (from, to) = ends((low, high), logarithmic);
            prop_assert!(from < to && from.is_finite() && to.is_finite() && (from > 0.0 || !logarithmic));
            if low < high && (low > 0.0 || !logarithmic) && low < f64::MAX.next_down() {
                prop_assert_eq!((from, to), (low, high));
            }
        }
    }
}
