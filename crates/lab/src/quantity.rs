//! Quantities of the laboratory: what an experiment has in place of α and β.

use std::ops::RangeInclusive;

use crate::Dimension;
use stribeck_input::{Entry, Fault, Values};

/// A quantity of an experiment, in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LaboratoryQuantity {
    /// R, radius of the cylinder.
    Radius,
    /// N, load per length of the cylinder.
    Load,
    /// E∞, modulus after a long time.
    RelaxedModulus,
    /// E₀ = (1 + f) E∞, modulus at once.
    InstantaneousModulus,
    /// ν, Poisson's ratio of the substrate.
    PoissonRatio,
    /// η, viscosity of the fluid.
    Viscosity,
    /// τ, retardation time of the substrate.
    RetardationTime,
    /// V, speed of the cylinder.
    Speed,
}

impl LaboratoryQuantity {
    /// All, in the order in which results have them: the speed, along which chains run, is the last.
    pub const ALL: [Self; 8] = [
        Self::Radius,
        Self::Load,
        Self::RelaxedModulus,
        Self::InstantaneousModulus,
        Self::PoissonRatio,
        Self::Viscosity,
        Self::RetardationTime,
        Self::Speed,
    ];

    /// Name in sweep files and results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Radius => "radius",
            Self::Load => "load",
            Self::RelaxedModulus => "relaxed_modulus",
            Self::InstantaneousModulus => "instantaneous_modulus",
            Self::PoissonRatio => "poisson_ratio",
            Self::Viscosity => "viscosity",
            Self::RetardationTime => "retardation_time",
            Self::Speed => "speed",
        }
    }

    /// The quantity of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// What it measures; `None` for Poisson's ratio, which has no unit.
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Radius => Some(Dimension::Length),
            Self::Load => Some(Dimension::LineLoad),
            Self::RelaxedModulus | Self::InstantaneousModulus => Some(Dimension::Modulus),
            Self::PoissonRatio => None,
            Self::Viscosity => Some(Dimension::Viscosity),
            Self::RetardationTime => Some(Dimension::Time),
            Self::Speed => Some(Dimension::Speed),
        }
    }

    /// SI unit; `1` for Poisson's ratio.
    pub fn units(self) -> &'static str {
        self.dimension().map_or("1", Dimension::unit)
    }

    /// What it is, in words.
    pub fn long_name(self) -> &'static str {
        match self {
            Self::Radius => "radius of the cylinder",
            Self::Load => "load per length of the cylinder",
            Self::RelaxedModulus => "relaxed modulus of the substrate",
            Self::InstantaneousModulus => "instantaneous modulus of the substrate",
            Self::PoissonRatio => "Poisson's ratio of the substrate",
            Self::Viscosity => "viscosity of the fluid",
            Self::RetardationTime => "retardation time of the substrate",
            Self::Speed => "speed of the cylinder",
        }
    }
}

/// What Poisson's ratio may be.
pub(crate) const POISSON_RATIOS: RangeInclusive<f64> = 0.0..=0.5;

impl Values for LaboratoryQuantity {
    /// A number in SI units or with a unit, above 0; Poisson's ratio is from 0 to 0.5.
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault> {
        let Some(dimension) = self.dimension() else {
            let value = entry.number()?;
            let remedy = "soft solids hardly change their volume: 0.5 is usual, 0.3 for a stiff polymer";
            let is_allowed = POISSON_RATIOS.contains(&value);
            return if is_allowed { Ok(value) } else { Err(entry.not_allowed("from 0 to 0.5", remedy)) };
        };
        dimension.read(entry)
    }
}
