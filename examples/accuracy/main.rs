//! How far a tolerance and the estimated errors can be trusted, and what a case costs beside the relaxation solver: the tables
//! of `docs/accuracy.md`, from the 84 cases of `tests/reference/single_mode.csv`.
//!
//! ```text
//! cargo run --release --example accuracy -- [--points 401,801,1601]
//! ```
//!
//! Exact is what the collocation solver gives for a tolerance of 1e-10 with panels of degree 12; `tests/collocation` shows that this is the
//! reference's solution. Times are given as ratios, for they depend on the machine.

mod beside_relaxation;
#[path = "../../tests/collocation/measure.rs"]
mod measure;
mod tolerances;

use std::error::Error;

use stribeck::collocation::{CollocationSolver, Settings};
use stribeck::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck::model::{FieldSelection, Output, Parameters};

/// What comes of a chain, without fields and limits.
fn outcomes(settings: Settings, chain: &[Parameters]) -> Vec<SolvedCase> {
    let solver = CollocationSolver::new(settings);
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    solve_chain(&solver, chain, &output, &Interrupt::new()).expect("nobody interrupts")
}

fn points() -> Result<Vec<usize>, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => Ok(vec![401, 801, 1601]),
        ["--points", list] => Ok(list.split(',').map(str::parse).collect::<Result<_, _>>()?),
        _ => Err("usage: accuracy [--points 401,801,1601]".into()),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let points = points()?;
    let cases: Vec<Parameters> = measure::reference().into_iter().map(|(parameters, _)| parameters).collect();
    // those of the reference stand in the order of β
    let chains: Vec<&[Parameters]> = cases.chunk_by(|a, b| (a.f, a.alpha) == (b.f, b.alpha)).collect();
    let alone: Vec<&[Parameters]> = cases.chunks(1).collect();

    let exact: Vec<_> = alone.iter().flat_map(|case| outcomes(measure::EXACT, case)).collect();
    let exact: Vec<_> = exact.into_iter().map(|case| case.outcome.map(|solution| solution.quantities)).collect();
    let exact = exact.into_iter().collect::<Result<Vec<_>, _>>().map_err(|failure| failure.reason)?;

    println!("## What a tolerance keeps\n");
    tolerances::print("Each case alone", &alone, &exact);
    tolerances::print("Chains of four β, a decade apart", &chains, &exact);
    println!("## Beside the relaxation solver\n");
    beside_relaxation::print(&points, &chains, &exact);
    Ok(())
}
