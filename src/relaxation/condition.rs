//! How well the discrete equations determine their solution: the condition number of their Jacobian.

use std::f64::consts::PI;

use faer::linalg::solvers::DenseSolveCore;
use faer::{Mat, MatRef};

use super::iteration::Iteration;
use super::{RelaxationSolver, State, Workspace, reynolds};
use crate::model::Parameters;

impl RelaxationSolver {
    /// The condition number ‖J‖₁ ‖J⁻¹‖₁ of the discrete equations at a solution on the grid of the workspace, exact to
    /// rounding; infinite where J is singular.
    ///
    /// J has one row for each point under pressure, the derivatives of A p_{i−1} + B p_i + C p_{i+1} − D (T20) with the film
    /// u = h₀ + x²/2 − χ∗p slaved to the pressure (T3), so that the rows are dense; and one row for the load (T4). The unknowns are the
    /// dimensionless p at the same points, in their own units, and h₀ in units of c, for the kernel whose mean at half a
    /// contact's width vanishes, as the iteration has it. Each row is divided by its largest entry. What stays as it is: the points
    /// without pressure, and the pressure at the end of the grid with the load ahead of it, which follow explicitly from the rest.
    ///
    /// It takes O(n³) operations and 2n² numbers of memory for n points under pressure.
    pub fn condition(&self, workspace: &Workspace, parameters: &Parameters, state: &State) -> f64 {
        condition_number(&scaled_jacobian(&Iteration::new(workspace.finest(), parameters.beta, state)))
    }
}

/// J with h₀ in units of c and each row over its largest entry.
fn scaled_jacobian(solution: &Iteration) -> Mat<f64> {
    let mut jacobian = jacobian(solution);
    let separation = jacobian.ncols() - 1;
    jacobian.col_mut(separation).iter_mut().for_each(|value| *value *= solution.c());
    for i in 0..jacobian.nrows() {
        let largest = jacobian.row(i).iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        jacobian.row_mut(i).iter_mut().for_each(|value| *value /= largest);
    }
    jacobian
}

/// ‖A‖₁ ‖A⁻¹‖₁.
fn condition_number(matrix: &Mat<f64>) -> f64 {
    let inverse = matrix.partial_piv_lu().inverse();
    let number = one_norm(matrix.as_ref()) * one_norm(inverse.as_ref());
    if number.is_finite() { number } else { f64::INFINITY }
}

/// ‖A‖₁, the largest sum of a column's absolute values; NaN if it holds one.
fn one_norm(matrix: MatRef<'_, f64>) -> f64 {
    let sums = matrix.col_iter().map(|column| column.iter().map(|value| value.abs()).sum::<f64>());
    sums.fold(0.0, |largest, sum| if sum > largest || sum.is_nan() { sum } else { largest })
}

/// Where p > 0, but for the end of the grid.
fn under_pressure(p: &[f64]) -> Vec<usize> {
    (1..p.len() - 1).filter(|&i| p[i] > 0.0).collect()
}

/// Derivatives of the equations of m points under pressure, then of the load, with respect to the m pressures, then to h₀:
/// (m + 1) × (m + 1).
fn jacobian(solution: &Iteration) -> Mat<f64> {
    let (p, u, shared) = (&solution.p, &solution.u, solution.shared);
    let (beta, dx) = (solution.beta, shared.grid.spacing());
    let points = under_pressure(p);
    let count = points.len();
    let around = |values: &[f64], i: usize| [values[i - 1], values[i], values[i + 1]];
    let by_film: Vec<[f64; 3]> =
        points.iter().map(|&i| reynolds::film_derivatives(around(p, i), around(u, i), beta, dx)).collect();

    let mut jacobian = Mat::zeros(count + 1, count + 1);
    let (mut unit, mut influence) = (vec![0.0; p.len()], vec![0.0; p.len()]);
    let mut space = shared.deformation.space();
    for (column, &k) in points.iter().enumerate() {
        unit[k] = 1.0;
        shared.deformation.displace(&unit, 0.0, &mut influence, &mut space);
        unit[k] = 0.0;
        for (row, (&i, by_film)) in points.iter().zip(&by_film).enumerate() {
            // ∂u/∂p_k = −χ
            jacobian[(row, column)] = -dot(by_film, &around(&influence, i));
        }
        jacobian[(count, column)] = 2.0 / PI * dx;
    }
    for (row, (&i, by_film)) in points.iter().zip(&by_film).enumerate() {
        let coefficients = reynolds::row(around(u, i), beta, dx);
        for (k, coefficient) in [i - 1, i, i + 1].into_iter().zip(coefficients) {
            if let Ok(column) = points.binary_search(&k) {
                jacobian[(row, column)] += coefficient;
            }
        }
        jacobian[(row, count)] = by_film.iter().sum();
    }
    jacobian
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::super::Settings;
    use super::*;
    use crate::continuation::{CaseSolver, Interrupt, Work};
    use crate::model::{FieldSelection, Output};

    /// A case solved alone.
    fn solved(points: usize, parameters: &Parameters) -> (RelaxationSolver, Workspace, State) {
        let output = Output { fields: FieldSelection::default(), ..Output::default() };
        let interrupt = Interrupt::new();
        let mut work = Work::new(&interrupt);
        let solver = RelaxationSolver::new(Settings { points, ..Settings::default() });
        let mut workspace = solver.prepare(parameters, &output).expect("the automatic domain fits");
        let (guess, _) = solver.start(&mut workspace, parameters, &mut work).expect("a start");
        let state = solver.solve(&mut workspace, parameters, guess, &mut work).expect("a solution");
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
                        let scale = found.row(row).iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
                        let error = (difference - found[(row, column)]).abs() / scale;
                        assert!(error < 1e-6, "{parameters:?}, {points} points, ({row}, {column}): {error:e}");
                    }
                }
            }
        }
    }

    /// κ₂/m ≤ κ₁ ≤ m κ₂ for a matrix of m rows, and κ₂ is the ratio of its singular values.
    #[test]
    fn the_condition_number_is_bounded_by_the_singular_values() {
        for parameters in cases(51) {
            let (_, workspace, state) = solved(51, &parameters);
            let scaled = scaled_jacobian(&Iteration::new(workspace.finest(), parameters.beta, &state));
            for i in 0..scaled.nrows() {
                let largest = scaled.row(i).iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
                assert!((largest - 1.0).abs() < 1e-15, "{parameters:?}, row {i}: {largest}");
            }
            let singular = scaled.singular_values().expect("the decomposition converges");
            let (two_norm, size) = (singular[0] / singular[singular.len() - 1], scaled.nrows() as f64);
            let number = condition_number(&scaled);
            assert!(number >= two_norm / size && number <= two_norm * size, "{parameters:?}: {number:e}, {two_norm:e}");
        }
        assert_eq!(condition_number(&Mat::identity(5, 5)), 1.0);
        assert_eq!(condition_number(&Mat::full(3, 3, 1.0)), f64::INFINITY);
    }

    /// The equations are second differences: four times the condition number on half the step, less where the grid is
    /// so coarse that the answer of the film rules.
    #[test]
    fn the_condition_number_grows_as_the_grid_is_refined() {
        for parameters in cases(201) {
            let numbers = [201, 401, 801].map(|points| {
                let (solver, workspace, state) = solved(points, &parameters);
                solver.condition(&workspace, &parameters, &state)
            });
            let growth = [numbers[1] / numbers[0], numbers[2] / numbers[1]];
            assert!(growth[0] > 2.5 && growth[0] < growth[1] && growth[1] < 4.2, "{parameters:?}: {numbers:?}");
            assert!(growth[1] > 3.4, "{parameters:?}: {numbers:?}");
        }
    }
}
