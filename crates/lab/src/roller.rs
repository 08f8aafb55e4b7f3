//! What the roller is made of, in numbers.

use crate::{Dimension, Modulus};

/// The moduli and times of a roller; its retardation spectrum stands beside it, as that of the flat does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roller {
    /// E∞ or E₀ (Pa); infinite for a rigid roller.
    pub modulus: Modulus,
    /// ν.
    pub poisson_ratio: f64,
    /// f = E₀/E∞ − 1 of the roller; 0 for an elastic one.
    pub f: f64,
    /// τ (s) of the roller.
    pub retardation_time: f64,
}

/// A quantity of a roller, named as in its section of a sweep file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RollerQuantity {
    /// f.
    Strength,
    /// E∞.
    RelaxedModulus,
    /// E₀.
    InstantaneousModulus,
    /// τ.
    RetardationTime,
}

impl Roller {
    /// A rigid roller.
    pub const RIGID: Self =
        Self { modulus: Modulus::Relaxed(f64::INFINITY), poisson_ratio: 0.0, f: 0.0, retardation_time: 0.0 };

    /// True for a rigid roller.
    pub fn is_rigid(&self) -> bool {
        self.modulus.relaxed(self.f) == f64::INFINITY
    }

    /// E∞/(1 − ν²) (Pa); infinite for a rigid roller.
    pub fn plane_strain_modulus(&self) -> f64 {
        self.modulus.relaxed(self.f) / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }

    /// The value of a quantity; the modulus that was not given follows from f.
    pub fn value(&self, quantity: RollerQuantity) -> f64 {
        match quantity {
            RollerQuantity::Strength => self.f,
            RollerQuantity::RelaxedModulus => self.modulus.relaxed(self.f),
            RollerQuantity::InstantaneousModulus => self.modulus.instantaneous(self.f),
            RollerQuantity::RetardationTime => self.retardation_time,
        }
    }

    /// Sets a quantity; a modulus becomes the given one.
    pub fn set(&mut self, quantity: RollerQuantity, value: f64) {
        match quantity {
            RollerQuantity::Strength => self.f = value,
            RollerQuantity::RelaxedModulus => self.modulus = Modulus::Relaxed(value),
            RollerQuantity::InstantaneousModulus => self.modulus = Modulus::Instantaneous(value),
            RollerQuantity::RetardationTime => self.retardation_time = value,
        }
    }

    /// The quantities that describe it: none of a rigid one, the modulus alone of an elastic one.
    pub fn given(&self) -> impl Iterator<Item = RollerQuantity> {
        use RollerQuantity::{InstantaneousModulus, RelaxedModulus, RetardationTime, Strength};
        let modulus = if matches!(self.modulus, Modulus::Relaxed(_)) { RelaxedModulus } else { InstantaneousModulus };
        let known = [(modulus, !self.is_rigid()), (Strength, self.f > 0.0), (RetardationTime, self.f > 0.0)];
        known.into_iter().filter_map(|(quantity, is_known)| is_known.then_some(quantity))
    }
}

impl Default for Roller {
    fn default() -> Self {
        Self::RIGID
    }
}

impl RollerQuantity {
    /// All.
    pub const ALL: [Self; 4] =
        [Self::Strength, Self::RelaxedModulus, Self::InstantaneousModulus, Self::RetardationTime];

    /// Its name in a sweep file, with the section.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strength => "roller.f",
            Self::RelaxedModulus => "roller.relaxed_modulus",
            Self::InstantaneousModulus => "roller.instantaneous_modulus",
            Self::RetardationTime => "roller.retardation_time",
        }
    }

    /// SI unit; `1` for f.
    pub fn units(self) -> &'static str {
        match self {
            Self::Strength => "1",
            Self::RelaxedModulus | Self::InstantaneousModulus => Dimension::Modulus.unit(),
            Self::RetardationTime => Dimension::Time.unit(),
        }
    }

    /// True for the two moduli.
    pub fn is_modulus(self) -> bool {
        matches!(self, Self::RelaxedModulus | Self::InstantaneousModulus)
    }
}
