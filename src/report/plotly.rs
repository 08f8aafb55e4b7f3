//! The drawing library of the page.

/// Plotly's script, deflated by `build.rs`.
const DEFLATED: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/plotly.deflate"));

/// Writes Plotly as an element that the page's script runs once its words are on the screen.
pub(super) fn element() -> String {
    let script = miniz_oxide::inflate::decompress_to_vec(DEFLATED).expect("the build has deflated it");
    let script = String::from_utf8(script).expect("the build has deflated a text");
    format!("<script type=\"text/plain\" id=\"plotly\">{script}</script>")
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_script_is_a_part_of_plotly_and_whole() {
        let script = super::element();
        assert!(script.starts_with("<script type=\"text/plain\" id=\"plotly\">/*! plotly.js v"), "{}", &script[..100]);
        assert!((1_000_000..2_000_000).contains(&script.len()) && script.trim_end().ends_with("</script>"));
        // Nothing in it ends the element before its end.
        assert_eq!(script.matches("</script").count(), 1);
    }
}
