//! Units of temperature, which have zeros of their own.

use crate::notation::parts;
use crate::{Conversion, Dimension};

/// What becomes of temperatures in a unit: `K`, `degC`, `°C`, `C`, `degF`, `°F`, `F`, or the whole word, in any case.
pub(crate) fn conversion(unit: &str) -> Option<Conversion> {
    let unit = unit.trim().to_lowercase();
    let letter = unit.trim_start_matches(['°', 'º']).trim_start_matches("degrees").trim_start_matches("deg");
    match letter.trim_matches([' ', '_', '.']) {
        "k" | "kelvin" | "kelvins" => Some(Conversion::NONE),
        // one sign of Unicode, too, for each of the others
        "c" | "celsius" | "℃" => Some(Conversion { factor: 1.0, offset: 273.15 }),
        "f" | "fahrenheit" | "℉" => Some(Conversion { factor: 1.0 / 1.8, offset: 459.67 / 1.8 }),
        _ => None,
    }
}

/// A temperature as in `20 degC` or `293.15 K`, in K; `None` if it has no unit or is not above absolute zero.
pub fn parse_temperature(text: &str) -> Option<f64> {
    let (number, unit) = parts(text);
    let kelvins = Dimension::Temperature.conversion(unit)?.in_si(number.parse().ok()?);
    (kelvins > 0.0 && kelvins.is_finite()).then_some(kelvins)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_temperature_is_written_in_many_ways() {
        for text in ["25 degC", "25°C", "25 C", "25.0 Celsius", "298.15 K", "298.15kelvin", "77 degF", "77 °F", "25 ℃"]
        {
            let kelvins = parse_temperature(text).unwrap_or_else(|| panic!("{text}"));
            assert!((kelvins - 298.15).abs() < 1e-9, "{text}: {kelvins}");
        }
        assert_eq!(parse_temperature("-40 degF").map(f64::round), parse_temperature("-40 degC").map(f64::round));
        for text in ["", "25", "K", "25 m", "0 K", "-300 degC", "nan K", "warm", "1e999 K"] {
            assert_eq!(parse_temperature(text), None, "{text}");
        }
        let difference = |unit: &str| conversion(unit).map(|it| it.of_difference(18.0));
        assert_eq!((difference("degF"), difference("degC")), (Some(10.0), Some(18.0)));
    }
}
