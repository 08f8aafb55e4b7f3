//! Singular value decompositions, by one-sided Jacobi rotations.
//!
//! They are slower than other methods, and matrices here are small. What they give is exact to rounding for matrices of
//! any rank, which the decomposition of nalgebra 0.34 is not: one in a hundred was off by a tenth.

use nalgebra::DMatrix;

/// Columns are at right angles if the cosine between them is below this for each of their numbers: its rounding error.
const ROUNDING: f64 = f64::EPSILON;

/// Singular values below this part of the largest are rounding.
const NOTHING: f64 = 1e-14;

/// Columns whose squares are below this part of all squares are zero: they are rounding, and their products underflow.
const LEAST: f64 = 1e-60;

/// Rotations of all pairs of columns converge in about ten rounds.
const MOST_ROUNDS: usize = 60;

/// A = U S Vᵀ, with as many singular values as A has rows or columns, whichever are fewer.
#[derive(Clone, Debug)]
pub struct Decomposition {
    /// U, with orthonormal columns; zero where the singular value is, if A is not wide.
    pub left: DMatrix<f64>,
    /// The singular values, from the largest to the smallest.
    pub values: Vec<f64>,
    /// V, as U; zero where the singular value is, if A is wide.
    pub right: DMatrix<f64>,
}

/// Decomposes a matrix. None if it does not converge, as of numbers that are not finite.
pub fn svd(matrix: &DMatrix<f64>) -> Option<Decomposition> {
    if matrix.nrows() < matrix.ncols() {
        let Decomposition { left, values, right } = of_columns(matrix.transpose())?;
        return Some(Decomposition { left: right, values, right: left });
    }
    of_columns(matrix.clone())
}

/// The pseudoinverse of a matrix, V S⁻¹ Uᵀ. None if its decomposition does not converge.
pub fn pseudoinverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let Decomposition { left, values, mut right } = svd(matrix)?;
    for (mut column, value) in right.column_iter_mut().zip(&values) {
        column *= if *value > NOTHING * values[0] { value.recip() } else { 0.0 };
    }
    Some(right * left.transpose())
}

/// Rotates the columns of a matrix that is not wide until all are at right angles (Hestenes, J. SIAM 6, 1958).
fn of_columns(mut columns: DMatrix<f64>) -> Option<Decomposition> {
    let n = columns.ncols();
    let mut rotations = DMatrix::identity(n, n);
    let mut rounds = 0;
    while rotate_all(&mut columns, &mut rotations) {
        rounds += 1;
        if rounds == MOST_ROUNDS {
            return None;
        }
    }
    let least = LEAST * columns.norm_squared();
    let size = |square: f64| if square < least { 0.0 } else { square.sqrt() };
    let sizes: Vec<f64> = columns.column_iter().map(|column| size(column.norm_squared())).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| sizes[b].total_cmp(&sizes[a]));
    let values: Vec<f64> = order.iter().map(|&column| sizes[column]).collect();
    let mut left = columns.select_columns(&order);
    for (mut column, size) in left.column_iter_mut().zip(&values) {
        column *= if *size > 0.0 { size.recip() } else { 0.0 };
    }
    Some(Decomposition { left, values, right: rotations.select_columns(&order) })
}

/// Rotates each two columns to right angles; false if all were.
fn rotate_all(columns: &mut DMatrix<f64>, rotations: &mut DMatrix<f64>) -> bool {
    let mut rotated = false;
    let rounding = ROUNDING * columns.nrows() as f64;
    let least = LEAST * columns.norm_squared();
    for second in 1..columns.ncols() {
        for first in 0..second {
            let (a, b) = (columns.column(first), columns.column(second));
            let (aa, bb, ab) = (a.norm_squared(), b.norm_squared(), a.dot(&b));
            if ab.abs() <= rounding * (aa * bb).sqrt() || aa.min(bb) < least {
                continue;
            }
            rotated = true;
            let half = 0.5 * (bb - aa) / ab;
            let tangent = 1.0_f64.copysign(half) / (half.abs() + half.hypot(1.0));
            let cosine = tangent.hypot(1.0).recip();
            for matrix in [&mut *columns, &mut *rotations] {
                for row in 0..matrix.nrows() {
                    let (a, b) = (matrix[(row, first)], matrix[(row, second)]);
                    matrix[(row, first)] = cosine * (a - tangent * b);
                    matrix[(row, second)] = cosine * (b + tangent * a);
                }
            }
        }
    }
    rotated
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        /// For matrices of any shape and rank, with singular values that are alike or fall over many decades.
        #[test]
        fn products_come_back_and_pseudoinverses_obey_the_laws_of_penrose(
            rows in 1_usize..30,
            columns in 1_usize..40,
            rank in 1_usize..30,
            decay in 0.0..0.5_f64,
            numbers in prop::collection::vec(-1.0..1.0_f64, 1000),
        ) {
            let rank = rank.min(rows).min(columns);
            let mut numbers = numbers.iter().copied().cycle();
            let mut random = |rows, columns| DMatrix::from_fn(rows, columns, |_, _| numbers.next().expect("a cycle"));
            let mut left = random(rows, rank);
            for (k, mut column) in left.column_iter_mut().enumerate() {
                column *= (-decay * k as f64).exp();
            }
            let a = left * random(rank, columns);

            let Decomposition { left, values, right } = svd(&a).expect("converged");
            prop_assert!(values.is_sorted_by(|a, b| a >= b));
            prop_assert!(values[rank..].iter().all(|value| *value < 1e-13 * values[0]));
            let scaled = DMatrix::from_fn(left.nrows(), left.ncols(), |i, k| left[(i, k)] * values[k]);
            prop_assert!((scaled * right.transpose() - &a).amax() < 1e-13 * values[0]);
            for vectors in [&left, &right] {
                // Orthonormal, or zero where the singular value is rounding.
                for (i, a) in vectors.column_iter().enumerate() {
                    for (j, b) in vectors.column_iter().enumerate() {
                        let off = if i == j { (a.dot(&b) - 1.0).abs().min(a.norm()) } else { a.dot(&b).abs() };
                        prop_assert!(off < 1e-12 && (i != j || i >= rank || a.norm() > 0.5), "{i}, {j}: {off:e}");
                    }
                }
            }

            let inverse = pseudoinverse(&a).expect("converged");
            let most = 1e-14 * values[0] / values[rank - 1] * (rows + columns) as f64;
            prop_assert!((&a * &inverse * &a - &a).amax() <= most * a.amax());
            prop_assert!((&inverse * &a * &inverse - &inverse).amax() <= most * inverse.amax());
        }
    }

    #[test]
    fn numbers_that_are_not_finite_have_no_decomposition() {
        assert!(svd(&DMatrix::from_element(3, 2, f64::NAN)).is_none());
    }
}
