//! What may be looked for.

use crate::Experiment;
use crate::LaboratoryQuantity;
use crate::Powers;

/// Something that is not known of an experiment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// f, strength of retardation.
    Strength,
    /// A quantity of the laboratory.
    Quantity(LaboratoryQuantity),
}

impl Unknown {
    /// All that may be looked for. Poisson's ratio is none: it is in the modulus only.
    pub fn all() -> impl Iterator<Item = Self> {
        let quantities = LaboratoryQuantity::ALL.into_iter();
        let quantities = quantities.filter(|quantity| *quantity != LaboratoryQuantity::PoissonRatio);
        std::iter::once(Self::Strength).chain(quantities.map(Self::Quantity))
    }

    /// The one of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|unknown| unknown.name() == name)
    }

    /// Its name, as in `[laboratory]`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strength => "f",
            Self::Quantity(quantity) => quantity.name(),
        }
    }

    /// Its unit; `1` for f.
    pub fn units(self) -> &'static str {
        match self {
            Self::Strength => "1",
            Self::Quantity(quantity) => quantity.units(),
        }
    }

    /// Its value in an experiment.
    pub fn value(self, experiment: &Experiment) -> f64 {
        match self {
            Self::Strength => experiment.f,
            Self::Quantity(quantity) => experiment.value(quantity),
        }
    }

    /// Gives it another value.
    pub(super) fn set(self, experiment: &mut Experiment, value: f64) {
        match self {
            Self::Strength => experiment.f = value,
            Self::Quantity(quantity) => experiment.set(quantity, value),
        }
    }

    /// By which powers α, β and a₀/R change with it.
    pub(super) fn powers(self, experiment: &Experiment) -> Powers {
        match self {
            Self::Strength => experiment.powers_of_strength(),
            Self::Quantity(quantity) => experiment.powers(quantity),
        }
    }
}
