//! A Chebyshev series in Tucker form, and its contraction with the polynomials at a point.
//!
//! The coefficient of T_i T_j T_k is Σ U₁[i][a] U₂[j][b] U₃[k][c] G[a][b][c], with a factor U of each axis and the core
//! G. So the series at a point is the core contracted with w_m = U_mᵀ T(t_m), one axis after the other.

/// Numbers as they stand in the file: single ones take half the memory, which is what a point waits for.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// Of single precision.
    Single(Vec<f32>),
    /// Of double precision.
    Double(Vec<f64>),
}

impl Numbers {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Single(numbers) => numbers.len(),
            Self::Double(numbers) => numbers.len(),
        }
    }

    /// All of them.
    pub fn to_doubles(&self) -> Vec<f64> {
        match self {
            Self::Single(numbers) => numbers.iter().map(|&number| number.into()).collect(),
            Self::Double(numbers) => numbers.clone(),
        }
    }

    /// See [`contract`].
    pub fn contract(&self, shape: [usize; 3], weights: &[f64], out: &mut [f64]) {
        match self {
            Self::Single(numbers) => contract(numbers, shape, weights, out),
            Self::Double(numbers) => contract(numbers, shape, weights, out),
        }
    }
}

/// A factor: polynomials by ranks.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// Number of polynomials.
    pub degrees: usize,
    /// Rank.
    pub rank: usize,
    /// Coefficients, the rank fastest.
    pub numbers: Numbers,
}

impl Factor {
    /// Uᵀ b: what the rank's functions are where the polynomials are b.
    pub fn weights(&self, basis: &[f64], weights: &mut [f64]) {
        self.numbers.contract([1, self.degrees, self.rank], &basis[..self.degrees], weights);
    }

    /// U v: coefficients of the polynomials.
    pub fn coefficients(&self, v: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.degrees];
        self.numbers.contract([self.degrees, self.rank, 1], v, &mut out);
        out
    }
}

/// A series in Tucker form.
#[derive(Clone, Debug, PartialEq)]
pub struct Tucker {
    /// The factor of each axis.
    pub factors: Vec<Factor>,
    /// The core, the last axis fastest.
    pub core: Numbers,
}

/// `out[o][i] = Σ_k weights[k] numbers[o][k][i]` for a shape of outer, contracted and inner length.
///
/// It takes the widest vectors that the processor has.
pub fn contract<N: Copy + Into<f64>>(numbers: &[N], shape: [usize; 3], weights: &[f64], out: &mut [f64]) {
    pulp::Arch::new().dispatch(Contraction { numbers, shape, weights, out });
}

struct Contraction<'a, N> {
    numbers: &'a [N],
    shape: [usize; 3],
    weights: &'a [f64],
    out: &'a mut [f64],
}

impl<N: Copy + Into<f64>> pulp::NullaryFnOnce for Contraction<'_, N> {
    type Output = ();

    // A closure would not be part of the code for wide vectors.
    #[inline(always)]
    fn call(self) {
        contract_rows(self.numbers, self.shape, self.weights, self.out);
    }
}

/// Four rows are added at once, which halves the loads and stores of `out`.
#[inline(always)]
fn contract_rows<N: Copy + Into<f64>>(
    numbers: &[N],
    [outer, length, inner]: [usize; 3],
    weights: &[f64],
    out: &mut [f64],
) {
    debug_assert_eq!((numbers.len(), weights.len(), out.len()), (outer * length * inner, length, outer * inner));
    if inner == 1 {
        for (sum, row) in out.iter_mut().zip(numbers.chunks_exact(length)) {
            *sum = row.iter().zip(weights).map(|(&number, weight)| number.into() * weight).sum();
        }
        return;
    }
    for (sums, block) in out.chunks_exact_mut(inner).zip(numbers.chunks_exact(length * inner)) {
        sums.fill(0.0);
        let (fours, rest) = (block.chunks_exact(4 * inner), weights.chunks_exact(4));
        let (last_rows, last_weights) = (fours.remainder(), rest.remainder());
        for (rows, w) in fours.zip(rest) {
            let (a, rows) = rows.split_at(inner);
            let (b, rows) = rows.split_at(inner);
            let (c, d) = rows.split_at(inner);
            for ((((sum, &a), &b), &c), &d) in sums.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                *sum += (w[0] * a.into() + w[1] * b.into()) + (w[2] * c.into() + w[3] * d.into());
            }
        }
        for (row, weight) in last_rows.chunks_exact(inner).zip(last_weights) {
            sums.iter_mut().zip(row).for_each(|(sum, &number)| *sum += weight * number.into());
        }
    }
}

/// T_k(t) of all k.
pub fn chebyshev(t: f64, values: &mut [f64]) {
    for k in 0..values.len() {
        values[k] = match k {
            0 => 1.0,
            1 => t,
            _ => 2.0 * t * values[k - 1] - values[k - 2],
        };
    }
}

/// dT_k/dt = k U_(k−1)(t) of all k.
pub fn chebyshev_slopes(t: f64, slopes: &mut [f64]) {
    let (mut before, mut second) = (0.0, 1.0);
    for (k, slope) in slopes.iter_mut().enumerate() {
        *slope = k as f64 * before;
        (before, second) = (second, 2.0 * t * second - before);
    }
}

/// Σ c_k T_k(t) by Clenshaw's recurrence.
pub fn clenshaw(coefficients: &[f64], t: f64) -> f64 {
    let [mut b1, mut b2] = [0.0; 2];
    for &c in coefficients[1..].iter().rev() {
        (b1, b2) = (c + 2.0 * t * b1 - b2, b1);
    }
    coefficients[0] + t * b1 - b2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_cosines_and_their_slopes_sines() {
        let (mut values, mut slopes) = ([0.0; 40], [0.0; 40]);
        for angle in [0.1_f64, 1.0, 2.0, 3.0] {
            chebyshev(angle.cos(), &mut values);
            chebyshev_slopes(angle.cos(), &mut slopes);
            for k in 0..40 {
                let order = k as f64;
                assert!((values[k] - (order * angle).cos()).abs() < 1e-12, "T_{k} at {angle}");
                let slope = order * (order * angle).sin() / angle.sin();
                assert!((slopes[k] - slope).abs() < 1e-9, "{k} {angle}: {} {slope}", slopes[k]);
            }
        }
    }

    #[test]
    fn clenshaw_is_the_sum_of_the_polynomials() {
        let coefficients: Vec<f64> = (0..25).map(|k| 1.0 / f64::from(1 + k * k)).collect();
        let mut values = [0.0; 25];
        for t in [-1.0, -0.3, 0.0, 0.8, 1.0] {
            chebyshev(t, &mut values);
            let sum = coefficients.iter().zip(&values).map(|(c, b)| c * b).sum::<f64>();
            assert!((clenshaw(&coefficients, t) - sum).abs() < 1e-13);
        }
    }

    #[test]
    fn a_contraction_is_the_triple_sum() {
        let [outer, length, inner] = [3, 7, 5];
        let numbers: Vec<f64> = (0..outer * length * inner).map(|i| ((i * 37 % 101) as f64).sin()).collect();
        let weights: Vec<f64> = (0..length).map(|k| (k as f64).cos()).collect();
        let mut out = vec![f64::NAN; outer * inner];
        contract(&numbers, [outer, length, inner], &weights, &mut out);
        for o in 0..outer {
            for i in 0..inner {
                let expected: f64 = (0..length).map(|k| weights[k] * numbers[(o * length + k) * inner + i]).sum();
                assert!((out[o * inner + i] - expected).abs() < 1e-14);
            }
        }
    }
}
