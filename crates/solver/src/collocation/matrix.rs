//! A dense matrix, column by column.

use std::ops::Range;

use faer::{Mat, MatRef};

/// A dense matrix, stored column by column as the factorisation wants it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matrix {
    rows: usize,
    values: Vec<f64>,
}

impl Matrix {
    /// Makes it all zeros and of this shape; what it holds already is used again.
    pub fn reset(&mut self, rows: usize, columns: usize) {
        self.rows = rows;
        self.values.clear();
        self.values.resize(rows * columns, 0.0);
    }

    /// Makes it a multiple of some rows of another one; what it holds already is used again.
    pub fn copy_scaled(&mut self, other: &Self, rows: Range<usize>, factor: f64) {
        self.rows = rows.len();
        self.values.clear();
        for j in 0..other.columns() {
            self.values.extend(other.column(j)[rows.clone()].iter().map(|value| factor * value));
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.values.len().checked_div(self.rows).unwrap_or(0)
    }

    /// A column.
    pub fn column(&self, j: usize) -> &[f64] {
        &self.values[j * self.rows..(j + 1) * self.rows]
    }

    /// A column, to change it.
    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.values[j * self.rows..(j + 1) * self.rows]
    }

    /// All values, column by column.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// All values, column by column, to change them.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// A copy for other uses than the method's own.
    pub fn to_faer(&self) -> Mat<f64> {
        MatRef::from_column_major_slice(&self.values, self.rows, self.columns()).to_owned()
    }

    /// Adds to the columns from `first` on a factor times the product of a matrix with another, given row by row, which
    /// is so small that a general routine would cost more.
    pub fn add_product(&mut self, first: usize, factor: f64, left: &Self, right: &[f64]) {
        let (count, inner) = (self.rows, left.columns());
        let columns = right.len() / inner;
        for j in 0..columns {
            let sum = &mut self.values[(first + j) * count..(first + j + 1) * count];
            let factors = |k: usize| factor * right[k * columns + j];
            // three columns at a time, so that the sum is not read and written for each
            let mut k = 0;
            while k + 3 <= inner {
                let (a, b, c) = (factors(k), factors(k + 1), factors(k + 2));
                let columns = left.column(k).iter().zip(left.column(k + 1)).zip(left.column(k + 2));
                for (sum, ((x, y), z)) in sum.iter_mut().zip(columns) {
                    *sum += a * x + b * y + c * z;
                }
                k += 3;
            }
            for k in k..inner {
                let a = factors(k);
                for (sum, x) in sum.iter_mut().zip(left.column(k)) {
                    *sum += a * x;
                }
            }
        }
    }

    /// Adds the product of the transpose with a vector.
    pub fn add_transposed(&self, vector: &[f64], sum: &mut [f64]) {
        // four sums at a time, which do not wait for one another
        const TOGETHER: usize = 4;
        for (block, sums) in sum.chunks_mut(TOGETHER).enumerate() {
            let column = |k: usize| self.column(block * TOGETHER + k.min(sums.len() - 1));
            let columns = [column(0), column(1), column(2), column(3)];
            let mut products = [0.0; TOGETHER];
            for (i, value) in vector.iter().enumerate() {
                for (product, column) in products.iter_mut().zip(&columns) {
                    *product += value * column[i];
                }
            }
            for (sum, product) in sums.iter_mut().zip(products) {
                *sum += product;
            }
        }
    }

    /// The rows `from..from + product.len()` of the product with a vector.
    pub fn multiply_rows(&self, from: usize, vector: &[f64], product: &mut [f64]) {
        product.fill(0.0);
        for (j, factor) in vector.iter().enumerate() {
            let column = &self.column(j)[from..from + product.len()];
            for (sum, value) in product.iter_mut().zip(column) {
                *sum += factor * value;
            }
        }
    }
}
