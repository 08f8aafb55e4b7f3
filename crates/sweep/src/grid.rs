//! The places of a sweep: products of axes, dimensionless or of the laboratory.

use crate::{Axes, Dimension, GridIndex, GridShape, LaboratoryAxes};
use stribeck_lab::Experiment;
use stribeck_solver::{Parameters, Substrate};

/// The grid of a sweep.
///
/// Rows run along β, or along the speed where quantities of the laboratory are given.
#[derive(Clone, Debug, PartialEq)]
pub enum Grid {
    /// Over f, α and β.
    Dimensionless(Axes),
    /// Over f and quantities of the laboratory.
    Laboratory(LaboratoryAxes),
}

impl From<Axes> for Grid {
    fn from(axes: Axes) -> Self {
        Grid::Dimensionless(axes)
    }
}

impl Grid {
    /// The axes of a dimensionless sweep.
    pub fn axes(&self) -> Option<&Axes> {
        match self {
            Grid::Dimensionless(axes) => Some(axes),
            Grid::Laboratory(_) => None,
        }
    }

    /// The lengths of the grid.
    pub fn shape(&self) -> GridShape {
        match self {
            Grid::Dimensionless(Axes { f, alpha, beta }) => {
                GridShape { strengths: f.len(), rows: alpha.len(), length: beta.len() }
            }
            Grid::Laboratory(axes) => axes.shape(),
        }
    }

    /// Number of places.
    pub fn cases(&self) -> usize {
        self.shape().places()
    }

    /// The dimensions of published results, the one along rows last.
    pub fn dimensions(&self) -> Vec<Dimension> {
        match self {
            Grid::Dimensionless(axes) => {
                vec![Dimension::strength(&axes.f), Dimension::alpha(&axes.alpha), Dimension::beta(&axes.beta)]
            }
            Grid::Laboratory(axes) => axes.dimensions(),
        }
    }

    /// f, α and β of a place.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn numbers(&self, index: GridIndex) -> [f64; 3] {
        match self {
            Grid::Dimensionless(axes) => [axes.f[index.f], axes.alpha[index.row], axes.beta[index.along]],
            Grid::Laboratory(axes) => {
                let experiment = axes.experiment(index);
                [experiment.f, experiment.alpha(), experiment.beta()]
            }
        }
    }

    /// The problem at a place, for a substrate.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn parameters(&self, index: GridIndex, substrate: &Substrate) -> Parameters {
        let [f, alpha, beta] = self.numbers(index);
        Parameters { alpha, beta, f, substrate: substrate.clone() }
    }

    /// The experiment at a place, where quantities of the laboratory are given.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn experiment(&self, index: GridIndex) -> Option<Experiment> {
        match self {
            Grid::Dimensionless(_) => None,
            Grid::Laboratory(axes) => Some(axes.experiment(index)),
        }
    }
}
