//! The retardation filter on one panel: weights of what is there in what comes out (T30).

use super::exponential_moments::{AtPlaces, MOST_PLACES, Room};
use super::reference::ReferencePanel;
use crate::linear::wide;

/// κ from which on α(v − e) is not formed as the difference that it is: its rounding error, about κ, would be above
/// that of e′, about d².
const STIFF_SLOPE: f64 = 50.0;

/// What a panel makes of e, and of what it is handed at its right end, at its [places](ReferencePanel::places).
pub struct PanelFilter {
    /// Weights of what is handed on.
    pub decay: AtPlaces,
    /// For v.
    pub displacement: Weights,
    /// For v′ = α(v − e), where the panel is stiff; it obeys the same filter with e′ in place of e.
    pub slope: Option<Weights>,
}

/// Weights of the values of e on a panel in those of something else at its places: of e at the Gauss points, and at the
/// left and the right end after them.
pub struct Weights(Vec<AtPlaces>);

impl Weights {
    /// Those of each value of e in turn.
    #[inline(always)]
    pub fn of_values(&self) -> impl Iterator<Item = &AtPlaces> {
        self.0.iter()
    }

    /// What all places have from e.
    #[inline(always)]
    pub fn apply(&self, e: &[f64], ends: [f64; 2]) -> AtPlaces {
        let mut at = [0.0; MOST_PLACES];
        for (weights, e) in self.0.iter().zip(e.iter().chain(&ends)) {
            for (at, weight) in at.iter_mut().zip(weights) {
                *at += weight * e;
            }
        }
        at
    }

    /// Adds to the weights of e a factor times what this place takes of it: the transpose of [`Weights::apply`].
    pub fn add_transposed(&self, place: usize, factor: f64, e: &mut [f64], ends: &mut [f64; 2]) {
        for (sum, weights) in e.iter_mut().chain(ends).zip(&self.0) {
            *sum += factor * weights[place];
        }
    }

    /// The weights of e that give the same for a factor times e′.
    fn of_derivative(&self, reference: &ReferencePanel, factor: f64) -> Self {
        let (degree, rich) = (reference.degree, reference.degree + 2);
        // the rich points begin with the left end
        let of = |j: usize| {
            let mut sums = [0.0; MOST_PLACES];
            let inputs = [&self.0[degree]].into_iter().chain(&self.0[..degree]).chain([&self.0[degree + 1]]);
            for (i, weights) in inputs.enumerate() {
                let derivative = factor * reference.rich_derivative[i * rich + j];
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    *sum += derivative * weight;
                }
            }
            sums
        };
        Self((1..=degree).chain([0, rich - 1]).map(of).collect())
    }
}

impl PanelFilter {
    /// The filter of rate α on a panel of this half width.
    pub fn new(reference: &ReferencePanel, alpha: f64, half: f64, room: &mut Room) -> Self {
        let (kappa, places) = (alpha * half, &reference.places);
        wide(
            #[inline(always)]
            || places.exponential_moments(kappa, reference.degree + 2, room),
        );
        Self::of(reference, kappa, half, places.decay(kappa), room)
    }

    /// α times its derivative with respect to α.
    pub fn derivatives(reference: &ReferencePanel, alpha: f64, half: f64, room: &mut Room) -> Self {
        let (kappa, places) = (alpha * half, &reference.places);
        places.exponential_moment_derivatives(kappa, reference.degree + 2, room);
        Self::of(reference, kappa, half, places.decay_derivative(kappa), room)
    }

    /// One of what is left of what is handed on, and of the moments.
    fn of(reference: &ReferencePanel, kappa: f64, half: f64, decay: AtPlaces, moments: &Room) -> Self {
        let displacement = wide(
            #[inline(always)]
            || response(reference, moments),
        );
        let slope = (kappa > STIFF_SLOPE).then(|| displacement.of_derivative(reference, half.recip()));
        Self { decay, displacement, slope }
    }

    /// v at the places: what they have from e and of what is handed on.
    #[inline(always)]
    pub fn pass(&self, handed_on: f64, e: &[f64], ends: [f64; 2]) -> AtPlaces {
        self.add_handed_on(handed_on, self.displacement.apply(e, ends))
    }

    /// Adds what is left at the places of what is handed on.
    #[inline(always)]
    pub fn add_handed_on(&self, handed_on: f64, mut at: AtPlaces) -> AtPlaces {
        for (at, decay) in at.iter_mut().zip(&self.decay) {
            *at += decay * handed_on;
        }
        at
    }
}

/// Weights of e in ∫_t^1 κ e^{−κ(s − t)} e(s) ds, from the d + 2 moments.
///
/// The polynomial through the Gauss points and both ends is the one through the Gauss points, and P_d(s)(a + bs), which
/// vanishes there, for what is missing at the ends.
#[inline(always)]
fn response(reference: &ReferencePanel, moments: &[AtPlaces]) -> Weights {
    let degree = reference.degree;
    let parity = if degree.is_multiple_of(2) { 1.0 } else { -1.0 };
    let (mut left, mut right) = ([0.0; MOST_PLACES], [0.0; MOST_PLACES]);
    for lane in 0..MOST_PLACES {
        let constant = moments[degree][lane];
        // s P_d = ((d + 1) P_{d+1} + d P_{d−1})/(2d + 1)
        let d = degree as f64;
        let linear = ((d + 1.0) * moments[degree + 1][lane] + d * moments[degree - 1][lane]) / (2.0 * d + 1.0);
        (left[lane], right[lane]) = (0.5 * parity * (constant - linear), 0.5 * (constant + linear));
    }
    let mut weights = Vec::with_capacity(degree + 2);
    for i in 0..degree {
        let [at_left, at_right] = [0, 1].map(|end| reference.end_values[end][i]);
        let mut of_point = [0.0; MOST_PLACES];
        for lane in 0..MOST_PLACES {
            of_point[lane] = -left[lane] * at_left - right[lane] * at_right;
        }
        for (k, moment) in moments[..degree].iter().enumerate() {
            let coefficient = reference.point_coefficients[k * degree + i];
            for (weight, moment) in of_point.iter_mut().zip(moment) {
                *weight += coefficient * moment;
            }
        }
        weights.push(of_point);
    }
    weights.extend([left, right]);
    Weights(weights)
}
