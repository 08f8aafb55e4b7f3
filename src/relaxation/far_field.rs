//! What lies beyond the ends of the grid: the inlet film ahead of x_max, the cavity behind x_min.
//!
//! The paper sets p = 0 at x_max and leaves out what is beyond. That is an error that no refinement removes (0.3 % of
//! the load at β = 10 on the automatic domain). Here the film ahead is integrated to infinity: u follows from (T3) with
//! the displacement of the pressure on the grid, p′ from (T2), both explicit.

use std::f64::consts::PI;

use super::Grid;
use crate::model::{DisplacementKernel, gauss};

/// Points beyond one end of the grid, with quadrature weights for the integral from there to infinity.
pub struct FarField {
    /// Where, one point per quadrature node.
    pub x: Vec<f64>,
    /// Weights of ∫ dx.
    pub weight: Vec<f64>,
    /// Displacement at each x for unit pressure at each grid point; row-major, x.len() × grid points.
    influence: Vec<f64>,
}

impl FarField {
    /// Ahead of the grid, x = x_max/t for 0 < t < 1.
    pub fn ahead(kernel: &DisplacementKernel, grid: &Grid) -> Self {
        let nodes = gauss::unit_interval().map(|(t, weight)| (grid.x_max / t, weight * grid.x_max / (t * t)));
        Self::at(kernel, grid, nodes)
    }

    /// Behind the grid, x = x_min − (x_max − x_min)(1/t − 1) for 0 < t < 1.
    pub fn behind(kernel: &DisplacementKernel, grid: &Grid) -> Self {
        let length = grid.x_max - grid.x_min;
        let nodes = gauss::unit_interval()
            .map(|(t, weight)| (grid.x_min - length * (1.0 / t - 1.0), weight * length / (t * t)));
        Self::at(kernel, grid, nodes)
    }

    /// At any points, with weight zero: to evaluate fields beyond the grid.
    pub fn points(kernel: &DisplacementKernel, grid: &Grid, x: impl Iterator<Item = f64>) -> Self {
        Self::at(kernel, grid, x.map(|x| (x, 0.0)))
    }

    fn at(kernel: &DisplacementKernel, grid: &Grid, nodes: impl Iterator<Item = (f64, f64)>) -> Self {
        let (x, weight): (Vec<f64>, Vec<f64>) = nodes.unzip();
        let (dx, last) = (grid.spacing(), grid.points - 1);
        let mut influence = Vec::with_capacity(x.len() * grid.points);
        for &x in &x {
            influence.extend((0..last).map(|k| dx / PI * kernel.cell_average(x - grid.x(k), dx)));
            influence.push(last_column(kernel, grid, x));
        }
        Self { x, weight, influence }
    }

    /// Displacement at `x[q]` of the pressure `p` on the grid.
    pub fn displacement(&self, q: usize, p: &[f64]) -> f64 {
        let row = &self.influence[q * p.len()..(q + 1) * p.len()];
        row.iter().zip(p).map(|(influence, p)| influence * p).sum()
    }
}

/// Displacement at x for unit pressure at the last grid point, which stands for half a cell and for the tail
/// p = (X/s)³ of the pressure at s > X = x_max.
///
/// ∫_X^∞ (X/s)³ K(x − s) ds has its logarithm in closed form; the bounded part of K is done by quadrature in t = X/s.
pub fn last_column(kernel: &DisplacementKernel, grid: &Grid, x: f64) -> f64 {
    let (end, half) = (grid.x_max, 0.5 * grid.spacing());
    let half_cell = half * kernel.cell_average(x - (end - 0.5 * half), half);
    let regular: f64 = gauss::unit_interval().map(|(t, weight)| weight * t * kernel.regular(x - end / t)).sum();
    (half_cell + kernel.singular_weight() * log_tail(x, end) + end * regular) / PI
}

/// ∫_X^∞ (X/s)³ ln|x − s| ds = ½X { ln X + ln|1 − r| (1 − 1/r²) − 1/r } with r = x/X, finite at r = 0 and r = 1.
fn log_tail(x: f64, end: f64) -> f64 {
    let r = x / end;
    let bracket = if r.abs() < 1e-2 {
        0.5 - r * (2.0 / 3.0) - r * r * 0.25 - r.powi(3) * (2.0 / 15.0) - r.powi(4) / 12.0 - r.powi(5) * (2.0 / 35.0)
    } else if r == 1.0 {
        -1.0
    } else {
        (1.0 - r).abs().ln() * (1.0 - 1.0 / (r * r)) - 1.0 / r
    };
    0.5 * end * (end.ln() + bracket)
}
