//! Errors of formulas for the film thickness c on cases that none of them was fitted to, as Markdown tables.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example film_formula -- [--cases 2000]
//! ```
//!
//! The cases are spread over ln α, ln(1+f) and ln β by a lattice without repetition (multiples of the powers of a
//! number, modulo 1), and solved by the collocation solver with a tolerance of 1e-7. Beside the fitted formula stand
//! Eq. 49 of the paper and the bare elastic asymptote.

use std::error::Error;

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::exact::{LargeBeta, fitted_c};
use stribeck_solver::{CavityShear, FieldSelection, Output, Parameters};

/// The ranges of α, 1 + f and β that are asked for.
const ALPHA: (f64, f64) = (1e-4, 1e4);
const STIFFENING: (f64, f64) = (1.1, 1e4 + 1.0);
const BETA: (f64, f64) = (10.0, 1e8);
/// c β^{3/5} of elastic films for β → ∞.
const ASYMPTOTE: f64 = 0.4458;

/// A case with the c of its solution.
struct Solved {
    case: Parameters,
    c: f64,
}

/// How a formula's error over some cases is told: the largest and the root of the mean square, as parts.
fn errors(cases: &[&Solved], formula: impl Fn(&Parameters) -> f64) -> (f64, f64) {
    let errors = cases.iter().map(|solved| formula(&solved.case) / solved.c - 1.0);
    let (largest, squares) = errors
        .fold((0.0, 0.0), |(largest, squares), error: f64| (f64::max(largest, error.abs()), squares + error * error));
    (largest, (squares / cases.len() as f64).sqrt())
}

fn percent((largest, rms): (f64, f64)) -> String {
    let digits =
        |error: f64| if error < 0.1 { format!("{:.2}", 100.0 * error) } else { format!("{:.0}", 100.0 * error) };
    format!("{} / {}", digits(largest), digits(rms))
}

fn fitted(case: &Parameters) -> f64 {
    fitted_c(case).expect("one retardation time")
}

fn equation_49(case: &Parameters) -> f64 {
    LargeBeta::new(case).expect("one retardation time").approx_c()
}

fn asymptote(case: &Parameters) -> f64 {
    ASYMPTOTE * case.beta.powf(-0.6)
}

fn header(first: &str) {
    println!("| {first} | cases | formula: largest / rms, % | Eq. 49 | $0.4458\\,\\beta^{{-3/5}}$ |");
    println!("| --- | --- | --- | --- | --- |");
}

fn row(name: &str, cases: &[&Solved]) {
    let formulas = [errors(cases, fitted), errors(cases, equation_49), errors(cases, asymptote)];
    println!("| {name} | {} | {} |", cases.len(), formulas.map(percent).join(" | "));
}

/// The table of the cases whose `value` is between neighbours of `edges`.
fn table(name: &str, solved: &[Solved], edges: &[f64], value: impl Fn(&Parameters) -> f64) {
    header(name);
    for ends in edges.windows(2) {
        let inside: Vec<&Solved> =
            solved.iter().filter(|solved| (ends[0]..ends[1]).contains(&value(&solved.case))).collect();
        row(&format!("{:e} to {:e}", ends[0], ends[1]), &inside);
    }
    row("all", &solved.iter().collect::<Vec<_>>());
    println!();
}

/// The solutions of cases; those without one are left out and counted.
fn solve(cases: Vec<Parameters>) -> (Vec<Solved>, usize) {
    let solver = CollocationSolver::new(Settings::for_tolerance(1e-7));
    let output = Output {
        fields: FieldSelection::default(),
        limits: false,
        cavity_shear: CavityShear::None,
        ..Output::default()
    };
    let count = cases.len();
    let solved: Vec<Solved> = cases
        .into_par_iter()
        .filter_map(|case| {
            let result = solve_chain(&solver, std::slice::from_ref(&case), &output, &Interrupt::new());
            let solution = result.expect("no one interrupts").remove(0).outcome.ok()?;
            Some(Solved { c: solution.quantities.c, case })
        })
        .collect();
    let failed = count - solved.len();
    (solved, failed)
}

fn between((from, to): (f64, f64), t: f64) -> f64 {
    from * (to / from).powf(t)
}

/// Cases that cover a box in ln α, ln(1 + f) and ln β evenly.
fn spread(count: u32, alpha: (f64, f64), stiffening: (f64, f64), beta: (f64, f64)) -> Vec<Parameters> {
    // the root of x⁴ = x + 1: its powers make the lattice that covers three dimensions most evenly
    const STEP: f64 = 1.220_744_084_605_759_5;
    let place = |i: u32, dimension: i32| (0.5 + f64::from(i) * STEP.powi(-dimension)).fract();
    let case = |i| {
        let f = between(stiffening, place(i, 3)) - 1.0;
        Parameters::new(between(alpha, place(i, 1)), between(beta, place(i, 2)), f)
    };
    (1..=count).map(case).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut count = 2000_u32;
    let mut arguments = std::env::args().skip(1);
    while let Some(name) = arguments.next() {
        match (name.as_str(), arguments.next()) {
            ("--cases", Some(value)) => count = value.parse()?,
            _ => return Err(format!("{name}: the only option is --cases N").into()),
        }
    }

    let (viscoelastic, failed) = solve(spread(count, ALPHA, STIFFENING, BETA));
    if failed > 0 {
        return Err(format!("{failed} cases have no solution").into());
    }
    table("β", &viscoelastic, &[10.0, 100.0, 1e3, 1e4, 1e6, 1e8], |case| case.beta);
    table("α", &viscoelastic, &[1e-4, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e4], |case| case.alpha);
    table("f", &viscoelastic, &[0.1, 1.0, 10.0, 100.0, 1e3, 1e4], |case| case.f);

    let elastic = (0..150).map(|i| Parameters::elastic(between((1e-4, 1e10), (f64::from(i) + 0.5) / 150.0)));
    let (elastic, _) = solve(elastic.collect());
    table("β, elastic", &elastic, &[1e-4, 1e-2, 1.0, 10.0, 100.0, 1e3, 1e4, 1e10], |case| case.beta);

    let (beyond, failed) = solve(spread(count / 4, (1e-8, 1e8), (1.1, 1e6), (1e-4, 1e10)));
    table("β, far beyond", &beyond, &[1e-4, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e4, 1e10], |case| case.beta);
    println!("Of the last set {failed} cases were not solved to the tolerance and are left out.\n");

    let (largest, _) = errors(&viscoelastic.iter().collect::<Vec<_>>(), fitted);
    let worst = viscoelastic.iter().find(|solved| (fitted(&solved.case) / solved.c - 1.0).abs() == largest);
    if let Some(Solved { case, .. }) = worst {
        println!(
            "Largest error of the formula, {:.2} %, at alpha = {:.3e}, f = {:.3e}, beta = {:.3e}.",
            100.0 * largest,
            case.alpha,
            case.f,
            case.beta
        );
    }
    Ok(())
}
