//! Condition numbers.

use nalgebra::DMatrix;

/// The condition number ‖A‖₁ ‖A⁻¹‖₁ of a square matrix whose rows, then columns, are divided by their largest entry.
///
/// The scaling removes the units of equations and unknowns. What remains bounds the relative error of a solution over
/// that of its equations. It is infinite if the matrix is singular, or an entry is not finite. The matrix is given column
/// by column.
pub(super) fn condition(columns: &[Vec<f64>]) -> f64 {
    let mut matrix = DMatrix::from_fn(columns.len(), columns.len(), |row, column| columns[column][row]);
    equilibrate(&mut matrix);
    let inverse = matrix.clone().lu().try_inverse();
    let condition = inverse.map(|inverse| one_norm(&matrix) * one_norm(&inverse));
    condition.filter(|condition| condition.is_finite()).unwrap_or(f64::INFINITY)
}

fn equilibrate(matrix: &mut DMatrix<f64>) {
    for row in 0..matrix.nrows() {
        let largest = matrix.row(row).iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        matrix.row_mut(row).iter_mut().for_each(|entry| *entry /= largest);
    }
    for column in 0..matrix.ncols() {
        let largest = matrix.column(column).iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        matrix.column_mut(column).iter_mut().for_each(|entry| *entry /= largest);
    }
}

/// The largest sum of a column's absolute values; NaN if it holds one.
fn one_norm(matrix: &DMatrix<f64>) -> f64 {
    let sums = matrix.column_iter().map(|column| column.iter().map(|entry| entry.abs()).sum::<f64>());
    sums.fold(0.0, |largest, sum| if sum > largest || sum.is_nan() { sum } else { largest })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square matrix, column by column.
    fn columns(n: usize, entry: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
        (0..n).map(|column| (0..n).map(|row| entry(row, column)).collect()).collect()
    }

    #[test]
    fn known_inverses_are_found() {
        assert_eq!(condition(&columns(5, |i, j| if i == j { 1.0 } else { 0.0 })), 1.0);
        // ((1, 1), (1, 1 − e)) has the inverse ((e − 1, 1), (1, −1))/e
        let e = 1e-6;
        let near = columns(2, |i, j| if i + j == 2 { 1.0 - e } else { 1.0 });
        assert!((condition(&near) * e / 4.0 - 1.0).abs() < 1e-5);
    }

    #[test]
    fn units_do_not_matter() {
        let matrix = |i: usize, j: usize| ((1 + i * j) as f64).sin() + if i == j { 3.0 } else { 0.0 };
        let plain = condition(&columns(12, matrix));
        let scaled = condition(&columns(12, |i, j| 10.0_f64.powi(3 * i as i32 - 18) * matrix(i, j)));
        assert!((1.0..1e3).contains(&plain) && (scaled / plain - 1.0).abs() < 1e-10, "{plain} {scaled}");
    }

    /// κ₂/n ≤ κ₁ ≤ n κ₂, and κ₂ is the ratio of the singular values.
    #[test]
    fn singular_values_bound_it() {
        for n in [3, 6, 9] {
            let entry = |i: usize, j: usize| ((1 + i + j) as f64).recip();
            let found = condition(&columns(n, entry));
            let mut hilbert = DMatrix::from_fn(n, n, entry);
            equilibrate(&mut hilbert);
            let singular = hilbert.singular_values();
            let two_norm = singular[0] / singular[n - 1];
            assert!(found >= two_norm / n as f64 && found <= two_norm * n as f64, "{found:e} {two_norm:e}");
        }
    }

    #[test]
    fn singular_matrices_show() {
        assert_eq!(condition(&columns(3, |_, _| 1.0)), f64::INFINITY);
        assert_eq!(condition(&columns(2, |i, _| if i == 0 { f64::NAN } else { 1.0 })), f64::INFINITY);
        assert_eq!(condition(&columns(2, |i, _| i as f64)), f64::INFINITY);
    }
}
