//! Numbers as a reader writes them: 0.02, 10⁻³, 2·10⁻⁵.

/// The integer in superscript digits.
pub(crate) fn superscript(integer: i32) -> String {
    let raised = |character: char| match character {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4'..='9' => char::from_u32('⁴' as u32 + (character as u32 - '4' as u32)).expect("⁴ to ⁹ follow one another"),
        _ => '⁰',
    };
    integer.to_string().chars().map(raised).collect()
}

/// A power of ten: 10⁻³.
pub(crate) fn decade(exponent: i32) -> String {
    format!("10{}", superscript(exponent))
}

/// The largest power of ten not above `value` > 0, as exponent; exact for powers of ten.
pub(crate) fn exponent(value: f64) -> i32 {
    format!("{value:e}").split_once('e').and_then(|(_, power)| power.parse().ok()).expect("{:e} writes an exponent")
}

/// Ten to the power, exact where a double is.
pub(crate) fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().expect("1e± integer is a number")
}

/// Which way the numbers of one axis are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Notation {
    /// 0.02
    Plain,
    /// 2·10⁻²
    Scientific,
}

impl Notation {
    /// What suits numbers up to this size, told apart by steps of this size.
    pub(crate) fn of(largest: f64, step: f64) -> Self {
        if (1e-4..1e5).contains(&largest) && step >= 1e-5 { Notation::Plain } else { Notation::Scientific }
    }
}

/// The value, told apart from its neighbours `step` away.
pub(crate) fn stepped(value: f64, step: f64, notation: Notation) -> String {
    let last = exponent(step);
    // What rounding leaves of zero is not a number of its own.
    if value.abs() < 0.01 * step {
        return "0".to_string();
    }
    let text = match notation {
        Notation::Plain => format!("{value:.*}", (-last).max(0) as usize),
        Notation::Scientific => {
            let power = exponent(value.abs() + 0.01 * step);
            let digits = (power - last).max(0) as usize;
            let mantissa = format!("{:.digits$}", value / power_of_ten(power));
            if mantissa == "1" { decade(power) } else { format!("{mantissa}·{}", decade(power)) }
        }
    };
    text.replace('-', "−")
}

/// Positive numbers to three digits, without zeros at the end: all plain if their size allows it.
pub(crate) fn short(values: &[f64]) -> Vec<String> {
    let rounded: Vec<f64> =
        values.iter().map(|value| format!("{value:.2e}").parse().expect("{:e} writes a number")).collect();
    let plain = rounded.iter().all(|value| (1e-2..2e4).contains(value));
    let write = |value: f64| {
        if plain {
            return value.to_string();
        }
        let scientific = format!("{value:e}");
        let (mantissa, power) = scientific.split_once('e').expect("{:e} writes an exponent");
        let power = decade(power.parse().expect("{:e} writes an exponent"));
        if mantissa == "1" { power } else { format!("{mantissa}·{power}") }
    };
    rounded.into_iter().map(write).collect()
}
