//! The retarded displacement of one mode: a filter that runs from right to left (T8).

use std::f64::consts::PI;
use std::ops::Range;

use super::discretisation::Discretisation;
use super::exponential_moments::{exponential_moment_derivatives, exponential_moments};
use super::log_moments::MOST_MOMENTS;
use super::matrix::Matrix;
use super::reference::{ReferencePanel, dot};
use crate::model::retarded_mode;

/// The filter on all panels of a mesh.
///
/// T8 reads v(y) = e^{−α(y₁ − y)} v(y₁) + ∫_y^{y₁} α e^{−α(s − y)} e(s) ds (T30). With e on a panel as the polynomial
/// through its Gauss points and both ends the integral is exact, however stiff the panel; the material carries v from
/// one panel to the next. The ends make e continuous, without which v − e would be poor where α is large.
pub struct RetardationFilter {
    alpha: f64,
    pub(super) panels: Vec<PanelFilter>,
    /// v(Y) − e(0) from p at the nodes.
    pub(super) ahead: Vec<f64>,
}

/// κ from which on α(v − e) is not formed as the difference that it is: its rounding error, about κ, would be above
/// that of e′, about d².
const STIFF_SLOPE: f64 = 50.0;

/// What a panel makes of e, and of what it is handed at its right end: at each Gauss point, and in the last place at
/// its left end.
pub(super) struct PanelFilter {
    /// Weights of what is handed on, d + 1.
    pub decay: Vec<f64>,
    /// For v.
    pub displacement: Weights,
    /// For v′ = α(v − e), where the panel is stiff; it obeys the same filter with e′ in place of e.
    pub slope: Option<Weights>,
}

/// Weights of the values of e on a panel in those of something else at d + 1 places.
pub(super) struct Weights {
    /// Weights of e at the Gauss points, (d + 1) × d row by row.
    points: Vec<f64>,
    /// Weights of e at the left and the right end, d + 1.
    ends: Vec<[f64; 2]>,
}

impl Weights {
    /// What the place with this index has from e.
    pub fn apply(&self, place: usize, e: &[f64], ends: [f64; 2]) -> f64 {
        let [left, right] = self.ends[place];
        dot(&self.points[place * e.len()..(place + 1) * e.len()], e) + left * ends[0] + right * ends[1]
    }

    /// The weights of e at the Gauss points, d × (d + 1): those of the first point in all places first.
    fn by_point(&self) -> Vec<f64> {
        let (places, degree) = (self.ends.len(), self.points.len() / self.ends.len());
        (0..degree).flat_map(|point| (0..places).map(move |place| self.points[place * degree + point])).collect()
    }

    /// Adds to the weights of e a factor times what this place takes of it: the transpose of [`Weights::apply`].
    pub fn add_transposed(&self, place: usize, factor: f64, e: &mut [f64], ends: &mut [f64; 2]) {
        let row = &self.points[place * e.len()..(place + 1) * e.len()];
        for (sum, weight) in e.iter_mut().zip(row).chain(ends.iter_mut().zip(&self.ends[place])) {
            *sum += factor * weight;
        }
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
        let kappa = alpha * half;
        let decay = |t: f64| (-kappa * (1.0 - t)).exp();
        Self::of(reference, kappa, half, decay, |t, moments| exponential_moments(kappa, t, moments))
    }

    /// α times its derivative with respect to α.
    pub fn derivatives(reference: &ReferencePanel, alpha: f64, half: f64) -> Self {
        let kappa = alpha * half;
        let decay = |t: f64| -kappa * (1.0 - t) * (-kappa * (1.0 - t)).exp();
        Self::of(reference, kappa, half, decay, |t, derivatives| exponential_moment_derivatives(kappa, t, derivatives))
    }

    /// One of what is left at t of what is handed on, and of the moments there.
    fn of(
        reference: &ReferencePanel,
        kappa: f64,
        half: f64,
        decay_at: impl Fn(f64) -> f64,
        moments_at: impl Fn(f64, &mut [f64]),
    ) -> Self {
        let degree = reference.degree;
        let mut displacement =
            Weights { points: vec![0.0; (degree + 1) * degree], ends: Vec::with_capacity(degree + 1) };
        let mut decay = Vec::with_capacity(degree + 1);
        let mut moments = [0.0; MOST_MOMENTS];
        let rows = displacement.points.chunks_exact_mut(degree);
        for (t, weights) in reference.points.iter().copied().chain([-1.0]).zip(rows) {
            decay.push(decay_at(t));
            moments_at(t, &mut moments[..degree + 2]);
            displacement.ends.push(response(reference, &moments, weights));
        }
        let slope = (kappa > STIFF_SLOPE).then(|| displacement.of_derivative(reference, half.recip()));
        Self { decay, displacement, slope }
    }
}

/// Weights of e in ∫_t^1 κ e^{−κ(s − t)} e(s) ds: of its values at the Gauss points, and at both ends; from the d + 2
/// moments at t.
///
/// The polynomial through all of them is the one through the Gauss points, and P_d(s)(a + bs), which vanishes there,
/// for what is missing at the ends.
fn response(reference: &ReferencePanel, moments: &[f64], weights: &mut [f64]) -> [f64; 2] {
    let degree = reference.degree;
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
        let mut ahead = far_field(discretisation, mesh.reach(), |x| retarded_mode(alpha, x));
        for (v, e) in ahead.iter_mut().zip(&discretisation.elastic_at_outlet) {
            *v -= e;
        }
        Self { alpha, panels: ends.map(panel).collect(), ahead }
    }

    /// α of the mode.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Adds `weight` times v − v(0) at the film's Gauss points, from p at the nodes, to a matrix of points × nodes.
    /// Leaves v(0) − e(0) from p at the nodes in `outlet`.
    pub fn add_to(&self, discretisation: &Discretisation, weight: f64, sum: &mut Matrix, outlet: &mut Vec<f64>) {
        let elastic = &discretisation.elastic;
        let degree = discretisation.reference.degree;
        let first = discretisation.film().start;
        outlet.clear();
        outlet.extend_from_slice(&self.ahead);
        for (index, filter) in self.panels.iter().enumerate().skip(first / degree).rev() {
            let rows = index * degree..(index + 1) * degree;
            let ends = discretisation.ends(index);
            let weights = filter.displacement.by_point();
            for (j, handed_on) in outlet.iter_mut().enumerate() {
                let e = elastic.column(j);
                let (on_panel, ends) = (&e[rows.clone()], [e[ends.0], e[ends.1]]);
                let mut at = [0.0; MOST_MOMENTS];
                let at = &mut at[..=degree];
                // all places together, which do not wait for one another
                for (weights, e) in weights.chunks_exact(at.len()).zip(on_panel) {
                    for (at, weight) in at.iter_mut().zip(weights) {
                        *at += weight * e;
                    }
                }
                for ((at, of_ends), decay) in at.iter_mut().zip(&filter.displacement.ends).zip(&filter.decay) {
                    *at = decay * *handed_on + (*at + of_ends[0] * ends[0] + of_ends[1] * ends[1]);
                }
                let column = &mut sum.column_mut(j)[rows.start - first..rows.end - first];
                for (sum, at) in column.iter_mut().zip(&*at) {
                    *sum += weight * at;
                }
                *handed_on = at[degree];
            }
        }
        for (j, outlet) in outlet.iter().enumerate() {
            for sum in sum.column_mut(j) {
                *sum -= weight * outlet;
            }
        }
    }

    /// v′ at the film's Gauss points, and v(0) − e(0), of one solution: `e` is its elastic displacement relative to the
    /// outlet at the rows, `pressure` its pressure at the nodes.
    pub fn slope(&self, discretisation: &Discretisation, e: &[f64], pressure: &[f64]) -> (Vec<f64>, f64) {
        let degree = discretisation.reference.degree;
        let first = discretisation.film().start;
        let mut slopes = vec![0.0; discretisation.film_points()];
        let mut v = dot(&self.ahead, pressure);
        let mut slope = self.alpha * (v - e[discretisation.ends(self.panels.len() - 1).1]);
        for (index, filter) in self.panels.iter().enumerate().skip(first / degree).rev() {
            let (on_panel, ends) = discretisation.on_panel(e, index);
            let slopes = &mut slopes[index * degree - first..(index + 1) * degree - first];
            let at = |weights: &Weights, i: usize, handed_on: f64| {
                filter.decay[i] * handed_on + weights.apply(i, on_panel, ends)
            };
            let left = at(&filter.displacement, degree, v);
            match &filter.slope {
                Some(weights) => {
                    for (i, value) in slopes.iter_mut().enumerate() {
                        *value = at(weights, i, slope);
                    }
                    slope = at(weights, degree, slope);
                }
                None => {
                    for (i, value) in slopes.iter_mut().enumerate() {
                        *value = self.alpha * (at(&filter.displacement, i, v) - on_panel[i]);
                    }
                    slope = self.alpha * (left - ends[0]);
                }
            }
            v = left;
        }
        (slopes, v)
    }

    /// v − v(0) at the Gauss points behind the outlet; `e` as above, and `outlet` is v(0) − e(0).
    pub fn behind(&self, discretisation: &Discretisation, e: &[f64], outlet: f64) -> Vec<f64> {
        let mut values = vec![0.0; e.len()];
        self.behind_on_rows(discretisation, e, outlet, &mut values);
        values.truncate(discretisation.behind().len());
        values
    }

    /// v − v(0) at all rows; `e` and `pressure` as above.
    pub fn on_rows(&self, discretisation: &Discretisation, e: &[f64], pressure: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; e.len()];
        let ahead = dot(&self.ahead, pressure);
        let behind = discretisation.mesh.behind.len() - 1;
        // relative to e(0) first: v(0) is what comes out at the outlet
        self.run(discretisation, e, behind..self.panels.len(), (ahead, 0.0), &mut values);
        let outlet = values[discretisation.outlet()];
        for row in discretisation.film().chain(discretisation.ends_of_film()) {
            values[row] -= outlet;
        }
        self.behind_on_rows(discretisation, e, outlet, &mut values);
        values
    }

    /// Constants pass the filter unchanged: with e − v(0) in it, it gives v − v(0), with no digits lost near the
    /// outlet.
    fn behind_on_rows(&self, discretisation: &Discretisation, e: &[f64], outlet: f64, values: &mut [f64]) {
        self.run(discretisation, e, 0..discretisation.mesh.behind.len() - 1, (0.0, outlet), values);
    }

    /// Runs the filter over panels from right to left with e − `origin` in it and `handed_on` at the right end; v −
    /// `origin` goes to the rows of their Gauss points and ends.
    fn run(
        &self,
        discretisation: &Discretisation,
        e: &[f64],
        panels: Range<usize>,
        (mut handed_on, origin): (f64, f64),
        values: &mut [f64],
    ) {
        let degree = discretisation.reference.degree;
        let mut relative = vec![0.0; degree];
        values[discretisation.ends(panels.end - 1).1] = handed_on;
        for index in panels.rev() {
            let filter = &self.panels[index];
            let (on_panel, ends) = discretisation.on_panel(e, index);
            for (relative, e) in relative.iter_mut().zip(on_panel) {
                *relative = e - origin;
            }
            let ends = ends.map(|e| e - origin);
            let at = |i: usize| filter.decay[i] * handed_on + filter.displacement.apply(i, &relative, ends);
            for (i, value) in values[index * degree..(index + 1) * degree].iter_mut().enumerate() {
                *value = at(i);
            }
            handed_on = at(degree);
            values[discretisation.ends(index).0] = handed_on;
        }
    }
}

/// (1/π) ∫ p(s) K(y − s) ds at a place y ≥ Y or far behind, from p at the nodes, by quadrature: v with the kernel
/// ln|y − s| + S(α(y − s)) (T10).
pub(super) fn far_field(discretisation: &Discretisation, y: f64, kernel: impl Fn(f64) -> f64) -> Vec<f64> {
    let reference = &discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    let mut weights = vec![0.0; discretisation.nodes()];
    for (i, (s, weight)) in
        discretisation.film_y().iter().zip(&discretisation.weights[discretisation.film()]).enumerate()
    {
        let kernel = weight / PI * kernel(y - s);
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

    /// Fine panels for a pressure, and that pressure at their nodes.
    fn pressed() -> (Discretisation, Vec<f64>) {
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
        (discretisation, nodes)
    }

    /// The filter (T8) and the kernel (T10) are independent ways to the same v: at Gauss points, and anywhere else.
    #[test]
    fn filter_agrees_with_the_exponential_integral_kernel() {
        let (discretisation, nodes) = pressed();
        let mut e = vec![0.0; discretisation.points.len()];
        discretisation.elastic.multiply_rows(0, &nodes, &mut e);
        for alpha in [1e-4, 0.05, 1.0, 7.0, 60.0, 1e4] {
            let filter = RetardationFilter::new(&discretisation, alpha);
            let film = discretisation.film();
            let (slope, outlet) = filter.slope(&discretisation, &e, &nodes);
            let v_outlet = outlet + dot(&discretisation.elastic_at_outlet, &nodes);
            // as a matrix, less twice the elastic part
            let (mut matrix, mut outlets) = (Matrix::default(), Vec::new());
            matrix.copy_scaled(&discretisation.elastic, film.clone(), -2.0);
            filter.add_to(&discretisation, 3.0, &mut matrix, &mut outlets);
            assert!((dot(&outlets, &nodes) - outlet).abs() < 1e-13);
            let mut product = vec![0.0; film.len()];
            matrix.multiply_rows(0, &nodes, &mut product);
            let mut v = filter.behind(&discretisation, &e, outlet);
            v.extend(film.clone().zip(&product).map(|(row, product)| (product + 2.0 * e[row]) / 3.0));
            v.push(0.0);
            for row in film {
                // v′ = α(v − e) (T8), up to what that difference loses
                let difference = (slope[row - discretisation.film().start] - alpha * (v[row] + outlet - e[row])).abs();
                assert!(difference < 1e-10 + 1e-15 * alpha, "α {alpha}, row {row}: {difference:e}");
            }
            let rows = discretisation.film().step_by(11).chain(discretisation.behind().step_by(7));
            for row in rows.chain([discretisation.outlet()]) {
                let y = discretisation.points[row];
                let exact = by_kernel(&discretisation, &nodes, alpha, y);
                // panels behind the contact grow with the distance, as the gap does that v is a part of
                let bound = if y < 0.0 { 1e-9 * (1.0 + y * y) } else { 1e-10 };
                assert!((v[row] + v_outlet - exact).abs() < bound, "α {alpha}, y {y}: {} {exact}", v[row]);
            }
            let on_rows = filter.on_rows(&discretisation, &e, &nodes);
            let ends = 0..discretisation.mesh.panels() + discretisation.mesh.behind.len() - 1;
            for row in ends.map(|panel| discretisation.ends(panel).0).chain(0..discretisation.film().end) {
                let y = discretisation.points[row];
                let exact = by_kernel(&discretisation, &nodes, alpha, y);
                let bound = if y < 0.0 { 1e-9 * (1.0 + y * y) } else { 1e-10 };
                assert!((on_rows[row] + v_outlet - exact).abs() < bound, "α {alpha}, y {y}: {} {exact}", on_rows[row]);
            }
            for y in [-300.0, 77.0] {
                let v = dot(&far_field(&discretisation, y, |x| retarded_mode(alpha, x)), &nodes);
                let exact = by_kernel(&discretisation, &nodes, alpha, y);
                assert!((v - exact).abs() < 1e-10, "α {alpha}, y {y}: {v} {exact}");
            }
        }
    }
}
