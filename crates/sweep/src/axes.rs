//! The axes of a sweep.

use crate::grid_index::indices;
use crate::{Dimension, GridIndex, GridShape};
use stribeck_lab::{Experiment, LaboratoryQuantity, Modulus, Motion};

/// The axes of a dimensionless sweep: each strictly ascending and not empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Strengths of retardation, finite and at least 0.
    pub f: Vec<f64>,
    /// Ratios of slide to retardation time, at least 0; the last may be +∞.
    pub alpha: Vec<f64>,
    /// Inverse Hersey numbers, finite and above 0.
    pub beta: Vec<f64>,
}

impl Axes {
    /// The number of places.
    pub fn cases(&self) -> usize {
        self.f.len() * self.alpha.len() * self.beta.len()
    }
}

/// A quantity with its values: one number, or an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// The quantity.
    pub quantity: LaboratoryQuantity,
    /// Its values, ascending and not empty.
    pub values: Vec<f64>,
    /// True if it is a dimension of the results, be it of one value.
    pub is_axis: bool,
}

/// Quantities of the laboratory, each a number or an axis. The product of the axes and of f is the sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct LaboratoryAxes {
    /// Strengths of retardation, ascending.
    pub f: Vec<f64>,
    /// One modulus, the speeds of one form of motion and all other quantities, in the order of
    /// [`LaboratoryQuantity::ALL`]: a speed is the last, and always an axis.
    pub given: Vec<Given>,
}

impl LaboratoryAxes {
    /// The axes between f and the speed, the last one fastest.
    fn between(&self) -> impl DoubleEndedIterator<Item = &Given> {
        self.given[..self.given.len() - 1].iter().filter(|given| given.is_axis)
    }

    fn speed(&self) -> &Given {
        self.given.last().expect("the speed is given")
    }

    /// True if the roller may turn: its speed is given beside that of the flat.
    pub fn rolls(&self) -> bool {
        self.speed().quantity != LaboratoryQuantity::Speed
    }

    /// The lengths of the grid.
    pub fn shape(&self) -> GridShape {
        let rows = self.between().map(|given| given.values.len()).product();
        GridShape { strengths: self.f.len(), rows, length: self.speed().values.len() }
    }

    /// The dimensions of the results: f, the axes between f and the speed in their order, and the speed.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let of = |given: &Given| {
            let quantity = given.quantity;
            Dimension::new(quantity.name(), quantity.units(), quantity.long_name(), &given.values)
        };
        let strength = Dimension::strength(&self.f);
        std::iter::once(strength).chain(self.between().chain([self.speed()]).map(of)).collect()
    }

    /// The experiment at a place.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn experiment(&self, index: GridIndex) -> Experiment {
        let mut experiment = Experiment {
            radius: f64::NAN,
            load: f64::NAN,
            modulus: Modulus::Relaxed(f64::NAN),
            poisson_ratio: f64::NAN,
            viscosity: f64::NAN,
            retardation_time: f64::NAN,
            motion: Motion::Sliding { speed: f64::NAN },
            f: self.f[index.f],
        };
        let others = &self.given[..self.given.len() - 1];
        let lengths = others.iter().map(|given| given.values.len());
        for (given, place) in others.iter().zip(indices(lengths, index.row)) {
            experiment.set(given.quantity, given.values[place]);
        }
        experiment.set(self.speed().quantity, self.speed().values[index.along]);
        experiment
    }
}
