//! Anderson acceleration of a fixed-point map (Walker and Ni, SIAM J. Numer. Anal. 49, 1715, 2011; type II).

use super::inner_product::inner_product;

/// A column whose part outside of the span of the others is smaller than this, relative to itself, adds nothing.
const DEPENDENT: f64 = 1e-10;

/// The last iterates of a map g: differences of x and of the residual r = g(x) − x, both of `size` numbers.
///
/// The differences of the residual are kept as Q R, newest first. A new one costs O(size depth): it is orthogonalised
/// against Q, put in front, and R made triangular again by rotations.
pub struct Anderson {
    size: usize,
    depth: usize,
    /// Differences Δx + Δr, newest first; `used` of them count.
    steps: Vec<Vec<f64>>,
    /// Columns of Q.
    orthonormal: Vec<Vec<f64>>,
    /// R, depth × depth, row by row.
    triangle: Vec<f64>,
    used: usize,
    previous: Option<Previous>,
    weights: Vec<f64>,
}

struct Previous {
    image: Vec<f64>,
    residual: Vec<f64>,
}

impl Anderson {
    /// No history yet.
    pub fn new(size: usize, depth: usize) -> Self {
        let columns = || vec![vec![0.0; size]; depth];
        Self {
            size,
            depth,
            steps: columns(),
            orthonormal: columns(),
            triangle: vec![0.0; depth * depth],
            used: 0,
            previous: None,
            weights: vec![0.0; depth],
        }
    }

    /// Forgets the history: the next step is the plain one.
    pub fn forget(&mut self) {
        self.used = 0;
        self.previous = None;
    }

    /// From x and its image g(x) to the next iterate, written over `image`: g(x) − Σ γ_j (Δx_j + Δr_j) with the γ that
    /// make r − Σ γ_j Δr_j smallest.
    pub fn mix(&mut self, x: &[f64], image: &mut [f64]) {
        assert_eq!((x.len(), image.len()), (self.size, self.size));
        let Some(mut previous) = self.previous.take() else {
            let residual = image.iter().zip(x).map(|(g, x)| g - x).collect();
            self.previous = Some(Previous { image: image.to_vec(), residual });
            return;
        };
        // the oldest makes room
        self.used = self.used.min(self.depth - 1);
        self.steps.rotate_right(1);
        let column = &mut self.orthonormal[self.used];
        let known = previous.image.iter_mut().zip(&mut previous.residual);
        let columns = self.steps[0].iter_mut().zip(column);
        for (((before, residual_before), (step, change)), (g, x)) in known.zip(columns).zip(image.iter().zip(x)) {
            let residual = g - x;
            // Δx + Δr is the difference of the images
            *step = g - *before;
            *change = residual - *residual_before;
            *before = *g;
            *residual_before = residual;
        }
        self.put_in_front();
        self.least_squares(&previous.residual);
        self.previous = Some(previous);
        for (step, weight) in self.steps[..self.used].iter().zip(&self.weights) {
            image.iter_mut().zip(step).for_each(|(image, step)| *image -= weight * step);
        }
    }

    /// Takes the column after the last of Q into the factorisation, as the first column. Where it adds nothing to the
    /// others, the oldest of them go.
    fn put_in_front(&mut self) {
        let Self { depth, orthonormal, triangle, used, weights, .. } = self;
        let (depth, mut count) = (*depth, *used);
        let (known, rest) = orthonormal.split_at_mut(count);
        let column = &mut rest[0];
        let (length, parts) = (norm(column), &mut weights[..count]);
        parts.fill(0.0);
        // a second time where the first leaves too little to be trusted
        for _ in 0..2 {
            let before = norm(column);
            for (direction, part) in known.iter().zip(parts.iter_mut()) {
                let share = inner_product(direction, column);
                *part += share;
                column.iter_mut().zip(direction).for_each(|(v, d)| *v -= share * d);
            }
            if norm(column) > 0.5 * before {
                break;
            }
        }
        let mut left = norm(column);
        while left <= DEPENDENT * length && count > 0 {
            count -= 1;
            column.iter_mut().zip(&known[count]).for_each(|(v, d)| *v += parts[count] * d);
            left = norm(column);
        }
        if left == 0.0 {
            *used = 0;
            return;
        }
        column.iter_mut().for_each(|v| *v /= left);
        orthonormal.swap(count, *used);

        for row in 0..count {
            triangle.copy_within(row * depth + row..row * depth + count, row * depth + row + 1);
            triangle[row * depth] = weights[row];
        }
        triangle[count * depth..count * depth + count + 1].fill(0.0);
        triangle[count * depth] = left;
        for row in (0..count).rev() {
            let (upper, lower) = triangle.split_at_mut((row + 1) * depth);
            let upper = &mut upper[row * depth..];
            // behind the new column the lower row begins one place further
            lower[row + 1] = 0.0;
            let length = upper[0].hypot(lower[0]);
            let (cosine, sine) = (upper[0] / length, lower[0] / length);
            (upper[0], lower[0]) = (length, 0.0);
            rotate(&mut upper[row + 1..=count], &mut lower[row + 1..=count], cosine, sine);
            let (before, after) = orthonormal.split_at_mut(row + 1);
            rotate(&mut before[row], &mut after[0], cosine, sine);
        }
        *used = count + 1;
    }

    /// γ by substitution; a column that adds nothing to newer ones gets no weight.
    fn least_squares(&mut self, residual: &[f64]) {
        let (used, depth) = (self.used, self.depth);
        for j in (0..used).rev() {
            let column = (0..j).map(|row| self.triangle[row * depth + j].powi(2)).sum::<f64>();
            let diagonal = self.triangle[j * depth + j];
            let mut right = inner_product(&self.orthonormal[j], residual);
            for k in j + 1..used {
                right -= self.triangle[j * depth + k] * self.weights[k];
            }
            let counts = diagonal.abs() > DEPENDENT * column.sqrt();
            self.weights[j] = if counts { right / diagonal } else { 0.0 };
        }
    }
}

/// (a, b) to (c a + s b, c b − s a).
fn rotate(a: &mut [f64], b: &mut [f64], cosine: f64, sine: f64) {
    for (a, b) in a.iter_mut().zip(b) {
        (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
    }
}

fn norm(a: &[f64]) -> f64 {
    inner_product(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear map with eigenvalues up to 0.999: in exact arithmetic Anderson needs as many steps as there are.
    #[test]
    fn a_linear_map_of_six_eigenvalues_is_solved_in_seven_steps() {
        let rates = [0.999, 0.9, 0.5, -0.3, 0.1, -0.9];
        let mut anderson = Anderson::new(6, 10);
        let mut x = vec![0.0; 6];
        for _ in 0..7 {
            let mut image: Vec<f64> = x.iter().zip(&rates).map(|(x, rate)| 1.0 + rate * x).collect();
            anderson.mix(&x, &mut image);
            x = image;
        }
        for (x, rate) in x.iter().zip(&rates) {
            let exact = 1.0 / (1.0 - rate);
            assert!((x - exact).abs() < 1e-8 * exact, "{x} instead of {exact}");
        }
    }

    proptest::proptest! {
        #![proptest_config(proptest::prelude::ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..proptest::prelude::ProptestConfig::default()
        })]

        /// Whatever the contraction, the mixed iterate is never farther from the fixed point than plain iteration gets
        /// in as many steps, and stays there: the same map, its fixed point as start.
        #[test]
        fn a_contraction_ends_at_its_fixed_point(
            rates in proptest::collection::vec(-0.95..0.95_f64, 8),
            shifts in proptest::collection::vec(-1.0..1.0_f64, 8),
        ) {
            let mut anderson = Anderson::new(8, 5);
            let map = |x: &[f64]| -> Vec<f64> {
                (0..8).map(|i| shifts[i] + rates[i] * x[i]).collect()
            };
            let distance = |x: &[f64]| -> f64 {
                (0..8).map(|i| (x[i] - shifts[i] / (1.0 - rates[i])).abs()).fold(0.0, f64::max)
            };
            let mut x = vec![0.0; 8];
            for _ in 0..120 {
                let mut image = map(&x);
                anderson.mix(&x, &mut image);
                x = image;
            }
            proptest::prop_assert!(distance(&x) < 1e-6, "{x:?}");
            let before = x.clone();
            let mut image = map(&x);
            anderson.mix(&before, &mut image);
            proptest::prop_assert!(distance(&image) < 1e-5, "{image:?}");
        }
    }
}
