//! Makes what the program holds of the pages of `stribeck report`: their scripts, joined into one for each kind of page
//! (`page.js` and others), and large files, deflated, in the directory of build products. Tells the program its version.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

#[path = "build/commit.rs"]
mod commit;
#[path = "build/deflated.rs"]
mod deflated;
#[path = "build/modules.rs"]
mod modules;

const SCRIPTS: &str = "assets/report";
/// The reader of surfaces, which pages share with others.
const READER: &str = "assets/surface.js";
/// The modules that a page may begin with.
const ENTRIES: [&str; 3] = ["page.js", "page_with_surface.js", "surface_page.js"];

fn main() {
    println!("cargo::rerun-if-changed={SCRIPTS}");
    println!("cargo::rerun-if-changed={READER}");
    println!("cargo::rerun-if-changed=build");
    commit::hand_over();
    deflated::write();
    let mut files = BTreeMap::new();
    let paths = fs::read_dir(SCRIPTS).expect("assets/report is listed");
    let paths = paths.map(|entry| entry.expect("assets/report is listed").path());
    for path in paths.chain([PathBuf::from(READER)]) {
        let name = path.file_name().and_then(|name| name.to_str()).expect("scripts have plain names").to_owned();
        if name.ends_with(".js") {
            files.insert(name, fs::read_to_string(&path).expect("a script is read"));
        }
    }
    match modules::join(&files, &ENTRIES) {
        Ok(scripts) => {
            let directory = env::var("OUT_DIR").expect("cargo names it");
            for (entry, script) in ENTRIES.iter().zip(scripts) {
                fs::write(Path::new(&directory).join(entry), script).expect("the script is written");
            }
        }
        Err(mistake) => println!("cargo::error={SCRIPTS}/{mistake}"),
    }
}
