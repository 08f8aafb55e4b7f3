//! Gauss–Legendre quadrature.

/// Number of nodes of the rule.
pub const POINTS: usize = 16;
/// Positive nodes and weights of the sixteen-point rule on [−1, 1].
const SIXTEEN: [(f64, f64); POINTS / 2] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// The sixteen nodes and weights on [0, 1], ascending.
pub fn unit_interval() -> impl Iterator<Item = (f64, f64)> + Clone {
    let left = SIXTEEN.iter().rev().map(|&(x, weight)| (0.5 - 0.5 * x, 0.5 * weight));
    left.chain(SIXTEEN.iter().map(|&(x, weight)| (0.5 + 0.5 * x, 0.5 * weight)))
}

/// Mean of a function over [a, b].
pub fn mean(a: f64, b: f64, function: impl Fn(f64) -> f64) -> f64 {
    unit_interval().map(|(t, weight)| weight * function(a + (b - a) * t)).sum()
}

/// Integral of a function from `a` to `b`; exact for polynomials up to degree 31.
pub fn integrate(a: f64, b: f64, function: impl Fn(f64) -> f64) -> f64 {
    (b - a) * mean(a, b, function)
}

#[cfg(test)]
mod tests {
    use super::integrate;

    #[test]
    fn exact_up_to_degree_thirty_one() {
        for degree in 0..32 {
            let exact = (3_f64.powi(degree + 1) - 1.0) / f64::from(degree + 1);
            let value = integrate(1.0, 3.0, |x| x.powi(degree));
            assert!((value / exact - 1.0).abs() < 1e-13, "degree {degree}");
        }
        let beyond = integrate(-1.0, 1.0, |x| 1e10 * x.powi(32));
        assert!((beyond - 1e10 * 2.0 / 33.0).abs() > 0.1, "no more than that");
    }
}
