//! A dense matrix, column by column.

use std::ops::Range;

use super::wide::wide;

/// Rows of a product that are done together.
const BLOCK: usize = 16;
const LONG: usize = 32;
const SHORT: usize = 8;

/// A dense matrix, stored column by column as the factorisation wants it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matrix {
    rows: usize,
    values: Vec<f64>,
}

impl Matrix {
    /// Gives it this shape; what it holds already is used again, and has to be overwritten.
    pub fn reshape(&mut self, rows: usize, columns: usize) {
        self.rows = rows;
        self.values.resize(rows * columns, 0.0);
    }

    /// Makes it a multiple of some rows of another one; what it holds already is used again.
    pub fn copy_scaled(&mut self, other: &Self, rows: Range<usize>, factor: f64) {
        self.reshape(rows.len(), other.columns());
        for j in 0..other.columns() {
            for (value, of_other) in self.column_mut(j).iter_mut().zip(&other.column(j)[rows.clone()]) {
                *value = factor * of_other;
            }
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

    /// All values, column by column, to change them.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Its columns, for other uses than the method's own.
    pub fn to_columns(&self) -> Vec<Vec<f64>> {
        (0..self.columns()).map(|j| self.column(j).to_vec()).collect()
    }

    /// Makes the columns from `first` on a factor times the product of a matrix with another, given row by row, which is
    /// so small that a general routine would cost more. Six arguments: the first column keeps what it holds, and the
    /// product is added to it, if it is `shared`.
    #[inline(always)]
    pub fn set_product(&mut self, first: usize, factor: f64, left: &Self, right: &[f64], shared: bool) {
        let columns = right.len() / left.columns();
        for j in 0..columns {
            let sum = &mut self.values[(first + j) * self.rows..(first + j + 1) * self.rows];
            if j > 0 || !shared {
                sum.fill(0.0);
            }
            let factors = right[j..].iter().step_by(columns).map(|value| factor * value);
            let (mut done, blocks) = (0, sum.as_chunks_mut::<BLOCK>());
            for sums in blocks.0 {
                add_rows(left, done, factors.clone(), sums);
                done += BLOCK;
            }
            for sum in blocks.1 {
                add_rows(left, done, factors.clone(), std::array::from_mut(sum));
                done += 1;
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

    /// The product with a vector.
    pub fn multiply(&self, vector: &[f64], product: &mut [f64]) {
        debug_assert_eq!((vector.len(), product.len()), (self.columns(), self.rows));
        wide(
            #[inline(always)]
            || {
                let (mut first, rows) = (0, self.rows);
                while first + LONG <= rows {
                    self.multiply_rows::<LONG>(first, vector, product);
                    first += LONG;
                }
                while first + SHORT <= rows {
                    self.multiply_rows::<SHORT>(first, vector, product);
                    first += SHORT;
                }
                if first > 0 && first < rows {
                    // with some of those before, to the same bits
                    self.multiply_rows::<SHORT>(rows - SHORT, vector, product);
                } else {
                    (first..rows).for_each(|row| self.multiply_rows::<1>(row, vector, product));
                }
            },
        );
    }

    #[inline(always)]
    fn multiply_rows<const N: usize>(&self, first: usize, vector: &[f64], product: &mut [f64]) {
        let mut sums = [0.0; N];
        add_rows(self, first, vector.iter().copied(), &mut sums);
        product[first..first + N].copy_from_slice(&sums);
    }
}

/// Adds some rows of the product of a matrix with a vector; the sums stay in registers.
#[inline(always)]
fn add_rows<const N: usize>(left: &Matrix, first: usize, vector: impl Iterator<Item = f64>, sums: &mut [f64; N]) {
    let mut here = *sums;
    for (column, factor) in left.values.chunks_exact(left.rows).zip(vector) {
        for (sum, value) in here.iter_mut().zip(&column[first..first + N]) {
            *sum = value.mul_add(factor, *sum);
        }
    }
    *sums = here;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: usize, columns: usize) -> Matrix {
        let mut matrix = Matrix::default();
        matrix.reshape(rows, columns);
        for (i, value) in matrix.values_mut().iter_mut().enumerate() {
            *value = (1.7 * i as f64).sin();
        }
        matrix
    }

    /// Whatever is left of the blocks of rows.
    #[test]
    fn products_are_sums_of_products() {
        for rows in [1, 7, 8, 9, 31, 32, 39, 41, 75] {
            for columns in [1, 4, 9] {
                let (left, vector) = (matrix(rows, columns), matrix(columns, 1));
                let mut product = vec![f64::NAN; rows];
                left.multiply(vector.column(0), &mut product);
                let sum = |i: usize| (0..columns).map(|j| left.column(j)[i] * vector.column(0)[j]).sum::<f64>();
                assert!((0..rows).all(|i| (product[i] - sum(i)).abs() < 1e-14), "{rows} × {columns}");

                let mut twice = Matrix::default();
                twice.reshape(rows, 2);
                twice.values_mut().fill(1.0);
                twice.set_product(0, 2.0, &left, vector.column(0), false);
                twice.set_product(1, -1.0, &left, vector.column(0), true);
                for i in 0..rows {
                    let error = (twice.column(0)[i] - 2.0 * sum(i)).abs() + (twice.column(1)[i] - 1.0 + sum(i)).abs();
                    assert!(error < 1e-14, "{rows} × {columns}");
                }
            }
        }
    }
}
