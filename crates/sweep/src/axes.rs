//! The axes of a sweep.

use crate::grid_index::{indices, place};
use crate::{Dimension, GridIndex, GridShape};
use stribeck_lab::{Experiment, LaboratoryQuantity, Modulus, Motion, Roller, Temperature, TemperatureLaws};
use stribeck_solver::Substrate;

/// The axes of a dimensionless sweep: each strictly ascending and not empty.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Slide-to-roll ratios S from −1 to 1 (T52); none for a roller that slides without turning, S = 1.
    pub slide_roll: Option<Vec<f64>>,
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
        self.slide_roll.as_ref().map_or(1, Vec::len) * self.f.len() * self.alpha.len() * self.beta.len()
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
    /// What the roller is made of.
    pub roller: Roller,
    /// The retardation spectrum of the roller; it counts where the roller has an f.
    pub roller_spectrum: Substrate,
    /// True if each case with a slide-to-roll ratio is there with the opposite one as well, and their friction is
    /// averaged: an instrument that swaps the faster body.
    pub swap: bool,
    /// Where the model ends.
    pub limits: ModelLimits,
    /// What changes with temperature, where that is given.
    pub laws: TemperatureLaws,
}

/// What the surfaces and the layer allow, as far as it is given (m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModelLimits {
    /// Combined r.m.s. roughness of both surfaces.
    pub roughness: Option<f64>,
    /// Thickness of the soft layer.
    pub thickness: Option<f64>,
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
        GridShape { blocks: self.f.len(), rows, length: self.speed().values.len() }
    }

    fn temperature_is_given(&self) -> bool {
        self.given.iter().any(|given| given.quantity == LaboratoryQuantity::Temperature)
    }

    /// All that is given but the last speed.
    fn others(&self) -> &[Given] {
        &self.given[..self.given.len() - 1]
    }

    /// Numbers of values of these.
    fn lengths(&self) -> impl DoubleEndedIterator<Item = usize> {
        self.others().iter().map(|given| given.values.len())
    }

    /// The place with the opposite slide-to-roll ratio; none where bodies are not swapped.
    pub fn swapped(&self, index: GridIndex) -> Option<GridIndex> {
        let is_ratio = |given: &Given| given.quantity == LaboratoryQuantity::SlideRollRatio;
        let at = self.others().iter().position(is_ratio).filter(|_| self.swap)?;
        let mut on_axes = indices(self.lengths(), index.row);
        // The ratios are as many below 0 as above it.
        on_axes[at] = self.given[at].values.len() - 1 - on_axes[at];
        Some(GridIndex { row: place(self.lengths(), &on_axes), ..index })
    }

    /// The dimensions of the results: f, the axes between f and the speed in their order, and the speed.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let of = |given: &Given| {
            let quantity = given.quantity;
            let long_name =
                if self.temperature_is_given() { self.laws.long_name(quantity) } else { quantity.long_name() };
            Dimension::new(quantity.name(), quantity.units(), long_name, &given.values)
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
            f: self.f[index.block],
            roller: self.roller,
            temperature: self.temperature_is_given().then_some(Temperature { value: f64::NAN, laws: self.laws }),
        };
        for (given, place) in self.others().iter().zip(indices(self.lengths(), index.row)) {
            experiment.set(given.quantity, given.values[place]);
        }
        experiment.set(self.speed().quantity, self.speed().values[index.along]);
        experiment
    }
}
