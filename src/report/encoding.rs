//! Numbers and texts inside the page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Numbers as base64 of 32-bit floats, seven digits of each; NaN and ∞ stay what they are.
pub(super) fn floats(values: impl IntoIterator<Item = f64>) -> String {
    STANDARD.encode(values.into_iter().flat_map(|value| (value as f32).to_le_bytes()).collect::<Vec<u8>>())
}

/// Integers as base64 of 32 bits each.
pub(super) fn integers(values: impl IntoIterator<Item = i32>) -> String {
    STANDARD.encode(values.into_iter().flat_map(i32::to_le_bytes).collect::<Vec<u8>>())
}

/// Integers as base64 of 16 bits each.
pub(super) fn shorts(values: impl IntoIterator<Item = u16>) -> String {
    STANDARD.encode(values.into_iter().flat_map(u16::to_le_bytes).collect::<Vec<u8>>())
}

/// JSON that can stand inside a `<script>` element, whatever its strings hold: `<` is written as an escape, so that nothing
/// in it ends the element or begins a comment.
pub(super) fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("texts, finite numbers and lists are JSON").replace('<', "\\u003c")
}

/// Text as HTML. A carriage return is written as a reference, or the browser would read a line feed.
pub(super) fn html(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.replace('\r', "&#13;")
}

/// Numbers between a lowest and a highest one, in 16 bits each.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Quantised {
    /// The lowest and the highest value; their decimal logarithms if `logarithmic`.
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) logarithmic: bool,
    /// 0 at the lowest value, 65535 at the highest.
    pub(super) steps: Vec<u16>,
}

/// Steps between the lowest and the highest value.
const STEPS: f64 = 65535.0;

impl Quantised {
    /// Positive values over more than a decade keep their relative accuracy, others their absolute one: at worst half a step of
    /// their range.
    pub(super) fn of(values: &[f64]) -> Self {
        let ends = |values: &[f64]| {
            values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
        };
        let (least, most) = ends(values);
        let logarithmic = least > 0.0 && most > 10.0 * least;
        let places: Vec<f64> = if logarithmic { values.iter().map(|v| v.log10()).collect() } else { values.to_vec() };
        let (low, high) = ends(&places);
        let span = if high > low { high - low } else { 1.0 };
        let steps = places.iter().map(|place| ((place - low) / span * STEPS).round() as u16).collect();
        Self { low, high: low + span, logarithmic, steps }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn no_text_ends_the_element_it_stands_in(text in any::<String>()) {
            for text in [text.clone(), format!("</script>{text}<!--"), format!("{text}]]></SCRIPT ")] {
                let written = json(&text);
                prop_assert!(!written.contains('<'));
                prop_assert_eq!(&serde_json::from_str::<String>(&written).unwrap(), &text);
                prop_assert!(!html(&text).contains(['<', '>', '"']));
            }
        }

        #[test]
        fn numbers_come_back_to_half_a_step(values in prop::collection::vec(prop_oneof![-5.0..5.0f64, 1e-7..1e2f64], 1..50)) {
            let Quantised { low, high, logarithmic, steps } = Quantised::of(&values);
            for (value, step) in values.iter().zip(steps) {
                let place = low + (high - low) * f64::from(step) / STEPS;
                if logarithmic {
                    // Nine decades in 65535 steps: 1.6e-4.
                    prop_assert!((10_f64.powf(place) / value - 1.0).abs() < 2e-4);
                } else {
                    prop_assert!((place - value).abs() <= 0.51 * (high - low) / STEPS);
                }
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
