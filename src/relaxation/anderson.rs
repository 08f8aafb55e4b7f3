//! Anderson acceleration of a fixed-point map (Walker and Ni, SIAM J. Numer. Anal. 49, 1715, 2011; type II).

use super::inner_product::inner_product;

/// The last iterates of a map g: differences of x and of the residual g(x) − x, both of `size` numbers.
pub struct Anderson {
    size: usize,
    depth: usize,
    /// Differences Δx + Δr, newest last; `used` of them count.
    steps: Vec<Vec<f64>>,
    /// Differences Δr, newest last.
    residuals: Vec<Vec<f64>>,
    used: usize,
    previous: Option<Previous>,
    orthonormal: Vec<Vec<f64>>,
    triangle: Vec<f64>,
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
            residuals: columns(),
            used: 0,
            previous: None,
            orthonormal: columns(),
            triangle: vec![0.0; depth * depth],
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
        let previous = self.previous.get_or_insert_with(|| Previous { image: Vec::new(), residual: Vec::new() });
        if previous.image.is_empty() {
            previous.image = image.to_vec();
            previous.residual = image.iter().zip(x).map(|(g, x)| g - x).collect();
            return;
        }
        if self.used == self.depth {
            self.steps.rotate_left(1);
            self.residuals.rotate_left(1);
        } else {
            self.used += 1;
        }
        let newest = self.used - 1;
        for i in 0..self.size {
            let residual = image[i] - x[i];
            // Δx + Δr is the difference of the images
            self.steps[newest][i] = image[i] - previous.image[i];
            self.residuals[newest][i] = residual - previous.residual[i];
            previous.image[i] = image[i];
            previous.residual[i] = residual;
        }
        self.least_squares();
        for (step, weight) in self.steps[..self.used].iter().zip(&self.weights) {
            for (image, step) in image.iter_mut().zip(step) {
                *image -= weight * step;
            }
        }
    }

    /// γ by Gram–Schmidt from the newest column back; a column that adds nothing new gets no weight.
    fn least_squares(&mut self) {
        const DEPENDENT: f64 = 1e-10;
        let (used, depth) = (self.used, self.depth);
        let residual = &self.previous.as_ref().expect("a step was made").residual;
        for j in 0..used {
            let column = used - 1 - j;
            let (done, rest) = self.orthonormal.split_at_mut(j);
            let vector = &mut rest[0];
            vector.copy_from_slice(&self.residuals[column]);
            let length = norm(vector);
            for (k, direction) in done.iter().enumerate() {
                let part = inner_product(direction, vector);
                self.triangle[k * depth + j] = part;
                vector.iter_mut().zip(direction).for_each(|(v, d)| *v -= part * d);
            }
            let left = norm(vector);
            if left > DEPENDENT * length {
                vector.iter_mut().for_each(|v| *v /= left);
                self.triangle[j * depth + j] = left;
            } else {
                vector.fill(0.0);
                self.triangle[j * depth + j] = 0.0;
            }
        }
        for j in (0..used).rev() {
            let diagonal = self.triangle[j * depth + j];
            let mut right = inner_product(&self.orthonormal[j], residual);
            for k in j + 1..used {
                right -= self.triangle[j * depth + k] * self.weights[used - 1 - k];
            }
            self.weights[used - 1 - j] = if diagonal > 0.0 { right / diagonal } else { 0.0 };
        }
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
        /// Whatever the contraction, the mixed iterate is never farther from the fixed point than plain iteration gets in as
        /// many steps, and stays there: the same map, its fixed point as start.
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
            for _ in 0..60 {
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
