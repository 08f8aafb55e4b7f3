//! Tensors: their products with matrices along an axis, and their Tucker form of lower rank.

use nalgebra::DMatrix;

use super::matrix::svd;

/// Numbers over one to three axes, the last one fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Tensor {
    /// The numbers.
    pub numbers: Vec<f64>,
    /// The length of each axis.
    pub shape: Vec<usize>,
}

impl Tensor {
    /// The product with a matrix along an axis: `out[o][r][i] = Σ_k matrix[r][k] numbers[o][k][i]`.
    pub fn along(&self, axis: usize, matrix: &DMatrix<f64>) -> Self {
        let (outer, length, inner) = self.around(axis);
        let rows = matrix.nrows();
        let mut numbers = vec![0.0; outer * rows * inner];
        for o in 0..outer {
            for r in 0..rows {
                let out = &mut numbers[(o * rows + r) * inner..][..inner];
                for k in 0..length {
                    let row = &self.numbers[(o * length + k) * inner..][..inner];
                    let weight = matrix[(r, k)];
                    out.iter_mut().zip(row).for_each(|(sum, number)| *sum += weight * number);
                }
            }
        }
        let mut shape = self.shape.clone();
        shape[axis] = rows;
        Self { numbers, shape }
    }

    /// The numbers along an axis by all others.
    fn unfolded(&self, axis: usize) -> DMatrix<f64> {
        let (outer, length, inner) = self.around(axis);
        let place = |k: usize, rest: usize| (rest / inner * length + k) * inner + rest % inner;
        DMatrix::from_fn(length, outer * inner, |k, rest| self.numbers[place(k, rest)])
    }

    /// The root of the sum of squares at each place along an axis.
    pub fn norms(&self, axis: usize) -> Vec<f64> {
        let unfolded = self.unfolded(axis);
        (0..unfolded.nrows()).map(|place| unfolded.row(place).norm()).collect()
    }

    /// The number of places before an axis, along it and after it.
    fn around(&self, axis: usize) -> (usize, usize, usize) {
        (self.shape[..axis].iter().product(), self.shape[axis], self.shape[axis + 1..].iter().product())
    }
}

/// Compresses a tensor by a higher-order singular value decomposition, axis by axis, leaving out so much that the root
/// of the sum of squares of what is left out is at most `most`: the factor of each axis, with orthonormal columns, and
/// the core. None if a decomposition does not converge.
pub fn compress(tensor: &Tensor, most: f64) -> Option<(Vec<DMatrix<f64>>, Tensor)> {
    let mut core = tensor.clone();
    let mut factors = Vec::with_capacity(core.shape.len());
    let share = most / (core.shape.len() as f64).sqrt();
    for axis in 0..core.shape.len() {
        let decomposition = svd(&core.unfolded(axis))?;
        let values = decomposition.values;
        let mut rank = values.len();
        let mut left_out = 0.0;
        while rank > 1 && left_out + values[rank - 1] * values[rank - 1] <= share * share {
            rank -= 1;
            left_out += values[rank] * values[rank];
        }
        let factor = decomposition.left.columns(0, rank).into_owned();
        core = core.along(axis, &factor.transpose());
        factors.push(factor);
    }
    Some((factors, core))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_below_the_bound_and_a_sum_of_products_has_its_rank() {
        let shape = vec![12, 9, 7];
        let decay = |i: usize, j: usize, k: usize| (-0.6 * (i + 2 * j + k) as f64).exp() * ((i * j + k) as f64).cos();
        let numbers: Vec<f64> = (0..12 * 9 * 7).map(|place| decay(place / 63, place / 7 % 9, place % 7)).collect();
        let tensor = Tensor { numbers, shape: shape.clone() };
        for most in [1e-2, 1e-5, 1e-12] {
            let (factors, core) = compress(&tensor, most).expect("converged");
            let back = factors.iter().enumerate().fold(core, |core, (axis, factor)| core.along(axis, factor));
            let square: f64 = back.numbers.iter().zip(&tensor.numbers).map(|(a, b)| (a - b) * (a - b)).sum();
            assert!(square.sqrt() <= most, "{most}: {}", square.sqrt());
        }
        let numbers = (0..12 * 9 * 7).map(|p| (p / 63 + 1) as f64 * ((p / 7 % 9) as f64 - 3.5)).collect();
        let (_, core) = compress(&Tensor { numbers, shape }, 1e-10).expect("converged");
        assert_eq!(core.shape, [1, 1, 1]);
    }
}
