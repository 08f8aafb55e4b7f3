//! Newton steps on richer panels by the factors of the plain ones.

use std::array::from_fn;
use std::sync::Arc;

use super::displacement::Displacement;
use super::legendre::legendre;
use super::log_moments::MOST_MOMENTS;
use super::reference::{ReferencePanel, dot, evaluate, multiply};
use super::state::State;
use super::system::System;
use crate::linear::{Factorisation, wide};

/// How many degrees richer the panels of the estimate are.
pub const ENRICHMENT: usize = 2;
/// Polynomials that each panel solves for by itself, the highest ones; the lower half of them are among the plain ones,
/// too. With the richer ones alone the part of a step that is left is ten times as large; with more of them, what
/// neighbouring panels do to each other is too much.
const OWN: usize = 4;

/// One number for each of a panel's own polynomials.
type Own = [f64; OWN];

/// Tables of the reference panel for degree d and the richer one.
///
/// The own polynomials of a panel are bubbles, 0 at both ends, with the highest Legendre polynomials as their slopes.
/// They displace other panels little, as all their low moments are 0.
#[derive(Debug)]
pub struct Tables {
    degree: usize,
    /// The part of degree below d of a residual at the plain Gauss points, from the residual at the richer ones:
    /// d × (d + 2).
    restriction: Vec<f64>,
    /// The highest Legendre coefficients of a residual: own × (d + 2).
    coefficients: Vec<f64>,
    /// Values at the richer nodes from values at the plain ones: (d + 3) × (d + 1).
    embedding: Vec<f64>,
    /// The bubbles at the richer nodes.
    values: Vec<Own>,
    /// Their slopes at the richer Gauss points.
    slopes: Vec<Own>,
}

impl Tables {
    /// For panels of these degrees.
    pub fn new(plain: &ReferencePanel, rich: &ReferencePanel) -> Self {
        let (degree, points) = (plain.degree, rich.degree);
        assert_eq!(points, degree + ENRICHMENT, "estimates are made for one enrichment");
        let polynomials = |t: f64| {
            let mut values = [0.0; MOST_MOMENTS];
            legendre(t, &mut values[..=points]);
            values
        };
        let of_points = &rich.point_coefficients;
        let restriction = plain.points.iter().flat_map(|&t| {
            let values = polynomials(t);
            (0..points).map(move |i| (0..degree).map(|k| values[k] * of_points[k * points + i]).sum())
        });
        let of_node = |j: usize| plain.node_coefficients.iter().skip(j).step_by(degree + 1).copied().collect();
        let of_nodes: Vec<Vec<f64>> = (0..=degree).map(of_node).collect();
        let embedding = rich.nodes.iter().flat_map(|&t| of_nodes.iter().map(move |node| evaluate(node, t)));
        let own = |k: usize| k + points - OWN;
        // ∫ P_k from −1 on is (P_{k+1} − P_{k−1})/(2k + 1)
        let bubbles = |&t: &f64| {
            let values = polynomials(t);
            from_fn(|k| (values[own(k) + 1] - values[own(k) - 1]) / (2 * own(k) + 1) as f64)
        };
        Self {
            degree,
            restriction: restriction.collect(),
            coefficients: of_points[own(0) * points..].to_vec(),
            embedding: embedding.collect(),
            values: rich.nodes.iter().map(bubbles).collect(),
            slopes: rich.points.iter().map(|&t| from_fn(|k| polynomials(t)[own(k)])).collect(),
        }
    }
}

/// The matrix of the richer panels, nearly inverted: first each panel is solved for its own polynomials, then all
/// panels for the plain ones.
pub struct TwoLevel {
    tables: Arc<Tables>,
    /// What the bubbles of each panel do to the flow at its Gauss points.
    columns: Vec<Own>,
    /// For each panel, the inverse of what they do to the highest Legendre coefficients.
    inverses: Vec<[Own; OWN]>,
    /// Buffers: the parts of a step.
    bubbles: Vec<Own>,
    plain: Vec<f64>,
}

impl TwoLevel {
    /// Without panels.
    pub fn new(tables: &Arc<Tables>) -> Self {
        Self {
            tables: Arc::clone(tables),
            columns: Vec::new(),
            inverses: Vec::new(),
            bubbles: Vec::new(),
            plain: Vec::new(),
        }
    }

    /// Takes up what bubbles do about the state that a system of the richer panels was linearised about last.
    pub fn linearise(&mut self, system: &System, displacement: &Displacement, beta: f64, state: &State) {
        self.columns.clear();
        self.inverses.clear();
        for panel in 0..displacement.discretisation.mesh.panels() {
            wide(
                #[inline(always)]
                || self.linearise_panel(panel, system, displacement, beta, state),
            );
        }
    }

    /// Five arguments: the operands of the equations, and the panel.
    #[inline(always)]
    fn linearise_panel(
        &mut self,
        panel: usize,
        system: &System,
        displacement: &Displacement,
        beta: f64,
        state: &State,
    ) {
        let Self { tables, columns, inverses, .. } = self;
        let ends = &displacement.discretisation.mesh.film[panel..=panel + 1];
        let points = tables.degree + ENRICHMENT;
        let rows = panel * points..(panel + 1) * points;
        let mut displaced = [[0.0; OWN]; MOST_MOMENTS];
        for (node, bubbles) in tables.values.iter().enumerate().take(points).skip(1) {
            let column = &displacement.relative.column(rows.start + node)[rows.clone()];
            for (sums, w) in displaced.iter_mut().zip(column) {
                for (sum, bubble) in sums.iter_mut().zip(bubbles) {
                    *sum += w * bubble;
                }
            }
        }
        let scale = 2.0 * beta / (ends[1] - ends[0]);
        let (films, stiffness) = (&state.film[rows.clone()], &system.stiffness()[rows.clone()]);
        for (((u, a), slopes), displaced) in films.iter().zip(stiffness).zip(&tables.slopes).zip(&displaced) {
            columns.push(from_fn(|k| scale * u * u * slopes[k] - a * displaced[k]));
        }
        let here = &columns[rows];
        let coefficient = |k: usize, j: usize| -> f64 {
            let row = &tables.coefficients[k * points..(k + 1) * points];
            row.iter().zip(here).map(|(coefficient, column)| coefficient * column[j]).sum()
        };
        inverses.push(inverse(from_fn(|k| from_fn(|j| coefficient(k, j)))));
    }

    /// Replaces the right side of the system by a step that solves it but for a small part.
    pub fn solve(&mut self, plain_factors: &mut Factorisation, system: &mut System) {
        let Self { tables, columns, inverses, bubbles, plain } = self;
        let (degree, points) = (tables.degree, tables.degree + ENRICHMENT);
        let (richer, count) = (inverses.len() * points, inverses.len() * degree);
        let gradient_at_end = system.inlet().gradient;
        let right_side = &mut system.right_side;
        bubbles.clear();
        plain.resize(count + 1, 0.0);
        let residuals = right_side[..richer].chunks_exact_mut(points).zip(columns.chunks_exact(points));
        for (((residual, columns), inverse), plain) in residuals.zip(&*inverses).zip(plain.chunks_exact_mut(degree)) {
            let mut highest = [0.0; OWN];
            multiply(&tables.coefficients, residual, &mut highest);
            let own = inverse.map(|row| dot(&row, &highest));
            for (value, column) in residual.iter_mut().zip(columns) {
                *value -= dot(column, &own);
            }
            multiply(&tables.restriction, residual, plain);
            bubbles.push(own);
        }
        plain[count] = right_side[richer];
        plain_factors.solve(plain);

        let (c, outlet) = (plain[count - 1], plain[count]);
        plain[count - 1] = gradient_at_end * outlet;
        let mut nodes = [0.0; MOST_MOMENTS];
        let steps = right_side[..richer].chunks_exact_mut(points);
        for ((step, plain), own) in steps.zip(plain.chunks_exact(degree)).zip(bubbles) {
            nodes[1..=degree].copy_from_slice(plain);
            multiply(&tables.embedding[degree + 1..], &nodes[..=degree], step);
            for (value, bubbles) in step.iter_mut().zip(&tables.values[1..]) {
                *value += dot(bubbles, own);
            }
            nodes[0] = nodes[degree];
        }
        right_side[richer - 1] = c;
        right_side[richer] = outlet;
    }
}

/// The inverse of a small matrix, by Gauss and Jordan's method with pivots.
fn inverse(mut matrix: [Own; OWN]) -> [Own; OWN] {
    let mut inverse: [Own; OWN] = from_fn(|i| from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    for i in 0..OWN {
        let pivot = (i..OWN).fold(i, |best, k| if matrix[k][i].abs() > matrix[best][i].abs() { k } else { best });
        matrix.swap(i, pivot);
        inverse.swap(i, pivot);
        let scale = matrix[i][i].recip();
        matrix[i] = matrix[i].map(|value| scale * value);
        inverse[i] = inverse[i].map(|value| scale * value);
        for k in (0..OWN).filter(|&k| k != i) {
            let factor = matrix[k][i];
            matrix[k] = from_fn(|j| matrix[k][j] - factor * matrix[i][j]);
            inverse[k] = from_fn(|j| inverse[k][j] - factor * inverse[i][j]);
        }
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::super::estimate::enriched;
    use super::super::newton::Corrector;
    use super::super::thick_film;
    use super::super::timings::Timings;
    use super::*;
    use crate::continuation::{Effort, Interrupt, SolveContext};
    use crate::model::{DisplacementKernel, Parameters};

    #[test]
    fn the_inverse_times_the_matrix_is_one() {
        let matrix: [Own; OWN] = from_fn(|i| from_fn(|j| if i == j { 0.0 } else { ((3 * i + j) as f64).sin() }));
        let inverse = inverse(matrix);
        for (i, row) in inverse.iter().enumerate() {
            let product: Own = from_fn(|j| row.iter().zip(&matrix).map(|(value, column)| value * column[j]).sum());
            let one: Own = from_fn(|j| f64::from(u8::from(i == j)));
            assert!(product.iter().zip(one).all(|(value, one)| (value - one).abs() < 1e-13), "{product:?}");
        }
    }

    /// A step by the plain factors is that by the matrix of the richer panels but for some percent, for any degree.
    #[test]
    fn a_cheap_step_is_nearly_newtons() {
        for (degree, alpha, beta, f) in [(8, 1.0, 0.05, 30.0), (6, 0.1, 0.3, 100.0), (12, f64::INFINITY, 0.1, 0.0)] {
            let references = [degree, degree + ENRICHMENT].map(|degree| Arc::new(ReferencePanel::new(degree)));
            let mesh = thick_film::mesh(degree, 3.0, beta, 1e3);
            let kernel = DisplacementKernel::new(&Parameters::new(alpha, beta, f));
            let [mut plain, mut rich] = references.each_ref().map(Displacement::new);
            plain.set_mesh(&mesh, &kernel, &mut Timings::default());
            let of_degree = super::super::mesh::Mesh { degree: degree + ENRICHMENT, ..(*mesh).clone() };
            rich.set_mesh(&Arc::new(of_degree), &kernel, &mut Timings::default());

            let interrupt = Interrupt::new();
            let (mut context, mut corrector) = (SolveContext::new(&interrupt), Corrector::default());
            let mut state = thick_film::state(&plain, beta);
            corrector.correct(&plain, beta, &mut state, 1e-12, &mut context).expect("a thick film");
            corrector.linearise(&plain, beta, &state, false);
            corrector.factorise(&plain, beta, &state, &mut Effort::default());

            let guess = enriched(&plain, &rich, &state);
            let mut newton = Corrector::default();
            newton.linearise(&rich, beta, &guess, false);
            newton.factorise(&rich, beta, &guess, &mut Effort::default());
            newton.step(&rich, beta, &guess);
            let step = newton.system.right_side.clone();

            let mut two_level = TwoLevel::new(&Arc::new(Tables::new(&references[0], &references[1])));
            newton.linearise(&rich, beta, &guess, false);
            two_level.linearise(&newton.system, &rich, beta, &guess);
            newton.system.fold_end(&rich, beta, &guess);
            two_level.solve(&mut corrector.factorisation, &mut newton.system);
            let largest = step.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
            let apart = step.iter().zip(&newton.system.right_side).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(largest > 0.0 && apart < 0.05 * largest, "degree {degree}: {apart:e} of {largest:e}");
        }
    }
}
