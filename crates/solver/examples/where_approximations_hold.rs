//! From which β on, and up to which, approximations are good to 1, 5 and 20 %, as Markdown tables.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example where_approximations_hold -- [--csv errors.csv]
//! ```
//!
//! Compared with the collocation solver (tolerance 1e-6) at 20 points a decade of β from 10 to 10⁸. A cell is the
//! longest range in which the error stays within the bound. `--csv` writes every error, for
//! `scripts/plot_approximations.py`.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::exact::{self, LargeBeta, fitted_c};
use stribeck_solver::{FieldSelection, Output, Parameters};

const STRENGTHS: [f64; 4] = [1.0, 10.0, 100.0, 1000.0];
const ALPHAS: [f64; 7] = [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3];
const BOUNDS: [f64; 3] = [0.01, 0.05, 0.2];
/// Points over the seven decades of β.
const POINTS: u32 = 141;
/// A β at which the formula for c is its own asymptote to rounding.
const ASYMPTOTIC: f64 = 1e60;

/// What is compared: a name for files, and words for people.
const APPROXIMATIONS: [(&str, &str); 7] = [
    ("dry_mu_v", "`dry_mu_v` for `mu_v`"),
    ("equation_49", "Eq. 49 for `c`"),
    ("approx_mu_h", "`approx_mu_h` for the film's part of `mu_h`"),
    ("approx_mu_h_cavity", "`approx_mu_h` for `mu_h` with a full cavity"),
    ("relaxed", "the relaxed elastic power law $0.4458\\,\\beta^{-3/5}$ for `c`"),
    ("asymptote", "the power law $c\\propto\\beta^{-3/5}$ with its exact factor, for `c`"),
    ("formula", "the formula (T34) for `c`"),
];

/// Relative errors along β, for each approximation.
struct Line {
    f: f64,
    alpha: f64,
    errors: [Vec<f64>; APPROXIMATIONS.len()],
}

fn beta(i: u32) -> f64 {
    10_f64.powf(1.0 + 7.0 * f64::from(i) / f64::from(POINTS - 1))
}

fn errors(case: &Parameters, solved: SolvedCase) -> Result<[f64; APPROXIMATIONS.len()], String> {
    let quantities = solved.outcome.map_err(|failure| format!("{case:?}: {failure}"))?.quantities;
    let one_time = "one retardation time";
    let asymptote = |case: &Parameters| {
        let thin = Parameters { beta: ASYMPTOTIC, ..case.clone() };
        fitted_c(&thin).expect(one_time) * (case.beta / ASYMPTOTIC).powf(-0.6)
    };
    let (friction, limits) = (&quantities.friction, exact::limits(case));
    Ok([
        limits.dry_mu_v / friction.viscoelastic,
        LargeBeta::new(case).expect(one_time).approx_c() / quantities.c,
        limits.approx_mu_h / friction.hydrodynamic_film,
        limits.approx_mu_h / friction.hydrodynamic(),
        0.4458 * case.beta.powf(-0.6) / quantities.c,
        asymptote(case) / quantities.c,
        fitted_c(case).expect(one_time) / quantities.c,
    ]
    .map(|ratio| ratio - 1.0))
}

fn line(f: f64, alpha: f64) -> Result<Line, String> {
    let solver = CollocationSolver::new(Settings::for_tolerance(1e-6));
    let output = Output { fields: FieldSelection::default(), ..Output::default() };
    let cases: Vec<Parameters> = (0..POINTS).map(|i| Parameters::new(alpha, beta(i), f)).collect();
    let solved = solve_chain(&solver, &cases, &output, &Interrupt::new()).expect("no one interrupts");
    let mut line = Line { f, alpha, errors: Default::default() };
    for (case, solved) in cases.iter().zip(solved) {
        for (along, error) in line.errors.iter_mut().zip(errors(case, solved)?) {
            along.push(error);
        }
    }
    Ok(line)
}

/// The longest run of points whose error is within the bound, in words.
fn range(errors: &[f64], bound: f64) -> String {
    let mut longest = 0..0;
    let mut start = 0;
    for i in 0..=errors.len() {
        if i == errors.len() || errors[i].is_nan() || errors[i].abs() > bound {
            if i - start > longest.len() {
                longest = start..i;
            }
            start = i + 1;
        }
    }
    let number = |i: usize| {
        // two digits, which is what 20 points a decade have
        let rounded: f64 = format!("{:.1e}", beta(i as u32)).parse().expect("a number");
        if rounded < 1e4 { rounded.to_string() } else { format!("{rounded:e}") }
    };
    match (longest.start, longest.end) {
        (start, end) if start == end => "–".into(),
        (0, end) if end == errors.len() => "all".into(),
        (0, end) => format!("< {}", number(end - 1)),
        (start, end) if end == errors.len() => format!("> {}", number(start)),
        (start, end) => format!("{} to {}", number(start), number(end - 1)),
    }
}

fn print_table(approximation: usize, lines: &[Line]) {
    println!("{}:\n", APPROXIMATIONS[approximation].1);
    println!("| f | within | α = {} |", ALPHAS.map(|alpha| alpha.to_string()).join(" | "));
    println!("| --- | --- |{}", " --- |".repeat(ALPHAS.len()));
    for f in STRENGTHS {
        for bound in BOUNDS {
            let cells = lines.iter().filter(|line| line.f == f).map(|line| range(&line.errors[approximation], bound));
            println!("| {f} | {} % | {} |", 100.0 * bound, cells.collect::<Vec<_>>().join(" | "));
        }
    }
    println!();
}

fn print_elastic(line: &Line) {
    println!("An elastic substrate ($f=0$ or $\\alpha=\\infty$; Eq. 49 is Eq. 34 there):\n");
    println!("| | {} |", BOUNDS.map(|bound| format!("within {} %", 100.0 * bound)).join(" | "));
    println!("| --- |{}", " --- |".repeat(BOUNDS.len()));
    // without retardation there is no viscoelastic friction to compare
    for (&(_, words), errors) in APPROXIMATIONS.iter().zip(&line.errors).skip(1) {
        println!("| {words} | {} |", BOUNDS.map(|bound| range(errors, bound)).join(" | "));
    }
    println!();
}

fn csv(lines: &[Line]) -> String {
    let mut text = format!("f,alpha,beta,{}\n", APPROXIMATIONS.map(|(name, _)| name).join(","));
    for line in lines {
        for i in 0..POINTS {
            let errors = line.errors.iter().map(|errors| format!("{:.6e}", errors[i as usize]));
            let errors = errors.collect::<Vec<_>>().join(",");
            writeln!(text, "{},{},{:.6e},{errors}", line.f, line.alpha, beta(i)).expect("a string takes all");
        }
    }
    text
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let file = match arguments.as_slice() {
        [] => None,
        [name, file] if name == "--csv" => Some(file),
        _ => return Err("the only option is --csv FILE".into()),
    };
    let pairs: Vec<(f64, f64)> = STRENGTHS.iter().flat_map(|&f| ALPHAS.map(|alpha| (f, alpha))).collect();
    let mut lines: Vec<Line> = pairs.into_par_iter().map(|(f, alpha)| line(f, alpha)).collect::<Result<_, String>>()?;
    // the formula has one line in place of a table: see the example `film_formula`
    for approximation in 0..APPROXIMATIONS.len() - 1 {
        print_table(approximation, &lines);
    }
    let formula = lines.iter().flat_map(|line| &line.errors[APPROXIMATIONS.len() - 1]);
    let largest = formula.fold(0.0, |largest, error| f64::max(largest, error.abs()));
    println!("The formula (T34) is within {:.1} % in all of these cases.\n", 100.0 * largest);
    let elastic = line(0.0, f64::INFINITY)?;
    print_elastic(&elastic);
    lines.push(elastic);
    if let Some(file) = file {
        fs::write(file, csv(&lines))?;
    }
    Ok(())
}
