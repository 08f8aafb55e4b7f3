//! Errors of the relaxation solver against `tests/reference/single_mode.csv` on several grids, as a Markdown table.
//!
//! ```text
//! cargo run --release -p stribeck-solver --example grid_error -- \
//!     [--points 401,801,1601] [--min-alpha 1] [--max-beta 1e3] [--plain]
//! ```
//!
//! The orders are log₂ of the ratio of two errors on grids of Δx and Δx/2. A case that fails stands in the table as
//! such, its reason below the table.

#[path = "relaxation_range/flow_error.rs"]
mod flow_error;

use std::error::Error;

use rayon::prelude::*;
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::exact::contact_bounds;
use stribeck_solver::relaxation::{Acceleration, RelaxationSolver, Settings};
use stribeck_solver::{FieldSelection, Output, Parameters, Quantities};

use flow_error::flow_error;

const REFERENCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/single_mode.csv");
/// A film is taken as resolved if the flow at the mid-points of the grid is right to this part of the film.
const RESOLVED: f64 = 0.05;
/// Orders that count as second.
const SECOND_ORDER: std::ops::RangeInclusive<f64> = 1.6..=2.4;
/// What is compared, and the column that shows it.
const QUANTITIES: [&str; 4] = ["F_v", "F_h", "c", "u_min"];

struct Options {
    points: Vec<usize>,
    min_alpha: f64,
    max_beta: f64,
    acceleration: Acceleration,
}

impl Options {
    fn parse() -> Result<Self, Box<dyn Error>> {
        let acceleration = Acceleration::Anderson;
        let mut options = Self { points: vec![401, 801, 1601], min_alpha: 1.0, max_beta: 1e3, acceleration };
        let mut arguments = std::env::args().skip(1);
        while let Some(name) = arguments.next() {
            if name == "--plain" {
                options.acceleration = Acceleration::None;
                continue;
            }
            let value = arguments.next().ok_or_else(|| format!("{name} needs a value"))?;
            match name.as_str() {
                "--points" => options.points = value.split(',').map(str::parse).collect::<Result<_, _>>()?,
                "--min-alpha" => options.min_alpha = value.parse()?,
                "--max-beta" => options.max_beta = value.parse()?,
                _ => return Err(format!("unknown option {name}").into()),
            }
        }
        Ok(options)
    }
}

/// A row of the reference.
struct Reference {
    parameters: Parameters,
    /// In the order of [`QUANTITIES`].
    values: [f64; 4],
}

fn reference(options: &Options) -> Result<Vec<Reference>, Box<dyn Error>> {
    let mut rows = Vec::new();
    for record in csv::Reader::from_path(REFERENCE)?.records() {
        let row = record?.iter().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let &[f, alpha, beta, c, film_min, _, _, viscoelastic, film, cavity, _, _] = &row[..] else {
            return Err(format!("{} columns in {REFERENCE}, not 12", row.len()).into());
        };
        let parameters = if f == 0.0 { Parameters::elastic(beta) } else { Parameters::new(alpha, beta, f) };
        if parameters.alpha >= options.min_alpha && beta <= options.max_beta {
            rows.push(Reference { parameters, values: [viscoelastic, film + cavity, c, film_min] });
        }
    }
    Ok(rows)
}

/// What a case gave on one grid.
struct OnGrid {
    errors: Result<GridErrors, String>,
    passes: u64,
    seconds: f64,
}

/// Errors of a case on one grid.
struct GridErrors {
    /// In the order of [`QUANTITIES`].
    relative: [f64; 4],
    /// Largest error of the flow at mid-points over the film.
    flow: f64,
}

/// Relative errors; F_v of an elastic substrate is zero, its error is taken over F_tot.
fn relative_errors(quantities: &Quantities, values: &[f64; 4]) -> [f64; 4] {
    let friction = &quantities.friction;
    let found = [friction.viscoelastic, friction.hydrodynamic(), quantities.c, quantities.film_min];
    std::array::from_fn(|i| {
        let scale = if values[i] == 0.0 { values[0] + values[1] } else { values[i] };
        (found[i] - values[i]) / scale
    })
}

/// The points of the automatic domain, from two half widths behind the dry contact to three ahead.
fn grid(parameters: &Parameters, points: usize) -> Vec<f64> {
    let (trailing, leading, half_width) = contact_bounds(parameters);
    let (from, to) = (trailing - 2.0 * half_width, leading + 3.0 * half_width);
    (0..points).map(|i| from + (to - from) * i as f64 / (points - 1) as f64).collect()
}

/// One chain, cases of the same f and α and ascending β, on one grid.
fn solve(chain: &[Reference], points: usize, acceleration: Acceleration) -> Vec<OnGrid> {
    let solver = RelaxationSolver::new(Settings { points, acceleration, ..Settings::default() });
    let x = grid(&chain[0].parameters, points);
    let fields = FieldSelection { pressure: true, film_thickness: true, ..FieldSelection::default() };
    let output = Output { fields, x: x.clone().into(), limits: false, ..Output::default() };
    let cases: Vec<Parameters> = chain.iter().map(|row| row.parameters.clone()).collect();
    let solved = solve_chain(&solver, &cases, &output, &Interrupt::new()).expect("nobody interrupts");
    let on_grid = |(row, case): (&Reference, SolvedCase)| OnGrid {
        errors: case.outcome.map_err(|failure| failure.to_string()).map(|solution| GridErrors {
            relative: relative_errors(&solution.quantities, &row.values),
            flow: flow_error(&solution.fields, &x, row.parameters.beta, solution.quantities.c),
        }),
        passes: case.effort.iterations,
        seconds: case.effort.seconds,
    };
    chain.iter().zip(solved).map(on_grid).collect()
}

/// A case on every grid.
struct Case<'a> {
    row: &'a Reference,
    grids: Vec<OnGrid>,
}

impl Case<'_> {
    fn error(&self, grid: usize, quantity: usize) -> Option<f64> {
        self.grids[grid].errors.as_ref().ok().map(|errors| errors.relative[quantity])
    }

    /// Observed order between a grid and the next one; `None` where a grid failed, or below what the reference knows.
    fn order(&self, grid: usize, quantity: usize) -> Option<f64> {
        const KNOWN: f64 = 1e-6;
        let (coarse, fine) = (self.error(grid, quantity)?.abs(), self.error(grid + 1, quantity)?.abs());
        (fine > KNOWN).then(|| (coarse / fine).log2())
    }

    fn is_resolved(&self, grid: usize) -> bool {
        self.grids[grid].errors.as_ref().is_ok_and(|errors| errors.flow <= RESOLVED)
    }

    /// A number for each grid, or the word that it failed.
    fn on_grids(&self, number: impl Fn(&OnGrid) -> Option<String>) -> String {
        let cells = self.grids.iter().map(|grid| number(grid).unwrap_or_else(|| "failed".to_owned()));
        cells.collect::<Vec<_>>().join(" ")
    }

    /// One row of the table.
    fn line(&self) -> String {
        let Parameters { alpha, beta, f, .. } = self.row.parameters;
        let mut cells = vec![f.to_string(), alpha.to_string(), beta.to_string()];
        for quantity in 0..QUANTITIES.len() {
            let errors = |grid: &OnGrid| grid.errors.as_ref().ok().map(|e| format!("{:.0e}", e.relative[quantity]));
            let orders = (1..self.grids.len())
                .map(|grid| self.order(grid - 1, quantity).map_or("–".to_owned(), |order| format!("{order:.1}")));
            cells.push(self.on_grids(errors));
            cells.push(orders.collect::<Vec<_>>().join(" "));
        }
        cells.push(self.on_grids(|grid| grid.errors.as_ref().ok().map(|e| format!("{:.1}", 100.0 * e.flow))));
        cells.push(self.remark());
        cells.push(self.on_grids(|grid| Some(grid.passes.to_string())));
        cells.push(self.on_grids(|grid| Some(format!("{:.2}", grid.seconds))));
        format!("| {} |", cells.join(" | "))
    }

    /// From where on the film is resolved, and whether the order is then the second.
    fn remark(&self) -> String {
        let Some(first) = (0..self.grids.len()).find(|&grid| self.is_resolved(grid)) else {
            return "not resolved".to_owned();
        };
        let is_odd = |quantity: &usize| {
            let mut orders = (first..self.grids.len() - 1).filter_map(|grid| self.order(grid, *quantity));
            orders.any(|order| !SECOND_ORDER.contains(&order))
        };
        let odd: Vec<&str> = (0..QUANTITIES.len()).filter(is_odd).map(|quantity| QUANTITIES[quantity]).collect();
        let from = if first == 0 { "resolved".to_owned() } else { format!("resolved from grid {}", first + 1) };
        if odd.is_empty() { from } else { format!("{from}; order not 2: {}", odd.join(", ")) }
    }
}

fn median_and_worst(mut errors: Vec<f64>) -> String {
    errors.sort_by(f64::total_cmp);
    let worst = errors.last().map(|worst| format!("{:.1e} / {worst:.1e}", errors[errors.len() / 2]));
    worst.unwrap_or_else(|| "–".to_owned())
}

/// Median and worst error of each quantity on each grid, of all cases that converged and of those that are resolved.
fn print_errors(cases: &[Case], points: &[usize]) {
    println!("\nMedian and worst error:\n");
    println!("| points | cases | {} | passes | seconds |", QUANTITIES.join(" | "));
    println!("| --- | --- | {}--- | --- |", "--- | ".repeat(QUANTITIES.len()));
    for (grid, points) in points.iter().enumerate() {
        let converged = |case: &&Case| case.grids[grid].errors.is_ok();
        let all: Vec<&Case> = cases.iter().filter(converged).collect();
        let resolved: Vec<&Case> = all.iter().copied().filter(|case| case.is_resolved(grid)).collect();
        let of_all = format!("{} of {} converged", all.len(), cases.len());
        for (counted, name) in [(&all, of_all), (&resolved, format!("{} resolved", resolved.len()))] {
            let errors = |quantity| {
                median_and_worst(counted.iter().filter_map(|case| case.error(grid, quantity)).map(f64::abs).collect())
            };
            let errors: Vec<String> = (0..QUANTITIES.len()).map(errors).collect();
            let passes: u64 = counted.iter().map(|case| case.grids[grid].passes).sum();
            let seconds: f64 = counted.iter().map(|case| case.grids[grid].seconds).sum();
            println!("| {points} | {name} | {} | {passes} | {seconds:.1} |", errors.join(" | "));
        }
    }
}

/// Median, least and greatest order between two grids, of the cases that are resolved on the coarser.
fn print_orders(cases: &[Case], points: &[usize]) {
    println!("\nMedian order (least to greatest) of the resolved cases:\n");
    println!("| grids | {} |", QUANTITIES.join(" | "));
    println!("| --- | {}", "--- | ".repeat(QUANTITIES.len()).trim_end());
    for (grid, pair) in points.windows(2).enumerate() {
        let orders = |quantity| {
            let resolved = cases.iter().filter(|case| case.is_resolved(grid));
            let mut orders: Vec<f64> = resolved.filter_map(|case| case.order(grid, quantity)).collect();
            orders.sort_by(f64::total_cmp);
            let text = |median: &f64| format!("{median:.2} ({:.1} to {:.1})", orders[0], orders[orders.len() - 1]);
            orders.get(orders.len() / 2).map_or("–".to_owned(), text)
        };
        println!("| {} to {} | {} |", pair[0], pair[1], (0..4).map(orders).collect::<Vec<_>>().join(" | "));
    }
}

fn print_failures(cases: &[Case], points: &[usize]) {
    for case in cases {
        let Parameters { alpha, beta, f, .. } = case.row.parameters;
        for (on_grid, points) in case.grids.iter().zip(points) {
            if let Err(reason) = &on_grid.errors {
                println!("\nFailed: f = {f}, α = {alpha}, β = {beta}, {points} points: {reason}");
            }
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse()?;
    let (points, rows) = (&options.points, reference(&options)?);
    let same_chain =
        |a: &Reference, b: &Reference| (a.parameters.f, a.parameters.alpha) == (b.parameters.f, b.parameters.alpha);
    let chains: Vec<&[Reference]> = rows.chunk_by(same_chain).collect();
    // the long ones first, so that no thread is left with one at the end
    let jobs: Vec<(usize, &[Reference])> =
        points.iter().rev().flat_map(|&points| chains.iter().map(move |&chain| (points, chain))).collect();
    let solve_job = |(points, chain): (usize, &[Reference])| solve(chain, points, options.acceleration);
    let by_grid: Vec<Vec<OnGrid>> = jobs.into_par_iter().with_max_len(1).map(solve_job).collect();

    let mut cases: Vec<Case> = rows.iter().map(|row| Case { row, grids: Vec::new() }).collect();
    // each grid's chains, one after the other, are its rows
    for (case, on_grid) in (0..rows.len()).cycle().zip(by_grid.into_iter().flatten()) {
        cases[case].grids.insert(0, on_grid);
    }

    let names: Vec<String> = points.iter().map(usize::to_string).collect();
    println!("Relative errors with {} points (F_v at f = 0: over F_tot), one number per grid.\n", names.join(", "));
    let columns: Vec<String> = QUANTITIES.iter().map(|name| format!("{name} | order")).collect();
    println!("| f | α | β | {} | flow error, % | film | passes | seconds |", columns.join(" | "));
    println!("| --- | --- | --- | {}--- | --- | --- | --- |", "--- | ".repeat(2 * QUANTITIES.len()));
    cases.iter().for_each(|case| println!("{}", case.line()));
    print_errors(&cases, points);
    print_orders(&cases, points);
    print_failures(&cases, points);
    Ok(())
}
