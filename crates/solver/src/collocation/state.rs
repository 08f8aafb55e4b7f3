//! The unknowns of the method.

use std::sync::Arc;

use super::mesh::Mesh;

/// A solution, or a guess at one.
#[derive(Clone, Debug)]
pub struct State {
    /// The panels it lives on.
    pub mesh: Arc<Mesh>,
    /// p at the nodes; 0 at the first, the outlet.
    pub pressure: Vec<f64>,
    /// u at the Gauss points of the film.
    pub film: Vec<f64>,
    /// c, the film where p′ = 0, and at the outlet.
    pub c: f64,
    /// x_out.
    pub outlet: f64,
    /// The estimated error over the tolerance, once it is known: it tells how the next mesh should be.
    pub error: Option<f64>,
    /// The longest first panel that the next mesh may have, over the length of the layer at the outlet.
    pub outlet_panel: f64,
}

/// Rounding error of the film (T12), whose terms are of order 1.
const ROUNDING: f64 = 2e-15;

impl State {
    /// The rounding error of the film over the thinnest film.
    pub fn rounding(&self) -> f64 {
        ROUNDING / self.film.iter().fold(self.c, |least, &u| least.min(u))
    }
}
