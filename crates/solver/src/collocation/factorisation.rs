//! Dense LU factorisation with buffers that are used again.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::{MatMut, MatRef, Par};

use super::matrix::Matrix;
use super::wide::wide;

/// P A = L U of the last matrix, sequential: parallel work is over chains.
pub struct Factorisation {
    /// Assembled here, replaced by its factors.
    pub matrix: Matrix,
    forward: Vec<usize>,
    inverse: Vec<usize>,
    permuted: Vec<f64>,
    scratch: MemBuffer,
    capacity: usize,
}

impl Default for Factorisation {
    fn default() -> Self {
        let scratch = MemBuffer::new(factor::lu_in_place_scratch::<usize, f64>(0, 0, Par::Seq, Default::default()));
        Self {
            matrix: Matrix::default(),
            forward: Vec::new(),
            inverse: Vec::new(),
            permuted: Vec::new(),
            scratch,
            capacity: 0,
        }
    }
}

impl Factorisation {
    /// Factorises the matrix in place.
    pub fn factorise(&mut self) {
        let n = self.matrix.rows();
        if n > self.capacity {
            let factor = factor::lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, Default::default());
            let transposed = solve::solve_transpose_in_place_scratch::<usize, f64>(n, 1, Par::Seq);
            self.scratch = MemBuffer::new(factor.or(transposed));
            self.capacity = n;
        }
        self.forward.resize(n, 0);
        self.inverse.resize(n, 0);
        let matrix = MatMut::from_column_major_slice_mut(self.matrix.values_mut(), n, n);
        let stack = MemStack::new(&mut self.scratch);
        factor::lu_in_place(matrix, &mut self.forward, &mut self.inverse, Par::Seq, stack, Default::default());
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
        let n = self.matrix.rows();
        let factors = MatRef::from_column_major_slice(self.matrix.values(), n, n);
        let permutation = PermRef::new_checked(&self.forward, &self.inverse, n);
        let right_side = MatMut::from_column_major_slice_mut(right_side, n, 1);
        let stack = MemStack::new(&mut self.scratch);
        solve::solve_transpose_in_place(factors, factors, permutation, right_side, Par::Seq, stack);
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

#[inline(always)]
fn subtract(factor: f64, column: &[f64], from: &mut [f64]) {
    for (value, entry) in from.iter_mut().zip(column) {
        *value = entry.mul_add(-factor, *value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_solve() {
        let mut factors = Factorisation::default();
        for n in [1, 2, 30, 107] {
            let mut matrix = Matrix::default();
            matrix.reshape(n, n);
            for (i, value) in matrix.values_mut().iter_mut().enumerate() {
                *value = (0.5 + 1.3 * (i * i) as f64).sin();
            }
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
