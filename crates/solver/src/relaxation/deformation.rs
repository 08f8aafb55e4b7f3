//! Surface displacement on the uniform grid by FFT convolution with the exact cell averages of the kernel.

use std::f64::consts::PI;
use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::Grid;
use super::far_field::EndColumn;
use crate::model::DisplacementKernel;

/// w_i = Σ_k χ_{i−k} p_k (Eq. 41 with the cell average of the kernel in place of its infinite point value).
///
/// The pressure is constant over the cell around each point, half a cell at the last, beyond which comes the tail of
/// [`EndColumn`]. Once per (α, f) and grid.
pub struct Deformation {
    points: usize,
    /// Transform of χ_m, m = −(n−2) … n−1, wrapped around: the last pressure has its own column.
    transfer: Vec<Complex<f64>>,
    /// The end of the grid seen from each point.
    end: Vec<EndColumn>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

/// Space to compute a displacement in; one per thread.
pub struct DeformationSpace {
    padded: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    forward: Vec<Complex<f64>>,
    inverse: Vec<Complex<f64>>,
}

impl Deformation {
    /// The displacement operator of a kernel on a grid.
    pub fn new(kernel: &DisplacementKernel, grid: &Grid) -> Self {
        let (n, dx) = (grid.points, grid.spacing());
        let length = transform_length(2 * n - 2);
        let mut planner = RealFftPlanner::new();
        let (forward, inverse) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));

        let mut influence = vec![0.0; length];
        for m in 0..n {
            let x = m as f64 * dx;
            influence[m] = kernel.cell_average(x, dx);
            if m > 0 && m < n - 1 {
                influence[length - m] = kernel.cell_average(-x, dx);
            }
        }
        // the transform pair of realfft multiplies by its length
        let scale = dx / PI / length as f64;
        influence.iter_mut().for_each(|value| *value *= scale);
        let mut transfer = forward.make_output_vec();
        forward.process(&mut influence, &mut transfer).expect("lengths fit by construction");

        let end = (0..n).map(|i| EndColumn::new(kernel, grid, grid.x(i))).collect();
        Self { points: n, transfer, end, forward, inverse }
    }

    /// Space for [`Deformation::displace`].
    pub fn space(&self) -> DeformationSpace {
        DeformationSpace {
            padded: self.forward.make_input_vec(),
            spectrum: self.forward.make_output_vec(),
            forward: self.forward.make_scratch_vec(),
            inverse: self.inverse.make_scratch_vec(),
        }
    }

    /// Displacement `w` (n values) of the pressure `p` (n values) and of the load ahead of the grid.
    pub fn displace(&self, p: &[f64], tail_load: f64, w: &mut [f64], space: &mut DeformationSpace) {
        self.convolve(p, space);
        self.assemble(p[self.points - 1], tail_load, w, space);
    }

    /// The part of the displacement that the pressure `p` but for its last value makes; it stays in `space`.
    pub fn convolve(&self, p: &[f64], space: &mut DeformationSpace) {
        let last = self.points - 1;
        assert_eq!(p.len(), self.points);
        space.padded[..last].copy_from_slice(&p[..last]);
        space.padded[last..].fill(0.0);
        let lengths = "lengths fit by construction";
        self.forward.process_with_scratch(&mut space.padded, &mut space.spectrum, &mut space.forward).expect(lengths);
        space.spectrum.iter_mut().zip(&self.transfer).for_each(|(value, factor)| *value *= factor);
        // real signals: exactly zero already, unless the pressure overflowed, which shows in w
        let nyquist = space.spectrum.len() - 1;
        space.spectrum[0].im = 0.0;
        space.spectrum[nyquist].im = 0.0;
        self.inverse.process_with_scratch(&mut space.spectrum, &mut space.padded, &mut space.inverse).expect(lengths);
    }

    /// Displacement `w` (n values) of what was convolved last, the last pressure, and the load ahead of the grid.
    pub fn assemble(&self, last_pressure: f64, tail_load: f64, w: &mut [f64], space: &DeformationSpace) {
        assert_eq!(w.len(), self.points);
        for ((w, convolution), end) in w.iter_mut().zip(&space.padded).zip(&self.end) {
            *w = convolution + end.displacement(last_pressure, tail_load);
        }
    }
}

/// The smallest even 2^a 3^b 5^c that is not below `least`: transforms of such lengths are fast.
fn transform_length(least: usize) -> usize {
    let is_smooth = |length: &usize| {
        let rest = [2, 3, 5].into_iter().fold(*length, |mut rest, prime| {
            while rest % prime == 0 {
                rest /= prime;
            }
            rest
        });
        rest == 1
    };
    let mut lengths = (least.next_multiple_of(2)..).step_by(2);
    lengths.find(is_smooth).expect("powers of two are among them")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Parameters, gauss};

    const END: f64 = 4.0;

    /// (1 − x²)² and the load of a film ahead.
    fn smooth(grid: &Grid) -> (Vec<f64>, f64) {
        let bump = |x: f64| (1.0 - x * x).max(0.0).powi(2);
        let mut p: Vec<f64> = (0..grid.points).map(|i| bump(grid.x(i))).collect();
        p[grid.points - 1] = 0.01;
        (p, 0.02)
    }

    #[test]
    fn the_transform_is_the_sum_over_the_cells() {
        for (alpha, f) in [(1.0, 0.0), (0.0, 3.0), (1e-3, 10.0), (1.0, 1.0), (50.0, 100.0), (1e6, 1e3)] {
            for points in [64, 201] {
                let kernel = DisplacementKernel::new(&Parameters::new(alpha, 1.0, f));
                let grid = Grid { x_min: -3.0, x_max: END, points };
                let deformation = Deformation::new(&kernel, &grid);
                let (p, tail_load) = smooth(&grid);
                let mut w = vec![0.0; points];
                deformation.displace(&p, tail_load, &mut w, &mut deformation.space());
                let (dx, last) = (grid.spacing(), points - 1);
                for (i, w) in w.iter().enumerate() {
                    let cells = (0..last).map(|k| p[k] * kernel.cell_average(grid.x(i) - grid.x(k), dx));
                    let end = EndColumn::new(&kernel, &grid, grid.x(i)).displacement(p[last], tail_load);
                    let sum = dx / PI * cells.sum::<f64>() + end;
                    assert!((w - sum).abs() < 1e-12 * (1.0 + sum.abs()), "α {alpha}, f {f}, point {i}: {w} and {sum}");
                }
            }
        }
    }

    /// e(x) = (1/π) ∫ (1 − s²)² ln|x − s| ds (T7), by panels that shrink towards s = x.
    fn elastic(x: f64) -> f64 {
        let integrand = |s: f64| (1.0 - s * s).powi(2) * (x - s).abs().ln();
        let from = |singular: f64, end: f64| -> f64 {
            let panel = |i| {
                let far = (end - singular) * 0.5_f64.powi(i);
                0.5 * far * gauss::mean(singular + 0.5 * far, singular + far, integrand)
            };
            (0..36).map(panel).sum()
        };
        let singular = x.clamp(-1.0, 1.0);
        (from(singular, 1.0) - from(singular, -1.0)) / PI
    }

    /// v(x) = ∫_0^∞ e^{−ξ} e(x + ξ/α) dξ (T8), by panels of half a unit.
    fn retarded(alpha: f64, x: f64) -> f64 {
        let panel = |i: i32| {
            let start = 0.5 * f64::from(i);
            0.5 * gauss::mean(start, start + 0.5, |xi| (-xi).exp() * elastic(x + xi / alpha))
        };
        (0..80).map(panel).sum()
    }

    /// Kernel (T10) and filter (T8) are two ways to the same displacement (T9). Cells of constant pressure are of
    /// second order: a quarter of the error on half the cells.
    #[test]
    fn kernel_and_filter_agree_for_a_smooth_pressure() {
        for (alpha, f) in [(0.3, 1.0), (2.0, 10.0), (20.0, 3.0)] {
            let kernel = DisplacementKernel::new(&Parameters::new(alpha, 1.0, f));
            let places = [0, 2, 5, 8, 11, 13, 16].map(|k| -2.0 + 0.25 * f64::from(k));
            let exact = places.map(|x| (elastic(x) + f * retarded(alpha, x)) / (1.0 + f));
            let errors = [141, 281].map(|points| {
                let grid = Grid { x_min: -3.0, x_max: END, points };
                let deformation = Deformation::new(&kernel, &grid);
                let mut p = smooth(&grid).0;
                p[points - 1] = 0.0;
                let mut w = vec![0.0; points];
                deformation.displace(&p, 0.0, &mut w, &mut deformation.space());
                let pairs = places.iter().zip(exact);
                pairs.map(|(&x, exact)| (grid.cubic(&w, x) - exact).abs()).fold(0.0, f64::max)
            });
            assert!(errors[0] < 1e-3 && errors[1] < 0.3 * errors[0], "α {alpha}, f {f}: {errors:?}");
        }
    }
}
