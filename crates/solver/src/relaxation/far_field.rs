//! What lies beyond the ends of the grid: the inlet film ahead of x_max, the cavity behind x_min.
//!
//! The paper sets p = 0 at x_max and leaves out what is beyond. That is an error that no refinement removes (0.3 % of
//! the load at β = 10 on the automatic domain). Here the film ahead is integrated to infinity: u follows from (T3) with
//! the displacement of the pressure on the grid, p′ from (T2), both explicit.

use std::f64::consts::PI;

use super::Grid;
use super::inner_product::inner_product;
use crate::model::{DisplacementKernel, gauss, retarded_mode};

/// Points beyond one end of the grid, with quadrature weights for the integral from there to infinity.
pub struct FarField {
    /// Where, one point per quadrature node.
    pub x: Vec<f64>,
    /// Weights of ∫ dx.
    pub weight: Vec<f64>,
    /// Displacement at each x for unit pressure at each grid point but the last; row-major, x.len() × (n − 1).
    influence: Vec<f64>,
    /// The end of the grid seen from each x.
    end: Vec<EndColumn>,
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
        let mut influence = Vec::with_capacity(x.len() * last);
        for &x in &x {
            influence.extend((0..last).map(|k| dx / PI * kernel.cell_average(x - grid.x(k), dx)));
        }
        let end = x.iter().map(|&x| EndColumn::new(kernel, grid, x)).collect();
        Self { x, weight, influence, end }
    }

    /// Displacement at `x[q]` of the pressure `p` on the grid and of the load ahead of it.
    pub fn displacement(&self, q: usize, p: &[f64], tail_load: f64) -> f64 {
        let (inside, last) = p.split_at(p.len() - 1);
        let row = &self.influence[q * inside.len()..(q + 1) * inside.len()];
        inner_product(row, inside) + self.end[q].displacement(last[0], tail_load)
    }
}

/// What the end of the grid adds to the displacement at one x: half a cell at the last point, and the tail ahead of it.
///
/// The tail is p(s) = a (X/s)³ + b (X/s)⁵ for s > X = x_max, the first two powers of its expansion, with the pressure
/// p_X = a + b at X and the load L = X (a/2 + b/4) that the inlet film has.
#[derive(Clone, Copy, Debug)]
pub struct EndColumn {
    /// Displacement for p_X = 1.
    pressure: f64,
    /// Displacement for L = 1.
    load: f64,
}

impl EndColumn {
    /// The end of a grid seen from x.
    pub fn new(kernel: &DisplacementKernel, grid: &Grid, x: f64) -> Self {
        let (end, half) = (grid.x_max, 0.5 * grid.spacing());
        let half_cell = half * kernel.cell_average(x - (end - 0.5 * half), half);
        let (cubic, quintic) = (tail(kernel, x, end, 3), tail(kernel, x, end, 5));
        Self {
            // a = 4L/X − p_X, b = 2p_X − 4L/X
            pressure: (half_cell - cubic + 2.0 * quintic) / PI,
            load: 4.0 / end * (cubic - quintic) / PI,
        }
    }

    /// Its displacement for the pressure at the end of the grid and the load ahead of it.
    pub fn displacement(&self, pressure: f64, load: f64) -> f64 {
        pressure * self.pressure + load * self.load
    }
}

/// ∫_X^∞ (X/s)^k K(x − s) ds.
fn tail(kernel: &DisplacementKernel, x: f64, end: f64, power: i32) -> f64 {
    let retarded = kernel.retarded().iter();
    let modes: f64 = retarded.map(|&(weight, rate)| weight * retarded_tail(rate, x, end, power, 0)).sum();
    kernel.singular_weight() * log_tail(x, end, power) + modes - kernel.level() * end / f64::from(power - 1)
}

/// J_k = ∫_X^∞ (X/s)^k I(x − s) ds with the bounded I of [`retarded_mode`].
///
/// I varies on the scale 1/α. Where that is not small against X, quadrature in t = X/s does. Where it is, I is nearly
/// the logarithm, and integration by parts gives J_k = ∫ (X/s)^k ln|x − s| ds + [I(x − X) − (k/X) J_{k+1}]/α; three
/// times over, an error of the quadrature counts no more.
fn retarded_tail(rate: f64, x: f64, end: f64, power: i32, depth: usize) -> f64 {
    const SMOOTH: f64 = 8.0;
    if depth == 3 || rate * end < SMOOTH {
        let value = |t: f64| t.powi(power - 2) * retarded_mode(rate, x - end / t);
        return end * gauss::mean(0.0, 1.0, value);
    }
    let next = retarded_tail(rate, x, end, power + 1, depth + 1);
    log_tail(x, end, power) + (retarded_mode(rate, x - end) - f64::from(power) / end * next) / rate
}

/// ∫_X^∞ (X/s)^k ln|x − s| ds = X/(k−1) (ln|X − x| + j_{k−1}), where j_m = X^m ∫_X^∞ s^{−m}/(s − x) ds follows from
/// j_m = (j_{m−1} − 1/(m−1))/r, j_1 = −ln|1 − r|/r with r = x/X, or for small r from Σ_i r^i/(m + i).
fn log_tail(x: f64, end: f64, power: i32) -> f64 {
    let r = x / end;
    let sum = if r.abs() < 0.3 {
        let terms = (0..40).map(|i| r.powi(i) / f64::from(power - 1 + i));
        (1.0 - r).ln() + terms.sum::<f64>()
    } else {
        // ln|1 − r| (1 − r^{−m}), finite at r = 1, and the rest of the recurrence
        let log = if r == 1.0 { 0.0 } else { (1.0 - r).abs().ln() * (1.0 - r.powi(1 - power)) };
        let rest = (1..power - 1).fold(0.0, |rest, m| (rest - 1.0 / f64::from(m)) / r);
        log + rest
    };
    end / f64::from(power - 1) * (end.ln() + sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same integral in t = X/s, by panels that shrink towards the singularity t = X/x.
    #[test]
    fn the_closed_form_of_the_tail_is_its_integral() {
        let end = 4.0;
        for power in [3, 5] {
            for x in [-30.0, -2.0, -1.0, 0.0, 0.4, 1.1, 1.3, 3.0, 3.99, 4.0, 4.01, 9.0, 60.0] {
                let integrand = |t: f64| t.powi(power - 2) * (x - end / t).abs().max(f64::MIN_POSITIVE).ln();
                let shrinking = |from: f64, to: f64| -> f64 {
                    let panel = |i| {
                        let width = (to - from) * 0.5_f64.powi(i + 1);
                        width * gauss::mean(to - 2.0 * width, to - width, integrand)
                    };
                    (0..45).map(panel).sum()
                };
                let singular = f64::clamp(end / f64::max(x, 1e-9), 0.0, 1.0);
                let behind = shrinking(0.5 * singular, singular) - shrinking(0.5 * singular, 0.0);
                let ahead = 0.5 * (1.0 + singular);
                let rest = if singular < 1.0 { shrinking(ahead, 1.0) - shrinking(ahead, singular) } else { 0.0 };
                let error = (log_tail(x, end, power) - end * (behind + rest)).abs();
                assert!(error < 1e-11, "power {power}, x {x}: error {error:e}");
            }
        }
    }
}
