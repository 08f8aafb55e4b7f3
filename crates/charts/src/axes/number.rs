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

/// The largest power of ten not above a finite `value` > 0, as exponent; exact for powers of ten.
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
    /// What suits numbers up to this size, whose last digit counts this power of ten.
    pub(crate) fn of(largest: f64, last: i32) -> Self {
        if (1e-4..1e5).contains(&largest) && last >= -5 { Notation::Plain } else { Notation::Scientific }
    }
}

/// The value to the digit that counts ten to the power `last`.
pub(crate) fn stepped(value: f64, last: i32, notation: Notation) -> String {
    match notation {
        _ if value == 0.0 => "0".to_string(),
        Notation::Plain => format!("{value:.*}", (-last).max(0) as usize).replace('-', "−"),
        Notation::Scientific => {
            let digits = (exponent(value.abs()) - last).max(0) as usize;
            scientific(&format!("{value:.digits$e}"))
        }
    }
}

/// The value in as many digits as tell it from all other numbers.
pub(crate) fn exact(value: f64) -> String {
    if value == 0.0 { "0".to_string() } else { scientific(&format!("{value:e}")) }
}

/// "2.5e-3" as a reader writes it.
fn scientific(text: &str) -> String {
    let (mantissa, power) = text.split_once('e').expect("{:e} writes an exponent");
    let power = decade(power.parse().expect("{:e} writes an exponent"));
    if mantissa == "1" { power } else { format!("{}·{power}", mantissa.replace('-', "−")) }
}

/// Positive numbers to three digits, without zeros at the end: all plain if their size allows it.
pub(crate) fn short(values: &[f64]) -> Vec<String> {
    // The largest numbers would round to infinity.
    let round = |value: &f64| format!("{value:.2e}").parse::<f64>().expect("{:e} writes a number").min(1.79e308);
    let rounded: Vec<f64> = values.iter().map(round).collect();
    let plain = rounded.iter().all(|value| (1e-2..2e4).contains(value));
    rounded.into_iter().map(|value| if plain { value.to_string() } else { exact(value) }).collect()
}
