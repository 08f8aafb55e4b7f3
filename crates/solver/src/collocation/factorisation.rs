//! Dense LU factorisation with buffers that are used again.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::perm::PermRef;
use faer::{MatMut, MatRef, Par};

use super::matrix::Matrix;

/// P A = L U of the last matrix, sequential: parallel work is over chains.
pub struct Factorisation {
    /// Assembled here, replaced by its factors.
    pub matrix: Matrix,
    forward: Vec<usize>,
    inverse: Vec<usize>,
    scratch: MemBuffer,
    capacity: usize,
}

impl Default for Factorisation {
    fn default() -> Self {
        let scratch = MemBuffer::new(factor::lu_in_place_scratch::<usize, f64>(0, 0, Par::Seq, Default::default()));
        Self { matrix: Matrix::default(), forward: Vec::new(), inverse: Vec::new(), scratch, capacity: 0 }
    }
}

impl Factorisation {
    /// Factorises the matrix in place.
    pub fn factorise(&mut self) {
        let n = self.matrix.rows();
        if n > self.capacity {
            let factor = factor::lu_in_place_scratch::<usize, f64>(n, n, Par::Seq, Default::default());
            let solve = solve::solve_in_place_scratch::<usize, f64>(n, 1, Par::Seq);
            let transposed = solve::solve_transpose_in_place_scratch::<usize, f64>(n, 1, Par::Seq);
            self.scratch = MemBuffer::new(factor.or(solve).or(transposed));
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
        let n = self.matrix.rows();
        let factors = MatRef::from_column_major_slice(self.matrix.values(), n, n);
        let permutation = PermRef::new_checked(&self.forward, &self.inverse, n);
        let right_side = MatMut::from_column_major_slice_mut(right_side, n, 1);
        let stack = MemStack::new(&mut self.scratch);
        solve::solve_in_place(factors, factors, permutation, right_side, Par::Seq, stack);
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
