//! How a case was reached: its seed, and the trace of its iterations.

use std::fmt::Write;

use crate::format::filled;
use stribeck_solver::continuation::{Event, Seed, SolvedCase};
use stribeck_solver::shortest;

/// Residuals in one line.
const PER_LINE: usize = 6;

/// Says where a first guess came from.
pub fn describe_seed(seed: Seed) -> &'static str {
    match seed {
        Seed::Hertz => "pressure of the dry contact",
        Seed::Elastic => "the elastic solution at the same beta",
        Seed::RescaledElastic => "the elastic solution for the instantaneous modulus",
        Seed::ThickFilm => "the film of a rigid cylinder on a rigid plane",
        Seed::Table => "the built-in table of solutions",
        Seed::Neighbour => "the case before it in its chain",
        Seed::Predictor => "extrapolated from the two cases before it in its chain",
        Seed::Intermediate(_) => "the case before it in its chain, by way of cases between them that are not published",
        Seed::March(_) => "a case of thicker film, by way of cases that are not published",
        Seed::None => "there was no first guess",
    }
}

/// Lists the events on the way to a case: at each point the residuals of its iterations, and estimated errors.
pub fn describe_trace(case: &SolvedCase, residual_name: &str) -> String {
    let mut text = String::new();
    let written = "writing to memory does not fail";
    let mut residuals: Vec<(u64, f64)> = Vec::new();
    for event in &case.trace.events {
        if let Event::Residual { iteration, residual } = event {
            if residuals.last().is_some_and(|(last, _)| iteration <= last) {
                text += &table(&std::mem::take(&mut residuals), residual_name);
            }
            residuals.push((*iteration, *residual));
            continue;
        }
        text += &table(&std::mem::take(&mut residuals), residual_name);
        match event {
            Event::Attempt { alpha, beta, f } => {
                let [alpha, beta, f] = [*alpha, *beta, *f].map(shortest);
                writeln!(text, "at f = {f}, alpha = {alpha}, beta = {beta}").expect(written);
            }
            Event::Evaluation => text += "evaluation of the solution\n",
            Event::Error { unknowns, error } => {
                writeln!(text, "  {unknowns} unknowns: estimated error {error:.2} of the tolerance").expect(written);
            }
            Event::Solved => text += "  accepted\n",
            Event::Failed(reason) => text += &(filled(&format!("  not accepted: {reason}"), "    ") + "\n"),
            Event::Residual { .. } => unreachable!("residuals are gathered above"),
        }
    }
    text + &table(&residuals, residual_name)
}

/// Iterations and what each left, side by side.
fn table(residuals: &[(u64, f64)], residual_name: &str) -> String {
    let mut text = String::new();
    for line in residuals.chunks(PER_LINE) {
        let row = |name: &str, cell: &dyn Fn(&(u64, f64)) -> String| {
            let cells: String = line.iter().map(|pair| format!("{:>9}", cell(pair))).collect();
            format!("  {name:<19}{cells}\n")
        };
        text += &row("iteration", &|(iteration, _)| iteration.to_string());
        text += &row(residual_name, &|(_, residual)| format!("{residual:.1e}"));
    }
    text
}
