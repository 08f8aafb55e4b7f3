//! The relaxation solver held against collocation, whose errors are known: over the range of the paper, and far
//! outside.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example relaxation_range -- \
//!     [--points 801] [--plain] [--alpha 1e-3,1e-2] [--box 400] [--list]
//! ```
//!
//! Without `--box`: f = 10 and 100, α from 10⁻³ to 10³ (`--alpha`: only these), five β from 10 to 1000, in chains of
//! ascending β. With it: so many cases, each alone, spread evenly over ln α, ln β and ln f of a box that holds far more
//! than the method can do; every other one has two retardation times six decades apart. `--list` prints each case.
//! `--plain` takes the paper's plain iteration. Times are given as ratios, for they depend on the machine.

mod comparison;
#[path = "../../tests/relaxation/far_cases.rs"]
mod far_cases;
mod flow_error;
mod paper;
mod wide_box;

use std::error::Error;

use stribeck_solver::Parameters;
use stribeck_solver::relaxation::{Acceleration, Settings};

use comparison::Compared;

struct Options {
    settings: Settings,
    alphas: Vec<f64>,
    box_cases: usize,
    list: bool,
}

impl Options {
    fn parse() -> Result<Self, Box<dyn Error>> {
        let alphas = (-3..=3).map(|exponent| 10_f64.powi(exponent)).collect();
        let mut options = Self { settings: Settings::default(), alphas, box_cases: 0, list: false };
        let mut arguments = std::env::args().skip(1);
        while let Some(name) = arguments.next() {
            match name.as_str() {
                "--plain" => options.settings.acceleration = Acceleration::None,
                "--list" => options.list = true,
                _ => {
                    let value = arguments.next().ok_or_else(|| format!("{name} needs a value"))?;
                    match name.as_str() {
                        "--points" => options.settings.points = value.parse()?,
                        "--alpha" => options.alphas = value.split(',').map(str::parse).collect::<Result<_, _>>()?,
                        "--box" => options.box_cases = value.parse()?,
                        _ => return Err(format!("unknown option {name}").into()),
                    }
                }
            }
        }
        Ok(options)
    }
}

/// One row for each case.
fn print_cases(cases: &[Compared]) {
    println!("| modes | f | α | β | c | u_min | F_v | F_h | flow error | passes | seconds | seed, reason |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for case in cases {
        let Parameters { alpha, beta, f, substrate } = &case.parameters;
        let numbers = match &case.deviations {
            Ok(found) => {
                let [c, film_min, viscoelastic, hydrodynamic] = found.relative;
                format!("{c:.1e} | {film_min:.1e} | {viscoelastic:.1e} | {hydrodynamic:.1e} | {:.1e}", found.flow)
            }
            Err(_) => "failed | | | |".to_owned(),
        };
        let reason = case.deviations.as_ref().err().map_or("", |reason| reason);
        println!(
            "| {} | {f:.3e} | {alpha:.3e} | {beta:.3e} | {numbers} | {} | {:.2} | {} {reason} |",
            substrate.modes().len(),
            case.passes,
            case.seconds,
            case.seed
        );
    }
    println!();
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse()?;
    let cases = match options.box_cases {
        0 => paper::solve(options.settings, &options.alphas),
        count => wide_box::solve(options.settings, count),
    };
    if options.list {
        print_cases(&cases);
    }
    match options.box_cases {
        0 => paper::print(&cases, &options.alphas),
        _ => wide_box::print(&cases),
    }
    Ok(())
}
