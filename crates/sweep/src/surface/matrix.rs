//! Singular value decompositions.

use nalgebra::{DMatrix, Dyn, SVD};

/// What a decomposition, multiplied out again, may be off by, over the largest singular value.
const WRONG: f64 = 1e-11;

/// Singular values below this part of the largest are rounding.
const ROUNDING: f64 = 1e-14;

/// The thin decomposition of a matrix, singular values from the largest to the smallest. None if it does not converge.
pub fn svd(matrix: &DMatrix<f64>) -> Option<SVD<f64, Dyn, Dyn>> {
    let decomposition = SVD::try_new(matrix.clone(), true, true, f64::EPSILON, 0)?;
    let largest = decomposition.singular_values[0];
    let difference = (decomposition.clone().recompose().ok()? - matrix).amax();
    (difference <= WRONG * largest).then_some(decomposition)
}

/// The left singular vectors, as columns.
pub fn left_vectors(decomposition: SVD<f64, Dyn, Dyn>) -> DMatrix<f64> {
    decomposition.u.expect("they were asked for")
}

/// The pseudoinverse of a matrix. None if its decomposition does not converge.
pub fn pseudoinverse(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let decomposition = svd(matrix)?;
    let least = ROUNDING * decomposition.singular_values[0];
    decomposition.pseudo_inverse(least).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The four laws of Penrose, for matrices of full rank and not, tall and wide.
    #[test]
    fn a_pseudoinverse_obeys_the_laws_of_penrose() {
        for (rows, columns) in [(1, 1), (7, 7), (40, 9), (9, 40), (30, 25)] {
            let full = DMatrix::from_fn(rows, columns, |i, j| ((1 + i * i + 3 * j) as f64).sin());
            let poor = DMatrix::from_fn(rows, columns, |i, j| (1.0 + i as f64) * (0.5 - j as f64).cos());
            for a in [full, poor] {
                let inverse = pseudoinverse(&a).expect("converged");
                let (left, right) = (&a * &inverse, &inverse * &a);
                let laws = [(&left * &a, a), (&right * &inverse, inverse)];
                for (found, expected) in laws.into_iter().chain([left, right].map(|it| (it.transpose(), it))) {
                    let error = (found - &expected).amax() / expected.amax();
                    assert!(error < 1e-10, "{rows} × {columns}: {error:e}");
                }
            }
        }
    }

    /// A graded matrix has small singular values to the rounding of the largest, and vectors that are orthonormal.
    #[test]
    fn vectors_are_orthonormal() {
        let matrix = DMatrix::from_fn(33, 200, |i, j| (-0.7 * (i + j / 7) as f64).exp() * ((i * j) as f64).cos());
        let decomposition = svd(&matrix).expect("converged");
        assert!(decomposition.singular_values.as_slice().is_sorted_by(|a, b| a >= b));
        let u = left_vectors(decomposition);
        assert!((u.transpose() * &u - DMatrix::identity(33, 33)).amax() < 1e-13);
    }
}
