//! The places of a sweep: products of axes, dimensionless or of the laboratory.

use crate::{Axes, Dimension, GridIndex, GridShape, LaboratoryAxes};
use stribeck_lab::{Experiment, LaboratoryQuantity};
use stribeck_solver::{Parameters, RetardationMode, Substrate, SubstrateError};

/// The grid of a sweep.
///
/// Rows run along β, or along the speed where quantities of the laboratory are given.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a sweep has one grid")]
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

    /// The radius of the cylinder (m), where a sweep of the laboratory has one.
    pub fn radius(&self) -> Option<f64> {
        let Grid::Laboratory(axes) = self else { return None };
        let radius = axes.given.iter().find(|given| given.quantity == LaboratoryQuantity::Radius)?;
        if let [radius] = radius.values[..] { Some(radius) } else { None }
    }

    /// The lengths of the grid.
    pub fn shape(&self) -> GridShape {
        match self {
            Grid::Dimensionless(Axes { slide_roll, f, alpha, beta }) => {
                let ratios = slide_roll.as_ref().map_or(1, Vec::len);
                GridShape { blocks: ratios * f.len(), rows: alpha.len(), length: beta.len() }
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
                let ratio = axes.slide_roll.as_deref().map(Dimension::slide_roll);
                let others = [Dimension::strength(&axes.f), Dimension::alpha(&axes.alpha), Dimension::beta(&axes.beta)];
                ratio.into_iter().chain(others).collect()
            }
            Grid::Laboratory(axes) => axes.dimensions(),
        }
    }

    /// The slide-to-roll ratio S of a place (T52); 1 for a roller that slides without turning.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn slide_roll(&self, index: GridIndex) -> f64 {
        match self {
            Grid::Dimensionless(axes) => {
                axes.slide_roll.as_ref().map_or(1.0, |ratios| ratios[index.block / axes.f.len()])
            }
            Grid::Laboratory(axes) => axes.experiment(index).motion.slide_roll(),
        }
    }

    /// f, α and β of a place; f and α of the flat.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn numbers(&self, index: GridIndex) -> [f64; 3] {
        match self {
            Grid::Dimensionless(axes) => {
                [axes.f[index.block % axes.f.len()], axes.alpha[index.row], axes.beta[index.along]]
            }
            Grid::Laboratory(axes) => {
                let experiment = axes.experiment(index);
                [experiment.f, experiment.alpha(), experiment.beta()]
            }
        }
    }

    /// The problem at a place, for a substrate: that of the flat over quantities of the laboratory, else of both
    /// bodies, with the times of the roller over the one in α too.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn parameters(&self, index: GridIndex, substrate: &Substrate) -> Parameters {
        match self {
            Grid::Dimensionless(_) => Self::case_of(self.numbers(index), self.slide_roll(index), substrate)
                .expect("the modes were a substrate"),
            Grid::Laboratory(axes) => axes.experiment(index).parameters_of_both(substrate, &axes.roller_spectrum),
        }
    }

    /// The problem at f, α of the flat and β with a slide-to-roll ratio, for a substrate of both bodies: the surface
    /// of the roller moves at u₁/u₂ times the speed of the flat.
    ///
    /// # Errors
    /// As [`Parameters::of_two_bodies`], where times of the roller become none.
    pub fn case_of(
        [f, alpha, beta]: [f64; 3],
        slide_roll: f64,
        substrate: &Substrate,
    ) -> Result<Parameters, SubstrateError> {
        let of_roller = substrate.of_roller();
        if of_roller == 0 {
            return Ok(Parameters { alpha, beta, f, substrate: substrate.clone() });
        }
        let (flat, roller) = substrate.modes().split_at(substrate.modes().len() - of_roller);
        // u₁/u₂
        let slower = (1.0 - slide_roll) / (1.0 + slide_roll);
        let roller: Vec<_> = roller.iter().map(|mode| RetardationMode { time: mode.time * slower, ..*mode }).collect();
        Parameters::of_two_bodies([alpha, beta, f], flat, &roller)
    }

    /// With which power of the f given to [`Grid::case_of`] that of the case changes: below 1 where the roller is at
    /// rest and has relaxed, as its part of f is none of the case's.
    pub fn power_of_strength(f: f64, slide_roll: f64, substrate: &Substrate) -> f64 {
        let modes = substrate.modes();
        let at_rest = if slide_roll == 1.0 { substrate.of_roller() } else { 0 };
        let share: f64 = modes[modes.len() - at_rest..].iter().map(|mode| mode.share).sum();
        1.0 / (1.0 + f * share)
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
