//! A chain solved by both methods.

use stribeck_solver::collocation::{self, CollocationSolver};
use stribeck_solver::continuation::{CaseSolver, Interrupt, SolvedCase, solve_chain};
use stribeck_solver::exact::contact_bounds;
use stribeck_solver::relaxation::{RelaxationSolver, Settings};
use stribeck_solver::{FieldSelection, Output, Parameters, Quantities};

use crate::flow_error::flow_error;

/// What is compared: names of [`Deviations::relative`].
pub const QUANTITIES: [&str; 4] = ["c", "u_min", "F_v", "F_h"];

/// How far the two methods are apart.
pub struct Deviations {
    /// |a/b − 1| of [`QUANTITIES`]; of F_v over F_tot.
    pub relative: [f64; 4],
    /// Largest |β p′u³ + u − c|/u at mid-points under pressure (T2): how well the grid resolves the film.
    pub flow: f64,
}

/// A case solved by both.
pub struct Compared {
    /// The case.
    pub parameters: Parameters,
    /// Deviations, or why the relaxation solver found nothing.
    pub deviations: Result<Deviations, String>,
    /// Passes of the relaxation solver.
    pub passes: u64,
    /// Its seconds.
    pub seconds: f64,
    /// Those of collocation.
    pub collocation_seconds: f64,
    /// Where the relaxation solver started.
    pub seed: String,
}

fn outcomes(solver: &impl CaseSolver, chain: &[Parameters], x: &[f64]) -> Vec<SolvedCase> {
    let fields = FieldSelection { pressure: true, film_thickness: true, ..FieldSelection::default() };
    let fields = if x.is_empty() { FieldSelection::default() } else { fields };
    let output = Output { fields, x: x.into(), limits: false, ..Output::default() };
    solve_chain(solver, chain, &output, &Interrupt::new()).expect("nobody interrupts")
}

/// Solves a chain by both; collocation is asked for 1e-6, or what it can reach up to 1e-3.
pub fn compare(solver: &RelaxationSolver, settings: Settings, chain: &[Parameters]) -> Vec<Compared> {
    // the points of the automatic domain
    let (trailing, leading, half_width) = contact_bounds(&chain[0]);
    let (from, length) = (trailing - 2.0 * half_width, leading - trailing + 5.0 * half_width);
    let x: Vec<f64> = (0..settings.points).map(|i| from + length * i as f64 / (settings.points - 1) as f64).collect();
    let exact =
        outcomes(&CollocationSolver::new(collocation::Settings { tolerance: 1e-6, ..Default::default() }), chain, &[]);
    let relaxed = outcomes(solver, chain, &x);
    let pair = |((parameters, relaxed), exact): ((&Parameters, SolvedCase), SolvedCase)| {
        let exactly = exact.outcome.or_else(|_| {
            let rough = CollocationSolver::new(collocation::Settings { tolerance: 1e-3, ..Default::default() });
            outcomes(&rough, std::slice::from_ref(parameters), &[]).remove(0).outcome
        });
        let deviations = relaxed.outcome.map_err(|failure| failure.to_string()).map(|solution| {
            let quantities = exactly.ok().map(|exact| exact.quantities);
            Deviations {
                relative: quantities.map_or([f64::NAN; 4], |exact| relative(&solution.quantities, &exact)),
                flow: flow_error(&solution.fields, &x, parameters.beta, solution.quantities.c),
            }
        });
        Compared {
            parameters: parameters.clone(),
            deviations,
            passes: relaxed.effort.iterations,
            seconds: relaxed.effort.seconds,
            collocation_seconds: exact.effort.seconds,
            seed: relaxed.seed.to_string(),
        }
    };
    chain.iter().zip(relaxed).zip(exact).map(pair).collect()
}

fn relative(found: &Quantities, exact: &Quantities) -> [f64; 4] {
    let off = |found: f64, exact: f64, scale: f64| ((found - exact) / scale).abs();
    let (friction, exactly) = (&found.friction, &exact.friction);
    [
        off(found.c, exact.c, exact.c),
        off(found.film_min, exact.film_min, exact.film_min),
        off(friction.viscoelastic, exactly.viscoelastic, exactly.total()),
        off(friction.hydrodynamic(), exactly.hydrodynamic(), exactly.hydrodynamic()),
    ]
}

/// Median and largest value, NaN as the largest; `None` of no values.
pub fn median_and_worst(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    Some((*values.get(values.len() / 2)?, *values.last()?))
}
