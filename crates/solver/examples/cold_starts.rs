//! What the table of starting solutions saves where a case has no neighbours, beside the march from a thick film.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example cold_starts -- [cases]
//! ```
//!
//! The cases are the 84 of `tests/reference/single_mode.csv`, random ones (1000) with α from 1e-4 to 1e4, β from 1 to 1e7
//! and f from 1e-2 to 1e4, and a curve of two soft bodies along the speed of the roller, which leads through another
//! spectrum at each speed. Each is solved alone by one thread for a tolerance of 1e-5, both ways in turn.

#[path = "../tests/collocation/measure.rs"]
#[allow(dead_code)]
mod measure;

use std::error::Error;

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::{Output, Parameters, RetardationMode};

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

/// Forty cases of two soft bodies of the same two modes, the roller's surface from a hundredth to a hundred times as fast
/// as the flat.
fn along_roller_speed() -> Vec<Parameters> {
    let modes =
        |slower: f64| [(0.35, 1.0), (0.15, 10.0)].map(|(share, time)| RetardationMode { share, time: time * slower });
    let case = |i: i32| {
        let ratio = 10_f64.powf(-2.0 + 4.0 * f64::from(i) / 39.0);
        Parameters::of_two_bodies([1.0, 1e3 / (1.0 + ratio), 10.0], &modes(1.0), &modes(ratio))
            .expect("shares add up to 1")
    };
    (0..40).map(case).collect()
}

fn solve(solver: &CollocationSolver, case: &Parameters) -> SolvedCase {
    solve_chain(solver, std::slice::from_ref(case), &Output::numbers(), &Interrupt::new())
        .expect("nobody interrupts")
        .remove(0)
}

/// The quantiles of a number of the cases that a row shows.
fn median_and_95(cases: &[SolvedCase], number: fn(&SolvedCase) -> f64) -> [f64; 2] {
    let numbers: Vec<f64> = cases.iter().map(number).collect();
    [0.5, 0.95].map(|part| quantile(&numbers, part))
}

fn milliseconds(case: &SolvedCase) -> f64 {
    1e3 * case.effort.seconds
}

fn print(name: &str, way: &str, cases: &[SolvedCase]) {
    let [ms, ms_95] = median_and_95(cases, milliseconds);
    let counts: [fn(&SolvedCase) -> f64; 3] = [
        |case| case.effort.iterations as f64,
        |case| case.effort.factorisations as f64,
        |case| case.effort.meshes as f64,
    ];
    let counts = counts.map(|count| median_and_95(cases, count).map(|count| count.to_string()).join(", ")).join(" | ");
    let at_once = cases.iter().filter(|case| case.path.points.is_empty() && case.outcome.is_ok()).count();
    let lost = cases.iter().filter(|case| case.outcome.is_err()).count();
    let at_once = 100.0 * at_once as f64 / cases.len() as f64;
    println!("| {name} | {way} | {ms:.2}, {ms_95:.2} | {counts} | {at_once:.1} % | {lost} |");
}

fn main() -> Result<(), Box<dyn Error>> {
    let count = std::env::args().nth(1).map_or(Ok(1000), |text| text.parse())?;
    let solver = || CollocationSolver::new(Settings::default());
    let ways = [("march", solver().marching()), ("table", solver())];
    println!("Median, 95 % of each:\n");
    println!("| cases | from | ms | iterations | factorisations | meshes | at the first try | lost |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    let reference = measure::reference().into_iter().map(|(case, _)| case).collect();
    let mut summary = String::new();
    let all = [("reference", reference), ("random", random_cases(count)), ("two bodies", along_roller_speed())];
    for (name, cases) in all {
        let mut solved: [Vec<SolvedCase>; 2] = Default::default();
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
            for (solved, best) in solved.iter_mut().zip(best) {
                solved.extend(best);
            }
        }
        for ((way, _), solved) in ways.iter().zip(&solved) {
            print(name, way, solved);
        }
        let [march, table] = &solved;
        let pairs = march
            .iter()
            .zip(table)
            .filter_map(|pair| Some((pair.0.outcome.as_ref().ok()?, pair.1.outcome.as_ref().ok()?)));
        let apart = pairs.map(|(march, table)| true_error(&march.quantities, &table.quantities)).fold(0.0, f64::max);
        let [before, after] = [march, table].map(|cases| median_and_95(cases, milliseconds));
        let [median, at_95] = [before[0] / after[0], before[1] / after[1]];
        summary += &format!(
            "{name}: {median:.1} times faster in the median, {at_95:.1} times at 95 %; numbers differ by {apart:.1e} at most\n"
        );
    }
    println!("\n{summary}");
    Ok(())
}
