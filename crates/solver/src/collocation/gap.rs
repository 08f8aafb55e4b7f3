//! The film and the displaced surface between the points of a mesh.

use super::displacement::Displacement;
use super::mesh::locate;
use super::reference::{ReferencePanel, dot, evaluate, evaluate_slope};
use super::state::State;

/// On a panel where w changes by more than so many times the thinnest film, ln u is the polynomial.
const THIN: f64 = 2.0;

/// The gap u, or the displacement w, at any place of a mesh, behind the outlet too, as polynomials on its panels.
///
/// No kernel is evaluated: what the solution knows at its points is all there is.
pub struct Gap {
    /// Ends of all panels, ascending, from −Y to Y.
    ends: Vec<f64>,
    /// Legendre coefficients of each panel, d + 2.
    coefficients: Vec<f64>,
    /// True for the panels whose polynomial is of ln u, false where it is of w less w(0).
    logarithmic: Vec<bool>,
    /// x_out.
    outlet: f64,
}

/// What a polynomial knows of a place; the other one follows from u = h − w (T3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// u, where the film is thin: an error of w would be a large part of it.
    Film(f64),
    /// w less w(0), where the gap is thick: an error of u would be a large part of it.
    Displacement(f64),
}

impl Gap {
    /// The gap of a solution.
    pub fn new(displacement: &Displacement, state: &State) -> Self {
        let discretisation = &displacement.discretisation;
        let (mesh, reference) = (&discretisation.mesh, &discretisation.reference);
        let (behind, panels) = (mesh.behind.len() - 1, mesh.behind.len() - 1 + mesh.panels());
        let w = displacement.on_rows(&state.pressure);
        let gap_at = |y: f64, w: f64| state.c + state.outlet * y + 0.5 * y * y - w;
        let mut gap = Self {
            ends: mesh.behind.iter().chain(&mesh.film[1..]).copied().collect(),
            coefficients: Vec::with_capacity(panels * (reference.degree + 2)),
            logarithmic: Vec::with_capacity(panels),
            outlet: state.outlet,
        };
        let meeting =
            meeting_films(reference, state, |end| gap_at(mesh.film[end], w[discretisation.ends_of_film().start + end]));
        let mut logarithms = Vec::with_capacity(reference.degree);
        for panel in 0..panels {
            let (w_points, w_ends) = discretisation.on_panel(&w, panel);
            let (y_points, y_ends) = discretisation.on_panel(&discretisation.points, panel);
            let mut u_ends = [0, 1].map(|end| gap_at(y_ends[end], w_ends[end]));
            logarithms.clear();
            logarithms.extend(y_points.iter().zip(w_points).map(|(&y, &w)| gap_at(y, w)));
            if let Some(of_film) = panel.checked_sub(behind) {
                logarithms.copy_from_slice(&state.film[of_film * reference.degree..(of_film + 1) * reference.degree]);
                u_ends = [meeting[of_film], meeting[of_film + 1]];
            }
            let thinnest = u_ends.iter().chain(&logarithms).fold(f64::INFINITY, |least, &u| least.min(u));
            let logarithmic = THIN * thinnest < range(w_points.iter().chain(&w_ends));
            if logarithmic {
                logarithms.iter_mut().for_each(|u| *u = u.ln());
                reference.append_polynomial(&logarithms, u_ends.map(f64::ln), &mut gap.coefficients);
            } else {
                reference.append_polynomial(w_points, w_ends, &mut gap.coefficients);
            }
            gap.logarithmic.push(logarithmic);
        }
        gap
    }

    /// True if a place y is on the mesh.
    pub fn holds(&self, y: f64) -> bool {
        (self.ends[0]..=self.ends[self.ends.len() - 1]).contains(&y)
    }

    /// u or w at a place y of the mesh.
    pub fn at(&self, y: f64) -> Known {
        let (panel, t) = locate(&self.ends, y);
        let value = evaluate(self.on_panel(panel), t);
        if self.logarithmic[panel] { Known::Film(value.exp()) } else { Known::Displacement(value) }
    }

    /// w′ at a place y of the mesh.
    pub fn slope(&self, y: f64) -> f64 {
        let (panel, t) = locate(&self.ends, y);
        let coefficients = self.on_panel(panel);
        let slope = evaluate_slope(coefficients, t) * 2.0 / (self.ends[panel + 1] - self.ends[panel]);
        match self.at(y) {
            Known::Film(u) => self.outlet + y - u * slope,
            Known::Displacement(_) => slope,
        }
    }

    fn on_panel(&self, panel: usize) -> &[f64] {
        let size = self.coefficients.len() / self.logarithmic.len();
        &self.coefficients[panel * size..(panel + 1) * size]
    }
}

/// u where panels of the film meet: c at the outlet, then what w leaves there, `of_displacement`.
///
/// The film equation holds at the Gauss points. Between them the displacement of a pressure that is known well may be
/// off by a good part of a thin film. So between two panels u is not outside of what both extrapolate.
fn meeting_films(reference: &ReferencePanel, state: &State, of_displacement: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut at_right = None;
    let mut meeting = vec![state.c];
    let mut logarithms = vec![0.0; reference.degree];
    for (panel, film) in state.film.chunks_exact(reference.degree).enumerate() {
        for (logarithm, u) in logarithms.iter_mut().zip(film) {
            *logarithm = u.ln();
        }
        let [left, right] = [0, 1].map(|end| dot(&reference.end_values[end], &logarithms).exp());
        if let Some(before) = at_right.replace(right) {
            meeting.push(of_displacement(panel).clamp(f64::min(before, left), f64::max(before, left)));
        }
    }
    meeting.push(of_displacement(meeting.len()));
    meeting
}

/// The largest value less the smallest one.
fn range<'v>(values: impl Iterator<Item = &'v f64>) -> f64 {
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for &value in values {
        (least, most) = (least.min(value), most.max(value));
    }
    most - least
}

impl ReferencePanel {
    /// Appends the d + 2 Legendre coefficients of the polynomial with these values at the Gauss points and at both
    /// ends: the one through the Gauss points, and P_d(t)(a + bt), which vanishes there, for what it misses at the
    /// ends.
    fn append_polynomial(&self, points: &[f64], ends: [f64; 2], coefficients: &mut Vec<f64>) {
        let degree = self.degree;
        let first = coefficients.len();
        coefficients.resize(first + degree + 2, 0.0);
        let coefficients = &mut coefficients[first..];
        self.coefficients_of_points(points, &mut coefficients[..degree]);
        let missing = |end: usize| ends[end] - dot(&self.end_values[end], points);
        // P_d(−1) = (−1)^d
        let parity = if degree.is_multiple_of(2) { 1.0 } else { -1.0 };
        let (left, right) = (parity * missing(0), missing(1));
        let (constant, linear) = (0.5 * (right + left), 0.5 * (right - left));
        // t P_d = ((d + 1) P_{d+1} + d P_{d−1})/(2d + 1)
        let d = degree as f64;
        coefficients[degree] += constant;
        coefficients[degree + 1] += linear * (d + 1.0) / (2.0 * d + 1.0);
        coefficients[degree - 1] += linear * d / (2.0 * d + 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial is found again from its values at the points and at both ends.
    #[test]
    fn polynomials_are_found_again() {
        for degree in [7, 8] {
            let panel = ReferencePanel::new(degree);
            let of = |t: f64| (0.6 * t - 0.2).powi(degree as i32 + 1);
            let points: Vec<f64> = panel.points.iter().map(|&t| of(t)).collect();
            let mut coefficients = Vec::new();
            panel.append_polynomial(&points, [of(-1.0), of(1.0)], &mut coefficients);
            for t in [-1.0, -0.7, 0.1, 1.0] {
                assert!((evaluate(&coefficients, t) - of(t)).abs() < 1e-13, "{degree} {t}");
            }
        }
    }
}
