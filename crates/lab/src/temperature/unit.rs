//! Units of temperature.

/// A unit of temperature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TemperatureUnit {
    /// K.
    Kelvin,
    /// °C.
    Celsius,
    /// °F.
    Fahrenheit,
}

impl TemperatureUnit {
    /// The unit of this name: `K`, `degC`, `°C`, `C`, `degF`, `°F`, `F`, or the whole word, in any case.
    pub fn named(name: &str) -> Option<Self> {
        let name = name.trim().to_lowercase();
        let letter = name.trim_start_matches(['°', 'º']).trim_start_matches("degrees").trim_start_matches("deg");
        match letter.trim_matches([' ', '_', '.']) {
            "k" | "kelvin" | "kelvins" => Some(Self::Kelvin),
            "c" | "celsius" => Some(Self::Celsius),
            "f" | "fahrenheit" => Some(Self::Fahrenheit),
            // one sign of Unicode for both
            "℃" => Some(Self::Celsius),
            "℉" => Some(Self::Fahrenheit),
            _ => None,
        }
    }

    /// A temperature of this unit in K.
    pub fn kelvins(self, value: f64) -> f64 {
        match self {
            Self::Kelvin => value,
            Self::Celsius => value + 273.15,
            Self::Fahrenheit => (value + 459.67) / 1.8,
        }
    }

    /// A difference of temperatures of this unit in K.
    pub fn kelvins_of_difference(self, value: f64) -> f64 {
        match self {
            Self::Kelvin | Self::Celsius => value,
            Self::Fahrenheit => value / 1.8,
        }
    }
}

/// A temperature as in `20 degC` or `293.15 K`, in K; `None` if it has no unit or is not above absolute zero.
pub fn parse_temperature(text: &str) -> Option<f64> {
    let end = text.rfind(|c: char| c.is_ascii_digit() || c == '.')? + 1;
    let number: f64 = text[..end].trim().parse().ok()?;
    let kelvins = TemperatureUnit::named(&text[end..])?.kelvins(number);
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
        assert_eq!(TemperatureUnit::Fahrenheit.kelvins_of_difference(18.0), 10.0);
        assert_eq!(TemperatureUnit::Celsius.kelvins_of_difference(18.0), 18.0);
    }
}
