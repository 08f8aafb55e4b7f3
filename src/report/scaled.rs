//! Where the values of a field lie in its range.

/// Values between 0, the lowest of them, and 1, the highest. Positive values over more than a decade lie by their
/// logarithm.
pub(super) struct Scaled {
    /// The lowest and the highest value; their decimal logarithms if `logarithmic`.
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) logarithmic: bool,
    pub(super) shares: Vec<f64>,
}

impl Scaled {
    pub(super) fn of(values: &[f64]) -> Self {
        let (least, most) = ends(values);
        let logarithmic = least > 0.0 && most > 10.0 * least;
        let places: Vec<f64> = if logarithmic { values.iter().map(|v| v.log10()).collect() } else { values.to_vec() };
        let (low, high) = ends(&places);
        let span = if high > low { high - low } else { 1.0 };
        let shares = places.into_iter().map(|place| (place - low) / span).collect();
        Self { low, high: low + span, logarithmic, shares }
    }
}

fn ends(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::encoding::step;
    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn numbers_come_back_to_half_a_step(
            values in prop::collection::vec(prop_oneof![-5.0..5.0f64, 1e-7..1e2f64], 1..50),
        ) {
            let Scaled { low, high, logarithmic, shares } = Scaled::of(&values);
            for (value, share) in values.iter().zip(shares) {
                let place = low + (high - low) * f64::from(step(share)) / 65535.0;
                if logarithmic {
                    // Nine decades in 65535 steps: 1.6e-4.
                    prop_assert!((10_f64.powf(place) / value - 1.0).abs() < 2e-4);
                } else {
                    prop_assert!((place - value).abs() <= 0.51 * (high - low) / 65535.0);
                }
            }
        }
    }
}
