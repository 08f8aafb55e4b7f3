//! The drawing library of the page.

/// Writes Plotly as an element that the page's script runs once its words are on the screen. MathJax, which the crate
/// puts behind it, is left out: the page has no formulas.
pub(super) fn element() -> String {
    const START: &str = "<script type=\"text/javascript\">";
    const END: &str = "</script>";
    let sources = plotly::Plot::offline_js_sources();
    let script = sources.strip_prefix(START).and_then(|rest| rest.split_once(END)).map(|(script, _)| script);
    format!("<script type=\"text/plain\" id=\"plotly\">{}{END}", script.expect("the first of the crate's scripts"))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_script_is_plotly_alone_and_whole() {
        let script = super::element();
        assert!(
            script.starts_with("<script type=\"text/plain\" id=\"plotly\">/**\n* plotly.js v"),
            "{}",
            &script[..100]
        );
        assert!(script.len() > 4_000_000 && script.trim_end().ends_with("</script>"));
        assert!(!script.contains("MathJax.js ") && !script.contains("mathjax/es5"));
    }
}
