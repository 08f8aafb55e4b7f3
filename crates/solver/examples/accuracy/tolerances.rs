//! True errors, estimated errors and costs for each tolerance.

use stribeck_solver::collocation::Settings;
use stribeck_solver::continuation::SolvedCase;
use stribeck_solver::{Parameters, Quantities};

use crate::measure::{TOLERANCES, quantile, true_error, worst};
use crate::outcomes;

/// How often each tolerance is timed; the shortest time of a case counts.
const REPETITIONS: usize = 3;
/// Times are relative to this tolerance.
const USUAL: f64 = 1e-5;

/// A case solved for one tolerance.
struct Measured {
    error: f64,
    estimate: f64,
    iterations: f64,
    factorisations: f64,
    unknowns: f64,
    seconds: f64,
}

impl Measured {
    fn new(case: &SolvedCase, exact: &Quantities) -> Option<Self> {
        let solution = case.outcome.as_ref().ok()?;
        Some(Self {
            error: true_error(&solution.quantities, exact),
            estimate: worst(&solution.errors),
            iterations: case.effort.iterations as f64,
            factorisations: case.effort.factorisations as f64,
            unknowns: case.effort.unknowns as f64,
            seconds: case.effort.seconds,
        })
    }
}

/// Solves all chains for one tolerance; cases that fail are left out.
fn solve(tolerance: f64, chains: &[&[Parameters]], exact: &[Quantities]) -> Vec<Measured> {
    let run = || -> Vec<Option<Measured>> {
        let solved = chains.iter().flat_map(|chain| outcomes(Settings { tolerance, ..Settings::default() }, chain));
        solved.zip(exact).map(|(case, exact)| Measured::new(&case, exact)).collect()
    };
    let mut best = run();
    for _ in 1..REPETITIONS {
        for (best, again) in best.iter_mut().zip(run()) {
            if let (Some(best), Some(again)) = (best, again) {
                best.seconds = best.seconds.min(again.seconds);
            }
        }
    }
    best.into_iter().flatten().collect()
}

/// Prints the table of some chains.
pub fn print(title: &str, chains: &[&[Parameters]], exact: &[Quantities]) {
    let solved = TOLERANCES.map(|tolerance| solve(tolerance, chains, exact));
    let median =
        |cases: &[Measured], number: fn(&Measured) -> f64| quantile(&cases.iter().map(number).collect::<Vec<_>>(), 0.5);
    let usual = TOLERANCES.iter().position(|&tolerance| tolerance == USUAL).expect("one of the tolerances");
    let unit = median(&solved[usual], |case| case.seconds);

    println!("{title}:\n");
    println!(
        "| tolerance | solved | error within | worst error/tolerance \
         | estimate/error: 5 % | median | 95 % | unknowns | iterations | factorisations | time |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for (tolerance, cases) in TOLERANCES.iter().zip(&solved) {
        let within = cases.iter().filter(|case| case.error <= *tolerance).count();
        let largest = cases.iter().map(|case| case.error / tolerance).fold(0.0, f64::max);
        let ratios: Vec<f64> = cases.iter().map(|case| case.estimate / case.error).collect();
        let of = |part| quantile(&ratios, part);
        println!(
            "| {tolerance:.0e} | {} of {} | {within} | {largest:.2} | {:.2} | {:.2} | {:.2} | {} | {} | {} | {:.2} |",
            cases.len(),
            exact.len(),
            of(0.05),
            of(0.5),
            of(0.95),
            median(cases, |case| case.unknowns),
            median(cases, |case| case.iterations),
            median(cases, |case| case.factorisations),
            median(cases, |case| case.seconds) / unit,
        );
    }
    println!();
}
