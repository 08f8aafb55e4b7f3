//! The retarded displacement of one mode: a filter that runs from right to left (T8).

use std::array::from_fn;
use std::f64::consts::PI;
use std::ops::Range;

use super::discretisation::Discretisation;
use super::exponential_moments::{AtPlaces, MOST_PLACES, NO_MOMENTS};
use super::panel_filter::PanelFilter;
use super::reference::dot;
use crate::linear::{Matrix, wide};
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

/// Columns of e that are filtered together.
const TOGETHER: usize = 4;
/// Adds the weights of a value at all places times that value, for several columns.
#[inline(always)]
fn add_weighted<const N: usize, const C: usize>(at: &mut [[f64; N]; C], weights: &AtPlaces, values: &[f64; C]) {
    for j in 0..C {
        for lane in 0..N {
            at[j][lane] = weights[lane].mul_add(values[j], at[j][lane]);
        }
    }
}

impl RetardationFilter {
    /// The filter of a mode of rate α on a mesh.
    pub fn new(discretisation: &Discretisation, alpha: f64) -> Self {
        let mesh = &discretisation.mesh;
        let ends = mesh.behind.windows(2).chain(mesh.film.windows(2));
        let mut room = NO_MOMENTS;
        let panel =
            |ends: &[f64]| PanelFilter::new(&discretisation.reference, alpha, 0.5 * (ends[1] - ends[0]), &mut room);
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
        outlet.clear();
        outlet.extend_from_slice(&self.ahead);
        wide(
            #[inline(always)]
            || match discretisation.reference.degree {
                ..12 => self.filter_columns::<12>(discretisation, weight, sum, outlet),
                _ => self.filter_columns::<MOST_PLACES>(discretisation, weight, sum, outlet),
            },
        );
    }

    /// [`RetardationFilter::add_to`] with room for `N` places, in `outlet` from v ahead of the mesh.
    #[inline(always)]
    fn filter_columns<const N: usize>(
        &self,
        discretisation: &Discretisation,
        weight: f64,
        sum: &mut Matrix,
        outlet: &mut [f64],
    ) {
        let rows = sum.rows();
        let (columns, last) = (outlet.len() / TOGETHER * TOGETHER, outlet.len());
        let (sums, last_sums) = sum.values_mut().split_at_mut(columns * rows);
        for (block, (sums, outlet)) in
            sums.chunks_exact_mut(TOGETHER * rows).zip(outlet[..columns].as_chunks_mut().0).enumerate()
        {
            let e = from_fn(|j| discretisation.elastic.column(TOGETHER * block + j));
            self.filter_block::<N, TOGETHER>(discretisation, weight, e, sums, outlet);
        }
        for ((j, sums), outlet) in (columns..last).zip(last_sums.chunks_exact_mut(rows)).zip(&mut outlet[columns..]) {
            let e = [discretisation.elastic.column(j)];
            self.filter_block::<N, 1>(discretisation, weight, e, sums, std::array::from_mut(outlet));
        }
    }

    /// Runs the filter along `C` columns of e from right to left, which need not wait for one another; adds `weight`
    /// times v − v(0) to `sums`. `v` is v(Y) before and v(0) after.
    #[inline(always)]
    fn filter_block<const N: usize, const C: usize>(
        &self,
        discretisation: &Discretisation,
        weight: f64,
        e: [&[f64]; C],
        sums: &mut [f64],
        v: &mut [f64; C],
    ) {
        let (degree, rows) = (discretisation.reference.degree, sums.len() / C);
        let first = discretisation.film().start;
        for (index, filter) in self.panels.iter().enumerate().skip(first / degree).rev() {
            let (left, right) = discretisation.ends(index);
            let on_panel = index * degree..(index + 1) * degree;
            let mut values = [[0.0; C]; MOST_PLACES + 1];
            for (j, e) in e.iter().enumerate() {
                for (values, e) in values.iter_mut().zip(&e[on_panel.clone()]) {
                    values[j] = *e;
                }
                (values[degree][j], values[degree + 1][j]) = (e[left], e[right]);
            }
            let mut at = [[0.0; N]; C];
            add_weighted(&mut at, &filter.decay, v);
            for (weights, values) in filter.displacement.of_values().zip(&values) {
                add_weighted(&mut at, weights, values);
            }
            for (j, at) in at.iter().enumerate() {
                let sums = &mut sums[j * rows..][on_panel.start - first..on_panel.end - first];
                for (sum, at) in sums.iter_mut().zip(at) {
                    *sum += weight * at;
                }
                v[j] = at[degree];
            }
        }
        for (sums, v) in sums.chunks_exact_mut(rows).zip(&*v) {
            for sum in sums {
                *sum -= weight * v;
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
            let v_at = filter.pass(v, on_panel, ends);
            v = v_at[degree];
            if let Some(weights) = &filter.slope {
                let slope_at = filter.add_handed_on(slope, weights.apply(on_panel, ends));
                slopes.copy_from_slice(&slope_at[..degree]);
                slope = slope_at[degree];
            } else {
                for ((slope, v), e) in slopes.iter_mut().zip(v_at).zip(on_panel) {
                    *slope = self.alpha * (v - e);
                }
                slope = self.alpha * (v - ends[0]);
            }
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
            let at = filter.pass(handed_on, &relative, ends);
            values[index * degree..(index + 1) * degree].copy_from_slice(&at[..degree]);
            handed_on = at[degree];
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
    use super::super::reference::{ReferencePanel, evaluate};
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
        discretisation.elastic.multiply(&nodes, &mut e);
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
            matrix.multiply(&nodes, &mut product);
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
