//! How precisely fields are kept.

/// How precisely the numbers of a field are kept. They are doubles in any case, so that whoever reads them need not
/// know; rounded ones take less than half of the bytes once they are packed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FieldPrecision {
    /// As they are solved.
    #[default]
    Double,
    /// Rounded to the 24 significant bits of single precision.
    Single,
}

impl FieldPrecision {
    /// The smallest tolerance whose errors rounding to single precision adds little to.
    pub const SINGLE_TOLERANCE: f64 = 1e-7;

    /// The bits of the mantissa that are kept, without the first one, which is not written; `None` if all are.
    pub fn kept_bits(self) -> Option<u32> {
        match self {
            Self::Double => None,
            Self::Single => Some(f32::MANTISSA_DIGITS - 1),
        }
    }

    /// Rounds numbers, as precisely as they are kept.
    pub fn round(self, values: &mut [f64]) {
        if let Some(kept) = self.kept_bits() {
            values.iter_mut().for_each(|value| *value = rounded(*value, kept));
        }
    }
}

/// The nearest number whose mantissa has so many bits behind the first one; of two the one whose last bit is 0. Numbers
/// without a first bit (0 and the subnormal) stay as they are, as do NaN, the infinities, and what would become one.
fn rounded(value: f64, kept: u32) -> f64 {
    let dropped = f64::MANTISSA_DIGITS - 1 - kept;
    let (bits, unit) = (value.to_bits(), 1_u64 << dropped);
    if !value.is_normal() {
        return value;
    }
    // A carry out of the mantissa is the next power of two.
    let above = bits + (unit / 2 - 1) + (bits >> dropped & 1);
    let nearest = f64::from_bits(above & !(unit - 1));
    if nearest.is_finite() { nearest } else { value }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn single(value: f64) -> f64 {
        let mut values = [value];
        FieldPrecision::Single.round(&mut values);
        values[0]
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn rounding_changes_a_number_by_a_part_of_two_to_the_minus_24(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            let rounded = single(value);
            prop_assert_eq!(single(rounded).to_bits(), rounded.to_bits(), "a second time nothing changes");
            prop_assert_eq!(rounded.is_sign_negative(), value.is_sign_negative());
            match value.is_normal() {
                true => prop_assert!((rounded / value - 1.0).abs() <= 2_f64.powi(-24) * (1.0 + f64::EPSILON)),
                false => prop_assert_eq!(rounded.to_bits(), bits),
            }
            let mut kept = [value];
            FieldPrecision::Double.round(&mut kept);
            prop_assert_eq!(kept[0].to_bits(), bits);
        }

        #[test]
        fn within_the_range_of_single_precision_it_is_the_cast(value in -1e38..1e38_f64) {
            prop_assert_eq!(single(value), f64::from(value as f32));
        }
    }

    #[test]
    fn what_has_no_nearest_number_stays() {
        for value in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MAX, f64::MIN, 5e-324] {
            assert_eq!(single(value).to_bits(), value.to_bits());
        }
        assert_eq!(single(1.0 + 2_f64.powi(-24)), 1.0, "half a unit goes to the even number");
        assert_eq!(single(2.0 - 2_f64.powi(-30)), 2.0, "a carry");
    }
}
