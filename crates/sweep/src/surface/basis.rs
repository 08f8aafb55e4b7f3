//! The functions of one coordinate that a surface is made of, and the nodes that tell them apart.

use nalgebra::DMatrix;

use super::leja::Leja;
use super::matrix::{pseudoinverse, svd};

/// What a value may depend on those at the nodes: the root of the sum of squares of its weights. Errors of three axes
/// are multiplied.
const STEADY: f64 = 2.0;

/// A node tells a quantity something if what it does not know yet is at least this part of the most that any node has.
const TELLING: f64 = 0.25;

/// The functions along an axis.
#[derive(Clone, Debug)]
pub struct Basis {
    /// For each quantity its own functions, Chebyshev polynomials by functions: orthonormal columns.
    pub vectors: Vec<DMatrix<f64>>,
    /// The Leja nodes, by their number, at which the functions of every quantity are known by their values: some more
    /// than functions, so that least squares dampen what the functions leave unsaid.
    pub nodes: Vec<usize>,
}

impl Basis {
    /// For each quantity the fewest functions that leave of no column of its Chebyshev coefficients a remainder (root of
    /// the sum of squares) above `threshold`. A case gives all quantities, so they share their nodes. Each one is where
    /// what the nodes before do not tell is largest (discrete empirical interpolation, of all quantities at once), or
    /// one of `solved` where that is nearly as much. None if a singular value decomposition does not converge.
    pub fn of(columns: &[DMatrix<f64>], threshold: f64, leja: &Leja, before: &[usize]) -> Option<Self> {
        let vectors = columns.iter().map(|columns| functions(columns, threshold)).collect::<Option<Vec<_>>>()?;
        let all: Vec<DMatrix<f64>> = vectors.iter().map(|vectors| values(vectors, leja)).collect();
        let nodes = steadied(&all, nodes_of(all.clone(), before))?;
        Some(Self { vectors, nodes })
    }

    /// From values of a quantity at the nodes to factors of its functions: functions by nodes.
    pub fn interpolation(&self, quantity: usize, leja: &Leja) -> Option<DMatrix<f64>> {
        pseudoinverse(&at_nodes(&values(&self.vectors[quantity], leja), &self.nodes))
    }
}

/// The fewest functions that leave of no column a remainder above the threshold.
fn functions(columns: &DMatrix<f64>, threshold: f64) -> Option<DMatrix<f64>> {
    let vectors = svd(columns)?.left;
    let shares = vectors.transpose() * columns;
    Some(vectors.columns(0, rank(&shares, threshold)).into_owned())
}

/// The number of rows after which no column has a remainder above the threshold; at least one.
fn rank(shares: &DMatrix<f64>, threshold: f64) -> usize {
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
fn values(vectors: &DMatrix<f64>, leja: &Leja) -> DMatrix<f64> {
    let degrees = vectors.nrows();
    let mut polynomials = vec![0.0; degrees];
    let mut all = DMatrix::zeros(degrees, degrees);
    for (row, &t) in leja.nodes[..degrees].iter().enumerate() {
        stribeck_surface::chebyshev(t, &mut polynomials);
        polynomials.iter().enumerate().for_each(|(k, value)| all[(row, k)] = *value);
    }
    all * vectors
}

/// So many nodes, of the rows of all of `values`, that the functions of each quantity are told apart: first those of
/// before.
fn nodes_of(mut values: Vec<DMatrix<f64>>, before: &[usize]) -> Vec<usize> {
    let rows = values[0].nrows();
    let mut untold: Vec<usize> = values.iter().map(DMatrix::ncols).collect();
    let mut nodes = Vec::new();
    while nodes.len() < before.len() || (untold.iter().any(|&functions| functions > 0) && nodes.len() < rows) {
        let open: Vec<usize> = (0..values.len()).filter(|&q| untold[q] > 0).collect();
        let sizes: Vec<Vec<f64>> = open.iter().map(|&q| told(&values[q])).collect();
        let is_next = |row: &usize| !nodes.contains(row) && (nodes.len() >= before.len() || before.contains(row));
        let gain = |row: usize| sizes.iter().map(|sizes| sizes[row]).sum::<f64>();
        let best = largest((0..rows).filter(is_next).map(|row| (row, gain(row))));
        for (q, _) in open.into_iter().zip(&sizes).filter(|(_, sizes)| sizes[best] >= TELLING) {
            take_out(&mut values[q], best);
            untold[q] -= 1;
        }
        nodes.push(best);
    }
    nodes
}

/// What each row would tell, over the most that one does.
fn told(values: &DMatrix<f64>) -> Vec<f64> {
    let sizes: Vec<f64> = (0..values.nrows()).map(|row| values.row(row).norm()).collect();
    let most = sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    sizes.into_iter().map(|size| size / most).collect()
}

/// The place of the largest number; of equals the first.
fn largest(numbers: impl Iterator<Item = (usize, f64)>) -> usize {
    numbers.fold((0, f64::NEG_INFINITY), |best, it| if it.1 > best.1 { it } else { best }).0
}

/// The rows of `values` at nodes.
fn at_nodes(values: &DMatrix<f64>, nodes: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(nodes.len(), values.ncols(), |row, k| values[(nodes[row], k)])
}

/// Adds nodes until no value of a quantity at any node depends on those at the chosen ones by more than [`STEADY`]: each
/// one where one depends most.
fn steadied(values: &[DMatrix<f64>], mut nodes: Vec<usize>) -> Option<Vec<usize>> {
    while nodes.len() < values[0].nrows() {
        let mut most = (0, 0.0);
        for values in values {
            let weights = values * pseudoinverse(&at_nodes(values, &nodes))?;
            let free = (0..weights.nrows()).filter(|row| !nodes.contains(row));
            let row = largest(free.map(|row| (row, weights.row(row).norm())));
            let size = weights.row(row).norm();
            most = if size > most.1 { (row, size) } else { most };
        }
        if most.1 <= STEADY {
            break;
        }
        nodes.push(most.0);
    }
    Some(nodes)
}

/// Takes out of all rows what they have in the direction of one.
fn take_out(values: &mut DMatrix<f64>, row: usize) {
    let size = values.row(row).norm();
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
        let columns = DMatrix::from_fn(12, 5, |n, c| match n {
            3 => 1.0 + c as f64,
            7 => (c * c) as f64 - 2.0,
            8 => 2.0 * ((c * c) as f64 - 2.0),
            _ => 1e-9,
        });
        let basis = Basis::of(&[columns], 1e-6, &leja, &[4]).expect("converged");
        assert_eq!((basis.vectors[0].ncols(), basis.nodes.len()), (2, 2));
        let function = |t: f64| {
            let mut p = [0.0; 12];
            stribeck_surface::chebyshev(t, &mut p);
            5.0 * p[3] - p[7] - 2.0 * p[8]
        };
        let values = DMatrix::from_fn(2, 1, |row, _| function(leja.nodes[basis.nodes[row]]));
        let found = &basis.vectors[0] * (basis.interpolation(0, &leja).expect("converged") * values);
        for n in 0..12 {
            let expected = [5.0, -1.0, -2.0][[3, 7, 8].iter().position(|&k| k == n).unwrap_or(0)];
            let expected = if [3, 7, 8].contains(&n) { expected } else { 0.0 };
            assert!((found[(n, 0)] - expected).abs() < 1e-7, "{n}: {}", found[(n, 0)]);
        }
    }

    #[test]
    fn a_lower_threshold_takes_more_functions() {
        let leja = Leja::new(20);
        let columns = DMatrix::from_fn(20, 20, |n, c| (-0.7 * (n + c) as f64).exp() * ((n * c) as f64).cos());
        let ranks =
            [1e-1, 1e-3, 1e-6].map(|t| Basis::of(std::slice::from_ref(&columns), t, &leja, &[]).expect("converged"));
        assert!(ranks.is_sorted_by_key(|basis| basis.vectors[0].ncols()) && ranks[2].vectors[0].ncols() > 5);
    }
}
