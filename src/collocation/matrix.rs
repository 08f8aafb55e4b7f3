//! A dense matrix, column by column.

/// A dense matrix, stored column by column as the factorisation wants it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matrix {
    rows: usize,
    values: Vec<f64>,
}

impl Matrix {
    /// All zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, values: vec![0.0; rows * columns] }
    }

    /// Makes it all zeros and of this shape; what it holds already is used again.
    pub fn reset(&mut self, rows: usize, columns: usize) {
        self.rows = rows;
        self.values.clear();
        self.values.resize(rows * columns, 0.0);
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        if self.rows == 0 { 0 } else { self.values.len() / self.rows }
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
