//! Dense LU factorisation with partial pivoting.

use std::array::from_fn;

use super::matrix::Matrix;
use super::wide::wide;

/// Columns that are eliminated from the rest together: that many of L stay in the processor's nearest memory.
const PANEL: usize = 8;
/// Columns and rows of the rest whose numbers stay in registers meanwhile.
const COLUMNS: usize = 4;
const ROWS: usize = 8;

/// P A = L U of the last matrix, sequential: parallel work is over chains.
///
/// Each number comes of the same operations in the same order on every processor, so of the same bits.
#[derive(Default)]
pub struct Factorisation {
    /// Assembled here, replaced by its factors.
    pub matrix: Matrix,
    /// P: the row of the matrix in each place.
    forward: Vec<usize>,
    permuted: Vec<f64>,
}

impl Factorisation {
    /// Factorises the matrix in place. Factors of a singular matrix are not all finite.
    pub fn factorise(&mut self) {
        let n = self.matrix.rows();
        self.forward.clear();
        self.forward.extend(0..n);
        wide(
            #[inline(always)]
            || {
                for first in (0..n).step_by(PANEL) {
                    eliminate_panel(&mut self.matrix, first, &mut self.forward);
                }
            },
        );
    }

    /// Solves with the factors, in place.
    pub fn solve(&mut self, right_side: &mut [f64]) {
        self.permuted.clear();
        self.permuted.extend(self.forward.iter().map(|&row| right_side[row]));
        right_side.copy_from_slice(&self.permuted);
        wide(
            #[inline(always)]
            || substitute(&self.matrix, right_side),
        );
    }

    /// Solves with the transpose of the factors, in place.
    pub fn solve_transposed(&mut self, right_side: &mut [f64]) {
        wide(
            #[inline(always)]
            || substitute_transposed(&self.matrix, right_side),
        );
        self.permuted.clear();
        self.permuted.extend_from_slice(right_side);
        for (&row, value) in self.forward.iter().zip(&self.permuted) {
            right_side[row] = *value;
        }
    }
}

/// Factorises a panel of columns, and eliminates them from those behind.
#[inline(always)]
fn eliminate_panel(matrix: &mut Matrix, first: usize, order: &mut [usize]) {
    let n = matrix.rows();
    let end = n.min(first + PANEL);
    let mut pivots = [0; PANEL];
    let (before, rest) = matrix.values_mut().split_at_mut(first * n);
    let (panel, behind) = rest.split_at_mut((end - first) * n);
    for (step, k) in (first..end).enumerate() {
        let pivot = k + largest(&panel[step * n..][k..n]);
        pivots[step] = pivot;
        order.swap(k, pivot);
        panel.chunks_exact_mut(n).for_each(|column| column.swap(k, pivot));
        let (done, next) = panel.split_at_mut((step + 1) * n);
        let (top, below) = done[step * n..].split_at_mut(k + 1);
        let inverse = top[k].recip();
        below.iter_mut().for_each(|value| *value *= inverse);
        for column in next.chunks_exact_mut(n) {
            let (top, column) = column.split_at_mut(k + 1);
            subtract(top[k], below, column);
        }
    }
    let exchange = |column: &mut [f64]| pivots[..end - first].iter().zip(first..).for_each(|(&i, k)| column.swap(k, i));
    before.chunks_exact_mut(n).for_each(exchange);
    behind.chunks_exact_mut(n).for_each(exchange);
    // Only whole panels have columns behind them.
    let mut columns = panel.chunks_exact(n);
    let panel: [&[f64]; PANEL] = from_fn(|_| columns.next().unwrap_or(&[]));
    let mut blocks = behind.chunks_exact_mut(COLUMNS * n);
    for block in &mut blocks {
        eliminate_from::<COLUMNS>(&panel, first, n, block);
    }
    for column in blocks.into_remainder().chunks_exact_mut(n) {
        eliminate_from::<1>(&panel, first, n, column);
    }
}

/// Where the first of the largest numbers is; NaN is not one.
#[inline(always)]
fn largest(numbers: &[f64]) -> usize {
    let (mut place, mut most) = (0, 0.0);
    for (i, number) in numbers.iter().enumerate() {
        if number.abs() > most {
            (place, most) = (i, number.abs());
        }
    }
    place
}

/// Eliminates the columns of a panel of L from `C` columns of the rest.
#[inline(always)]
fn eliminate_from<const C: usize>(panel: &[&[f64]; PANEL], first: usize, n: usize, block: &mut [f64]) {
    let mut columns = block.chunks_exact_mut(n);
    let mut columns: [&mut [f64]; C] = from_fn(|_| columns.next().expect("a block has so many columns"));
    let mut factors = [[0.0; PANEL]; C];
    for (column, factors) in columns.iter_mut().zip(&mut factors) {
        *factors = from_fn(|k| column[first + k]);
        for k in 0..PANEL {
            for row in k + 1..PANEL {
                factors[row] = panel[k][first + row].mul_add(-factors[k], factors[row]);
            }
        }
        column[first..first + PANEL].copy_from_slice(factors);
    }
    let mut row = first + PANEL;
    while row + ROWS <= n {
        subtract_products::<C, ROWS>(panel, &factors, row, &mut columns);
        row += ROWS;
    }
    for row in row..n {
        subtract_products::<C, 1>(panel, &factors, row, &mut columns);
    }
}

/// Subtracts from `R` rows of `C` columns those of L times the factors of each column.
#[inline(always)]
fn subtract_products<const C: usize, const R: usize>(
    panel: &[&[f64]; PANEL],
    factors: &[[f64; PANEL]; C],
    row: usize,
    columns: &mut [&mut [f64]; C],
) {
    let mut rest = [[0.0; R]; C];
    for (rest, column) in rest.iter_mut().zip(&*columns) {
        rest.copy_from_slice(&column[row..row + R]);
    }
    for (k, lower) in panel.iter().enumerate() {
        let lower = &lower[row..row + R];
        for (rest, factors) in rest.iter_mut().zip(factors) {
            subtract(factors[k], lower, rest);
        }
    }
    for (rest, column) in rest.iter().zip(columns) {
        column[row..row + R].copy_from_slice(rest);
    }
}

/// Solves L U x = b in place, with both factors in one matrix, column by column: for one right side that takes a third
/// of what a routine for many does.
#[inline(always)]
fn substitute(factors: &Matrix, x: &mut [f64]) {
    for j in 0..x.len() {
        let (known, rest) = x[j..].split_first_mut().expect("there is an unknown left");
        subtract(*known, &factors.column(j)[j + 1..], rest);
    }
    for j in (0..x.len()).rev() {
        let (rest, known) = x[..=j].split_at_mut(j);
        known[0] /= factors.column(j)[j];
        subtract(known[0], &factors.column(j)[..j], rest);
    }
}

/// Solves Uᵀ Lᵀ x = b in place, a product of vectors for each column.
#[inline(always)]
fn substitute_transposed(factors: &Matrix, x: &mut [f64]) {
    for j in 0..x.len() {
        let column = factors.column(j);
        x[j] = (x[j] - product(&column[..j], &x[..j])) / column[j];
    }
    for j in (0..x.len()).rev() {
        x[j] -= product(&factors.column(j)[j + 1..], &x[j + 1..]);
    }
}

/// The product of two vectors, as several sums that need not wait for one another.
#[inline(always)]
fn product(left: &[f64], right: &[f64]) -> f64 {
    let mut sums = [0.0; ROWS];
    let (left, left_last) = left.as_chunks::<ROWS>();
    let (right, right_last) = right.as_chunks::<ROWS>();
    for (left, right) in left.iter().zip(right) {
        for (sum, (left, right)) in sums.iter_mut().zip(left.iter().zip(right)) {
            *sum = left.mul_add(*right, *sum);
        }
    }
    let last: f64 = left_last.iter().zip(right_last).map(|(left, right)| left * right).sum();
    sums.iter().sum::<f64>() + last
}

#[inline(always)]
fn subtract(factor: f64, column: &[f64], from: &mut [f64]) {
    for (value, entry) in from.iter_mut().zip(column) {
        *value = entry.mul_add(-factor, *value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix without order.
    fn matrix(n: usize) -> Matrix {
        let mut matrix = Matrix::default();
        matrix.reshape(n, n);
        for (i, value) in matrix.values_mut().iter_mut().enumerate() {
            *value = (0.5 + 1.3 * (i * i) as f64).sin();
        }
        matrix
    }

    /// Whatever is left of panels and blocks, it does what the textbook does, in its order: column after column.
    #[test]
    fn factors_are_those_of_elimination_column_by_column() {
        for n in [1, 2, 7, 8, 9, 16, 19, 30, 64, 107] {
            let mut a: Vec<Vec<f64>> = matrix(n).to_columns();
            for k in 0..n {
                let pivot = (k..n).rev().max_by(|&i, &j| a[k][i].abs().total_cmp(&a[k][j].abs())).unwrap();
                a.iter_mut().for_each(|column| column.swap(k, pivot));
                let inverse = a[k][k].recip();
                a[k][k + 1..].iter_mut().for_each(|value| *value *= inverse);
                let lower = a[k].clone();
                for column in &mut a[k + 1..] {
                    for i in k + 1..n {
                        column[i] = lower[i].mul_add(-column[k], column[i]);
                    }
                }
            }
            let mut factors = Factorisation { matrix: matrix(n), ..Factorisation::default() };
            factors.factorise();
            assert_eq!(factors.matrix.to_columns(), a, "{n}");
        }
    }

    #[test]
    fn factors_of_a_singular_matrix_are_not_finite() {
        for n in [2, 12] {
            let mut factors = Factorisation { matrix: matrix(n), ..Factorisation::default() };
            let first = factors.matrix.column(0).to_vec();
            factors.matrix.column_mut(n - 1).copy_from_slice(&first);
            factors.matrix.column_mut(0).fill(0.0);
            factors.factorise();
            let mut x = vec![1.0; n];
            factors.solve(&mut x);
            assert!(x.iter().any(|x| !x.is_finite()), "{n}");
        }
    }

    #[test]
    fn both_ways_solve() {
        let mut factors = Factorisation::default();
        for n in [1, 2, 30, 107] {
            let matrix = matrix(n);
            factors.matrix = matrix.clone();
            factors.factorise();
            let known: Vec<f64> = (0..n).map(|i| (0.7 * i as f64).cos()).collect();
            let (mut right_side, mut transposed) = (vec![0.0; n], vec![0.0; n]);
            matrix.multiply(&known, &mut right_side);
            matrix.add_transposed(&known, &mut transposed);
            factors.solve(&mut right_side);
            factors.solve_transposed(&mut transposed);
            for i in 0..n {
                let error = (right_side[i] - known[i]).abs() + (transposed[i] - known[i]).abs();
                assert!(error < 1e-10, "{n}: {error:e}");
            }
        }
    }
}
