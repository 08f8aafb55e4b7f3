//! How far a tolerance and the estimated errors can be trusted, and what a case costs beside the relaxation solver: the
//! tables of `docs/explanation/accuracy.md`, from the 84 cases of `tests/reference/single_mode.csv`.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example accuracy -- [--box] [--points 401,801,1601]
//! ```
//!
//! `--box` adds the whole range of parameters, `--points` the relaxation solver with these grids.
//!
//! Exact is what the collocation solver gives for a tolerance of 1e-10 with panels of degree 12; `tests/collocation`
//! shows that this is the reference's solution. Times are given as ratios, for they depend on the machine.

mod beside_relaxation;
#[path = "../../tests/collocation/measure.rs"]
mod measure;
mod tolerances;
mod whole_box;

use std::error::Error;

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::{FieldSelection, Output, Parameters};

/// What comes of a chain, without fields and limits.
fn outcomes(settings: Settings, chain: &[Parameters]) -> Vec<SolvedCase> {
    let solver = CollocationSolver::new(settings);
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    solve_chain(&solver, chain, &output, &Interrupt::new()).expect("nobody interrupts")
}

/// What to print besides the first table.
#[derive(Default)]
struct Options {
    whole_box: bool,
    points: Vec<usize>,
}

impl Options {
    fn parse() -> Result<Self, Box<dyn Error>> {
        let mut options = Self::default();
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--box" => options.whole_box = true,
                "--points" => {
                    let list = arguments.next().ok_or("--points needs a list such as 401,801")?;
                    options.points = list.split(',').map(str::parse).collect::<Result<_, _>>()?;
                }
                _ => return Err(format!("unknown option {argument}").into()),
            }
        }
        Ok(options)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse()?;
    let cases: Vec<Parameters> = measure::reference().into_iter().map(|(parameters, _)| parameters).collect();
    // those of the reference stand in the order of β
    let chains: Vec<&[Parameters]> = cases.chunk_by(|a, b| (a.f, a.alpha) == (b.f, b.alpha)).collect();
    let alone: Vec<&[Parameters]> = cases.chunks(1).collect();

    let exact: Vec<_> = alone.iter().flat_map(|case| outcomes(measure::EXACT, case)).collect();
    let exact: Vec<_> = exact.into_iter().map(|case| case.outcome.map(|solution| solution.quantities)).collect();
    let exact = exact.into_iter().collect::<Result<Vec<_>, _>>().map_err(|failure| failure.to_string())?;

    tolerances::print("Each case alone", &alone, &exact);
    if options.whole_box {
        println!("The whole box, each case alone:\n");
        whole_box::print();
    }
    if !options.points.is_empty() {
        println!("Beside the relaxation solver:\n");
        beside_relaxation::print(&options.points, &chains, &exact);
    }
    Ok(())
}
