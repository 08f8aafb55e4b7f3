//! From Chebyshev coefficients on a box to a Tucker form of lower rank.

use faer::Mat;

/// A Tucker form: for each axis the factor, polynomials by ranks with the rank fastest, and the core.
#[derive(Clone, Debug)]
pub struct Compressed {
    /// Number of polynomials and rank of each axis.
    pub shape: Vec<[usize; 2]>,
    /// The factors.
    pub factors: Vec<Vec<f64>>,
    /// The core, the last axis fastest.
    pub core: Vec<f64>,
}

/// Compresses coefficients by a higher-order singular value decomposition, axis by axis, leaving out so much that the
/// root of the sum of squares of what is left out is at most `most`. Returns none if a decomposition does not converge.
pub fn compress(coefficients: &[f64], lengths: &[usize], most: f64) -> Option<Compressed> {
    let mut core = coefficients.to_vec();
    let mut now = lengths.to_vec();
    let (mut shape, mut factors) = (Vec::new(), Vec::new());
    let share = most / (lengths.len() as f64).sqrt();
    for axis in 0..lengths.len() {
        let (outer, length): (usize, usize) = (now[..axis].iter().product(), now[axis]);
        let inner: usize = now[axis + 1..].iter().product();
        let unfolded =
            Mat::from_fn(length, outer * inner, |k, rest| core[(rest / inner * length + k) * inner + rest % inner]);
        let decomposition = unfolded.thin_svd().ok()?;
        let (vectors, values) = (decomposition.U(), decomposition.S().column_vector());
        let mut rank = values.nrows();
        let mut left_out = 0.0;
        while rank > 1 && left_out + values[rank - 1] * values[rank - 1] <= share * share {
            rank -= 1;
            left_out += values[rank] * values[rank];
        }
        let mut smaller = vec![0.0; outer * rank * inner];
        for o in 0..outer {
            for r in 0..rank {
                let out = &mut smaller[(o * rank + r) * inner..][..inner];
                for k in 0..length {
                    let row = &core[(o * length + k) * inner..][..inner];
                    let weight = vectors[(k, r)];
                    out.iter_mut().zip(row).for_each(|(sum, number)| *sum += weight * number);
                }
            }
        }
        factors.push((0..length).flat_map(|k| (0..rank).map(move |r| vectors[(k, r)])).collect());
        shape.push([length, rank]);
        now[axis] = rank;
        core = smaller;
    }
    Some(Compressed { shape, factors, core })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients that a form stands for.
    fn expand(form: &Compressed) -> Vec<f64> {
        let [[a, ra], [b, rb], [c, rc]] = [form.shape[0], form.shape[1], form.shape[2]];
        let mut all = Vec::new();
        for i in 0..a {
            for j in 0..b {
                for k in 0..c {
                    let mut sum = 0.0;
                    for (place, core) in form.core.iter().enumerate() {
                        let [p, q, r] = [place / (rb * rc), place / rc % rb, place % rc];
                        sum += core
                            * form.factors[0][i * ra + p]
                            * form.factors[1][j * rb + q]
                            * form.factors[2][k * rc + r];
                    }
                    all.push(sum);
                }
            }
        }
        all
    }

    #[test]
    fn what_is_left_out_is_below_the_bound_and_a_sum_of_products_has_its_rank() {
        let lengths = [12, 9, 7];
        let decay = |i: usize, j: usize, k: usize| (-0.6 * (i + 2 * j + k) as f64).exp() * ((i * j + k) as f64).cos();
        let numbers: Vec<f64> = (0..12 * 9 * 7).map(|place| decay(place / 63, place / 7 % 9, place % 7)).collect();
        for most in [1e-2, 1e-5, 1e-12] {
            let form = compress(&numbers, &lengths, most).expect("converged");
            let square: f64 = expand(&form).iter().zip(&numbers).map(|(a, b)| (a - b) * (a - b)).sum();
            assert!(square.sqrt() <= most, "{most}: {}", square.sqrt());
        }
        let product: Vec<f64> = (0..12 * 9 * 7).map(|p| (p / 63 + 1) as f64 * ((p / 7 % 9) as f64 - 3.5)).collect();
        let form = compress(&product, &lengths, 1e-10).expect("converged");
        assert_eq!(form.shape, [[12, 1], [9, 1], [7, 1]]);
    }
}
