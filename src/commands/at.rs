//! Values of axes on the command line: `speed=3 mm/s,load=200 N/m`.

use super::number::number;
use stribeck_lab::LaboratoryQuantity;

/// Axes, each with the values asked for, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct At(pub Vec<(String, Vec<f64>)>);

/// Reads axes with their values; a quantity of the laboratory may have a unit.
///
/// # Errors
/// How they are written.
pub fn parse(text: &str) -> Result<At, String> {
    let usage = || "an axis and values of it, as in speed=0.001,0.01 or \"speed=3 mm/s,load=200 N/m\"".to_owned();
    let mut axes: Vec<(String, Vec<f64>)> = Vec::new();
    let pieces: Vec<&str> = text.split(',').collect();
    refuse_decimal_comma(&pieces)?;
    for piece in pieces {
        let written = match piece.split_once('=') {
            Some((axis, written)) if !axis.trim().is_empty() => {
                axes.push((axis.trim().to_owned(), Vec::new()));
                written
            }
            Some(_) => return Err(usage()),
            None => piece,
        };
        let (axis, values) = axes.last_mut().ok_or_else(usage)?;
        values.push(value(axis, written.trim().trim_matches('"')).ok_or_else(usage)??);
    }
    Ok(At(axes))
}

/// Refuses `3,5 mm/s`, which would be 3 m/s and 5 mm/s.
fn refuse_decimal_comma(pieces: &[&str]) -> Result<(), String> {
    let ends_in_digit = |piece: &str| piece.ends_with(|c: char| c.is_ascii_digit());
    let is_digits_and_unit = |piece: &str| {
        let unit = piece.trim_start_matches(|c: char| c.is_ascii_digit());
        number(piece).is_none()
            && unit.len() < piece.len()
            && unit.trim_start().starts_with(|c: char| c.is_alphabetic() || "%°".contains(c))
    };
    match pieces.windows(2).find(|pair| ends_in_digit(pair[0]) && is_digits_and_unit(pair[1])) {
        Some(pair) => Err(format!(
            "commas stand between values, so \"{},{}\" is two; write a point as decimal mark, or each with its unit",
            pair[0], pair[1]
        )),
        None => Ok(()),
    }
}

/// The axes of all options.
pub fn all(options: &[At]) -> Vec<(String, Vec<f64>)> {
    options.iter().flat_map(|At(axes)| axes.clone()).collect()
}

/// A value of an axis; `None` if it is no number.
fn value(axis: &str, text: &str) -> Option<Result<f64, String>> {
    match (number(text), LaboratoryQuantity::named(axis)) {
        (Some(value), _) if !value.is_nan() => Some(Ok(value)),
        (None, Some(quantity)) if !text.is_empty() => Some(quantity.parse(text)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_units_where_they_are_quantities() {
        let axes = |text: &str| parse(text).map(|At(axes)| axes);
        let pair = |name: &str, values: &[f64]| (name.to_owned(), values.to_vec());
        assert_eq!(axes("speed=3 mm/s,load=200 N/m"), Ok(vec![pair("speed", &[3e-3]), pair("load", &[200.0])]));
        assert_eq!(axes("speed=\"3 mm/s\",0.01"), Ok(vec![pair("speed", &[3e-3, 0.01])]));
        assert_eq!(
            axes("slide_roll_ratio=50 %,alpha=inf"),
            Ok(vec![pair("slide_roll_ratio", &[0.5]), pair("alpha", &[f64::INFINITY])])
        );
        assert!(axes("load=3 mm").unwrap_err().contains("a length, not a load per length"));
        for comma in ["speed=3,5 mm/s", "speed=3,5mm/s,load=1", "slide_roll_ratio=0,5 %", "temperature=20,5 °C"] {
            assert!(axes(comma).unwrap_err().contains("write a point as decimal mark"), "{comma}");
        }
        assert_eq!(axes("speed=3 mm/s,5 mm/s"), Ok(vec![pair("speed", &[3e-3, 5e-3])]));
        assert_eq!(axes("speed=3,5"), Ok(vec![pair("speed", &[3.0, 5.0])]));
        assert_eq!(axes("beta=10,1e2"), Ok(vec![pair("beta", &[10.0, 100.0])]));
        for bad in ["", "speed", "=1", "speed=", "alpha=3 mm", "3,speed=1"] {
            assert!(axes(bad).unwrap_err().contains("as in speed=0.001,0.01"), "{bad}");
        }
    }
}
