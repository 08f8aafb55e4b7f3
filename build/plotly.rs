//! The drawing library of the page of `stribeck report`: the parts of Plotly's script that `scripts/plotly-bundle` took.
//!
//! The program holds the script deflated, 0.6 MB for 1.7.

use std::path::Path;
use std::{env, fs};

const SCRIPT: &str = "assets/plotly/plotly.min.js";

/// Writes the script, deflated, to `plotly.deflate` in the directory of build products.
pub fn write() {
    println!("cargo::rerun-if-changed={SCRIPT}");
    let script = fs::read(SCRIPT).expect("the script is read");
    let directory = env::var("OUT_DIR").expect("cargo names it");
    let deflated = miniz_oxide::deflate::compress_to_vec(&script, 6);
    fs::write(Path::new(&directory).join("plotly.deflate"), deflated).expect("the script is written");
}
