//! A temperature, and the laws of what changes with it.

use crate::{LaboratoryQuantity, ShiftLaw, ViscosityLaw};

/// A temperature, and what changes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperature {
    /// T (K).
    pub value: f64,
    /// The laws of what changes.
    pub laws: TemperatureLaws,
}

/// How times and viscosity change with temperature; what has no law stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TemperatureLaws {
    /// Of the times of the flat.
    pub flat: Option<ShiftLaw>,
    /// Of the times of the roller.
    pub roller: Option<ShiftLaw>,
    /// Of the viscosity.
    pub viscosity: Option<ViscosityLaw>,
}

impl TemperatureLaws {
    /// What a quantity is, in words; what a law changes belongs to the reference temperature of that law.
    pub fn long_name(&self, quantity: LaboratoryQuantity) -> &'static str {
        match quantity {
            LaboratoryQuantity::Viscosity if self.viscosity.is_some() => {
                "viscosity of the fluid at the reference temperature of its law"
            }
            LaboratoryQuantity::RetardationTime if self.flat.is_some() => {
                "retardation time of the substrate at the reference temperature of its shift"
            }
            other => other.long_name(),
        }
    }

    /// True where every law has a value.
    pub fn admit(&self, temperature: f64) -> bool {
        let shifts = [self.flat, self.roller].into_iter().flatten().all(|law| law.shift_factor(temperature).is_some());
        shifts && self.viscosity.is_none_or(|law| law.factor(temperature).is_some())
    }
}
