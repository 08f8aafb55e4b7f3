//! Ratios of modified Bessel functions, without overflow or cancellation for any argument.
//!
//! The dry contact needs ratios only, and differences of ratios that vanish for small or large argument. Formed from
//! function values these lose all digits at k = 10⁸; here each has its own formula with positive terms.

use pxfm::{f_k0e, f_k1e};

/// Beyond this the asymptotic series of I₀ and I₁ reach rounding error (their smallest term is about e^{−2k}).
const ASYMPTOTIC: f64 = 20.0;

/// K₀(x)/K₁(x) for x ≥ 0; 0 at x = 0, → 1 for x → ∞.
pub(super) fn k0_over_k1(x: f64) -> f64 {
    if x < f64::MIN_POSITIVE {
        0.0
    } else if x == f64::INFINITY {
        1.0
    } else {
        f_k0e(x) / f_k1e(x)
    }
}

/// I₂(k)/I₁(k) for k ≥ 0; k/4 for k → 0, → 1 for k → ∞.
///
/// For small k Gauss's continued fraction 1/(4/k + 1/(6/k + 1/(8/k + …))), all of whose terms are positive.
pub(super) fn i2_over_i1(k: f64) -> f64 {
    if k >= ASYMPTOTIC {
        return 1.0 - (2.0 - excess(k)) / k;
    }
    // Forty terms reach rounding error at k = 20; fewer for smaller k, but the loop is cheap.
    (2..42).rev().fold(0.0, |tail, order| k / (2.0 * f64::from(order) + k * tail))
}

/// k (I₀(k)/I₁(k) − 1) for k ≥ 0; 2 at k = 0, → ½ for k → ∞.
///
/// For large k the quotient of two asymptotic series without the factor e^k/√(2πk) (Abramowitz & Stegun 9.7.1); the
/// terms of I₀ − I₁ are all positive.
pub(super) fn excess(k: f64) -> f64 {
    if k < ASYMPTOTIC {
        return 2.0 + k * (i2_over_i1(k) - 1.0);
    }
    if k == f64::INFINITY {
        return 0.5;
    }
    let (mut term0, mut term1) = (1.0, 1.0);
    let (mut difference, mut i1) = (0.0, 1.0);
    for j in 1..40 {
        let odd = f64::from((2 * j - 1) * (2 * j - 1));
        let step = 8.0 * k * f64::from(j);
        term0 *= odd / step;
        term1 *= (odd - 4.0) / step;
        difference += term0 - term1;
        i1 += term1;
        if term0 <= 0.1 * f64::EPSILON * difference {
            break;
        }
    }
    k * difference / i1
}

#[cfg(test)]
mod tests {
    use super::*;
    use pxfm::{f_i0e, f_i1e};

    /// The quotient of scaled function values, which is right as long as nothing cancels.
    #[test]
    fn ratios_are_those_of_the_functions() {
        for i in -120..=120 {
            let k = 10_f64.powf(f64::from(i) / 20.0);
            let r = f_i0e(k) / f_i1e(k);
            assert!((excess(k) / k + 1.0 - r).abs() <= 4e-15 * r, "excess at {k}");
            let i2 = i2_over_i1(k);
            assert!((i2 + 2.0 / k - r).abs() <= 4e-15 * r, "I2/I1 at {k}: {i2}");
        }
    }

    #[test]
    fn branches_join() {
        let below = ASYMPTOTIC * (1.0 - 1e-15);
        assert!((excess(below) - excess(ASYMPTOTIC)).abs() < 1e-13);
        assert!((i2_over_i1(below) - i2_over_i1(ASYMPTOTIC)).abs() < 1e-14);
    }

    #[test]
    fn ends_have_their_leading_terms() {
        assert_eq!((excess(0.0), i2_over_i1(0.0), k0_over_k1(0.0)), (2.0, 0.0, 0.0));
        let infinity = f64::INFINITY;
        assert_eq!((excess(infinity), i2_over_i1(infinity), k0_over_k1(infinity)), (0.5, 1.0, 1.0));
        for k in [1e-12, 1e-9, 1e-6] {
            assert!((i2_over_i1(k) / (k / 4.0) - 1.0).abs() < 1e-12);
        }
        for k in [1e8_f64, 1e12, 1e300] {
            assert!((excess(k) - 0.5 - 3.0 / (8.0 * k)).abs() < 1e-15);
            assert!((k0_over_k1(k) - 1.0 + 0.5 / k).abs() < 1e-15);
        }
        for x in [1e-300_f64, 1e-100, 1e-9] {
            let leading = x * ((2.0 / x).ln() - 0.577_215_664_901_532_9);
            assert!((k0_over_k1(x) / leading - 1.0).abs() < 1e-13, "K0/K1 at {x}");
        }
        assert!((k0_over_k1(f64::MAX) - 1.0).abs() < 1e-15);
    }
}
