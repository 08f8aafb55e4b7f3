//! How moduli, and not their times alone, change with temperature.

use std::ops::RangeInclusive;

use super::isotherms::{Isotherm, Isotherms};

/// How isotherms are shifted along the axis of moduli: multiplied by b_T, which is 1 at the reference temperature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum VerticalShift {
    /// Not at all: b_T = 1.
    #[default]
    None,
    /// By what lays neighbours best over one another, together with the shift of their rates.
    Overlap,
    /// As the modulus of a rubber is proportional to ρT: b_T = ρ₀T₀/(ρT).
    Density {
        /// Thermal expansion of the volume (1/K): ρ₀/ρ = 1 + expansion (T − T₀).
        expansion: f64,
    },
}

impl VerticalShift {
    /// Thermal expansions of volumes that may be (1/K).
    pub const EXPANSION: RangeInclusive<f64> = 0.0..=2e-3;
    /// What an expansion must be, in words.
    pub const EXPANSION_ALLOWED: &str = "a number from 0 to 0.002; rubber has 6e-4";

    /// log₁₀ b_T where it is known before the isotherms are shifted; else 0.
    pub(super) fn log_factor(self, temperature: f64, reference: f64) -> f64 {
        match self {
            Self::None | Self::Overlap => 0.0,
            Self::Density { expansion } => {
                ((1.0 + expansion * (temperature - reference)) * reference / temperature).log10()
            }
        }
    }

    /// Isotherms multiplied by b_T, as far as it is known.
    pub(super) fn levelled(self, isotherms: &Isotherms, reference: f64) -> Vec<Isotherm> {
        let levelled = |Isotherm { temperature, measurements }: &Isotherm| Isotherm {
            temperature: *temperature,
            measurements: measurements.stiffer(10_f64.powf(self.log_factor(*temperature, reference))),
        };
        isotherms.all().iter().map(levelled).collect()
    }
}
