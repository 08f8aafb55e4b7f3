//! What becomes of stiff and extreme cases: the table of `docs/explanation/extremes.md`.
//!
//! ```text
//! cargo run --release -p stribeck-sweep --example extremes -- [--sample N] [--edge]
//! ```
//!
//! One row for each of the shipped sets, and with `--sample` one for so many cases out of the whole box. Cases that
//! fail, and those whose error is above the tolerance, are listed below the table. `--edge` looks for the β from which
//! on cases fail.

#[allow(dead_code, reason = "shared with tests, which need the rest of it")]
#[path = "../../tests/extremes/cases.rs"]
mod cases;
mod edge;
#[allow(dead_code, reason = "shared with tests, which need the rest of it")]
#[path = "../../../solver/tests/collocation/measure.rs"]
mod measure;

use std::error::Error;

use rayon::prelude::*;

use cases::{SHIPPED, Set, Verdict, verdicts};

fn main() -> Result<(), Box<dyn Error>> {
    let mut sample = 0;
    let mut edge = false;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--sample" => sample = arguments.next().ok_or("--sample needs a number of cases")?.parse()?,
            "--edge" => edge = true,
            _ => return Err(format!("unknown option {argument}").into()),
        }
    }
    if edge {
        edge::print();
        return Ok(());
    }
    println!(
        "| set | tolerance | cases | converged | failed | compared | error above the tolerance | worst error/tolerance | most iterations | longest, s |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut remarks = Vec::new();
    for name in SHIPPED {
        print(name, &Set::shipped(name), &mut remarks);
    }
    if sample > 0 {
        print("sample of the box", &Set::sample(sample), &mut remarks);
    }
    println!();
    for remark in remarks {
        println!("- {remark}");
    }
    Ok(())
}

/// Prints the row of a set.
fn print(name: &str, set: &Set, remarks: &mut Vec<String>) {
    let chains = set.chains.par_iter().with_max_len(1);
    let verdicts: Vec<Verdict> = chains.flat_map_iter(|chain| verdicts(set.settings, chain)).collect();
    let errors: Vec<f64> = verdicts.iter().filter_map(|verdict| verdict.error).collect();
    let failed = verdicts.iter().filter(|verdict| verdict.solved.outcome.is_err()).count();
    let efforts = verdicts.iter().map(|verdict| verdict.solved.effort);
    println!(
        "| {name} | {:.0e} | {} | {} | {failed} | {} | {} | {:.2} | {} | {:.1} |",
        set.settings.tolerance,
        verdicts.len(),
        verdicts.len() - failed,
        errors.len(),
        errors.iter().filter(|error| **error > 1.0).count(),
        errors.iter().copied().fold(0.0, f64::max),
        efforts.clone().map(|effort| effort.iterations).max().unwrap_or(0),
        efforts.map(|effort| effort.seconds).fold(0.0, f64::max),
    );
    for Verdict { case, solved, error } in &verdicts {
        let modes: Vec<String> =
            case.substrate.modes().iter().map(|mode| format!("{:.2} at {:.1e}", mode.share, mode.time)).collect();
        let place = format!(
            "{name}: f = {:.4e}, α = {:.4e}, β = {:.4e}, modes {}",
            case.f,
            case.alpha,
            case.beta,
            modes.join(", ")
        );
        match (&solved.outcome, error) {
            (Err(failure), _) => remarks.push(format!("{place}: {failure}")),
            (Ok(_), Some(error)) if *error > 1.0 => remarks.push(format!("{place}: {error:.2} times the tolerance")),
            (Ok(_), None) => remarks.push(format!("{place}: not solved again")),
            _ => {}
        }
    }
}
