//! Makes what the program holds of the page of `stribeck report`: its scripts, joined into one (`page.js`), and
//! Plotly's, deflated (`plotly.deflate`), both in the directory of build products. Tells the program its version.

use std::collections::BTreeMap;
use std::path::Path;
use std::{env, fs};

#[path = "build/commit.rs"]
mod commit;
#[path = "build/modules.rs"]
mod modules;
#[path = "build/plotly.rs"]
mod plotly;

const SCRIPTS: &str = "assets/report";

fn main() {
    println!("cargo::rerun-if-changed={SCRIPTS}");
    println!("cargo::rerun-if-changed=build");
    commit::hand_over();
    plotly::write();
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(SCRIPTS).expect("assets/report is listed") {
        let path = entry.expect("assets/report is listed").path();
        let name = path.file_name().and_then(|name| name.to_str()).expect("scripts have plain names").to_owned();
        if name.ends_with(".js") {
            files.insert(name, fs::read_to_string(&path).expect("a script is read"));
        }
    }
    match modules::join(&files, "page.js") {
        Ok(script) => {
            let directory = env::var("OUT_DIR").expect("cargo names it");
            fs::write(Path::new(&directory).join("page.js"), script).expect("the script is written");
        }
        Err(mistake) => println!("cargo::error={SCRIPTS}/{mistake}"),
    }
}
