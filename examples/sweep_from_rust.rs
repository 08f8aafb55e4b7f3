//! Runs a small sweep from Rust and reads its data back: `cargo run --release --example sweep_from_rust --
//! [DIRECTORY]`.

use std::error::Error;
use std::path::PathBuf;

use stribeck_sweep::campaign::{Event, RunOptions, run};
use stribeck_sweep::store::DataSet;
use stribeck_sweep::{Column, Sweep};

const SWEEP: &str =
    "[axes]\nf = [100.0]\nalpha = [1.0]\nbeta = { from = 10.0, to = 1000.0, points = 9, scale = \"log\" }";

fn main() -> Result<(), Box<dyn Error>> {
    let temporary = tempfile::tempdir()?;
    let directory = std::env::args_os().nth(1).map_or_else(|| temporary.path().to_owned(), PathBuf::from);
    let sweep = Sweep::parse("small", SWEEP)?;
    run(&sweep, &directory, &RunOptions::default(), &mut |event| {
        if let Event::Committed { converged, failed } = event {
            println!("{converged} cases converged, {failed} failed");
        }
    })?;
    let data = DataSet::open(&directory)?;
    for (beta, friction) in data.dimensions[2].values.iter().zip(data.column(Column::MuTot)?) {
        println!("beta = {beta:6.1}: friction {friction:.5} a0/R");
    }
    Ok(())
}
