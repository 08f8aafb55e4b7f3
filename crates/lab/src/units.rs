//! Values with units: "5.1 Pa s", "119 N/m", "2 mm".
//!
//! Units and their factors are those of the crate `uom`. `notation` brings a text into the form in which `uom` writes
//! units.

use uom::si::f64::{
    Angle, AngularVelocity, DynamicViscosity, Force, Frequency, KinematicViscosity, Length, Pressure, SurfaceTension,
    Time, Velocity,
};
use uom::si::{
    angle, angular_velocity, dynamic_viscosity, force, frequency, kinematic_viscosity, length, pressure,
    surface_tension, time, velocity,
};

use crate::notation::{Comma, canonical, in_si, parts, with_point};
use crate::temperature_unit;
use std::f64::consts::TAU;
use stribeck_input::{Entry, Fault, Values};

/// How people write turns in a minute, beside rpm.
const TURNS_A_MINUTE: [&str; 5] = ["1/min", "U/min", "rev/min", "r/min", "turns/min"];

/// What a value with a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// In m.
    Length,
    /// Load per length, in N/m.
    LineLoad,
    /// In Pa.
    Modulus,
    /// In Pa s.
    Viscosity,
    /// In s.
    Time,
    /// In m/s.
    Speed,
    /// In Hz.
    Frequency,
    /// In rad/s.
    AngularFrequency,
    /// In K.
    Temperature,
    /// In rad.
    Angle,
    /// In N.
    Force,
    /// In m²/s.
    KinematicViscosity,
}

/// How a number in some unit becomes one in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conversion {
    pub(crate) factor: f64,
    /// Added after the factor.
    pub(crate) offset: f64,
}

impl Conversion {
    /// No change.
    pub const NONE: Self = Self::by(1.0);

    /// A multiplication.
    pub const fn by(factor: f64) -> Self {
        Self { factor, offset: 0.0 }
    }

    /// The number in SI units; with a power of ten the one that a person would write, to the last bit.
    pub fn in_si(self, number: f64) -> f64 {
        let scaled = in_si(number, self.factor);
        if self.offset == 0.0 { scaled } else { scaled + self.offset }
    }

    /// A difference of two such numbers in SI units.
    pub fn of_difference(self, number: f64) -> f64 {
        in_si(number, self.factor)
    }
}

impl Dimension {
    const ALL: [Self; 12] = [
        Self::Length,
        Self::LineLoad,
        Self::Modulus,
        Self::Viscosity,
        Self::Time,
        Self::Speed,
        Self::Frequency,
        Self::AngularFrequency,
        Self::Temperature,
        Self::Angle,
        Self::Force,
        Self::KinematicViscosity,
    ];

    /// Its name with an article, its SI unit, and an example of a value.
    fn facts(self) -> [&'static str; 3] {
        match self {
            Dimension::Length => ["a length", "m", "\"2 mm\" or 2e-3 (in m)"],
            Dimension::LineLoad => ["a load per length", "N/m", "\"119 N/m\" or 119.0 (in N/m)"],
            Dimension::Modulus => ["a modulus", "Pa", "\"100 kPa\" or 1e5 (in Pa)"],
            Dimension::Viscosity => ["a viscosity", "Pa s", "\"5.1 Pa s\" or 5.1 (in Pa s)"],
            Dimension::Time => ["a time", "s", "\"20 ms\" or 0.02 (in s)"],
            Dimension::Speed => ["a speed", "m/s", "\"1 mm/s\" or 1e-3 (in m/s)"],
            Dimension::Frequency => ["a frequency", "Hz", "\"10 Hz\" or 10.0 (in Hz)"],
            Dimension::AngularFrequency => ["an angular frequency", "rad/s", "\"10 rad/s\" or 10.0 (in rad/s)"],
            Dimension::Temperature => ["a temperature", "K", "\"20 degC\" or 293.15 (in K)"],
            Dimension::Angle => ["an angle", "rad", "\"5 deg\" or 0.087 (in rad)"],
            Dimension::Force => ["a force", "N", "\"20 N\" or 20.0 (in N)"],
            Dimension::KinematicViscosity => ["a kinematic viscosity", "m²/s", "\"10 cSt\" or 1e-5 (in m²/s)"],
        }
    }

    /// Its name, with an article.
    pub fn words(self) -> &'static str {
        self.facts()[0]
    }

    /// Its SI unit.
    pub fn unit(self) -> &'static str {
        self.facts()[1]
    }

    /// An example of a value.
    fn example(self) -> &'static str {
        self.facts()[2]
    }

    /// The number of SI units in a unit, written as `uom` writes it; `None` if the unit has another dimension.
    fn factor(self, unit: &str) -> Option<f64> {
        /// Looks a unit up by its abbreviation.
        macro_rules! factor {
            ($quantity:ident, $module:ident, $base:ident) => {{
                let known = $module::units().find(|known| canonical(known.abbreviation()) == unit)?;
                format!("1 {}", known.abbreviation()).parse::<$quantity>().ok().map(|one| one.get::<$module::$base>())
            }};
        }
        match self {
            Dimension::Length => factor!(Length, length, meter),
            Dimension::LineLoad => {
                Self::per_length(unit).or_else(|| factor!(SurfaceTension, surface_tension, newton_per_meter))
            }
            Dimension::Modulus if unit == "N/m²" => Some(1.0),
            Dimension::Modulus => factor!(Pressure, pressure, pascal),
            Dimension::Viscosity if unit == "N·s/m²" => Some(1.0),
            Dimension::Viscosity => factor!(DynamicViscosity, dynamic_viscosity, pascal_second),
            Dimension::Time => factor!(Time, time, second),
            Dimension::Speed => factor!(Velocity, velocity, meter_per_second),
            Dimension::Frequency => factor!(Frequency, frequency, hertz),
            Dimension::AngularFrequency if unit == "1/s" => Some(1.0),
            Dimension::AngularFrequency if TURNS_A_MINUTE.contains(&unit) => Some(TAU / 60.0),
            Dimension::AngularFrequency => factor!(AngularVelocity, angular_velocity, radian_per_second),
            Dimension::Angle => factor!(Angle, angle, radian),
            Dimension::Force => factor!(Force, force, newton),
            Dimension::KinematicViscosity => {
                factor!(KinematicViscosity, kinematic_viscosity, square_meter_per_second)
            }
            Dimension::Temperature => None,
        }
    }

    /// The number of N/m in a unit of force over one of length.
    fn per_length(unit: &str) -> Option<f64> {
        let (force, length) = unit.split_once('/')?;
        let length = Dimension::Length.factor(length)?;
        // the reciprocal of a power of ten is one, to the last bit
        Some(in_si(1.0 / length, Dimension::Force.factor(force)?))
    }

    /// What becomes of numbers in a unit, written in any way; `None` if the unit has another dimension.
    pub fn conversion(self, unit: &str) -> Option<Conversion> {
        if self == Dimension::Temperature {
            return temperature_unit::conversion(unit);
        }
        self.factor(&canonical(unit)).map(Conversion::by)
    }

    /// What a unit measures, written in any way.
    pub fn of_unit(unit: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dimension| dimension.conversion(unit).is_some())
    }

    /// Why a value of another dimension is none of this one, and how it becomes one.
    pub fn mismatch(self, other: Self) -> String {
        match (self, other) {
            (Dimension::LineLoad, Dimension::Force) => {
                "a force; a load is per length: divide it by the length of the cylinder".to_owned()
            }
            (Dimension::Viscosity, Dimension::KinematicViscosity) => {
                "a kinematic viscosity; multiply it by the density: 1 cSt of a fluid of 1000 kg/m³ is 1 mPa s"
                    .to_owned()
            }
            (Dimension::Speed, Dimension::AngularFrequency) => {
                "turns, not a speed; multiply by the radius: 1 rpm is 2π/60 times the radius per second".to_owned()
            }
            _ => format!("{}, not {}", other.words(), self.words()),
        }
    }

    /// Reads a number in SI units, or a text with a unit, whatever its sign.
    pub(crate) fn read_number(self, entry: &Entry<'_>) -> Result<f64, Fault> {
        if !entry.is_text() {
            return entry.number();
        }
        self.parse(entry.text()?).map_err(|refusal| refusal.of(entry))
    }

    /// The value of a text with a unit, in SI units and whatever its sign.
    pub(crate) fn parse(self, text: &str) -> Result<f64, Refusal> {
        let (number, unit) = parts(text);
        let help = format!("write {}", self.example());
        let wanted = format!("{}, a number with a unit", self.words());
        let number = match with_point(number) {
            Comma::None(number) => number,
            Comma::Ambiguous => {
                let label = "a comma that is a decimal mark or stands between thousands";
                return Err(Refusal::new(wanted, label, format!("{help}; with a point as decimal mark")));
            }
        };
        let Ok(number) = number.parse::<f64>() else {
            return Err(Refusal::new(wanted, "does not begin with a number", help));
        };
        if unit.trim().is_empty() {
            let help = format!("{help}; a number without a unit stands without quotes");
            return Err(Refusal::new(wanted, "has no unit", help));
        }
        if let Some(conversion) = self.conversion(unit) {
            return Ok(conversion.in_si(number));
        }
        let label = match Self::of_unit(unit) {
            Some(other) => self.mismatch(other),
            None => "not a unit that is known here".to_owned(),
        };
        Err(Refusal::new(format!("{}, in {} or a unit of that kind", self.words(), self.unit()), label, help))
    }
}

/// Why a text is no value with a unit.
pub(crate) struct Refusal {
    /// What it must be.
    wanted: String,
    /// What it is.
    label: String,
    /// What to do.
    help: String,
}

impl Refusal {
    pub(crate) fn new(wanted: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Self {
        Self { wanted: wanted.into(), label: label.into(), help: help.into() }
    }

    /// As the fault of an entry of a file.
    pub(crate) fn of(self, entry: &Entry<'_>) -> Fault {
        entry.fault(format!("`{}` must be {}", entry.path(), self.wanted), self.label, self.help)
    }

    /// In one line, of a value that has a name and no place.
    pub(crate) fn sentence(&self, name: &str) -> String {
        format!("{name} must be {}: {}; {}", self.wanted, self.label, self.help)
    }
}

impl Values for Dimension {
    /// A finite number above 0, in SI units.
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault> {
        let value = self.read_number(entry)?;
        if value.is_finite() && value > 0.0 {
            return Ok(value);
        }
        let remedy = "write it in SI units as in 1e-3, or with its unit in quotes";
        Err(entry.not_allowed("finite and above 0", remedy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_known_however_they_are_written() {
        for (dimension, text, value) in [
            (Dimension::Viscosity, "5.1 Pa s", 5.1),
            (Dimension::Viscosity, "5.1 Pa·s", 5.1),
            (Dimension::Viscosity, "5.1Pa*s", 5.1),
            (Dimension::Viscosity, "0.9 mPa s", 0.9e-3),
            (Dimension::Viscosity, "0.9 mPa.s", 0.9e-3),
            (Dimension::Viscosity, "1 cP", 1e-3),
            (Dimension::LineLoad, "119 N/m", 119.0),
            (Dimension::LineLoad, "2 kN / m", 2000.0),
            (Dimension::Length, "2 mm", 2e-3),
            (Dimension::Length, "+2e1 um", 2e-5),
            (Dimension::Length, "20 μm", 2e-5),
            (Dimension::Length, "2.5E-1 cm", 2.5e-3),
            (Dimension::Modulus, "1e5 Pa", 1e5),
            (Dimension::Modulus, ".1 MPa", 1e5),
            (Dimension::Modulus, "3 N/mm^2", 3e6),
            (Dimension::Time, "20 ms", 0.02),
            (Dimension::Time, "2 min", 120.0),
            (Dimension::Speed, "1 mm/s", 1e-3),
            (Dimension::Speed, "36 km/h", 10.0),
            (Dimension::Speed, "1 mm s-1", 1e-3),
            (Dimension::Speed, "1 mm s^-1", 1e-3),
            (Dimension::Speed, "1 mm·s⁻¹", 1e-3),
            (Dimension::Speed, "1 \u{3bc}m/s", 1e-6),
            (Dimension::Speed, "1 \u{b5}m/s", 1e-6),
            (Dimension::LineLoad, "3 mN/mm", 3.0),
            (Dimension::LineLoad, "3 N/mm", 3e3),
            (Dimension::LineLoad, "0.3 N/cm", 30.0),
            (Dimension::LineLoad, "3 N m-1", 3.0),
            (Dimension::Viscosity, "3 mPas", 3e-3),
            (Dimension::Viscosity, "3 mPa-s", 3e-3),
            (Dimension::Viscosity, "3 N s/m^2", 3.0),
            (Dimension::Viscosity, "3 N s m-2", 3.0),
            (Dimension::Viscosity, "3 P", 0.3),
            (Dimension::Modulus, "3 N/m2", 3.0),
            (Dimension::AngularFrequency, "3 s^-1", 3.0),
            (Dimension::AngularFrequency, "30 rpm", TAU / 2.0),
            (Dimension::AngularFrequency, "30 1/min", TAU / 2.0),
            (Dimension::AngularFrequency, "30 min^-1", TAU / 2.0),
            (Dimension::AngularFrequency, "30 U/min", TAU / 2.0),
            (Dimension::AngularFrequency, "3 rad s-1", 3.0),
            (Dimension::Temperature, "20 degC", 293.15),
            (Dimension::Temperature, "20 °C", 293.15),
            (Dimension::Temperature, "293.15 K", 293.15),
            (Dimension::KinematicViscosity, "3 cSt", 3e-6),
        ] {
            let (number, unit) = parts(text);
            let conversion = dimension.conversion(unit).unwrap_or_else(|| panic!("{text} is not known"));
            let found = conversion.in_si(number.parse().expect(text));
            assert!((found - value).abs() <= 4.0 * f64::EPSILON * value, "{text}: {found}");
        }
    }

    /// A unit belongs to one dimension, so that the wrong one can be named.
    #[test]
    fn no_unit_belongs_to_two_dimensions() {
        for unit in [
            "m", "mm", "N/m", "Pa", "kPa", "Pa·s", "P", "s", "ms", "min", "m/s", "mm/s", "N", "cSt", "K", "Hz", "rad/s",
        ] {
            let of: Vec<Dimension> = Dimension::ALL.into_iter().filter(|it| it.conversion(unit).is_some()).collect();
            assert_eq!(of.len(), 1, "{unit}: {of:?}");
        }
        assert!(Dimension::ALL.into_iter().all(|it| it.conversion("parrot").is_none()));
        // a product is not a prefix
        assert!(["m s", "m.s", "m in"].into_iter().all(|unit| Dimension::Time.conversion(unit).is_none()));
        assert!(Dimension::ALL.into_iter().all(|it| it.conversion(it.unit()) == Some(Conversion::NONE)));
    }

    /// What people have at hand in place of a quantity is told with what it lacks.
    #[test]
    fn what_is_missing_is_named() {
        for (wanted, unit, words) in [
            (Dimension::LineLoad, "N", "a force; a load is per length: divide it by the length"),
            (Dimension::Viscosity, "cSt", "multiply it by the density"),
            (Dimension::Speed, "rpm", "multiply by the radius"),
            (Dimension::Speed, "Pa", "a modulus, not a speed"),
        ] {
            let other = Dimension::of_unit(unit).unwrap_or_else(|| panic!("{unit} is known"));
            assert!(wanted.mismatch(other).contains(words), "{unit}");
        }
    }
}
