//! Why cases failed, in words.

/// A reason without its numbers: what is left is the same for failures of the same kind.
pub fn kind_of_reason(reason: &str) -> String {
    reason.split_whitespace().filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::kind_of_reason;

    #[test]
    fn reasons_that_differ_in_numbers_are_alike() {
        let one = kind_of_reason("from elastic: stalled: residual 3.0e-2 after 900 passes, tolerance 1.0e-8");
        assert_eq!(one, kind_of_reason("from elastic: stalled: residual 4.1e-5 after 12 passes, tolerance 1.0e-8"));
        assert_ne!(one, kind_of_reason("from elastic: diverged: residual 3.0e-2 after 900 passes, tolerance 1.0e-8"));
    }
}
