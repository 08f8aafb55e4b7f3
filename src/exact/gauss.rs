//! Gauss–Legendre quadrature with ten points on a panel.

/// Positive nodes on [−1, 1] and their weights; the negative ones mirror them.
const NODES: [(f64, f64); 5] = [
    (0.148_874_338_981_631_21, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_36),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// ∫ `function` from `a` to `b`; exact for polynomials up to degree 19.
pub(super) fn integrate(a: f64, b: f64, function: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let sum: f64 = NODES
        .iter()
        .map(|&(node, weight)| weight * (function(middle - half * node) + function(middle + half * node)))
        .sum();
    half * sum
}

#[cfg(test)]
mod tests {
    use super::integrate;

    #[test]
    fn exact_up_to_degree_nineteen() {
        for degree in 0..20 {
            let exact = (3_f64.powi(degree + 1) - 1.0) / f64::from(degree + 1);
            let value = integrate(1.0, 3.0, |x| x.powi(degree));
            assert!((value / exact - 1.0).abs() < 1e-14, "degree {degree}");
        }
        let beyond = integrate(-1.0, 1.0, |x| 1e6 * x.powi(20));
        assert!((beyond - 1e6 * 2.0 / 21.0).abs() > 0.1, "no more than that");
    }
}
