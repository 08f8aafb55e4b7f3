//! A solution, or a guess at one, on the uniform grid.

use super::Grid;
use super::iteration::{Discretisation, index_of_largest};

/// Smallest film of a guess over its c; u_min/c is between 0.74 and 1 in all solutions known.
const THINNEST: f64 = 0.7;

/// The unknowns of the relaxation method.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// p at the n points of the grid.
    pub pressure: Vec<f64>,
    /// h₀ (T3), but for the level of the kernel times load/π.
    pub separation: f64,
    /// Load of the film ahead of the grid.
    pub tail_load: f64,
    /// Film thickness at the largest pressure.
    pub c: f64,
}

impl State {
    /// A guess: a pressure, and the h₀ that makes the film c thick under its largest value, but nowhere thinner than a
    /// part of that: a pressure that does not fit its film would make it so thin that the iteration starts with a
    /// shock.
    pub fn resting(shared: &Discretisation, pressure: Vec<f64>, c: f64) -> Self {
        let mut displacement = vec![0.0; pressure.len()];
        // as if the pressure fell as x⁻³ ahead of the grid
        let tail_load = 0.5 * shared.grid.x_max * pressure[pressure.len() - 1];
        shared.deformation.displace(&pressure, tail_load, &mut displacement, &mut shared.deformation.space());
        let clearance = |i: usize| 0.5 * shared.grid.x(i).powi(2) - displacement[i];
        let lowest = (0..pressure.len()).map(clearance).fold(f64::INFINITY, f64::min);
        let separation = f64::max(c - clearance(index_of_largest(&pressure)), THINNEST * c - lowest);
        Self { separation, pressure, tail_load, c }
    }

    /// The same state on another grid.
    pub fn on(&self, from: &Grid, to: &Discretisation) -> Self {
        let pressure = (0..to.grid.points).map(|i| from.interpolate(&self.pressure, to.grid.x(i))).collect();
        Self::resting(to, pressure, self.c)
    }
}
