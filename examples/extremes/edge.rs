//! From which β on cases fail.

use rayon::prelude::*;
use stribeck::collocation::Settings;
use stribeck::model::Parameters;

use crate::cases::outcomes;

/// Points a decade of β.
const POINTS: i32 = 2;
/// The largest exponent of β.
const LAST: i32 = 20;

/// The largest β up to which no case of a chain fails, with c there, and the first reason after it.
fn edge(settings: Settings, alpha: f64, f: f64) -> (f64, f64, String) {
    let beta = (0..=POINTS * LAST).map(|i| 10_f64.powf(f64::from(i) / f64::from(POINTS)));
    let chain: Vec<Parameters> = beta.map(|beta| Parameters::new(alpha, beta, f)).collect();
    let mut last = (0.0, 0.0, "none".to_owned());
    for (solved, case) in outcomes(settings, &chain).into_iter().zip(&chain) {
        match solved.outcome {
            Ok(solution) => (last.0, last.1) = (case.beta, solution.quantities.c),
            Err(failure) => {
                last.2 = failure.reason;
                break;
            }
        }
    }
    last
}

/// Prints a table: f, α, and for each tolerance the last β that is solved, with c.
pub fn print() {
    const TOLERANCES: [f64; 4] = [1e-3, 1e-5, 1e-7, 1e-9];
    let titles: Vec<String> = TOLERANCES.iter().map(|tolerance| format!("{tolerance:.0e} | c")).collect();
    println!("| f | α | {} |", titles.join(" | "));
    println!("| --- | --- |{}", " --- | --- |".repeat(TOLERANCES.len()));
    let mut cases = vec![(0.0, f64::INFINITY)];
    for f in [10.0, 1e3, 1e4, 1e6, 1e8] {
        cases.extend([1e-4, 1e-2, 1.0, 100.0, 1e4].map(|alpha| (f, alpha)));
    }
    let rows: Vec<(String, String)> = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(f, alpha)| {
            let edges = TOLERANCES.map(|tolerance| edge(Settings::for_tolerance(tolerance), alpha, f));
            let columns: Vec<String> = edges.iter().map(|(beta, c, _)| format!("{beta:.0e} | {c:.0e}")).collect();
            let row = format!("| {f:.0e} | {alpha:.0e} | {} |", columns.join(" | "));
            (row, format!("f = {f:.0e}, α = {alpha:.0e}: {:.300}", edges[1].2))
        })
        .collect();
    for (row, _) in &rows {
        println!("{row}");
    }
    println!();
    for (_, reason) in &rows {
        println!("- {reason}");
    }
}
