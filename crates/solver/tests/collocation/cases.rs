//! Ways to solve cases for the tests.

use std::sync::{Arc, LazyLock};

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, Solution, SolvedCase, solve_chain};
use stribeck_solver::{FieldSelection, Output, Parameters, Quantities, RetardationMode, Substrate};

use crate::collocation::measure::{EXACT, reference};

/// Panels of the usual degree.
pub fn settings(tolerance: f64) -> Settings {
    Settings { tolerance, ..Settings::default() }
}

/// No field, no limits.
pub fn numbers() -> Output {
    Output { fields: FieldSelection::default(), limits: false, ..Output::default() }
}

/// Every field at these places.
pub fn fields_at(x: impl Into<Arc<[f64]>>) -> Output {
    Output { x: x.into(), limits: false, ..Output::default() }
}

/// What comes of a chain.
pub fn outcomes(settings: Settings, cases: &[Parameters], output: &Output) -> Vec<SolvedCase> {
    solve_chain(&CollocationSolver::new(settings), cases, output, &Interrupt::new()).expect("nobody interrupts")
}

/// The solutions of a chain in which no case may fail.
pub fn solutions(settings: Settings, cases: &[Parameters], output: &Output) -> Vec<Solution> {
    let solved = outcomes(settings, cases, output).into_iter().zip(cases);
    solved.map(|(case, parameters)| case.outcome.unwrap_or_else(|why| panic!("{parameters:?}: {why}"))).collect()
}

/// The solution of one case.
pub fn solution(settings: Settings, parameters: &Parameters, output: &Output) -> Solution {
    solutions(settings, std::slice::from_ref(parameters), output).remove(0)
}

/// The numbers of one case for a tolerance.
pub fn quantities(tolerance: f64, parameters: &Parameters) -> Quantities {
    solution(settings(tolerance), parameters, &numbers()).quantities
}

/// A case with these modes, (share, time) each.
pub fn with_modes(alpha: f64, beta: f64, f: f64, modes: &[(f64, f64)]) -> Parameters {
    let modes = modes.iter().map(|&(share, time)| RetardationMode { share, time }).collect();
    Parameters { substrate: Substrate::new(modes).expect("shares add up to 1"), ..Parameters::new(alpha, beta, f) }
}

/// The rows of the reference.
pub static ROWS: LazyLock<Vec<Parameters>> = LazyLock::new(|| reference().into_iter().map(|row| row.0).collect());
/// What counts as their exact numbers.
pub static EXACTLY: LazyLock<Vec<Quantities>> =
    LazyLock::new(|| ROWS.par_iter().map(|case| solution(EXACT, case, &numbers()).quantities).collect());

/// |a/b − 1|.
pub fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

/// The largest relative difference of c, u_min, p_max, F_v, F_h, its part in the cavity, and F_drag, the forces over
/// the drag; and of x_out over the width of the film under pressure (from it to the largest pressure).
pub fn difference(found: &Quantities, exact: &Quantities) -> f64 {
    let (friction, exactly) = (&found.friction, &exact.friction);
    let forces = [
        (friction.viscoelastic, exactly.viscoelastic),
        (friction.hydrodynamic_film, exactly.hydrodynamic_film),
        (friction.hydrodynamic_cavity, exactly.hydrodynamic_cavity),
        (friction.drag, exactly.drag),
    ];
    let pairs = [(found.c, exact.c), (found.film_min, exact.film_min), (found.p_max, exact.p_max)];
    let outlet = (found.x_outlet - exact.x_outlet).abs() / (exact.x_p_max - exact.x_outlet);
    let forces = forces.into_iter().map(|(a, b)| (a - b).abs() / exactly.drag);
    let all = forces.chain(pairs.into_iter().map(|(a, b)| relative(a, b))).chain([outlet]);
    all.fold(0.0, |a, b| if b.is_nan() || b > a { b } else { a })
}
