//! Numbers of any size, for laws that hold for all of them.

use proptest::prelude::*;

/// Any finite number of either sign, from the smallest to the largest.
pub(crate) fn any_number() -> BoxedStrategy<f64> {
    let by_bits = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |number| number.is_finite());
    let denormal = (0..64u64, any::<bool>()).prop_map(|(bits, minus)| {
        let number = f64::from_bits(bits);
        if minus { -number } else { number }
    });
    let special = vec![0.0, 1.0, 10.0, f64::MAX, f64::MIN, 1.7e308, -1.7e308, 1e308, 1e-308, f64::MIN_POSITIVE, 5e-324];
    prop_oneof![3 => by_bits, 2 => -1e6..1e6f64, 1 => denormal, 2 => prop::sample::select(special)].boxed()
}

/// Any finite number above zero.
pub(crate) fn any_positive() -> BoxedStrategy<f64> {
    any_number().prop_map(f64::abs).prop_filter("above zero", |number| *number > 0.0).boxed()
}

/// Two numbers in order, from the ends of all numbers to neighbours.
pub(crate) fn range_of(number: BoxedStrategy<f64>) -> impl Strategy<Value = (f64, f64)> {
    let apart = (number.clone(), number.clone()).prop_filter("two numbers", |(one, other)| one != other);
    let apart = apart.prop_map(|(one, other)| (one.min(other), one.max(other)));
    let steps = prop_oneof![1..4u32, 1..100u32, 1..10_000u32];
    let near = (number, steps).prop_map(|(low, steps)| (low, (0..steps).fold(low, |high, _| high.next_up())));
    prop_oneof![apart, near.prop_filter("finite", |(_, high)| high.is_finite())]
}

/// Increasing numbers, at least `count.start` of them: spread over all sizes, or neighbours.
pub(crate) fn increasing(number: BoxedStrategy<f64>, count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<f64>> {
    let least = count.start;
    let spread = prop::collection::vec(number.clone(), 2 * least..2 * count.end).prop_map(|mut numbers| {
        numbers.sort_by(f64::total_cmp);
        numbers.dedup();
        numbers
    });
    let neighbours = (number, count).prop_map(|(first, count)| {
        std::iter::successors(Some(first), |number| Some(number.next_up())).take(count).collect::<Vec<f64>>()
    });
    let enough = move |numbers: &Vec<f64>| numbers.len() >= least && numbers.iter().all(|number| number.is_finite());
    prop_oneof![3 => spread, 1 => neighbours].prop_filter("enough numbers", enough)
}
