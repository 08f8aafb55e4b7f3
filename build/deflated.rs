//! Large files that the program holds deflated: the drawing library of the page of `stribeck report`, which are the parts
//! of Plotly's script that `scripts/plotly-bundle` took (0.6 MB for 1.7), and the built-in surface (0.35 MB for 0.46).

use std::path::Path;
use std::{env, fs};

/// Each file, and the name of what is made of it.
const FILES: [(&str, &str); 2] =
    [("assets/plotly/plotly.min.js", "plotly.deflate"), ("assets/universe.json", "universe.deflate")];

/// Writes the files, deflated, to the directory of build products.
pub fn write() {
    let directory = env::var("OUT_DIR").expect("cargo names it");
    for (path, deflated) in FILES {
        println!("cargo::rerun-if-changed={path}");
        let content = fs::read(path).expect("an asset is read");
        let content = miniz_oxide::deflate::compress_to_vec(&content, 8);
        fs::write(Path::new(&directory).join(deflated), content).expect("an asset is written");
    }
}
