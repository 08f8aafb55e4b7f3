//! Time beside the relaxation solver at equal error.

use rayon::prelude::*;
use stribeck_solver::collocation;
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::relaxation::{RelaxationSolver, Settings};
use stribeck_solver::{FieldSelection, Output, Parameters, Quantities};

use crate::measure::{TOLERANCES, quantile, true_error};
use crate::outcomes;

/// The cases that the relaxation solver is made for.
fn is_compared(case: &Parameters) -> bool {
    case.alpha >= 1.0 && case.beta <= 1e3
}

/// Error and time of a case.
#[derive(Clone, Copy)]
struct Cost {
    error: f64,
    seconds: f64,
}

fn cost(case: &SolvedCase, exact: &Quantities) -> Option<Cost> {
    let solution = case.outcome.as_ref().ok()?;
    Some(Cost { error: true_error(&solution.quantities, exact), seconds: case.effort.seconds })
}

fn relaxed(points: usize, chain: &[Parameters]) -> Vec<SolvedCase> {
    let solver = RelaxationSolver::new(Settings { points, ..Settings::default() });
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    solve_chain(&solver, chain, &output, &Interrupt::new()).expect("nobody interrupts")
}

/// Prints, for each grid, how much longer the relaxation solver takes than collocation with the largest tolerance whose
/// error is not larger. Both solve the same chains in β.
pub fn print(points: &[usize], chains: &[&[Parameters]], exact: &[Quantities]) {
    let all = chains.iter().flat_map(|chain| chain.iter());
    let exact: Vec<Quantities> =
        all.zip(exact).filter(|(case, _)| is_compared(case)).map(|(_, exact)| *exact).collect();
    let chains: Vec<Vec<Parameters>> =
        chains.iter().map(|chain| chain.iter().filter(|case| is_compared(case)).cloned().collect()).collect();

    let costs = |solved: Vec<SolvedCase>| -> Vec<Option<Cost>> {
        solved.iter().zip(&exact).map(|(case, exact)| cost(case, exact)).collect()
    };
    let by_tolerance: Vec<Vec<Option<Cost>>> = TOLERANCES
        .iter()
        .map(|&tolerance| {
            costs(
                chains
                    .iter()
                    .flat_map(|chain| outcomes(collocation::Settings { tolerance, ..Default::default() }, chain))
                    .collect(),
            )
        })
        .collect();

    println!(
        "| points | solved | error, median | worst | collocation cannot match \
         | error there, median | time ratio: least | median | largest | all cases |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for &points in points {
        let solved: Vec<Vec<SolvedCase>> =
            chains.par_iter().with_max_len(1).map(|chain| relaxed(points, chain)).collect();
        let relaxed = costs(solved.into_iter().flatten().collect());
        let reached: Vec<(usize, Cost)> =
            relaxed.iter().enumerate().filter_map(|(i, cost)| cost.map(|cost| (i, cost))).collect();
        let equal = |&(i, relaxed): &(usize, Cost)| {
            let mut candidates = by_tolerance.iter().filter_map(|costs| costs[i]);
            candidates.find(|cost| cost.error <= relaxed.error).map(|cost| (relaxed, cost))
        };
        let pairs: Vec<(Cost, Cost)> = reached.iter().filter_map(equal).collect();
        let ratios: Vec<f64> = pairs.iter().map(|(slow, fast)| slow.seconds / fast.seconds).collect();
        let errors: Vec<f64> = reached.iter().map(|(_, cost)| cost.error).collect();
        let matched: Vec<f64> = pairs.iter().map(|(_, fast)| fast.error).collect();
        let sum = |part: fn(&(Cost, Cost)) -> f64| pairs.iter().map(part).sum::<f64>();
        println!(
            "| {points} | {} of {} | {:.1e} | {:.1e} | {} | {:.1e} | {:.0} | {:.0} | {:.0} | {:.0} |",
            reached.len(),
            exact.len(),
            quantile(&errors, 0.5),
            quantile(&errors, 1.0),
            reached.len() - pairs.len(),
            quantile(&matched, 0.5),
            quantile(&ratios, 0.0),
            quantile(&ratios, 0.5),
            quantile(&ratios, 1.0),
            sum(|pair| pair.0.seconds) / sum(|pair| pair.1.seconds),
        );
    }
}
