//! The pressure gradient of a dry contact everywhere at once.

use std::iter;

use super::dry::DryContact;
use super::lobatto::{self, POINTS};
use super::position::Position;

/// Where the table ends at the trailing edge, in ln tan(θ/2).
const TRAILING_END: f64 = 15.0;
/// Where the contact is on its way to the trailing edge and the panels may be wide.
const TAIL: f64 = 3.0;
/// Widest panels before and in this tail.
const WIDTHS: (f64, f64) = (0.5, 2.0);

/// p′ of a dry contact, tabulated for many β.
///
/// With η = ln tan(θ/2), s = sin θ = sech η and ξ = cos θ = −tanh η the derivative of (T13) is a linear equation for
/// P = p′ s, which is finite at both edges:
///
/// ```text
/// dP/dη = (ξ − k s²) P − kΓ₁ + kΓ₂ ξ − k s² ξ
/// ```
///
/// It is solved from the leading to the trailing edge, panel by panel, by collocation at Chebyshev–Lobatto points;
/// these damp what a stiff equation (k → ∞) damps.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct DryGradient {
    points: [f64; POINTS],
    pub(super) panels: Vec<Panel>,
    /// The points of all panels and the extremes between them, ascending.
    pub(super) places: Vec<Place>,
}

/// A place in the contact and p′ there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) eta: f64,
    pub(super) gradient: f64,
    /// Whether p′ has a minimum here.
    pub(super) dip: bool,
}

/// A part of the contact and P on it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Panel {
    /// The ends, in η.
    pub(super) start: f64,
    pub(super) end: f64,
    /// P at the points.
    scaled: [f64; POINTS],
    /// p′ at the points.
    pub(super) gradient: [f64; POINTS],
    /// Weights of ∫ … s²/4 dη over the panel.
    pub(super) weights: [f64; POINTS],
}

impl DryGradient {
    pub(super) fn new(contact: &DryContact) -> Self {
        let (points, weights, differentiation) = (lobatto::points(), lobatto::weights(), lobatto::differentiation());
        let start = -0.5 * (1e6 * (1.0 + contact.k.min(1e15))).ln();
        let mut scaled_start = contact.pressure_gradient(Position::at(start)) * sine(Position::at(start));
        let mut panels = Vec::new();
        for (start, end) in edges(start, TAIL, WIDTHS.0).chain(edges(TAIL, TRAILING_END, WIDTHS.1)) {
            let half = 0.5 * (end - start);
            let places = points.map(|x| Position::at(0.5 * (start + end) + half * x));
            let scaled = if contact.elastic {
                places.map(|here| (here.to_leading - here.to_trailing) / contact.half_width().powi(2))
            } else {
                let equation = places.map(|here| coefficients(contact, here));
                collocate(&differentiation, half, &equation, scaled_start)
            };
            scaled_start = scaled[POINTS - 1];
            panels.push(Panel {
                start,
                end,
                scaled,
                gradient: std::array::from_fn(|j| scaled[j] / sine(places[j])),
                weights: std::array::from_fn(|j| weights[j] * half * places[j].to_leading * places[j].to_trailing),
            });
        }
        let mut table = Self { points, panels, places: Vec::new() };
        table.places = table.places();
        table
    }

    /// The points of all panels, and the extremes of p′ between them.
    fn places(&self) -> Vec<Place> {
        let on = |panel: &Panel, j: usize| Place { eta: self.eta(panel, j), gradient: panel.gradient[j], dip: false };
        let later = self.panels.iter().flat_map(|panel| (1..POINTS).map(move |j| on(panel, j)));
        let points: Vec<Place> = iter::once(on(&self.panels[0], 0)).chain(later).collect();
        let mut places = points.clone();
        for three in points.windows(3) {
            let [before, here, after] = [three[0].gradient, three[1].gradient, three[2].gradient];
            for (dip, sign) in [(true, 1.0), (false, -1.0)] {
                if sign * (before - here) > 0.0 && sign * (after - here) >= 0.0 {
                    let p = |eta: f64| self.at(self.panel(eta), eta, Position::at(eta));
                    let eta = minimum(|eta| sign * p(eta), three[0].eta, three[2].eta);
                    places.push(Place { eta, gradient: p(eta), dip });
                }
            }
        }
        places.sort_by(|a, b| a.eta.total_cmp(&b.eta));
        places
    }

    /// The panel that holds η.
    pub(super) fn panel(&self, eta: f64) -> usize {
        self.panels.partition_point(|panel| panel.end < eta).min(self.panels.len() - 1)
    }

    /// p′ at `here`, where ln tan(θ/2) is `eta`, in the given panel.
    pub(super) fn at(&self, panel: usize, eta: f64, here: Position) -> f64 {
        let panel = &self.panels[panel];
        let x = (2.0 * eta - panel.start - panel.end) / (panel.end - panel.start);
        lobatto::interpolate(&self.points, &panel.scaled, x) / sine(here)
    }

    /// η at a point of a panel; its ends to the last bit.
    fn eta(&self, panel: &Panel, point: usize) -> f64 {
        match point {
            0 => panel.start,
            _ if point == POINTS - 1 => panel.end,
            _ => 0.5 * (panel.start + panel.end) + 0.5 * (panel.end - panel.start) * self.points[point],
        }
    }
}

/// Where a function with one minimum between `low` and `high` has it, by golden section.
fn minimum(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let golden = 0.5 * (5_f64.sqrt() - 1.0);
    // the minimum is as exact as the square of the bracket that is left
    while high - low > 1e-7 {
        let (lower, upper) = (high - golden * (high - low), low + golden * (high - low));
        if function(lower) < function(upper) { high = upper } else { low = lower }
    }
    0.5 * (low + high)
}

/// sin θ.
fn sine(here: Position) -> f64 {
    2.0 * (here.to_leading * here.to_trailing).sqrt()
}

/// The ends of equal panels, none wider than `width`.
fn edges(start: f64, end: f64, width: f64) -> impl Iterator<Item = (f64, f64)> {
    let count = ((end - start) / width).ceil();
    let edge = move |i: u32| if f64::from(i) == count { end } else { start + (end - start) * f64::from(i) / count };
    (0..count as u32).map(move |i| (edge(i), edge(i + 1)))
}

/// a and b of P′ = aP + b. Nothing cancels in b at the trailing edge, where it is −k(Γ₁ + Γ₂).
fn coefficients(contact: &DryContact, here: Position) -> (f64, f64) {
    let xi = here.to_trailing - here.to_leading;
    let k_sine2 = 4.0 * contact.k * here.to_leading * here.to_trailing;
    let source = contact.trailing_slope + 2.0 * contact.k * contact.gamma2() * here.to_trailing - k_sine2 * xi;
    (xi - k_sine2, source)
}

/// P at the points of a panel of half length `half` from P at its first point.
fn collocate(
    differentiation: &[[f64; POINTS]; POINTS],
    half: f64,
    equation: &[(f64, f64); POINTS],
    first: f64,
) -> [f64; POINTS] {
    const UNKNOWNS: usize = POINTS - 1;
    let mut matrix = [[0.0; UNKNOWNS]; UNKNOWNS];
    let mut right = [0.0; UNKNOWNS];
    for i in 0..UNKNOWNS {
        let (a, b) = equation[i + 1];
        matrix[i].copy_from_slice(&differentiation[i + 1][1..]);
        matrix[i][i] -= half * a;
        right[i] = half * b - differentiation[i + 1][0] * first;
    }
    eliminate(&mut matrix, &mut right);
    std::array::from_fn(|j| if j == 0 { first } else { right[j - 1] })
}

/// Gaussian elimination with partial pivoting; the solution takes the place of the right-hand side.
fn eliminate<const N: usize>(matrix: &mut [[f64; N]; N], right: &mut [f64; N]) {
    for column in 0..N {
        let size = |row: &usize| matrix[*row][column].abs();
        let pivot = (column..N).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(column);
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let pivot_row = matrix[column];
        for row in column + 1..N {
            let factor = matrix[row][column] / pivot_row[column];
            for j in column + 1..N {
                matrix[row][j] -= factor * pivot_row[j];
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..N).rev() {
        let known: f64 = (row + 1..N).map(|j| matrix[row][j] * right[j]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table against the integral of each place, between and at its points.
    #[test]
    fn gradient_is_that_of_the_integral() {
        for alpha in [0.0, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, f64::INFINITY] {
            for f in [0.0, 1e-3, 1.0, 100.0, 1e4, 1e6] {
                let contact = DryContact::new(alpha, f);
                let table = DryGradient::new(&contact);
                let (first, last) = (table.panels[0].start, TRAILING_END);
                let mut worst: f64 = 0.0;
                for i in 0..=200 {
                    let eta = first + (last - first) * f64::from(i) / 200.0;
                    let here = Position::at(eta);
                    let exact = contact.pressure_gradient(here);
                    let value = table.at(table.panel(eta), eta, here);
                    // P is of the order of its largest values, at the edges
                    let scale = exact.abs() + contact.trailing_slope / sine(here);
                    worst = worst.max(((value - exact) / scale).abs());
                }
                assert!(worst < 1e-9, "alpha={alpha}, f={f}: {worst:e}");
            }
        }
    }
}
