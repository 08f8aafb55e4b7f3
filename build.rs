//! Joins the scripts of the page of `stribeck report` into one: `page.js` in the directory of build products.

use std::collections::BTreeMap;
use std::path::Path;
use std::{env, fs};

#[path = "build/modules.rs"]
mod modules;

const SCRIPTS: &str = "assets/report";

fn main() {
    println!("cargo::rerun-if-changed={SCRIPTS}");
    println!("cargo::rerun-if-changed=build");
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
