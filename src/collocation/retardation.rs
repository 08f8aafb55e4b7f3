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
/// T8 reads v(y) = e^{−α(y₁ − y)} v(y₁) + ∫_y^{y₁} α e^{−α(s − y)} e(s) ds (T30). With e on a panel as the polynomial through
/// its Gauss points and both ends the integral is exact, however stiff the panel; the material carries v from one panel to
/// the next. The ends make e continuous, without which v − e would be poor where α is large.
pub struct RetardationFilter {
    alpha: f64,
    panels: Vec<PanelFilter>,
}

/// κ from which on α(v − e) is not formed as the difference that it is: its rounding error, about κ, would be above that of
/// e′, about d².
const STIFF_SLOPE: f64 = 50.0;

/// What a panel makes of e, and of what it is handed at its right end: at each Gauss point, and in the last place at its left
/// end.
struct PanelFilter {
    /// Weights of what is handed on, d + 1.
    decay: Vec<f64>,
    /// For v.
    displacement: Weights,
    /// For v′ = α(v − e), where the panel is stiff; it obeys the same filter with e′ in place of e.
    slope: Option<Weights>,
}

/// Weights of the values of e on a panel in those of something else at d + 1 places.
struct Weights {
    /// Of e at the Gauss points, (d + 1) × d row by row.
    points: Vec<f64>,
    /// Of e at the left and the right end, d + 1.
    ends: Vec<[f64; 2]>,
}

impl Weights {
    /// What the place with this index has from e.
    fn apply(&self, place: usize, e: &[f64], ends: [f64; 2]) -> f64 {
        let [left, right] = self.ends[place];
        dot(&self.points[place * e.len()..(place + 1) * e.len()], e) + left * ends[0] + right * ends[1]
    }

    /// The weights of e that give the same for a factor times e′.
    fn of_derivative(&self, reference: &ReferencePanel, factor: f64) -> Self {
        let (degree, rich) = (reference.degree, reference.degree + 2);
        let mut weights =
            Self { points: Vec::with_capacity(self.points.len()), ends: Vec::with_capacity(self.ends.len()) };
        for (points, ends) in self.points.chunks_exact(degree).zip(&self.ends) {
            let all = || std::iter::once(&ends[0]).chain(points).chain([&ends[1]]);
            let of = |j: usize| {
                factor * all().enumerate().map(|(i, w)| w * reference.rich_derivative[i * rich + j]).sum::<f64>()
            };
            weights.ends.push([of(0), of(rich - 1)]);
            weights.points.extend((1..=degree).map(of));
        }
        weights
    }
}

impl PanelFilter {
    fn new(reference: &ReferencePanel, alpha: f64, half: f64) -> Self {
        let (degree, kappa) = (reference.degree, alpha * half);
        let mut displacement =
            Weights { points: vec![0.0; (degree + 1) * degree], ends: Vec::with_capacity(degree + 1) };
        let mut decay = Vec::with_capacity(degree + 1);
        let rows = displacement.points.chunks_exact_mut(degree);
        for (t, weights) in reference.points.iter().copied().chain([-1.0]).zip(rows) {
            decay.push((-kappa * (1.0 - t)).exp());
            displacement.ends.push(response(reference, kappa, t, weights));
        }
        let slope = (kappa > STIFF_SLOPE).then(|| displacement.of_derivative(reference, half.recip()));
        Self { decay, displacement, slope }
    }
}

/// Weights of e in ∫_t^1 κ e^{−κ(s − t)} e(s) ds: of its values at the Gauss points, and at both ends.
///
/// The polynomial through all of them is the one through the Gauss points, and P_d(s)(a + bs), which vanishes there, for what
/// is missing at the ends.
fn response(reference: &ReferencePanel, kappa: f64, t: f64, weights: &mut [f64]) -> [f64; 2] {
    let degree = reference.degree;
    let mut moments = [0.0; MOST_MOMENTS];
    exponential_moments(kappa, t, &mut moments[..degree + 2]);
    let constant = moments[degree];
    // s P_d = ((d + 1) P_{d+1} + d P_{d−1})/(2d + 1)
    let d = degree as f64;
    let linear = ((d + 1.0) * moments[degree + 1] + d * moments[degree - 1]) / (2.0 * d + 1.0);
    let parity = if degree.is_multiple_of(2) { 1.0 } else { -1.0 };
    let (left, right) = (0.5 * parity * (constant - linear), 0.5 * (constant + linear));
    for (i, weight) in weights.iter_mut().enumerate() {
        *weight = -left * reference.end_values[0][i] - right * reference.end_values[1][i];
    }
    for (k, moment) in moments[..degree].iter().enumerate() {
        let coefficients = &reference.point_coefficients[k * degree..(k + 1) * degree];
        for (weight, coefficient) in weights.iter_mut().zip(coefficients) {
            *weight += moment * coefficient;
        }
    }
    [left, right]
}

impl RetardationFilter {
    /// The filter of a mode of rate α on a mesh.
    pub fn new(discretisation: &Discretisation, alpha: f64) -> Self {
        let mesh = &discretisation.mesh;
        let ends = mesh.behind.windows(2).chain(mesh.film.windows(2));
        let panel = |ends: &[f64]| PanelFilter::new(&discretisation.reference, alpha, 0.5 * (ends[1] - ends[0]));
        Self { alpha, panels: ends.map(panel).collect() }
    }

    /// α of the mode.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// v and v′ at the Gauss points, and v at the outlet, from p at the nodes, rows × nodes; 0 at the other ends. `panel` is a
    /// buffer.
    pub fn apply(
        &self,
        discretisation: &Discretisation,
        retarded: &mut Matrix,
        slopes: &mut Matrix,
        panel: &mut Matrix,
    ) {
        let elastic = &discretisation.elastic;
        let degree = discretisation.reference.degree;
        let outlet = discretisation.outlet();
        retarded.reset(elastic.rows(), elastic.columns());
        slopes.reset(elastic.rows(), elastic.columns());
        panel.reset(degree + 1, elastic.columns());
        let mut right = far_field(discretisation, self.alpha, discretisation.mesh.reach());
        let last_end = discretisation.ends(self.panels.len() - 1).1;
        let mut right_slope: Vec<f64> =
            right.iter().enumerate().map(|(j, v)| self.alpha * (v - elastic.column(j)[last_end])).collect();
        for (index, filter) in self.panels.iter().enumerate().rev() {
            let rows = index * degree..(index + 1) * degree;
            let ends = discretisation.ends(index);
            // a place's share of what is handed on, of e at the Gauss points (in `panel`), and of e at the ends
            let at = |weights: &Weights, panel: &Matrix, j: usize, i: usize, handed_on: f64| {
                let e = elastic.column(j);
                let [left, right] = weights.ends[i];
                filter.decay[i] * handed_on + panel.column(j)[i] + left * e[ends.0] + right * e[ends.1]
            };
            panel.set_to_product(&filter.displacement.points, elastic, rows.clone());
            for (j, right) in right.iter_mut().enumerate() {
                let column = retarded.column_mut(j);
                for (i, v) in column[rows.clone()].iter_mut().enumerate() {
                    *v = at(&filter.displacement, panel, j, i, *right);
                }
                *right = at(&filter.displacement, panel, j, degree, *right);
                if ends.0 == outlet {
                    column[outlet] = *right;
                }
            }
            let Some(weights) = &filter.slope else {
                for (j, right_slope) in right_slope.iter_mut().enumerate() {
                    let (v, e) = (&retarded.column(j)[rows.clone()], elastic.column(j));
                    for ((slope, v), e) in slopes.column_mut(j)[rows.clone()].iter_mut().zip(v).zip(&e[rows.clone()]) {
                        *slope = self.alpha * (v - e);
                    }
                    *right_slope = self.alpha * (right[j] - e[ends.0]);
                }
                continue;
            };
            panel.set_to_product(&weights.points, elastic, rows.clone());
            for (j, right_slope) in right_slope.iter_mut().enumerate() {
                for (i, slope) in slopes.column_mut(j)[rows.clone()].iter_mut().enumerate() {
                    *slope = at(weights, panel, j, i, *right_slope);
                }
                *right_slope = at(weights, panel, j, degree, *right_slope);
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
        let (mesh, reference) = (&discretisation.mesh, &discretisation.reference);
        let degree = reference.degree;
        let on_panel = |index: usize| {
            let (left, right) = discretisation.ends(index);
            (&e[index * degree..(index + 1) * degree], [e[left], e[right]])
        };
        let mut at_right = vec![0.0; self.panels.len()];
        let mut right = dot(&far_field(discretisation, self.alpha, mesh.reach()), pressure);
        for (index, filter) in self.panels.iter().enumerate().rev() {
            at_right[index] = right;
            let (e, e_ends) = on_panel(index);
            right = filter.decay[degree] * right + filter.displacement.apply(degree, e, e_ends);
        }
        let ends: Vec<f64> = mesh.behind.iter().chain(&mesh.film[1..]).copied().collect();
        let mut weights = vec![0.0; degree];
        let at = |&y: &f64| {
            if y < ends[0] || y > mesh.reach() {
                return dot(&far_field(discretisation, self.alpha, y), pressure);
            }
            let (panel, t) = locate(&ends, y);
            let kappa = 0.5 * self.alpha * (ends[panel + 1] - ends[panel]);
            let (e, e_ends) = on_panel(panel);
            let [left, right] = response(reference, kappa, t, &mut weights);
            (-kappa * (1.0 - t)).exp() * at_right[panel] + dot(&weights, e) + left * e_ends[0] + right * e_ends[1]
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

#[cfg(test)]
mod tests {
    use super::super::mesh::Mesh;
    use super::super::reference::evaluate;
    use super::*;
    use crate::model::gauss;
    use std::sync::Arc;

    /// A pressure like that of a film: steep at both sides, with a long tail.
    fn pressure(y: f64) -> f64 {
        y * y / (1.0 + y * y) / (1.0 + (y / 2.0).powi(6))
    }

    /// ∫ p(s) (S(α(y − s)) + ln|y − s|) ds/π (T10) on panels that shrink towards s = y.
    fn by_kernel(discretisation: &Discretisation, nodes: &[f64], alpha: f64, y: f64) -> f64 {
        let reference = &discretisation.reference;
        let (degree, size) = (reference.degree, reference.degree + 1);
        let mut coefficients = vec![0.0; size];
        let mut sum = 0.0;
        for (panel, ends) in discretisation.mesh.film.windows(2).enumerate() {
            reference.coefficients_of_nodes(&nodes[panel * degree..panel * degree + size], &mut coefficients);
            let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            let integrand = |s: f64| evaluate(&coefficients, (s - centre) / half) * retarded_mode(alpha, y - s);
            let near = y.clamp(ends[0], ends[1]);
            for end in ends {
                let mut far = *end;
                while (far - near).abs() > 1e-14 {
                    let closer = near + 0.5 * (far - near);
                    sum += gauss::integrate(far.min(closer), far.max(closer), integrand);
                    far = closer;
                }
            }
        }
        sum / PI
    }

    /// The filter (T8) and the kernel (T10) are independent ways to the same v: at Gauss points, and anywhere else.
    #[test]
    fn filter_agrees_with_the_exponential_integral_kernel() {
        let reference = Arc::new(ReferencePanel::new(8));
        let fine = |from: f64, to: f64| (0..12).map(move |i| from + (to - from) * f64::from(i) / 12.0);
        let start = [0.0, 1e-3, 4e-3, 0.012, 0.03, 0.06].into_iter();
        let ends = start
            .chain(fine(0.1, 1.2))
            .chain(fine(1.2, 4.0))
            .chain(fine(4.0, 12.0))
            .chain([12.0, 14.0, 17.0, 21.0, 26.0, 32.0, 40.0])
            .collect();
        let mut discretisation = Discretisation::new(&reference);
        discretisation.set_mesh(&Mesh::new(8, 3.0, ends));
        let nodes: Vec<f64> = discretisation
            .mesh
            .film
            .windows(2)
            .enumerate()
            .flat_map(|(panel, ends)| {
                let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
                reference.nodes.iter().skip(usize::from(panel > 0)).map(move |t| pressure(centre + half * t))
            })
            .collect();
        let mut e = vec![0.0; discretisation.points.len()];
        discretisation.elastic.multiply_rows(0, &nodes, &mut e);
        for alpha in [1e-4, 0.05, 1.0, 7.0, 60.0, 1e4] {
            let filter = RetardationFilter::new(&discretisation, alpha);
            let (mut retarded, mut slopes, mut buffer) = Default::default();
            filter.apply(&discretisation, &mut retarded, &mut slopes, &mut buffer);
            let (mut v, mut slope) = (vec![0.0; e.len()], vec![0.0; e.len()]);
            retarded.multiply_rows(0, &nodes, &mut v);
            slopes.multiply_rows(0, &nodes, &mut slope);
            for row in discretisation.film() {
                // v′ = α(v − e) (T8), up to what that difference loses
                let difference = (slope[row] - alpha * (v[row] - e[row])).abs();
                assert!(difference < 1e-10 + 1e-15 * alpha, "α {alpha}, row {row}: {difference:e}");
            }
            let rows = discretisation.film().step_by(11).chain(discretisation.behind().step_by(7));
            for row in rows.chain([discretisation.outlet()]) {
                let y = discretisation.points[row];
                let exact = by_kernel(&discretisation, &nodes, alpha, y);
                // panels behind the contact grow with the distance, as the gap does that v is a part of
                let bound = if y < 0.0 { 1e-9 * (1.0 + y * y) } else { 1e-10 };
                assert!((v[row] - exact).abs() < bound, "α {alpha}, y {y}: {} {exact}", v[row]);
            }
            let places = [-300.0, -0.33, 0.017, 0.9, 2.0, 77.0];
            let interpolated = filter.interpolate(&discretisation, &e, &nodes, &places);
            for (y, v) in places.into_iter().zip(interpolated) {
                let exact = by_kernel(&discretisation, &nodes, alpha, y);
                assert!((v - exact).abs() < 1e-10, "α {alpha}, y {y}: {v} {exact}");
            }
        }
    }
}
