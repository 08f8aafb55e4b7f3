//! What the table of starting solutions saves where a case has no neighbours, beside the march from a thick film.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example cold_starts -- [cases]
//! ```
//!
//! The cases are the 84 of `tests/reference/single_mode.csv` and random ones (1000) with α from 1e-4 to 1e4, β from 1
//! to 1e7 and f from 1e-2 to 1e4, each solved alone by one thread for a tolerance of 1e-5, both ways in turn.

#[path = "../tests/collocation/measure.rs"]
#[allow(dead_code)]
mod measure;

use std::error::Error;

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, Seed, SolvedCase, solve_chain};
use stribeck_solver::{Output, Parameters};

use measure::{quantile, true_error};

/// The shortest of so many times counts.
const REPETITIONS: usize = 3;

/// Numbers between 0 and 1 that look random, always the same ones (SplitMix64).
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

fn random_cases(count: usize) -> Vec<Parameters> {
    let mut state = 24;
    let mut power = |from: f64, to: f64| 10_f64.powf(from + (to - from) * random(&mut state));
    (0..count).map(|_| Parameters::new(power(-4.0, 4.0), power(0.0, 7.0), power(-2.0, 4.0))).collect()
}

fn solve(solver: &CollocationSolver, case: &Parameters) -> SolvedCase {
    solve_chain(solver, std::slice::from_ref(case), &Output::numbers(), &Interrupt::new()).expect("nobody interrupts").remove(0)
}

fn print(name: &str, way: &str, cases: &[SolvedCase]) {
    let of = |number: fn(&SolvedCase) -> f64, part| quantile(&cases.iter().map(number).collect::<Vec<_>>(), part);
    let ms = |case: &SolvedCase| 1e3 * case.effort.seconds;
    let iterations = |case: &SolvedCase| case.effort.iterations as f64;
    let factorisations = |case: &SolvedCase| case.effort.factorisations as f64;
    let meshes = |case: &SolvedCase| case.effort.meshes as f64;
    let from_table = cases.iter().filter(|case| case.seed == Seed::Table).count();
    let lost = cases.iter().filter(|case| case.outcome.is_err()).count();
    println!(
        "| {name} | {way} | {:.2} | {:.2} | {} | {} | {} | {} | {} | {} | {:.1} % | {lost} |",
        of(ms, 0.5),
        of(ms, 0.95),
        of(iterations, 0.5),
        of(iterations, 0.95),
        of(factorisations, 0.5),
        of(factorisations, 0.95),
        of(meshes, 0.5),
        of(meshes, 0.95),
        100.0 * from_table as f64 / cases.len() as f64,
    );
}

fn main() -> Result<(), Box<dyn Error>> {
    let count = std::env::args().nth(1).map_or(Ok(1000), |text| text.parse())?;
    let ways = [
        ("march", CollocationSolver::new(Settings::default()).marching()),
        ("table", CollocationSolver::new(Settings::default())),
    ];
    println!("| cases | way | ms: median | 95 % | iterations | 95 % | factorisations | 95 % | meshes | 95 % | from the table | lost |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let reference = measure::reference().into_iter().map(|(case, _)| case).collect();
    for (name, cases) in [("reference", reference), ("random", random_cases(count))] {
        let mut solved: [Vec<SolvedCase>; 2] = Default::default();
        let mut apart: Vec<f64> = Vec::new();
        for case in &cases {
            let mut best: [Option<SolvedCase>; 2] = Default::default();
            for _ in 0..REPETITIONS {
                for (best, (_, solver)) in best.iter_mut().zip(&ways) {
                    let again = solve(solver, case);
                    if best.as_ref().is_none_or(|best| again.effort.seconds < best.effort.seconds) {
                        *best = Some(again);
                    }
                }
            }
            let [march, table] = best.map(|best| best.expect("it was solved"));
            if std::env::var_os("SHOW").is_some() && table.seed != Seed::Table {
                println!("{case:?} {} {:?}", table.seed, table.effort);
            }
            if let (Ok(a), Ok(b)) = (&march.outcome, &table.outcome) {
                apart.push(true_error(&a.quantities, &b.quantities));
            }
            solved[0].push(march);
            solved[1].push(table);
        }
        for ((way, _), solved) in ways.iter().zip(&solved) {
            print(name, way, solved);
        }
        let ratio = |part| {
            let ms = |cases: &[SolvedCase]| quantile(&cases.iter().map(|case| case.effort.seconds).collect::<Vec<_>>(), part);
            ms(&solved[0]) / ms(&solved[1])
        };
        println!("{name}: {:.2} times faster in the median, {:.2} at 95 %; numbers differ by {:.1e} at most", ratio(0.5), ratio(0.95), quantile(&apart, 1.0));
    }
    Ok(())
}
