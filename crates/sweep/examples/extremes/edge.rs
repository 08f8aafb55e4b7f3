//! From which β on cases fail.

use rayon::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::collocation::Settings;

use crate::cases::outcome;

/// The largest exponent of β.
const LAST: i32 = 18;

/// The largest power of ten up to which β is solved, each case alone, with c there, and the reason of the failure after
/// it.
fn edge(settings: Settings, alpha: f64, f: f64) -> (f64, f64, String) {
    let mut last = (f64::NAN, f64::NAN, "none fails".to_owned());
    for exponent in 6..=LAST {
        let case = Parameters::new(alpha, 10_f64.powi(exponent), f);
        match outcome(settings, &case).outcome {
            Ok(solution) => (last.0, last.1) = (case.beta, solution.quantities.c),
            Err(failure) => {
                last.2 = failure.to_string();
                break;
            }
        }
    }
    last
}

/// Prints a table: f, α, and for each tolerance the last β that is solved, with c.
pub fn print() {
    const TOLERANCES: [f64; 3] = [1e-3, 1e-5, 1e-7];
    let titles: Vec<String> = TOLERANCES.iter().map(|tolerance| format!("{tolerance:.0e} | c")).collect();
    println!("| f | α | {} |", titles.join(" | "));
    println!("| --- | --- |{}", " --- | --- |".repeat(TOLERANCES.len()));
    let mut cases = vec![(0.0, f64::INFINITY)];
    for f in [10.0, 1e4, 1e8] {
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
