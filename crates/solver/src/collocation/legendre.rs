//! Legendre polynomials, and the Gauss and Lobatto points made of them.

/// P_0 … P_n at t, n + 1 values into `values`.
pub fn legendre(t: f64, values: &mut [f64]) {
    let (mut before, mut here) = (0.0, 1.0);
    for (k, value) in values.iter_mut().enumerate() {
        *value = here;
        let k = k as f64;
        (before, here) = (here, ((2.0 * k + 1.0) * t * here - k * before) / (k + 1.0));
    }
}

/// P_n and P_n′ at |t| < 1.
fn with_derivative(n: usize, t: f64) -> (f64, f64) {
    let (mut before, mut here) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (before, here) = (here, ((2.0 * k + 1.0) * t * here - k * before) / (k + 1.0));
    }
    (here, n as f64 * (before - t * here) / (1.0 - t * t))
}

/// The `n` Gauss points on [−1, 1], ascending, and their weights; exact for polynomials up to degree 2n − 1.
pub fn gauss(n: usize) -> (Vec<f64>, Vec<f64>) {
    let root = |i: usize| {
        let mut t = -(std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        for _ in 0..10 {
            let (value, slope) = with_derivative(n, t);
            t -= value / slope;
        }
        t
    };
    let points: Vec<f64> = symmetric(n, root);
    let weight = |&t: &f64| 2.0 / ((1.0 - t * t) * with_derivative(n, t).1.powi(2));
    let weights = points.iter().map(weight).collect();
    (points, weights)
}

/// The n + 1 Lobatto points on [−1, 1], ascending, both ends among them, and their weights; exact for polynomials up to
/// degree 2n − 1.
pub fn lobatto(n: usize) -> (Vec<f64>, Vec<f64>) {
    let order = n as f64 * (n as f64 + 1.0);
    let root = |i: usize| {
        if i == 0 {
            return -1.0;
        }
        let mut t = -(std::f64::consts::PI * i as f64 / n as f64).cos();
        for _ in 0..10 {
            // the roots of P_n′, whose derivative follows from Legendre's equation
            let (value, slope) = with_derivative(n, t);
            t -= slope * (1.0 - t * t) / (2.0 * t * slope - order * value);
        }
        t
    };
    let points: Vec<f64> = symmetric(n + 1, root);
    let mut values = vec![0.0; n + 1];
    let mut weight = |&t: &f64| {
        legendre(t, &mut values);
        2.0 / (order * values[n] * values[n])
    };
    let weights = points.iter().map(&mut weight).collect();
    (points, weights)
}

/// `count` ascending points that mirror each other about 0, from the left half of them.
fn symmetric(count: usize, left: impl Fn(usize) -> f64) -> Vec<f64> {
    let at = |i: usize| match (2 * i + 1).cmp(&count) {
        std::cmp::Ordering::Less => left(i),
        std::cmp::Ordering::Equal => 0.0,
        std::cmp::Ordering::Greater => -left(count - 1 - i),
    };
    (0..count).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(points: &[f64], weights: &[f64], power: i32) -> f64 {
        points.iter().zip(weights).map(|(t, weight)| weight * t.powi(power)).sum()
    }

    #[test]
    fn both_rules_are_exact_up_to_their_degree_and_no_further() {
        for n in 3..=16 {
            for (points, weights) in [gauss(n), lobatto(n)] {
                for power in 0..2 * n as i32 {
                    let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
                    assert!((moment(&points, &weights, power) - exact).abs() < 1e-14, "n {n}, power {power}");
                }
                let beyond = moment(&points, &weights, 2 * n as i32) - 2.0 / (2.0 * n as f64 + 1.0);
                assert!(beyond.abs() > 1e-11, "n {n}");
                assert!(points.windows(2).all(|pair| pair[0] < pair[1]));
            }
        }
    }
}
