//! A value with its standard error in short: `4.5(5) ms`.

/// Prefixes of units, with their powers of ten.
const PREFIXES: [(i32, &str); 7] = [(-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G")];

/// A value with the error of its last digits in brackets, and its unit with a prefix; `1` is no unit. Without an error
/// it has four digits.
pub fn short(value: f64, error: f64, unit: &str) -> String {
    let power = (value.abs().log10() / 3.0).floor() as i32 * 3;
    let known = PREFIXES.into_iter().find(|(known, _)| *known == power).filter(|_| unit != "1");
    let (power, unit) = match known {
        Some((power, prefix)) => (power, format!(" {prefix}{unit}")),
        None if unit == "1" && (-3..=0).contains(&power) => (0, String::new()),
        None if unit == "1" => (power, format!("e{power}")),
        None => (power, format!("e{power} {unit}")),
    };
    let scale = 10_f64.powi(power);
    let (value, error) = (value / scale, error / scale);
    if !(error > 0.0 && error.is_finite()) {
        let digits = (3 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
        return format!("{value:.digits$}{unit}");
    }
    // one digit of the error, two where the first is 1
    let first = error.log10().floor() as i32;
    let two = i32::from(error / 10_f64.powi(first) < 1.95);
    let last = (first - two).max(-15);
    let step = 10_f64.powi(last);
    let digits = usize::try_from(-last).unwrap_or(0);
    let rounded = (error / step).round() * if last > 0 { step } else { 1.0 };
    let value = if last > 0 { (value / step).round() * step } else { value };
    format!("{value:.digits$}({rounded:.0}){unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_stand_behind_the_digits_that_they_are_of() {
        for (value, error, unit, expected) in [
            (4.46e-3, 0.52e-3, "s", "4.5(5) ms"),
            (4.46e-3, 0.14e-3, "s", "4.46(14) ms"),
            (1.0012e5, 340.0, "Pa", "100.1(3) kPa"),
            (5.1, 0.01, "Pa s", "5.100(10) Pa s"),
            (9.81, 2.3, "1", "10(2)"),
            (312.0, 40.0, "1", "310(40)"),
            (4.5e5, 2e4, "1", "450(20)e3"),
            (100.0, f64::NAN, "1", "100.0"),
            (1.5e12, 1e11, "Pa", "1.50(10)e12 Pa"),
        ] {
            assert_eq!(short(value, error, unit), expected, "{value} {error} {unit}");
        }
    }
}
