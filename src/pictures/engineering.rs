//! Numbers as an engineer writes them: 0.5 mm/s, 20 °C, 31.6, 2·10⁶.

/// Prefixes of units with their powers of ten, the nearest to none first.
const SMALLER: [(i32, &str); 3] = [(-3, "m"), (-6, "µ"), (-9, "n")];
const LARGER: [(i32, &str); 3] = [(3, "k"), (6, "M"), (9, "G")];

/// From 0 °C to 0 K.
const CELSIUS: f64 = 273.15;

/// From SI units to the unit in which numbers are shown.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownUnit {
    /// The power of ten of the prefix.
    power: i32,
    /// What is taken off first.
    offset: f64,
    /// The name; empty for pure numbers.
    pub name: String,
}

impl ShownUnit {
    /// The unit in place of an SI unit, of which the largest number shown is between 0.1 and 1000 if a prefix does it.
    pub fn of(si: &str, largest: f64) -> Self {
        if si == "K" {
            return Self { power: 0, offset: CELSIUS, name: "°C".to_owned() };
        }
        let largest = largest.abs();
        let fits = |(power, _): &(i32, &str)| (0.1..1000.0).contains(&(largest * 10_f64.powi(-power)));
        // Pure numbers have no prefix.
        let has_prefix = si.starts_with(|letter: char| letter.is_ascii_alphabetic()) && largest > 0.0;
        let prefixes = if largest < 0.1 { SMALLER } else { LARGER };
        let is_plain = !has_prefix || fits(&(0, ""));
        let found = prefixes.into_iter().find(fits).filter(|_| !is_plain);
        let (power, prefix) = found.unwrap_or((0, ""));
        Self { power, offset: 0.0, name: format!("{prefix}{}", if si == "1" { "" } else { si }) }
    }

    /// A scale of dimensionless numbers, which stay as they are.
    pub fn scale(name: &str) -> Self {
        Self { power: 0, offset: 0.0, name: name.to_owned() }
    }

    /// A number of SI units in this one.
    pub fn shown(&self, value: f64) -> f64 {
        // One rounding: 0.0005 m is 0.5 mm.
        let value = value - self.offset;
        if self.power < 0 { value * 10_f64.powi(-self.power) } else { value / 10_f64.powi(self.power) }
    }

    /// What an axis is called whose numbers are in this unit.
    pub fn label(&self, words: &str) -> String {
        if self.name.is_empty() { words.to_owned() } else { format!("{words}  ({})", self.name) }
    }
}

/// A value in SI units with as many digits as tell it from others ([`digits`]), and its unit.
pub fn with_unit(value: f64, si: &str, digits: usize) -> String {
    let unit = ShownUnit::of(si, value);
    format!("{} {}", text(rounded(unit.shown(value), digits)), unit.name).trim_end().to_owned()
}

/// How many digits tell these values apart: three, or more.
pub fn digits(values: &[f64]) -> usize {
    let are_apart = |digits: &usize| {
        let mut rounded: Vec<f64> = values.iter().map(|value| rounded(*value, *digits)).collect();
        rounded.sort_by(f64::total_cmp);
        rounded.windows(2).all(|pair| pair[0] != pair[1])
    };
    (3..17).find(are_apart).unwrap_or(17)
}

/// A number with this many digits. One that has four is left as it is, and of three two are enough where the third
/// changes less than 0.3 %.
fn rounded(value: f64, digits: usize) -> f64 {
    let to = |digits: usize| format!("{value:.*e}", digits - 1).parse::<f64>().expect("{:e} writes a number");
    let is_same = |other: f64, share: f64| (other - value).abs() <= share * value.abs();
    if value == 0.0 || !value.is_finite() {
        value
    } else if digits <= 4 && is_same(to(4), 1e-12) {
        to(4)
    } else if digits == 3 && is_same(to(2), 3e-3) {
        to(2)
    } else {
        Some(to(digits)).filter(|short| short.is_finite()).unwrap_or(value)
    }
}

/// A number in letters: −0.5, ∞, 2·10⁶.
fn text(value: f64) -> String {
    if value == f64::INFINITY {
        return "∞".to_owned();
    }
    if value == 0.0 || (1e-4..1e6).contains(&value.abs()) {
        return format!("{value}").replace('-', "−");
    }
    let whole = format!("{value:e}");
    let (mantissa, power) = whole.split_once('e').expect("{:e} writes an exponent");
    let raised: String = power.chars().map(|digit| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(place(digit)).expect("a digit")).collect();
    let mantissa = mantissa.replace('-', "−");
    if mantissa == "1" { format!("10{raised}") } else { format!("{mantissa}·10{raised}") }
}

/// The place of a digit, and of the sign before all of them, among those that stand higher.
fn place(digit: char) -> usize {
    digit.to_digit(10).map_or(0, |digit| digit as usize + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_units_that_people_use() {
        for (value, si, expected) in [
            (0.0005011872336272725, "m/s", "0.5 mm/s"),
            (0.05, "m/s", "50 mm/s"),
            (0.5, "m/s", "0.5 m/s"),
            (119.0, "N/m", "119 N/m"),
            (1234.0, "N/m", "1.234 kN/m"),
            (3e6, "Pa", "3 MPa"),
            (0.0796, "Pa s", "79.6 mPa s"),
            (2.3e-7, "m", "0.23 µm"),
            (293.15, "K", "20 °C"),
            (31.622776601683793, "1", "31.6"),
            (215.44346900318845, "", "215"),
            (-0.5, "1", "−0.5"),
            (0.0, "m/s", "0 m/s"),
            (2e6, "", "2·10⁶"),
            (1e-7, "", "10⁻⁷"),
            (f64::INFINITY, "", "∞"),
        ] {
            assert_eq!(with_unit(value, si, 3), expected);
        }
        assert!(with_unit(f64::MAX, "", 3).starts_with("1.797"));
    }

    #[test]
    fn neighbours_are_told_apart() {
        assert_eq!(digits(&[1.0, 10.0, 31.6227]), 3);
        let values = [100.11, 100.12, 100.13];
        let words = values.map(|value| with_unit(value, "", digits(&values)));
        assert_eq!(words, ["100.11", "100.12", "100.13"]);
    }

    #[test]
    fn all_numbers_of_an_axis_have_one_unit() {
        let unit = ShownUnit::of("m", 2.4e-6);
        assert!((unit.shown(2.4e-6) - 2.4).abs() < 1e-12 && (unit.shown(1e-9) - 0.001).abs() < 1e-15);
        assert_eq!(unit.label("film"), "film  (µm)");
        assert_eq!((ShownUnit::scale("a₀").shown(1e-9), ShownUnit::of("1", 1e-9).shown(1e-9)), (1e-9, 1e-9));
    }
}
