//! The range of the paper.

use rayon::prelude::*;
use stribeck_solver::Parameters;
use stribeck_solver::relaxation::{RelaxationSolver, Settings};

use crate::comparison::{Compared, QUANTITIES, compare, median_and_worst};

/// f = 10 and 100 and five β at each α.
pub fn solve(settings: Settings, alphas: &[f64]) -> Vec<Compared> {
    let pairs: Vec<(f64, f64)> = [10.0, 100.0].into_iter().flat_map(|f| alphas.iter().map(move |&a| (a, f))).collect();
    let solver = RelaxationSolver::new(settings);
    let chain = |&(alpha, f): &(f64, f64)| -> Vec<Parameters> {
        (0..5).map(|k| Parameters::new(alpha, 10_f64.powf(1.0 + 0.5 * f64::from(k)), f)).collect()
    };
    pairs.par_iter().with_max_len(1).flat_map_iter(|pair| compare(&solver, settings, &chain(pair))).collect()
}

/// Median and worst deviation for each α.
pub fn print(cases: &[Compared], alphas: &[f64]) {
    println!("| α | converged | {} | passes, median | most | time over that of collocation |", QUANTITIES.join(" | "));
    println!("| --- | --- | {}--- | --- | --- |", "--- | ".repeat(QUANTITIES.len()));
    for alpha in alphas.iter().map(Some).chain([None]) {
        let counted: Vec<&Compared> =
            cases.iter().filter(|case| alpha.is_none_or(|&alpha| case.parameters.alpha == alpha)).collect();
        let converged: Vec<_> = counted.iter().filter_map(|case| case.deviations.as_ref().ok()).collect();
        let pair = |values: Option<(f64, f64)>| {
            values.map_or("–".to_owned(), |(median, worst)| format!("{median:.1e} / {worst:.1e}"))
        };
        let deviations: Vec<String> = (0..QUANTITIES.len())
            .map(|i| pair(median_and_worst(converged.iter().map(|deviations| deviations.relative[i]))))
            .collect();
        let (median, most) = median_and_worst(counted.iter().map(|case| case.passes as f64)).unwrap_or_default();
        let sum = |seconds: fn(&Compared) -> f64| counted.iter().map(|case| seconds(case)).sum::<f64>();
        let ratio = sum(|case| case.seconds) / sum(|case| case.collocation_seconds);
        println!(
            "| {} | {} of {} | {} | {median:.0} | {most:.0} | {ratio:.0} |",
            alpha.map_or("all".to_owned(), |alpha| format!("{alpha:e}")),
            converged.len(),
            counted.len(),
            deviations.join(" | "),
        );
    }
    let seconds: f64 = cases.iter().map(|case| case.seconds).sum();
    println!("\n{seconds:.0} seconds of one core for the relaxation solver");
}
