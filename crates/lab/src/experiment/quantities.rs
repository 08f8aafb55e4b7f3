//! The quantities of an experiment by their names: their values, which of them are given, and what is published.

use super::{Experiment, Modulus, Temperature, TemperatureLaws};
use crate::{LaboratoryQuantity, Scales};

impl Experiment {
    /// Names of the numbers that temperature changes, with unit and description, in the order of
    /// [`Experiment::variables`], behind those of [`Scales::VARIABLES`].
    pub const AT_TEMPERATURE: [(&'static str, &'static str, &'static str); 2] = [
        ("viscosity_at_temperature", "Pa s", "viscosity of the fluid at the temperature"),
        ("retardation_time_at_temperature", "s", "retardation time of the substrate at the temperature"),
    ];

    /// What is published beside the solution, with name, unit and description: the scales, and what temperature changes
    /// if there is one.
    pub fn variables(&self) -> impl Iterator<Item = ((&'static str, &'static str, &'static str), f64)> {
        let at_temperature = [self.viscosity_there(), self.flat_time()];
        let shifted = Self::AT_TEMPERATURE.into_iter().zip(at_temperature).filter(|_| self.temperature.is_some());
        Scales::VARIABLES.into_iter().zip(self.scales().values()).chain(shifted)
    }

    /// The value of a quantity; the modulus that was not given follows from f.
    pub fn value(&self, quantity: LaboratoryQuantity) -> f64 {
        match quantity {
            LaboratoryQuantity::Radius => self.radius,
            LaboratoryQuantity::Load => self.load,
            LaboratoryQuantity::RelaxedModulus => self.modulus.relaxed(self.f),
            LaboratoryQuantity::InstantaneousModulus => self.modulus.instantaneous(self.f),
            LaboratoryQuantity::PoissonRatio => self.poisson_ratio,
            LaboratoryQuantity::Viscosity => self.viscosity,
            LaboratoryQuantity::RetardationTime => self.retardation_time,
            LaboratoryQuantity::Temperature => self.temperature.map_or(f64::NAN, |temperature| temperature.value),
            speed => self.motion.value(speed),
        }
    }

    /// What a quantity is, in words.
    pub fn long_name(&self, quantity: LaboratoryQuantity) -> &'static str {
        self.temperature.map_or(quantity.long_name(), |temperature| temperature.laws.long_name(quantity))
    }

    /// The quantities that are given, in the order of [`LaboratoryQuantity::ALL`]: one of the moduli, and the speeds of
    /// one form of motion; the temperature where times or viscosity follow from it.
    pub fn given(&self) -> impl Iterator<Item = LaboratoryQuantity> {
        let other = match self.modulus {
            Modulus::Relaxed(_) => LaboratoryQuantity::InstantaneousModulus,
            Modulus::Instantaneous(_) => LaboratoryQuantity::RelaxedModulus,
        };
        let speeds = self.motion.given();
        let is_speed = |quantity: &LaboratoryQuantity| LaboratoryQuantity::SPEEDS.contains(quantity);
        let is_known = |it: &LaboratoryQuantity| *it != LaboratoryQuantity::Temperature || self.temperature.is_some();
        let others =
            LaboratoryQuantity::ALL.into_iter().filter(move |it| *it != other && !is_speed(it) && is_known(it));
        others.chain(speeds.iter().copied())
    }

    /// Sets a quantity; a modulus becomes the given one.
    pub fn set(&mut self, quantity: LaboratoryQuantity, value: f64) {
        match quantity {
            LaboratoryQuantity::Radius => self.radius = value,
            LaboratoryQuantity::Load => self.load = value,
            LaboratoryQuantity::RelaxedModulus => self.modulus = Modulus::Relaxed(value),
            LaboratoryQuantity::InstantaneousModulus => self.modulus = Modulus::Instantaneous(value),
            LaboratoryQuantity::PoissonRatio => self.poisson_ratio = value,
            LaboratoryQuantity::Viscosity => self.viscosity = value,
            LaboratoryQuantity::RetardationTime => self.retardation_time = value,
            LaboratoryQuantity::Temperature => {
                let laws = self.temperature.map_or_else(TemperatureLaws::default, |temperature| temperature.laws);
                self.temperature = Some(Temperature { value, laws });
            }
            speed => self.motion.set(speed, value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::tests::EXAMPLE;

    #[test]
    fn both_moduli_give_the_same_experiment() {
        for f in [0.0, 1.0, 100.0] {
            let relaxed = Experiment { f, ..EXAMPLE };
            let mut instantaneous = relaxed;
            let value = relaxed.value(LaboratoryQuantity::InstantaneousModulus);
            instantaneous.set(LaboratoryQuantity::InstantaneousModulus, value);
            assert!((instantaneous.beta() / relaxed.beta() - 1.0).abs() < 1e-14);
            assert!((instantaneous.value(LaboratoryQuantity::RelaxedModulus) - 1e5).abs() < 1e-9);
        }
    }
}
