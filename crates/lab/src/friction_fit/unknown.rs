//! The unknowns of a fit.

use crate::{Experiment, LaboratoryQuantity, Powers, RollerQuantity};

/// A quantity of an experiment that a fit may look for. Moduli, times and f without a body are those of the flat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// f, strength of retardation.
    Strength,
    /// A quantity of the laboratory.
    Quantity(LaboratoryQuantity),
    /// A quantity of the roller.
    Roller(RollerQuantity),
}

impl Unknown {
    /// All unknowns that there are. Poisson's ratio is none: it appears in the plane-strain modulus only. Nor is what
    /// may be 0: the slide-to-roll ratio and the speed of one surface; nor the temperature, which stands for others.
    pub fn all() -> impl Iterator<Item = Self> {
        use LaboratoryQuantity::{FlatSpeed, PoissonRatio, RollerSpeed, SlideRollRatio, Temperature};
        let others = [PoissonRatio, SlideRollRatio, RollerSpeed, FlatSpeed, Temperature];
        let quantities = LaboratoryQuantity::ALL.into_iter().filter(move |quantity| !others.contains(quantity));
        std::iter::once(Self::Strength)
            .chain(quantities.map(Self::Quantity))
            .chain(RollerQuantity::ALL.map(Self::Roller))
    }

    /// The unknown of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|unknown| unknown.name() == name)
    }

    /// Its name, as in `[laboratory]`; that of the roller begins with its section.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strength => "f",
            Self::Quantity(quantity) => quantity.name(),
            Self::Roller(quantity) => quantity.name(),
        }
    }

    /// Its unit; `1` for f.
    pub fn units(self) -> &'static str {
        match self {
            Self::Strength => "1",
            Self::Quantity(quantity) => quantity.units(),
            Self::Roller(quantity) => quantity.units(),
        }
    }

    /// True for the two moduli of the flat.
    pub(super) fn is_modulus(self) -> bool {
        use LaboratoryQuantity::{InstantaneousModulus, RelaxedModulus};
        matches!(self, Self::Quantity(RelaxedModulus | InstantaneousModulus))
    }

    /// Its value in an experiment.
    pub fn value(self, experiment: &Experiment) -> f64 {
        match self {
            Self::Strength => experiment.f,
            Self::Quantity(quantity) => experiment.value(quantity),
            Self::Roller(quantity) => experiment.roller.value(quantity),
        }
    }

    /// Sets its value in an experiment.
    pub fn set(self, experiment: &mut Experiment, value: f64) {
        match self {
            Self::Strength => experiment.f = value,
            Self::Quantity(quantity) => experiment.set(quantity, value),
            Self::Roller(quantity) => experiment.roller.set(quantity, value),
        }
    }

    /// The powers by which the parameters of the case and a₀/R change with it.
    pub fn powers(self, experiment: &Experiment) -> Powers {
        match self {
            Self::Strength => experiment.powers_of_strength(),
            Self::Quantity(quantity) => experiment.powers(quantity),
            Self::Roller(quantity) => experiment.powers_of_roller(quantity),
        }
    }
}
