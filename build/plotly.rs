//! The drawing library of the page of `stribeck report`: Plotly's script, as the crate `plotly` brings it along.
//!
//! The crate is needed while building alone. The program holds the script deflated, 1.4 MB for 4.6.

use std::path::Path;
use std::{env, fs};

/// Writes the script, deflated, to `plotly.deflate` in the directory of build products.
pub fn write() {
    const START: &str = "<script type=\"text/javascript\">";
    // The crate puts MathJax behind Plotly, and the page has no formulas for it.
    let sources = plotly::Plot::offline_js_sources();
    let script = sources.strip_prefix(START).and_then(|rest| rest.split_once("</script>")).map(|(script, _)| script);
    let script = script.expect("Plotly is the first of the crate's scripts");
    let directory = env::var("OUT_DIR").expect("cargo names it");
    let deflated = miniz_oxide::deflate::compress_to_vec(script.as_bytes(), 6);
    fs::write(Path::new(&directory).join("plotly.deflate"), deflated).expect("the script is written");
}
