//! The retarded displacement of one mode: a filter that runs from right to left (T8).

use std::f64::consts::PI;

use super::discretisation::Discretisation;
use super::exponential_moments::exponential_moments;
use super::log_moments::MOST_MOMENTS;
use super::matrix::Matrix;
use super::mesh::locate;
use super::reference::{ReferencePanel, dot};
use crate::model::retarded_mode;

/// The filter on all panels of a mesh.
///
/// T8 reads v(y) = e^{−α(y₁ − y)} v(y₁) + ∫_y^{y₁} α e^{−α(s − y)} e(s) ds. With e on a panel as the polynomial through its
/// Gauss points the integral is exact, however stiff the panel; the material carries v from one panel to the next.
pub struct RetardationFilter {
    alpha: f64,
    panels: Vec<PanelFilter>,
}

/// What a panel makes of v at its right end and e at its Gauss points.
struct PanelFilter {
    /// Weight of v at the right end in v at each Gauss point.
    decay: Vec<f64>,
    /// Weight of e at the Gauss points in v at each, d × d.
    response: Vec<f64>,
    /// The same for v at the left end.
    left_decay: f64,
    left_response: Vec<f64>,
}

impl PanelFilter {
    fn new(reference: &ReferencePanel, kappa: f64) -> Self {
        let row = |t: f64| -> Vec<f64> { response(reference, kappa, t) };
        Self {
            decay: reference.points.iter().map(|t| (-kappa * (1.0 - t)).exp()).collect(),
            response: reference.points.iter().flat_map(|&t| row(t)).collect(),
            left_decay: (-2.0 * kappa).exp(),
            left_response: row(-1.0),
        }
    }
}

/// Weights of e at the Gauss points in ∫_t^1 κ e^{−κ(s − t)} e(s) ds.
fn response(reference: &ReferencePanel, kappa: f64, t: f64) -> Vec<f64> {
    let degree = reference.degree;
    let mut moments = [0.0; MOST_MOMENTS];
    exponential_moments(kappa, t, &mut moments[..degree]);
    let mut weights = vec![0.0; degree];
    for (k, moment) in moments[..degree].iter().enumerate() {
        let coefficients = &reference.point_coefficients[k * degree..(k + 1) * degree];
        for (weight, coefficient) in weights.iter_mut().zip(coefficients) {
            *weight += moment * coefficient;
        }
    }
    weights
}

impl RetardationFilter {
    /// The filter of a mode of rate α on a mesh.
    pub fn new(discretisation: &Discretisation, alpha: f64) -> Self {
        let mesh = &discretisation.mesh;
        let ends = mesh.behind.windows(2).chain(mesh.film.windows(2));
        let panel = |ends: &[f64]| PanelFilter::new(&discretisation.reference, 0.5 * alpha * (ends[1] - ends[0]));
        Self { alpha, panels: ends.map(panel).collect() }
    }

    /// v at the rows of a discretisation from p at the nodes, rows × nodes.
    pub fn apply(&self, discretisation: &Discretisation, retarded: &mut Matrix) {
        let elastic = &discretisation.elastic;
        retarded.reset(elastic.rows(), elastic.columns());
        let at_end = far_field(discretisation, self.alpha, discretisation.mesh.reach());
        for (j, end) in at_end.into_iter().enumerate() {
            self.run(discretisation, elastic.column(j), end, retarded.column_mut(j), |_, _| {});
        }
    }

    /// One run: v at the rows from e at the rows and v at Y. `visit` gets each panel with v at its right end.
    fn run(
        &self,
        discretisation: &Discretisation,
        e: &[f64],
        at_end: f64,
        v: &mut [f64],
        mut visit: impl FnMut(usize, f64),
    ) {
        let degree = discretisation.reference.degree;
        let film_starts = discretisation.behind().end / degree;
        let mut right = at_end;
        for (index, panel) in self.panels.iter().enumerate().rev() {
            visit(index, right);
            let rows = index * degree..(index + 1) * degree;
            let e = &e[rows.clone()];
            for (i, v) in v[rows].iter_mut().enumerate() {
                *v = panel.decay[i] * right + dot(&panel.response[i * degree..(i + 1) * degree], e);
            }
            right = panel.left_decay * right + dot(&panel.left_response, e);
            if index == film_starts {
                v[discretisation.outlet()] = right;
            }
        }
    }

    /// v at any places of one solution: `e` and `pressure` are its elastic displacement at the rows and its pressure at the
    /// nodes.
    pub fn interpolate(
        &self,
        discretisation: &Discretisation,
        e: &[f64],
        pressure: &[f64],
        places: &[f64],
    ) -> Vec<f64> {
        let mesh = &discretisation.mesh;
        let degree = discretisation.reference.degree;
        let mut at_right = vec![0.0; self.panels.len()];
        let end = dot(&far_field(discretisation, self.alpha, mesh.reach()), pressure);
        self.run(discretisation, e, end, &mut vec![0.0; e.len()], |panel, v| at_right[panel] = v);
        let ends: Vec<f64> = mesh.behind.iter().chain(&mesh.film[1..]).copied().collect();
        let at = |&y: &f64| {
            if y < ends[0] || y > mesh.reach() {
                return dot(&far_field(discretisation, self.alpha, y), pressure);
            }
            let (panel, t) = locate(&ends, y);
            let kappa = 0.5 * self.alpha * (ends[panel + 1] - ends[panel]);
            let e = &e[panel * degree..(panel + 1) * degree];
            (-kappa * (1.0 - t)).exp() * at_right[panel] + dot(&response(&discretisation.reference, kappa, t), e)
        };
        places.iter().map(at).collect()
    }
}

/// v at a place y ≥ Y or far behind, from p at the nodes: the kernel ln|y − s| + S(α(y − s)) (T10) by quadrature.
fn far_field(discretisation: &Discretisation, alpha: f64, y: f64) -> Vec<f64> {
    let reference = &discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    let mut weights = vec![0.0; discretisation.nodes()];
    for (i, (s, weight)) in
        discretisation.film_y().iter().zip(&discretisation.weights[discretisation.film()]).enumerate()
    {
        let kernel = weight / PI * retarded_mode(alpha, y - s);
        let (panel, point) = (i / degree, i % degree);
        let values = &reference.values[point * size..(point + 1) * size];
        for (node, value) in weights[panel * degree..].iter_mut().zip(values) {
            *node += kernel * value;
        }
    }
    weights
}
