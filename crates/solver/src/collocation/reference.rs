//! What all panels of one degree share: points, derivative and transforms on the reference panel [−1, 1].

use super::exponential_moments::Places;
use super::legendre::{gauss, legendre, lobatto};
use super::log_moments::{MOST_MOMENTS, log_moments};

/// Tables of the reference panel of degree d; computed once for each degree.
///
/// A panel carries p as a polynomial of degree d by its values at d + 1 Lobatto points, and the equation holds at its d
/// Gauss points. Matrices are stored row by row.
#[derive(Debug)]
pub struct ReferencePanel {
    /// d.
    pub degree: usize,
    /// d + 1 Lobatto points, the first −1, the last 1.
    pub nodes: Vec<f64>,
    /// Their weights.
    pub node_weights: Vec<f64>,
    /// d Gauss points.
    pub points: Vec<f64>,
    /// Their weights.
    pub weights: Vec<f64>,
    /// Derivative at the Gauss points from values at the nodes, d × (d + 1).
    pub derivative: Vec<f64>,
    /// Value at the Gauss points from values at the nodes, d × (d + 1).
    pub values: Vec<f64>,
    /// Value at some places between neighbouring nodes from values at the nodes, 7d × (d + 1).
    pub between_nodes: Vec<f64>,
    /// Legendre coefficients from values at the nodes, (d + 1) × (d + 1).
    pub node_coefficients: Vec<f64>,
    /// Legendre coefficients from values at the Gauss points, d × d.
    pub point_coefficients: Vec<f64>,
    /// The Gauss points and, after them, the left end.
    pub places: Places,
    /// What each Gauss point contributes to the value at −1, and at 1, of the polynomial through the Gauss points.
    pub end_values: [Vec<f64>; 2],
    /// Derivative at −1, the Gauss points and 1 from the values there, (d + 2) × (d + 2).
    pub rich_derivative: Vec<f64>,
    /// ∫ P_k(t) ln|s − t| dt at the Gauss points s of the same panel, (d + 1) × d: all points for k = 0 first.
    pub own_log_moments: Vec<f64>,
}

impl ReferencePanel {
    /// The tables for degree d ≥ 2.
    pub fn new(degree: usize) -> Self {
        let (nodes, node_weights) = lobatto(degree);
        let (points, weights) = gauss(degree);
        let size = degree + 1;
        let mut polynomial = vec![0.0; size];
        let node_coefficients = coefficients_from_nodes(&nodes, &node_weights);
        let mut point_coefficients = vec![0.0; degree * degree];
        let mut own_log_moments = vec![0.0; size * degree];
        let mut end_values = [vec![0.0; degree], vec![0.0; degree]];
        let (mut values, mut derivative) = (vec![0.0; degree * size], vec![0.0; degree * size]);
        let mut moments = vec![0.0; size];
        for (i, (&t, weight)) in points.iter().zip(&weights).enumerate() {
            legendre(t, &mut polynomial);
            for k in 0..degree {
                let coefficient = weight * polynomial[k] * (2 * k + 1) as f64 / 2.0;
                point_coefficients[k * degree + i] = coefficient;
                // P_k(±1) = (±1)^k
                end_values[0][i] += if k % 2 == 0 { coefficient } else { -coefficient };
                end_values[1][i] += coefficient;
            }
            let slopes = slopes(&polynomial);
            for j in 0..size {
                let sum = |of: &[f64]| (0..size).map(|k| of[k] * node_coefficients[k * size + j]).sum();
                values[i * size + j] = sum(&polynomial);
                derivative[i * size + j] = sum(&slopes);
            }
            log_moments(t, &mut moments);
            for (k, moment) in moments.iter().enumerate() {
                own_log_moments[k * degree + i] = *moment;
            }
        }
        let places = Places::new(points.iter().copied().chain([-1.0]));
        let between_nodes = values_between_nodes(&nodes, &node_coefficients);
        let rich_points: Vec<f64> = std::iter::once(-1.0).chain(points.iter().copied()).chain([1.0]).collect();
        let rich_derivative = differentiation(&rich_points);
        Self {
            degree,
            nodes,
            node_weights,
            points,
            weights,
            derivative,
            values,
            between_nodes,
            node_coefficients,
            point_coefficients,
            places,
            end_values,
            rich_derivative,
            own_log_moments,
        }
    }

    /// Legendre coefficients of the polynomial with these values at the nodes.
    pub fn coefficients_of_nodes(&self, values: &[f64], coefficients: &mut [f64]) {
        multiply(&self.node_coefficients, values, coefficients);
    }

    /// Legendre coefficients of the polynomial with these values at the Gauss points.
    pub fn coefficients_of_points(&self, values: &[f64], coefficients: &mut [f64]) {
        multiply(&self.point_coefficients, values, coefficients);
    }
}

/// Legendre coefficients from values at the Lobatto points, by discrete orthogonality; the last coefficient has the norm
/// 2/d of the Lobatto rule.
fn coefficients_from_nodes(nodes: &[f64], weights: &[f64]) -> Vec<f64> {
    let (size, degree) = (nodes.len(), nodes.len() - 1);
    let mut polynomial = vec![0.0; size];
    let mut coefficients = vec![0.0; size * size];
    for (j, (&t, weight)) in nodes.iter().zip(weights).enumerate() {
        legendre(t, &mut polynomial);
        for (k, value) in polynomial.iter().enumerate() {
            let norm = if k == degree { 2.0 / degree as f64 } else { 2.0 / (2 * k + 1) as f64 };
            coefficients[k * size + j] = weight * value / norm;
        }
    }
    coefficients
}

/// Values between neighbouring nodes from the values there, from their Legendre coefficients.
fn values_between_nodes(nodes: &[f64], node_coefficients: &[f64]) -> Vec<f64> {
    const BETWEEN: [f64; 7] = [0.02, 0.06, 0.15, 0.3, 0.5, 0.7, 0.9];
    let size = nodes.len();
    let mut polynomial = vec![0.0; size];
    let mut values = Vec::with_capacity(BETWEEN.len() * (size - 1) * size);
    for t in nodes.windows(2).flat_map(|gap| BETWEEN.map(|part| gap[0] + part * (gap[1] - gap[0]))) {
        legendre(t, &mut polynomial);
        let value = |j: usize| (0..size).map(|k| polynomial[k] * node_coefficients[k * size + j]).sum::<f64>();
        values.extend((0..size).map(value));
    }
    values
}

/// Derivative at some points from the values there, row by row: of the polynomial through all of them.
fn differentiation(points: &[f64]) -> Vec<f64> {
    let count = points.len();
    let others = |i: usize| points.iter().enumerate().filter(move |&(j, _)| j != i).map(|(_, t)| t);
    let product = |i: usize| others(i).map(|t| points[i] - t).product::<f64>();
    let mut matrix = vec![0.0; count * count];
    for i in 0..count {
        for j in 0..count {
            matrix[i * count + j] = if i == j {
                others(i).map(|t| (points[i] - t).recip()).sum()
            } else {
                product(i) / product(j) / (points[i] - points[j])
            };
        }
    }
    matrix
}

/// Matrix times vector, the matrix row by row.
pub fn multiply(matrix: &[f64], vector: &[f64], product: &mut [f64]) {
    for (value, row) in product.iter_mut().zip(matrix.chunks_exact(vector.len())) {
        *value = dot(row, vector);
    }
}

/// Sum of the products of two vectors.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// P_k′ from P_k at the same place: P_{k+1}′ = P_{k−1}′ + (2k + 1) P_k.
fn slopes(values: &[f64]) -> Vec<f64> {
    let mut slopes = vec![0.0; values.len()];
    for k in 1..values.len() {
        let two_below = if k >= 2 { slopes[k - 2] } else { 0.0 };
        slopes[k] = two_below + (2 * k - 1) as f64 * values[k - 1];
    }
    slopes
}

/// The value at t of the polynomial with these Legendre coefficients, by Clenshaw's recurrence.
pub fn evaluate(coefficients: &[f64], t: f64) -> f64 {
    let (mut above, mut here) = (0.0, 0.0);
    for (coefficient, (outer, inner)) in coefficients.iter().zip(&CLENSHAW).skip(1).rev() {
        let next = coefficient + outer * t * here - inner * above;
        (above, here) = (here, next);
    }
    coefficients[0] + t * here - 0.5 * above
}

/// (2k + 1)/(k + 1) and (k + 1)/(k + 2).
const CLENSHAW: [(f64, f64); MOST_MOMENTS] = {
    let mut factors = [(0.0, 0.0); MOST_MOMENTS];
    let mut k = 0;
    while k < factors.len() {
        let n = k as f64;
        factors[k] = ((2.0 * n + 1.0) / (n + 1.0), (n + 1.0) / (n + 2.0));
        k += 1;
    }
    factors
};

/// The derivative at t of the polynomial with these Legendre coefficients.
pub fn evaluate_slope(coefficients: &[f64], t: f64) -> f64 {
    // the coefficients of the derivative from above: c_k′ = (2k + 1) (c_{k+1} + c_{k+3} + …)
    let (mut above, mut here) = (0.0, 0.0);
    let (mut sum, mut other) = (0.0, 0.0);
    for k in (0..coefficients.len() - 1).rev() {
        sum += coefficients[k + 1];
        let (outer, inner) = CLENSHAW[k];
        let next = (2 * k + 1) as f64 * sum + outer * t * here - inner * above;
        (above, here) = (here, next);
        (sum, other) = (other, sum);
    }
    here
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial of degree d is differentiated, interpolated and transformed exactly.
    #[test]
    fn polynomials_of_the_degree_are_exact() {
        for degree in 2..=16 {
            let panel = ReferencePanel::new(degree);
            let power = degree as i32;
            let at_nodes: Vec<f64> = panel.nodes.iter().map(|t| (t + 0.3).powi(power)).collect();
            let (mut values, mut slopes) = (vec![0.0; degree], vec![0.0; degree]);
            multiply(&panel.values, &at_nodes, &mut values);
            multiply(&panel.derivative, &at_nodes, &mut slopes);
            for (i, t) in panel.points.iter().enumerate() {
                let scale = 1.3_f64.powi(power);
                assert!((values[i] - (t + 0.3).powi(power)).abs() < 1e-13 * scale);
                let slope = f64::from(power) * (t + 0.3).powi(power - 1);
                assert!((slopes[i] - slope).abs() < 1e-11 * scale);
            }
            let rich: Vec<f64> =
                [-1.0].iter().chain(&panel.points).chain(&[1.0]).map(|t| (t + 0.3).powi(power)).collect();
            let mut rich_slopes = vec![0.0; degree + 2];
            multiply(&panel.rich_derivative, &rich, &mut rich_slopes);
            for (slope, rich_slope) in slopes.iter().zip(&rich_slopes[1..]) {
                assert!((slope - rich_slope).abs() < 1e-11 * 1.3_f64.powi(power));
            }
            let mut coefficients = vec![0.0; degree + 1];
            panel.coefficients_of_nodes(&at_nodes, &mut coefficients);
            for t in [-1.0, -0.37, 0.0, 0.81, 1.0] {
                assert!((evaluate(&coefficients, t) - (t + 0.3_f64).powi(power)).abs() < 1e-12 * 1.3_f64.powi(power));
                let slope = f64::from(power) * (t + 0.3_f64).powi(power - 1);
                assert!((evaluate_slope(&coefficients, t) - slope).abs() < 1e-10 * 1.3_f64.powi(power));
            }
            let lower: Vec<f64> = panel.points.iter().map(|t| (t - 0.1).powi(power - 1)).collect();
            let mut coefficients = vec![0.0; degree];
            panel.coefficients_of_points(&lower, &mut coefficients);
            assert!((evaluate(&coefficients, 0.5) - 0.4_f64.powi(power - 1)).abs() < 1e-12);
        }
    }
}
