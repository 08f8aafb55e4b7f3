//! The functions of one coordinate that a surface is made of, and the nodes that tell them apart.

use faer::{Mat, MatRef};

use super::leja::Leja;

/// Functions for each of which there is one node more.
const EXTRA: usize = 12;

/// How much more a node that is solved counts.
const SOLVED: f64 = 4.0;

/// A basis of the functions along an axis.
#[derive(Clone, Debug)]
pub struct Basis {
    /// Chebyshev polynomials by functions: orthonormal columns.
    pub vectors: Mat<f64>,
    /// The Leja nodes, by their number, at which a function of the basis is known by its values: some more than
    /// functions, so that least squares dampen what the functions leave unsaid.
    pub nodes: Vec<usize>,
}

impl Basis {
    /// The least basis that leaves of no column of Chebyshev coefficients a remainder (root of the sum of squares) above
    /// `threshold`. Each of its nodes is where what the nodes before do not tell is largest (discrete empirical
    /// interpolation), or one of `solved` where that is nearly as much. None if the singular value decomposition does
    /// not converge.
    pub fn of(columns: MatRef<'_, f64>, threshold: f64, leja: &Leja, solved: &[usize]) -> Option<Self> {
        let decomposition = columns.thin_svd().ok()?;
        let shares = decomposition.U().transpose() * columns;
        let vectors = decomposition.U().subcols(0, rank(shares.as_ref(), threshold)).to_owned();
        let all = values(&vectors, leja);
        let nodes = with_extra(&all, nodes_of(all.clone(), solved))?;
        Some(Self { vectors, nodes })
    }

    /// From values at the nodes to factors of the functions: functions by nodes.
    pub fn interpolation(&self, leja: &Leja) -> Option<Mat<f64>> {
        Some(at_nodes(&values(&self.vectors, leja), &self.nodes).thin_svd().ok()?.pseudoinverse())
    }
}

/// The number of rows after which no column has a remainder above the threshold; at least one.
fn rank(shares: MatRef<'_, f64>, threshold: f64) -> usize {
    let needed = |column: usize| {
        let mut left = 0.0;
        let mut rows = (1..shares.nrows()).rev();
        let last = rows.find(|&row| {
            left += shares[(row, column)] * shares[(row, column)];
            left > threshold * threshold
        });
        last.map_or(1, |row| row + 1)
    };
    (0..shares.ncols()).map(needed).max().unwrap_or(1)
}

/// The functions at the first Leja nodes, as many as there are polynomials: nodes by functions.
fn values(vectors: &Mat<f64>, leja: &Leja) -> Mat<f64> {
    let degrees = vectors.nrows();
    let mut polynomials = vec![0.0; degrees];
    let mut all = Mat::zeros(degrees, degrees);
    for (row, &t) in leja.nodes[..degrees].iter().enumerate() {
        stribeck_surface::chebyshev(t, &mut polynomials);
        polynomials.iter().enumerate().for_each(|(k, value)| all[(row, k)] = *value);
    }
    all * vectors
}

/// As many nodes as functions, of the rows of `values`.
fn nodes_of(mut values: Mat<f64>, solved: &[usize]) -> Vec<usize> {
    let mut nodes = Vec::with_capacity(values.ncols());
    while nodes.len() < values.ncols() {
        let size = |row: usize| values.row(row).norm_l2() * if solved.contains(&row) { SOLVED } else { 1.0 };
        // Of equals the first.
        let largest = (0..values.nrows()).fold(0, |best, row| if size(row) > size(best) { row } else { best });
        nodes.push(largest);
        take_out(&mut values, largest);
    }
    nodes
}

/// The rows of `values` at nodes.
fn at_nodes(values: &Mat<f64>, nodes: &[usize]) -> Mat<f64> {
    Mat::from_fn(nodes.len(), values.ncols(), |row, k| values[(nodes[row], k)])
}

/// Adds a node for each [`EXTRA`] functions: each one where the sum of functions that the nodes before tell worst is
/// largest.
fn with_extra(values: &Mat<f64>, mut nodes: Vec<usize>) -> Option<Vec<usize>> {
    for _ in 0..nodes.len() / EXTRA {
        let decomposition = at_nodes(values, &nodes).thin_svd().ok()?;
        let worst = values * decomposition.V().col(values.ncols() - 1);
        let size = |row: usize| if nodes.contains(&row) { -1.0 } else { worst[row].abs() };
        nodes.push((0..values.nrows()).fold(0, |best, row| if size(row) > size(best) { row } else { best }));
    }
    Some(nodes)
}

/// Takes out of all rows what they have in the direction of one.
fn take_out(values: &mut Mat<f64>, row: usize) {
    let size = values.row(row).norm_l2();
    // What is rounding has no direction.
    if size < 1e-12 {
        return;
    }
    let direction: Vec<f64> = values.row(row).iter().map(|value| value / size).collect();
    for other in 0..values.nrows() {
        let along: f64 = values.row(other).iter().zip(&direction).map(|(value, d)| value * d).sum();
        direction.iter().enumerate().for_each(|(k, d)| values[(other, k)] -= along * d);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Columns of two functions: the basis has two, two nodes tell them, and a third function of their span comes back.
    #[test]
    fn a_basis_has_the_functions_of_its_columns_and_no_more() {
        let leja = Leja::new(12);
        let columns = Mat::from_fn(12, 5, |n, c| match n {
            3 => 1.0 + c as f64,
            7 => (c * c) as f64 - 2.0,
            8 => 2.0 * ((c * c) as f64 - 2.0),
            _ => 1e-9,
        });
        let basis = Basis::of(columns.as_ref(), 1e-6, &leja, &[4]).expect("converged");
        assert_eq!((basis.vectors.ncols(), basis.nodes.len()), (2, 2));
        let function = |t: f64| {
            let mut p = [0.0; 12];
            stribeck_surface::chebyshev(t, &mut p);
            5.0 * p[3] - p[7] - 2.0 * p[8]
        };
        let values = Mat::from_fn(2, 1, |row, _| function(leja.nodes[basis.nodes[row]]));
        let found = &basis.vectors * (basis.interpolation(&leja).expect("converged") * values);
        for n in 0..12 {
            let expected = [5.0, -1.0, -2.0][[3, 7, 8].iter().position(|&k| k == n).unwrap_or(0)];
            let expected = if [3, 7, 8].contains(&n) { expected } else { 0.0 };
            assert!((found[(n, 0)] - expected).abs() < 1e-7, "{n}: {}", found[(n, 0)]);
        }
    }

    #[test]
    fn a_lower_threshold_takes_more_functions() {
        let leja = Leja::new(20);
        let columns = Mat::from_fn(20, 20, |n, c| (-0.7 * (n + c) as f64).exp() * ((n * c) as f64).cos());
        let ranks = [1e-1, 1e-3, 1e-6].map(|t| Basis::of(columns.as_ref(), t, &leja, &[]).expect("converged"));
        assert!(ranks.is_sorted_by_key(|basis| basis.vectors.ncols()) && ranks[2].vectors.ncols() > 5);
    }
}
