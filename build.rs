//! Makes what the program holds of the page of `stribeck report`.

#[path = "build/plotly.rs"]
mod plotly;

fn main() {
    println!("cargo::rerun-if-changed=build");
    plotly::write();
}
