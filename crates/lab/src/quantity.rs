//! Quantities of the laboratory: what an experiment has in place of α and β.

use crate::Dimension;
use crate::notation::{Comma, with_point};
use crate::units::Refusal;
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
    /// T, the temperature.
    Temperature,
    /// V, speed of a roller that slides without turning.
    Speed,
    /// u₁, speed of the roller's surface.
    RollerSpeed,
    /// (u₂ − u₁)/U, the slide-to-roll ratio.
    SlideRollRatio,
    /// U = (u₁ + u₂)/2, the entrainment speed.
    EntrainmentSpeed,
    /// u₂, speed of the flat.
    FlatSpeed,
}

impl LaboratoryQuantity {
    /// All, in the order in which results have them: of the speeds that are given the last one is that along which
    /// chains run.
    pub const ALL: [Self; 13] = [
        Self::Radius,
        Self::Load,
        Self::RelaxedModulus,
        Self::InstantaneousModulus,
        Self::PoissonRatio,
        Self::Viscosity,
        Self::RetardationTime,
        Self::Temperature,
        Self::Speed,
        Self::RollerSpeed,
        Self::SlideRollRatio,
        Self::EntrainmentSpeed,
        Self::FlatSpeed,
    ];

    /// Those that say how fast the surfaces move.
    pub const SPEEDS: [Self; 5] =
        [Self::Speed, Self::RollerSpeed, Self::SlideRollRatio, Self::EntrainmentSpeed, Self::FlatSpeed];

    /// Temperatures of soft bodies and fluids (K): a number outside was meant in another unit.
    pub const TEMPERATURES: std::ops::RangeInclusive<f64> = 100.0..=2000.0;

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
            Self::Temperature => "temperature",
            Self::Speed => "speed",
            Self::RollerSpeed => "roller_speed",
            Self::SlideRollRatio => "slide_roll_ratio",
            Self::EntrainmentSpeed => "entrainment_speed",
            Self::FlatSpeed => "flat_speed",
        }
    }

    /// The quantity of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// What it measures; `None` for ratios, which have no unit.
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Radius => Some(Dimension::Length),
            Self::Load => Some(Dimension::LineLoad),
            Self::RelaxedModulus | Self::InstantaneousModulus => Some(Dimension::Modulus),
            Self::PoissonRatio | Self::SlideRollRatio => None,
            Self::Temperature => Some(Dimension::Temperature),
            Self::Viscosity => Some(Dimension::Viscosity),
            Self::RetardationTime => Some(Dimension::Time),
            Self::Speed | Self::RollerSpeed | Self::EntrainmentSpeed | Self::FlatSpeed => Some(Dimension::Speed),
        }
    }

    /// SI unit; `1` for ratios.
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
            Self::Temperature => "temperature",
            Self::Speed => "speed of the cylinder",
            Self::RollerSpeed => "speed of the roller's surface",
            Self::SlideRollRatio => "slide-to-roll ratio, flat less roller over the entrainment speed",
            Self::EntrainmentSpeed => "entrainment speed, the mean of both surfaces",
            Self::FlatSpeed => "speed of the flat",
        }
    }

    /// True for a value that the quantity may have.
    pub fn admits(self, value: f64) -> bool {
        match self {
            Self::PoissonRatio => (0.0..=0.5).contains(&value),
            Self::SlideRollRatio => (-2.0..=2.0).contains(&value),
            Self::RollerSpeed | Self::FlatSpeed => value >= 0.0 && value.is_finite(),
            Self::Temperature => Self::TEMPERATURES.contains(&value),
            _ => value > 0.0 && value.is_finite(),
        }
    }

    /// What to do about a value that it may not have.
    fn remedy(self, value: f64) -> &'static str {
        match self {
            Self::PoissonRatio => "soft solids hardly change their volume: 0.5 is usual, 0.3 for a stiff polymer",
            Self::SlideRollRatio => {
                "it is (flat_speed - roller_speed) / entrainment_speed: 0 is pure rolling, 2 a roller that does not \
                 turn; beyond, the surfaces would move against each other, and a film of that kind is not computed. \
                 In per cent write \"50 %\" for 0.5. Some instruments divide by the sum of the speeds: take twice their \
                 number"
            }
            Self::RollerSpeed | Self::FlatSpeed if value < 0.0 => {
                "both surfaces must move the same way: where they move against each other fluid enters from both sides, \
                 and that film is not computed"
            }
            Self::Temperature => "a plain number is in kelvins; write \"20 degC\", say",
            _ => "write it in SI units as in 1e-3, or with its unit in quotes",
        }
    }

    /// The value of a text with a unit, in SI units; a ratio may be in per cent.
    fn with_unit(self, text: &str) -> Result<f64, Refusal> {
        match self.dimension() {
            Some(dimension) => dimension.parse(text),
            None => {
                let percent = text.trim().strip_suffix('%').map(|number| with_point(number.trim()));
                let number = match percent {
                    Some(Comma::None(number)) => number.parse::<f64>().ok(),
                    _ => None,
                };
                let refused =
                    || Refusal::new("a number", "no number", "write a plain number, or one in per cent as \"50 %\"");
                number.map(|number| number / 100.0).ok_or_else(refused)
            }
        }
    }

    /// The value of a text as on the command line: a number in SI units, or one with a unit.
    ///
    /// # Errors
    /// What it must be, in words.
    pub fn parse(self, text: &str) -> Result<f64, String> {
        let value = match text.trim().parse::<f64>() {
            Ok(value) => value,
            Err(_) => self.with_unit(text).map_err(|refusal| refusal.sentence(self.name()))?,
        };
        match self.admits(value) {
            true => Ok(value),
            false => Err(format!("{} must be {}: {}", self.name(), self.allowed(), self.remedy(value))),
        }
    }

    /// The value of an entry, in SI units, if the quantity may have it.
    pub(crate) fn read_value(self, entry: &Entry<'_>, value: f64) -> Result<f64, Fault> {
        if self.admits(value) { Ok(value) } else { Err(entry.not_allowed(self.allowed(), self.remedy(value))) }
    }

    /// The values that it may have, in words.
    pub fn allowed(self) -> &'static str {
        match self {
            Self::PoissonRatio => "from 0 to 0.5",
            Self::SlideRollRatio => "from -2 to 2",
            Self::RollerSpeed | Self::FlatSpeed => "finite and at least 0",
            Self::Temperature => "from 100 K to 2000 K",
            _ => "finite and above 0",
        }
    }
}

impl Values for LaboratoryQuantity {
    /// A number in SI units or with a unit, within what the quantity [admits](LaboratoryQuantity::admits).
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault> {
        let value = match self.dimension() {
            Some(dimension) => dimension.read_number(entry)?,
            None if entry.is_text() => self.with_unit(entry.text()?).map_err(|refusal| refusal.of(entry))?,
            None => entry.number()?,
        };
        self.read_value(entry, value)
    }
}
