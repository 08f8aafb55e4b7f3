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
    /// Transform of χ_m, m = −(n−1) … n−1, wrapped around.
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
        let length = (2 * n).next_power_of_two();
        let mut planner = RealFftPlanner::new();
        let (forward, inverse) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));

        let mut influence = vec![0.0; length];
        for m in 0..n {
            let x = m as f64 * dx;
            influence[m] = kernel.cell_average(x, dx);
            if m > 0 {
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
        let last = self.points - 1;
        assert_eq!((p.len(), w.len()), (self.points, self.points));
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
        for ((w, convolution), end) in w.iter_mut().zip(&space.padded).zip(&self.end) {
            *w = convolution + end.displacement(p[last], tail_load);
        }
    }
}
