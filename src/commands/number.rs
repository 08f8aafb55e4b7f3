//! Numbers of the command line.

/// A number of double precision. One that overflows is none, as in a sweep file: infinity is written as inf.
pub fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    // −0 is 0.
    text.parse().ok().filter(|number: &f64| number.is_finite() || text.contains(['n', 'N'])).map(|number| number + 0.0)
}

/// The same for an option.
///
/// # Errors
/// What is allowed.
pub fn parse(text: &str) -> Result<f64, String> {
    number(text).ok_or_else(|| "give a number of double precision, as in 0.01 or 1e-3".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_overflows_is_no_number() {
        assert_eq!(["1e3", " -2 ", "inf", "-0"].map(number), [Some(1e3), Some(-2.0), Some(f64::INFINITY), Some(0.0)]);
        assert_eq!(["1e309", "-1e999", "", "1,5", "x"].map(number), [None; 5]);
    }
}
