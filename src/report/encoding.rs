//! Numbers and texts inside the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Writes numbers as base64 of 32-bit floats, seven digits of each; NaN and ∞ stay what they are.
pub(super) fn floats(values: impl IntoIterator<Item = f64>) -> String {
    STANDARD.encode(values.into_iter().flat_map(|value| (value as f32).to_le_bytes()).collect::<Vec<u8>>())
}

/// Writes integers as base64 of 32 bits each.
pub(super) fn integers(values: impl IntoIterator<Item = i32>) -> String {
    STANDARD.encode(values.into_iter().flat_map(i32::to_le_bytes).collect::<Vec<u8>>())
}

/// Writes integers as base64 of 16 bits each.
pub(super) fn shorts(values: impl IntoIterator<Item = u16>) -> String {
    STANDARD.encode(values.into_iter().flat_map(u16::to_le_bytes).collect::<Vec<u8>>())
}

/// Writes JSON that can stand inside a `<script>` element, whatever its strings hold: `<` is written as an escape, so
/// that nothing in it ends the element or begins a comment.
pub(super) fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("texts, finite numbers and lists are JSON").replace('<', "\\u003c")
}

/// Writes text as HTML. A carriage return is written as a reference, or the browser would read a line feed.
pub(super) fn html(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.replace('\r', "&#13;")
}

/// Steps between the lowest and the highest value of a field.
const STEPS: f64 = 65535.0;

/// Where a value lies in the range of its field, from 0 to 1, in steps of 16 bits.
pub(super) fn step(share: f64) -> u16 {
    (share * STEPS).round() as u16
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn no_text_ends_the_element_it_stands_in(text in any::<String>()) {
            for text in [text.clone(), format!("</script>{text}<!--"), format!("{text}]]></SCRIPT ")] {
                let written = json(&text);
                prop_assert!(!written.contains('<'));
                prop_assert_eq!(&serde_json::from_str::<String>(&written).unwrap(), &text);
                prop_assert!(!html(&text).contains(['<', '>', '"']));
            }
        }
    }

    #[test]
    fn numbers_are_little_endian() {
        assert_eq!(floats([1.0]), "AACAPw==");
        assert_eq!(integers([-1, 1]), "/////wEAAAA=");
        assert_eq!(shorts([258]), "AgE=");
    }
}
