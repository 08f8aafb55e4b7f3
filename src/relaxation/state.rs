//! A solution, or a guess at one, on the uniform grid.

use super::Grid;
use super::iteration::{Discretisation, index_of_largest};

/// The unknowns of the relaxation method.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// p at the n points of the grid.
    pub pressure: Vec<f64>,
    /// h₀ (T3).
    pub separation: f64,
    /// Load of the film ahead of the grid.
    pub tail_load: f64,
    /// Film thickness at the largest pressure.
    pub c: f64,
}

impl State {
    /// A guess: a pressure, and the h₀ that makes the film c thick under its largest value.
    pub fn resting(shared: &Discretisation, pressure: Vec<f64>, c: f64) -> Self {
        let mut displacement = vec![0.0; pressure.len()];
        shared.deformation.displace(&pressure, &mut displacement, &mut shared.deformation.space());
        let peak = index_of_largest(&pressure);
        let x = shared.grid.x(peak);
        Self { separation: c - 0.5 * x * x + displacement[peak], pressure, tail_load: 0.0, c }
    }

    /// The same on another grid.
    pub fn on(&self, from: &Grid, to: &Discretisation) -> Self {
        let pressure = (0..to.grid.points).map(|i| from.interpolate(&self.pressure, to.grid.x(i))).collect();
        Self { tail_load: self.tail_load, ..Self::resting(to, pressure, self.c) }
    }
}
