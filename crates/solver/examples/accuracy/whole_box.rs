//! Errors over the whole range of parameters, of which the reference covers the middle.

use rayon::prelude::*;
use stribeck_solver::collocation::Settings;
use stribeck_solver::continuation::Solution;
use stribeck_solver::{Parameters, Quantities};

use crate::measure::{EXACT, quantile, true_error, worst};
use crate::outcomes;

/// The tolerances that are tried.
const TOLERANCES: [f64; 4] = [1e-3, 1e-5, 1e-7, 1e-8];

/// α from 10⁻⁴ to 10⁴ and 0, f from 1 to 10⁴, and the elastic case, each at β from 10⁻² to 10⁸.
fn cases() -> Vec<Parameters> {
    let power = |exponent: i32| 10_f64.powi(exponent);
    let alphas = (-4..=4).map(power).chain([0.0]);
    let pairs = alphas.flat_map(|alpha| (0..=4).map(move |exponent| (alpha, power(exponent))));
    let pairs = pairs.chain([(f64::INFINITY, 0.0)]);
    pairs.flat_map(|(alpha, f)| (-2..=8).map(move |exponent| Parameters::new(alpha, power(exponent), f))).collect()
}

fn solve(settings: Settings, case: &Parameters) -> Option<Solution> {
    outcomes(settings, std::slice::from_ref(case)).remove(0).outcome.ok()
}

/// The numbers at the smallest tolerance that is reached.
fn exact(case: &Parameters) -> Quantities {
    let mut tolerances = [1e-9, 1e-8, 1e-7].into_iter();
    let solution = tolerances.find_map(|tolerance| solve(Settings { tolerance, ..EXACT }, case));
    solution.expect("a tolerance of 1e-7 is reached").quantities
}

/// Prints how many cases are solved, and how well.
pub fn print() {
    let cases = cases();
    let exact: Vec<Quantities> = cases.par_iter().map(exact).collect();
    println!("| tolerance | solved | error within | worst error/tolerance | estimate/error: 5 % | median | 95 % |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for tolerance in TOLERANCES {
        let solved: Vec<Option<Solution>> =
            cases.par_iter().map(|case| solve(Settings { tolerance, ..Settings::default() }, case)).collect();
        let pairs = solved.iter().zip(&exact).filter_map(|(solution, exact)| Some((solution.as_ref()?, exact)));
        let errors: Vec<(f64, f64)> =
            pairs.map(|(solution, exact)| (true_error(&solution.quantities, exact), worst(&solution.errors))).collect();
        let within = errors.iter().filter(|(error, _)| *error <= tolerance).count();
        let largest = errors.iter().map(|(error, _)| error / tolerance).fold(0.0, f64::max);
        let ratios: Vec<f64> = errors.iter().map(|(error, estimate)| estimate / error).collect();
        println!(
            "| {tolerance:.0e} | {} of {} | {within} | {largest:.2} | {:.2} | {:.2} | {:.2} |",
            errors.len(),
            cases.len(),
            quantile(&ratios, 0.05),
            quantile(&ratios, 0.5),
            quantile(&ratios, 0.95),
        );
    }
    println!();
}
