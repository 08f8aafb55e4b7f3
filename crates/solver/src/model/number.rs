//! Numbers in messages.

/// 10, 0.25, 1e-300: the shortest text that reads back as the same number.
pub fn shortest(number: f64) -> String {
    let text = format!("{number:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        let numbers = [0.0, 10.0, 0.25, 1e-300, 1e14, 1e60, 0.1 + 0.2, f64::INFINITY];
        assert_eq!(numbers.map(shortest)[..6], ["0", "10", "0.25", "1e-300", "100000000000000", "1e60"]);
        for number in numbers {
            assert_eq!(shortest(number).parse(), Ok(number));
        }
    }
}
