//! The equations on a mesh: residuals, and the matrix of Newton's method.

use std::f64::consts::FRAC_PI_2;

use super::displacement::Displacement;
use super::inlet::Inlet;
use super::reference::dot;
use super::state::State;
use crate::linear::{Matrix, wide};

/// Reynolds' equation integrated once (T2): β p′ u³ + u − c; zero where the flow is conserved.
pub fn flow_residual(beta: f64, pressure_gradient: f64, film: f64, c: f64) -> f64 {
    beta * pressure_gradient * film.powi(3) + film - c
}

/// The system of one case on one mesh, linearised about a state.
///
/// Unknowns are p at the nodes, u at the Gauss points, c and x_out. p is 0 at the outlet, and at Y that of the
/// [`Inlet`]. With u = c at the outlet (T5) the film equation (T12) is u = c + x_out y + y²/2 − W p, W being the
/// displacement relative to the outlet. It is linear: it gives δu, and what is left is
///
/// ```text
///             δp (m·d − 1)                     δc        δx_out
///   ┌                                                              ┐
///   │  βu²D − a∘W                             3βp′u       a y       │  flow / u (T2), m·d rows
///   │  node weights                             0        −p(X)      │  load (T4)
///   └                                                              ┘
/// ```
///
/// with D the derivative and a = (3βp′u² + 1)/u. The last node, whose pressure follows from the inlet, adds
/// its column times dp(Y)/dx_out to that of x_out; the derivatives of the inlet with respect to c and u are left out.
#[derive(Default)]
pub struct System {
    /// p′ at the Gauss points.
    gradient: Vec<f64>,
    /// W p at the film's rows.
    displacement: Vec<f64>,
    /// u less the right side of the film equation.
    film_residual: Vec<f64>,
    /// ∂(flow residual/u)/∂u.
    stiffness: Vec<f64>,
    /// Ahead of the mesh.
    inlet: Option<Inlet>,
    /// What is lacking in p(Y).
    end_correction: f64,
    /// The right side, and then the step.
    pub right_side: Vec<f64>,
    /// Change of p at the nodes.
    step_pressure: Vec<f64>,
    /// Change of u at the Gauss points.
    step_film: Vec<f64>,
    step_displacement: Vec<f64>,
}

/// Number of unknowns of the reduced system.
pub fn unknowns(displacement: &Displacement) -> usize {
    displacement.discretisation.film_points() + 1
}

/// p′ at the Gauss points.
pub fn pressure_gradient(displacement: &Displacement, pressure: &[f64], gradient: &mut Vec<f64>) {
    let discretisation = &displacement.discretisation;
    let reference = &discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    gradient.clear();
    for (panel, ends) in discretisation.mesh.film.windows(2).enumerate() {
        let nodes = &pressure[panel * degree..panel * degree + size];
        let scale = 2.0 / (ends[1] - ends[0]);
        gradient.extend(reference.derivative.chunks_exact(size).map(|row| scale * dot(row, nodes)));
    }
}

impl System {
    /// Residuals of a state; the right side is left in `right_side`.
    pub fn linearise(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        self.displacement.resize(displacement.discretisation.film_points(), 0.0);
        displacement.relative.multiply(&state.pressure, &mut self.displacement);
        self.linearise_advanced(displacement, beta, state);
    }

    /// The same for the state that was [advanced](System::advance) last, whose displacement is known.
    pub fn linearise_advanced(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        let discretisation = &displacement.discretisation;
        let points = discretisation.film_points();
        pressure_gradient(displacement, &state.pressure, &mut self.gradient);

        self.film_residual.clear();
        let y = discretisation.film_y();
        self.film_residual.extend(
            (0..points)
                .map(|i| state.film[i] - (state.c + state.outlet * y[i] + 0.5 * y[i] * y[i] - self.displacement[i])),
        );
        let reach = discretisation.mesh.reach();
        let x = state.outlet + reach;
        let last_y = y[points - 1];
        // the film at the last Gauss point is carried on to Y as a parabola
        let end_film = state.film[points - 1] + 0.5 * (x * x - (state.outlet + last_y).powi(2));
        let inlet = Inlet::new(beta, x, end_film, state.c);
        self.end_correction = inlet.pressure - state.pressure[points];

        self.right_side.clear();
        self.stiffness.clear();
        for i in 0..points {
            let (u, gradient) = (state.film[i], self.gradient[i]);
            let a = (3.0 * beta * gradient * u * u + 1.0) / u;
            self.stiffness.push(a);
            self.right_side.push(-flow_residual(beta, gradient, u, state.c) / u + a * self.film_residual[i]);
        }
        let load = dot(&discretisation.node_weights, &state.pressure) + inlet.load - FRAC_PI_2;
        self.right_side.push(-load);
        self.inlet = Some(inlet);
    }

    /// The matrix about the state of the last [`System::linearise`].
    pub fn matrix(&self, displacement: &Displacement, beta: f64, state: &State, matrix: &mut Matrix) {
        wide(
            #[inline(always)]
            || self.assemble(displacement, beta, state, matrix),
        );
    }

    #[inline(always)]
    fn assemble(&self, displacement: &Displacement, beta: f64, state: &State, matrix: &mut Matrix) {
        let discretisation = &displacement.discretisation;
        let points = discretisation.film_points();
        matrix.reshape(points + 1, points + 1);
        let inlet = self.inlet();
        for node in 1..=points {
            // the last node is not an unknown of its own: its column counts with dp(Y)/dx_out
            let last = node == points;
            let column = matrix.column_mut(if last { points } else { node - 1 });
            let factor = if last { inlet.gradient } else { 1.0 };
            self.set_node(displacement, beta, state, node, factor, &mut column[..points]);
            column[points] = factor * discretisation.node_weights[node];
        }
        let c_column = matrix.column_mut(points - 1);
        for ((entry, gradient), u) in c_column.iter_mut().zip(&self.gradient).zip(&state.film) {
            *entry = 3.0 * beta * gradient * u;
        }
        c_column[points] = 0.0;
        let outlet = matrix.column_mut(points);
        for ((entry, a), y) in outlet.iter_mut().zip(&self.stiffness).zip(discretisation.film_y()) {
            *entry += a * y;
        }
        // d(∫ p dx ahead of X)/dX = −p(X)
        outlet[points] -= inlet.pressure;
    }

    /// Sets the rows of the flow in a column to a factor times what p at a node does to them. Six arguments: the
    /// operands of the equations, and the place of one column.
    #[inline(always)]
    pub fn set_node(
        &self,
        displacement: &Displacement,
        beta: f64,
        state: &State,
        node: usize,
        factor: f64,
        column: &mut [f64],
    ) {
        let discretisation = &displacement.discretisation;
        let reference = &discretisation.reference;
        let (degree, size) = (reference.degree, reference.degree + 1);
        for ((entry, a), w) in column.iter_mut().zip(&self.stiffness).zip(displacement.relative.column(node)) {
            *entry = -factor * a * w;
        }
        // a node between two panels belongs to both
        let panels = discretisation.mesh.panels();
        for panel in (node - 1) / degree..=(node / degree).min(panels - 1) {
            let (ends, j) = (&discretisation.mesh.film[panel..=panel + 1], node - panel * degree);
            let factor = 2.0 * beta / (ends[1] - ends[0]) * factor;
            let rows = panel * degree..(panel + 1) * degree;
            let slopes = reference.derivative.iter().skip(j).step_by(size);
            for ((entry, u), slope) in column[rows.clone()].iter_mut().zip(&state.film[rows]).zip(slopes) {
                *entry += factor * u * u * slope;
            }
        }
    }

    /// p′ at the Gauss points of the state of the last [`System::linearise`].
    pub fn gradient(&self) -> &[f64] {
        &self.gradient
    }

    /// a = (3βp′u² + 1)/u there.
    pub fn stiffness(&self) -> &[f64] {
        &self.stiffness
    }

    /// Ahead of the mesh.
    pub fn inlet(&self) -> &Inlet {
        self.inlet.as_ref().expect("linearised before")
    }

    /// Takes the known change of p(Y) to the right side.
    pub fn fold_end(&mut self, displacement: &Displacement, beta: f64, state: &State) {
        let discretisation = &displacement.discretisation;
        let reference = &discretisation.reference;
        let (points, degree, size) = (discretisation.film_points(), reference.degree, reference.degree + 1);
        let change = self.end_correction;
        let displaced = displacement.relative.column(points);
        for ((value, a), w) in self.right_side.iter_mut().zip(&self.stiffness).zip(displaced) {
            *value += change * a * w;
        }
        self.right_side[points] -= change * discretisation.node_weights[points];
        let ends = &discretisation.mesh.film;
        let scale = 2.0 * beta / (ends[ends.len() - 1] - ends[ends.len() - 2]);
        for i in points - degree..points {
            let (u, row) = (state.film[i], i + degree - points);
            self.right_side[i] -= change * scale * u * u * reference.derivative[row * size + degree];
        }
    }

    /// The full step from the solution of the reduced system, which `right_side` holds now.
    pub fn expand(&mut self, displacement: &Displacement) {
        let discretisation = &displacement.discretisation;
        let points = discretisation.film_points();
        let solution = &self.right_side;
        let (c, outlet) = (solution[points - 1], solution[points]);
        let inlet = *self.inlet();
        self.step_pressure.clear();
        self.step_pressure.push(0.0);
        self.step_pressure.extend_from_slice(&solution[..points - 1]);
        self.step_pressure.push(self.end_correction + inlet.gradient * outlet);
        self.step_displacement.resize(points, 0.0);
        displacement.relative.multiply(&self.step_pressure, &mut self.step_displacement);
        self.step_film.clear();
        let y = discretisation.film_y();
        self.step_film
            .extend((0..points).map(|i| -self.film_residual[i] + c + outlet * y[i] - self.step_displacement[i]));
    }

    /// The part of the step, at most 1, that leaves every film at least a fifth of itself.
    pub fn admissible(&self, state: &State) -> f64 {
        const LEAST: f64 = 0.2;
        let points = self.step_film.len();
        let pairs = state.film.iter().zip(&self.step_film).chain([(&state.c, &self.right_side[points - 1])]);
        pairs.fold(
            1.0,
            |part: f64, (u, step)| if u + step < LEAST * u { part.min((LEAST - 1.0) * u / step) } else { part },
        )
    }

    /// The largest relative change of film and flow, and of pressure over the largest pressure, that the step makes.
    pub fn size(&self, state: &State) -> f64 {
        let points = self.step_film.len();
        let film = state.film.iter().zip(&self.step_film).map(|(u, step)| (step / u).abs()).fold(0.0, nan_max);
        let largest = state.pressure.iter().fold(0.0, |a: f64, p| a.max(p.abs()));
        let pressure = self.step_pressure.iter().fold(0.0, |a, step| nan_max(a, step.abs())) / largest;
        nan_max(nan_max(film, pressure), (self.right_side[points - 1] / state.c).abs())
    }

    /// Goes a part of the step.
    pub fn advance(&mut self, state: &mut State, part: f64) {
        let points = self.step_film.len();
        for (p, step) in state.pressure.iter_mut().zip(&self.step_pressure) {
            *p += part * step;
        }
        for (u, step) in state.film.iter_mut().zip(&self.step_film) {
            *u += part * step;
        }
        for (w, step) in self.displacement.iter_mut().zip(&self.step_displacement) {
            *w += part * step;
        }
        state.c += part * self.right_side[points - 1];
        state.outlet += part * self.right_side[points];
    }
}

/// The larger of two numbers; NaN if one of them is.
fn nan_max(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::newton::Corrector;
    use super::super::reference::ReferencePanel;
    use super::super::thick_film;
    use super::super::timings::Timings;
    use super::*;
    use crate::continuation::{Interrupt, SolveContext};
    use crate::model::{DisplacementKernel, Parameters};

    /// The matrix times a step against central differences of the residuals, about a solution. The step in p(Y) and u
    /// is the one that keeps to the inlet and to the film equation.
    #[test]
    fn matrix_is_the_derivative_of_the_residuals() {
        for (alpha, beta, f) in [(f64::INFINITY, 0.05, 0.0), (1.0, 0.05, 30.0), (0.01, 1.0, 1e3)] {
            let parameters = Parameters::new(alpha, beta, f);
            let mut displacement = Displacement::new(&Arc::new(ReferencePanel::new(6)));
            displacement.set_mesh(
                &thick_film::mesh(6, 3.0, beta, 500.0),
                &DisplacementKernel::new(&parameters),
                &mut Timings::default(),
            );
            let mut state = thick_film::state(&displacement, beta);
            let interrupt = Interrupt::new();
            let mut context = SolveContext::new(&interrupt);
            Corrector::default().correct(&displacement, beta, &mut state, 1e-13, &mut context).expect("a thick film");

            let mut system = System::default();
            system.linearise(&displacement, beta, &state);
            let n = unknowns(&displacement);
            let mut matrix = Matrix::default();
            system.matrix(&displacement, beta, &state, &mut matrix);
            let scales: Vec<f64> = (0..n).map(|i| if i < n - 2 { 0.1 } else { state.c }).collect();
            let direction: Vec<f64> =
                scales.iter().enumerate().map(|(i, s)| s * (0.3 + 1.7 * i as f64).sin()).collect();
            let mut predicted = vec![0.0; n];
            matrix.multiply(&direction, &mut predicted);

            let residuals = |part: f64| {
                let mut there = state.clone();
                let mut step = System::default();
                step.linearise(&displacement, beta, &state);
                step.right_side.copy_from_slice(&direction);
                step.expand(&displacement);
                step.advance(&mut there, part);
                step.linearise(&displacement, beta, &there);
                step.right_side
            };
            let epsilon = 1e-4 / (1.0 + f);
            let (ahead, behind) = (residuals(epsilon), residuals(-epsilon));
            let largest = predicted.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            for i in 0..n {
                // the right side is minus the residual
                let difference = (behind[i] - ahead[i]) / (2.0 * epsilon);
                let error = (difference - predicted[i]).abs();
                assert!(error < 3e-6 * largest.max(predicted[i].abs()), "row {i}: {} {difference}", predicted[i]);
            }
        }
    }
}
