//! Numbers and units as people write them.

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

/// The number at the beginning of a text, be its decimal mark a point or a comma, and what follows.
pub(crate) fn parts(text: &str) -> (&str, &str) {
    let text = text.trim();
    let in_number = |(place, c): (usize, char)| {
        let exponent = |rest: &str| rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit());
        match c {
            '0'..='9' | '.' => true,
            ',' => text[place + 1..].starts_with(|c: char| c.is_ascii_digit()),
            '+' | '-' => place == 0 || text[..place].ends_with(['e', 'E']),
            'e' | 'E' => place > 0 && exponent(&text[place + 1..]),
            _ => false,
        }
    };
    let end = text.char_indices().find(|&at| !in_number(at)).map_or(text.len(), |(place, _)| place);
    (&text[..end], &text[end..])
}

/// A number after a look at its commas.
pub(crate) enum Comma {
    /// It has none any more: a decimal comma is a point now.
    None(String),
    /// Its comma is a decimal mark or stands between thousands, as in 1,500.
    Ambiguous,
}

/// A number with a point for its decimal comma.
pub(crate) fn with_point(number: &str) -> Comma {
    let is_group = |after: &str| after.len() == 3 && after.bytes().all(|byte| byte.is_ascii_digit());
    let thousands = number
        .trim_start_matches(['+', '-'])
        .split_once(',')
        .is_some_and(|(before, after)| (1..=3).contains(&before.len()) && !before.starts_with('0') && is_group(after));
    if thousands { Comma::Ambiguous } else { Comma::None(number.replace(',', ".")) }
}

/// A unit in one way of writing: one · between factors, one / at most, none of them beside the other, signs for micro,
/// degrees and powers.
pub(crate) fn canonical(unit: &str) -> String {
    let signs = [("⋅", "·"), ("*", "·"), (".", "·"), ("^", ""), ("μ", "µ"), ("⁻", "-"), ("¹", "1"), ("²", "2")];
    let mut text = signs.iter().fold(unit.to_owned(), |text, (from, to)| text.replace(from, to));
    for (from, to) in [("Pa-s", "Pa·s"), ("Pas", "Pa·s"), ("degC", "°C"), ("degF", "°F"), ("deg", "°")] {
        text = text.replace(from, to);
    }
    let words = text.split(|c: char| c == '·' || c.is_whitespace()).filter(|word| !word.is_empty());
    let (below, above): (Vec<&str>, Vec<&str>) = words.partition(|word| negative(word).is_some());
    let joined = above.join("·").replace("·/", "/").replace("/·", "/");
    let joined = match below.iter().filter_map(|word| negative(word)).collect::<Vec<String>>() {
        below if below.is_empty() => joined,
        below if joined.is_empty() => format!("1/{}", below.join("·")),
        below => format!("{joined}/{}", below.join("·")),
    };
    let powers = joined.replace('2', "²");
    match powers.strip_prefix('u') {
        // micro where there is no such letter at hand; no unit known here begins with u
        Some(rest) if !rest.is_empty() => format!("µ{rest}"),
        _ => powers,
    }
}

/// A factor with a negative power, as it stands below the line: `s-1` is s, `m-2` is m2.
fn negative(word: &str) -> Option<String> {
    let (base, power) = word.split_once('-')?;
    match power {
        _ if !base.ends_with(char::is_alphabetic) => None,
        "1" => Some(base.to_owned()),
        "2" => Some(format!("{base}2")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            ("1,5 m", ("1,5", " m")),
            ("1, 5 m", ("1", ", 5 m")),
        ] {
            assert_eq!(parts(text), expected, "{text}");
        }
    }

    #[test]
    fn a_comma_is_a_decimal_mark_where_it_cannot_be_another() {
        let read = |text: &str| match with_point(text) {
            Comma::None(number) => Some(number),
            Comma::Ambiguous => None,
        };
        for (text, number) in [("1,5", "1.5"), ("0,125", "0.125"), ("-12,5e3", "-12.5e3"), ("1500,250", "1500.250")] {
            assert_eq!(read(text).as_deref(), Some(number));
        }
        assert!(["1,500", "-12,345"].into_iter().all(|text| read(text).is_none()));
    }
}
