//! The median of numbers that spread over decades.

/// The median of positive numbers, of two middle ones their geometric mean: 0 if one of these is 0. None if there are
/// none.
///
/// It is the median on a logarithmic axis, so that a chart and a table of the same cases show the same number.
pub fn geometric_median(numbers: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.into_iter().collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    let lower = sorted[(sorted.len() - 1) / 2];
    // the product of the roots neither overflows nor underflows
    Some(if lower == upper { upper } else { lower.sqrt() * upper.sqrt() })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;

    laws! {
        seed: 4, cases: 256;

        fn half_of_the_numbers_lie_on_either_side(
            numbers in prop::collection::vec((-300.0..300.0f64).prop_map(|e| 10f64.powf(e)), 1..30),
        ) {
            let median = geometric_median(numbers.iter().copied()).unwrap();
            prop_assert_eq!(geometric_median(numbers.iter().rev().copied()), Some(median));
            let below = numbers.iter().filter(|number| **number <= median * (1.0 + 1e-12)).count();
            let above = numbers.iter().filter(|number| **number >= median * (1.0 - 1e-12)).count();
            prop_assert!(2 * below >= numbers.len() && 2 * above >= numbers.len());
            prop_assert!(numbers.len() % 2 == 0 || numbers.contains(&median));
            // On a logarithmic axis nothing changes if all is turned round.
            let turned = geometric_median(numbers.iter().map(|number| number.recip())).unwrap();
            prop_assert!((turned * median - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn two_middle_numbers_have_their_geometric_mean() {
        assert_eq!(geometric_median([16.0, 1.0, 4.0, 1e300]), Some(8.0));
        assert_eq!(geometric_median([1e-3, 0.0, 0.0, 1e-3]), Some(0.0));
        assert_eq!(geometric_median([0.0, 1e-3, 1e-3]), Some(1e-3));
        assert_eq!(geometric_median([]), None);
    }
}
