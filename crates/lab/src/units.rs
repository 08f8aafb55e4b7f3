//! Values with units: "5.1 Pa s", "119 N/m", "2 mm".
//!
//! Units and their factors are those of the crate `uom`. This file brings a text into the form in which `uom` writes
//! units.

use uom::si::f64::{DynamicViscosity, Length, Pressure, SurfaceTension, Time, Velocity};
use uom::si::{dynamic_viscosity, length, pressure, surface_tension, time, velocity};

use stribeck_input::{Entry, Fault, Values};

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
}

impl Dimension {
    const ALL: [Self; 6] = [Self::Length, Self::LineLoad, Self::Modulus, Self::Viscosity, Self::Time, Self::Speed];

    /// Its name, with an article.
    fn words(self) -> &'static str {
        match self {
            Dimension::Length => "a length",
            Dimension::LineLoad => "a load per length",
            Dimension::Modulus => "a modulus",
            Dimension::Viscosity => "a viscosity",
            Dimension::Time => "a time",
            Dimension::Speed => "a speed",
        }
    }

    /// Its SI unit.
    pub fn unit(self) -> &'static str {
        match self {
            Dimension::Length => "m",
            Dimension::LineLoad => "N/m",
            Dimension::Modulus => "Pa",
            Dimension::Viscosity => "Pa s",
            Dimension::Time => "s",
            Dimension::Speed => "m/s",
        }
    }

    /// An example of a value.
    fn example(self) -> &'static str {
        match self {
            Dimension::Length => "\"2 mm\" or 2e-3 (in m)",
            Dimension::LineLoad => "\"119 N/m\" or 119.0 (in N/m)",
            Dimension::Modulus => "\"100 kPa\" or 1e5 (in Pa)",
            Dimension::Viscosity => "\"5.1 Pa s\" or 5.1 (in Pa s)",
            Dimension::Time => "\"20 ms\" or 0.02 (in s)",
            Dimension::Speed => "\"1 mm/s\" or 1e-3 (in m/s)",
        }
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
            Dimension::LineLoad => factor!(SurfaceTension, surface_tension, newton_per_meter),
            Dimension::Modulus => factor!(Pressure, pressure, pascal),
            Dimension::Viscosity => factor!(DynamicViscosity, dynamic_viscosity, pascal_second),
            Dimension::Time => factor!(Time, time, second),
            Dimension::Speed => factor!(Velocity, velocity, meter_per_second),
        }
    }

    /// The number of SI units in a unit, written in any way; `None` if the unit has another dimension.
    pub fn factor_of(self, unit: &str) -> Option<f64> {
        self.factor(&canonical(unit))
    }

    /// Reads a number in SI units, or a text with a unit, whatever its sign.
    pub(crate) fn read_number(self, entry: &Entry<'_>) -> Result<f64, Fault> {
        if !entry.is_text() {
            return entry.number();
        }
        let text = entry.text()?;
        let (number, unit) = parts(text);
        let help = format!("write {}", self.example());
        let what = || format!("`{}` must be {}, a number with a unit", entry.path(), self.words());
        let Ok(number) = number.parse::<f64>() else {
            return Err(entry.fault(what(), "does not begin with a number", help));
        };
        let unit = canonical(unit);
        if unit.is_empty() {
            let help = format!("{help}; a number without a unit stands without quotes");
            return Err(entry.fault(what(), "has no unit", help));
        }
        if let Some(factor) = self.factor(&unit) {
            return Ok(in_si(number, factor));
        }
        let label = match Self::ALL.into_iter().find(|other| other.factor(&unit).is_some()) {
            Some(other) => format!("{}, not {}", other.words(), self.words()),
            None => "not a unit that is known here".to_owned(),
        };
        let what = format!("`{}` must be {}, in {} or a unit of that kind", entry.path(), self.words(), self.unit());
        Err(entry.fault(what, label, help))
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

/// A value in SI units: a number times the factor of its unit.
///
/// With a power of ten it is the number that a person would write, to the last bit: 0.9 mPa s is 9e-4 Pa s.
pub(crate) fn in_si(number: f64, factor: f64) -> f64 {
    let power = factor.log10().round() as i32;
    let is_power = format!("1e{power}").parse() == Ok(factor);
    let text = format!("{number:e}");
    match text.split_once('e').and_then(|(digits, exponent)| Some((digits, exponent.parse::<i32>().ok()?))) {
        Some((digits, exponent)) if is_power => {
            format!("{digits}e{}", exponent + power).parse().unwrap_or(number * factor)
        }
        _ => number * factor,
    }
}

/// The number at the beginning of a text, and what follows.
fn parts(text: &str) -> (&str, &str) {
    let text = text.trim();
    let in_number = |(place, c): (usize, char)| {
        let exponent = |rest: &str| rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit());
        match c {
            '0'..='9' | '.' => true,
            '+' | '-' => place == 0 || text[..place].ends_with(['e', 'E']),
            'e' | 'E' => place > 0 && exponent(&text[place + 1..]),
            _ => false,
        }
    };
    let end = text.char_indices().find(|&at| !in_number(at)).map_or(text.len(), |(place, _)| place);
    (&text[..end], &text[end..])
}

/// A unit in one way of writing: one · between factors, none beside /, signs for micro and powers.
fn canonical(unit: &str) -> String {
    let separated = unit.replace(['⋅', '*', '.'], "·").replace("^2", "²").replace('μ', "µ");
    let words = separated.split(|c: char| c == '·' || c.is_whitespace()).filter(|word| !word.is_empty());
    let joined = words.collect::<Vec<_>>().join("·").replace("·/", "/").replace("/·", "/");
    match joined.strip_prefix('u') {
        // micro where there is no such letter at hand; no unit known here begins with u
        Some(rest) if !rest.is_empty() => format!("µ{rest}"),
        _ => joined,
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
        ] {
            let (number, unit) = parts(text);
            let factor = dimension.factor(&canonical(unit)).unwrap_or_else(|| panic!("{text} is not known"));
            assert_eq!(in_si(number.parse().expect(text), factor), value, "{text}");
        }
    }

    /// A unit belongs to one dimension, so that the wrong one can be named.
    #[test]
    fn no_unit_belongs_to_two_dimensions() {
        for unit in ["m", "mm", "N/m", "Pa", "kPa", "Pa·s", "P", "s", "ms", "min", "m/s", "mm/s"] {
            let of: Vec<Dimension> = Dimension::ALL.into_iter().filter(|it| it.factor(unit).is_some()).collect();
            assert_eq!(of.len(), 1, "{unit}: {of:?}");
        }
        assert!(Dimension::ALL.into_iter().all(|it| it.factor("parrot").is_none()));
        // a product is not a prefix
        assert!(["m s", "m.s", "m in"].into_iter().all(|unit| Dimension::Time.factor_of(unit).is_none()));
        assert!(Dimension::ALL.into_iter().all(|it| it.factor(&canonical(it.unit())) == Some(1.0)));
    }

    #[test]
    fn numbers_end_where_units_begin() {
        for (text, expected) in [
            ("5 eV", ("5", " eV")),
            ("5e3 m", ("5e3", " m")),
            ("5e-3m", ("5e-3", "m")),
            ("-1 m", ("-1", " m")),
            ("m", ("", "m")),
            ("", ("", "")),
            ("1-2 m", ("1", "-2 m")),
            ("1 e3 m", ("1", " e3 m")),
        ] {
            assert_eq!(parts(text), expected, "{text}");
        }
    }
}
