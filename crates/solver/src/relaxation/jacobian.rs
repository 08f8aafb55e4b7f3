//! The Jacobian of the discrete equations.

use std::f64::consts::PI;

use super::iteration::Iteration;
use super::{RelaxationSolver, State, Workspace, reynolds};
use crate::model::Parameters;

impl RelaxationSolver {
    /// The Jacobian of the discrete equations at a solution on the grid of the workspace.
    ///
    /// Column by column. One row for each point under pressure, the derivatives of
    /// A p_{i−1} + B p_i + C p_{i+1} − D (T20) with the film u = h₀ + x²/2 − χ∗p slaved to the pressure (T3), so that the
    /// rows are dense; and one row for the load (T4). The unknowns are the dimensionless p at the same points, and h₀ for
    /// the kernel whose mean at half a contact's width vanishes, as the iteration has it. What stays as it is: the points
    /// without pressure, and the pressure at the end of the grid with the load ahead of it, which follow explicitly from
    /// the rest.
    pub fn jacobian(&self, workspace: &Workspace, parameters: &Parameters, state: &State) -> Vec<Vec<f64>> {
        jacobian(&Iteration::new(workspace.finest(), parameters.beta, state))
    }
}

/// Where p > 0, but for the end of the grid.
fn under_pressure(p: &[f64]) -> Vec<usize> {
    (1..p.len() - 1).filter(|&i| p[i] > 0.0).collect()
}

/// Derivatives of the equations of m points under pressure, then of the load, with respect to the m pressures, then to
/// h₀: (m + 1) × (m + 1).
fn jacobian(solution: &Iteration) -> Vec<Vec<f64>> {
    let (p, u, shared) = (&solution.p, &solution.u, solution.shared);
    let (beta, dx) = (solution.beta, shared.grid.spacing());
    let points = under_pressure(p);
    let count = points.len();
    let around = |values: &[f64], i: usize| [values[i - 1], values[i], values[i + 1]];
    let by_film: Vec<[f64; 3]> =
        points.iter().map(|&i| reynolds::film_derivatives(around(p, i), around(u, i), beta, dx)).collect();

    let mut columns = vec![vec![0.0; count + 1]; count + 1];
    let (mut unit, mut influence) = (vec![0.0; p.len()], vec![0.0; p.len()]);
    let mut space = shared.deformation.space();
    for (column, &k) in points.iter().enumerate() {
        unit[k] = 1.0;
        shared.deformation.displace(&unit, 0.0, &mut influence, &mut space);
        unit[k] = 0.0;
        for (row, (&i, by_film)) in points.iter().zip(&by_film).enumerate() {
            // ∂u/∂p_k = −χ
            columns[column][row] = -dot(by_film, &around(&influence, i));
        }
        columns[column][count] = 2.0 / PI * dx;
    }
    for (row, (&i, by_film)) in points.iter().zip(&by_film).enumerate() {
        let coefficients = reynolds::row(around(u, i), beta, dx);
        for (k, coefficient) in [i - 1, i, i + 1].into_iter().zip(coefficients) {
            if let Ok(column) = points.binary_search(&k) {
                columns[column][row] += coefficient;
            }
        }
        columns[count][row] = by_film.iter().sum();
    }
    columns
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::super::Settings;
    use super::*;
    use crate::continuation::{CaseSolver, Interrupt, SolveContext};
    use crate::model::{FieldSelection, Output};

    /// A case solved alone.
    fn solved(points: usize, parameters: &Parameters) -> (RelaxationSolver, Workspace, State) {
        let output = Output { fields: FieldSelection::default(), ..Output::default() };
        let interrupt = Interrupt::new();
        let mut context = SolveContext::new(&interrupt);
        let solver = RelaxationSolver::new(Settings { points, ..Settings::default() });
        let mut workspace = solver.prepare(parameters, &output).expect("the automatic domain fits");
        let (guess, _) = solver.start(&mut workspace, parameters, &mut context).expect("a start");
        let state = solver.solve(&mut workspace, parameters, guess, &mut context).expect("a solution");
        (solver, workspace, state)
    }

    /// Films that so many points resolve.
    fn cases(points: usize) -> [Parameters; 4] {
        let thickness = if points < 101 { 0.1 } else { 1.0 };
        [(f64::INFINITY, 20.0, 0.0), (1.0, 30.0, 10.0), (10.0, 100.0, 100.0), (0.01, 100.0, 10.0)]
            .map(|(alpha, beta, f)| Parameters::new(alpha, beta * thickness, f))
    }

    /// The equations themselves, in the order of the rows of [`jacobian`].
    fn equations(iteration: &Iteration, points: &[usize]) -> Vec<f64> {
        let (p, u, dx) = (&iteration.p, &iteration.u, iteration.shared.grid.spacing());
        let equation = |&i: &usize| {
            let [a, b, c, d] = reynolds::row([u[i - 1], u[i], u[i + 1]], iteration.beta, dx);
            a * p[i - 1] + b * p[i] + c * p[i + 1] - d
        };
        points.iter().map(equation).chain([iteration.load_residual()]).collect()
    }

    /// Each column is the central difference of the equations.
    #[test]
    fn the_jacobian_is_the_derivative_of_the_equations() {
        for points in [51, 101] {
            for parameters in cases(points) {
                let (_, workspace, state) = solved(points, &parameters);
                let mut iteration = Iteration::new(workspace.finest(), parameters.beta, &state);
                let (rows, found) = (under_pressure(&state.pressure), jacobian(&iteration));
                for column in 0..=rows.len() {
                    let step = 1e-4 * state.c;
                    let mut moved = |step: f64| {
                        let mut moved = state.clone();
                        match rows.get(column) {
                            Some(&k) => moved.pressure[k] += step,
                            None => moved.separation += step,
                        }
                        iteration.restore(&moved);
                        equations(&iteration, &rows)
                    };
                    let (forward, backward) = (moved(step), moved(-step));
                    for (row, (forward, backward)) in forward.iter().zip(&backward).enumerate() {
                        let difference = (forward - backward) / (2.0 * step);
                        let scale = found.iter().fold(0.0, |largest: f64, values| largest.max(values[row].abs()));
                        let error = (difference - found[column][row]).abs() / scale;
                        assert!(error < 1e-6, "{parameters:?}, {points} points, ({row}, {column}): {error:e}");
                    }
                }
            }
        }
    }
}
