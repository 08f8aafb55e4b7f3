//! Polynomials through the Chebyshev–Lobatto points.

use std::f64::consts::PI;

/// Degree of the polynomials.
const DEGREE: usize = 16;
/// Number of points, both ends included.
pub(super) const POINTS: usize = DEGREE + 1;

/// xⱼ = −cos(jπ/N) on [−1, 1].
pub(super) fn points() -> [f64; POINTS] {
    // as a sine, so that the points are symmetric to the last bit
    std::array::from_fn(|j| (0.5 * PI * (2.0 * j as f64 / DEGREE as f64 - 1.0)).sin())
}

/// 2 at both ends, 1 between them, with alternating signs: the reciprocal barycentric weights.
fn signed(j: usize) -> f64 {
    let end = if j == 0 || j == DEGREE { 2.0 } else { 1.0 };
    if j.is_multiple_of(2) { end } else { -end }
}

/// The matrix that takes values at the points to derivatives there; its rows add up to zero.
pub(super) fn differentiation() -> [[f64; POINTS]; POINTS] {
    let x = points();
    std::array::from_fn(|i| {
        let mut row = std::array::from_fn(|j| if i == j { 0.0 } else { signed(i) / (signed(j) * (x[i] - x[j])) });
        row[i] = -row.iter().sum::<f64>();
        row
    })
}

/// Clenshaw–Curtis weights on [−1, 1].
pub(super) fn weights() -> [f64; POINTS] {
    let n = DEGREE as f64;
    std::array::from_fn(|j| {
        let angle = PI * j as f64 / n;
        let terms = (1..DEGREE / 2).map(|k| 2.0 * (2.0 * k as f64 * angle).cos() / (4.0 * (k * k) as f64 - 1.0));
        let sum = 1.0 - terms.sum::<f64>() - (n * angle).cos() / (n * n - 1.0);
        sum * 2.0 / (n * signed(j).abs())
    })
}

/// The polynomial through `values` at the points `x`, at `at` in [−1, 1].
pub(super) fn interpolate(x: &[f64; POINTS], values: &[f64; POINTS], at: f64) -> f64 {
    let (mut above, mut below) = (0.0, 0.0);
    for j in 0..POINTS {
        let distance = at - x[j];
        if distance == 0.0 {
            return values[j];
        }
        let weight = 1.0 / (signed(j) * distance);
        above += weight * values[j];
        below += weight;
    }
    above / below
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact() {
        let x = points();
        for degree in 0..=DEGREE as i32 {
            let values = x.map(|x| x.powi(degree));
            let integral: f64 = weights().iter().zip(values).map(|(weight, value)| weight * value).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((integral - exact).abs() < 1e-14, "∫ x^{degree}: {integral}");
            for (row, x) in differentiation().iter().zip(x) {
                let slope: f64 = row.iter().zip(values).map(|(entry, value)| entry * value).sum();
                let exact = if degree == 0 { 0.0 } else { f64::from(degree) * x.powi(degree - 1) };
                assert!((slope - exact).abs() < 1e-11, "x^{degree} at {x}: {slope}");
            }
            for at in [-1.0, -0.73, 0.0, 0.4, 1.0] {
                assert!((interpolate(&x, &values, at) - f64::powi(at, degree)).abs() < 1e-14, "x^{degree} at {at}");
            }
        }
    }
}
