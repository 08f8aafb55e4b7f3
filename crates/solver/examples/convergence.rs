//! Error of the collocation solver against the number of its unknowns, for degrees 4, 6 and 8 of the panels, as CSV;
//! the slopes that fit it go to standard error.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example convergence > convergence.csv
//! python scripts/plot_convergence.py convergence.csv -o docs/figures/collocation_convergence.svg
//! ```
//!
//! The number of unknowns is the solver's answer to a tolerance, which is what is varied. The error is that of
//! `tests/collocation/measure.rs`: the largest of μ_v, μ_h and c.

#[allow(dead_code, reason = "shared with the tests, which need more of it")]
#[path = "../tests/collocation/measure.rs"]
mod measure;

use std::collections::BTreeMap;

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::{FieldSelection, Output, Parameters};

const DEGREES: [usize; 3] = [4, 6, 8];
/// f, α, β of the cases: elastic and not, stiff and soft, thick and thin films.
const CASES: [(f64, f64, f64); 6] = [
    (0.0, f64::INFINITY, 1e3),
    (1.0, 1.0, 1e2),
    (10.0, 10.0, 1e3),
    (100.0, 0.1, 1e2),
    (100.0, 1.0, 1e4),
    (1000.0, 10.0, 1e3),
];
/// Tolerances a decade, from 10⁻¹ to 10⁻⁹.
const PER_DECADE: i32 = 8;
/// The errors between which a slope is fitted: small enough to be of the highest order, above those of what counts as
/// exact.
const FITTED: std::ops::Range<f64> = 1e-9..1e-4;

fn solve(settings: Settings, case: &Parameters) -> SolvedCase {
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let solved = solve_chain(&CollocationSolver::new(settings), std::slice::from_ref(case), &output, &Interrupt::new());
    solved.expect("nobody interrupts").remove(0)
}

/// The slope of ln error over ln unknowns by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = points.iter().map(|(n, error)| (n.ln(), error.ln())).collect();
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / count, sum.1 + point.1 / count));
    let covariance: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    covariance / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

/// The geometric means of the errors that go with each number of unknowns.
fn means(points: &[(usize, f64)]) -> Vec<(f64, f64)> {
    let mut by_unknowns: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for &(unknowns, error) in points.iter().filter(|(_, error)| FITTED.contains(error)) {
        by_unknowns.entry(unknowns).or_default().push(error.ln());
    }
    let mean = |(unknowns, errors): (usize, Vec<f64>)| {
        (unknowns as f64, (errors.iter().sum::<f64>() / errors.len() as f64).exp())
    };
    by_unknowns.into_iter().map(mean).collect()
}

/// A solution, as a line of the table and as a point.
type Solved = (String, (usize, f64));

/// All solutions of a case with panels of one degree. A tolerance that a low degree does not reach has none, nor have
/// those below.
fn sweep(&(f, alpha, beta): &(f64, f64, f64), degree: usize) -> Vec<Solved> {
    let case = Parameters::new(alpha, beta, f);
    let exact = solve(measure::EXACT, &case).outcome.expect("the exact solution converges").quantities;
    let solved = (PER_DECADE..=9 * PER_DECADE).map_while(|step| {
        let tolerance = 10_f64.powf(-f64::from(step) / f64::from(PER_DECADE));
        let solved = solve(Settings { tolerance, degree }, &case);
        let solution = solved.outcome.ok()?;
        let (unknowns, error) = (solved.effort.unknowns, measure::true_error(&solution.quantities, &exact));
        let estimate = measure::worst(&solution.errors);
        let line = format!("{f},{alpha},{beta},{degree},{tolerance:e},{unknowns},{error:e},{estimate:e}");
        Some((line, (unknowns, error)))
    });
    solved.collect()
}

fn main() {
    let jobs: Vec<_> = CASES.iter().flat_map(|case| DEGREES.map(|degree| (case, degree))).collect();
    let solved: Vec<Vec<Solved>> = jobs.par_iter().with_max_len(1).map(|(case, degree)| sweep(case, *degree)).collect();

    println!("f,alpha,beta,degree,tolerance,unknowns,error,estimate");
    solved.iter().flatten().for_each(|(line, _)| println!("{line}"));
    let names = DEGREES.map(|degree| format!("d = {degree}: slope | unknowns | least error"));
    eprintln!("| f | α | β | {} |", names.join(" | "));
    eprintln!("| --- | --- | --- |{}", " --- | --- | --- |".repeat(DEGREES.len()));
    for ((f, alpha, beta), by_degree) in CASES.iter().zip(solved.chunks(DEGREES.len())) {
        let cells = by_degree.iter().map(|solved| {
            let points: Vec<(usize, f64)> = solved.iter().map(|(_, point)| *point).collect();
            let (least, most) =
                points.iter().fold((usize::MAX, 0), |(least, most), point| (least.min(point.0), most.max(point.0)));
            let error = points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
            format!("{:.1} | {least} to {most} | {error:.0e}", slope(&means(&points)))
        });
        eprintln!("| {f} | {alpha} | {beta:e} | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
}
