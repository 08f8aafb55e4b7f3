//! ∫ κ e^{−κ(s − t)} P_k(s) ds over the rest of the reference panel: the retardation filter (T8) of a polynomial.

use super::legendre::legendre;
use super::log_moments::MOST_MOMENTS;

/// Most places of a panel: its Gauss points, and its left end after them.
pub const MOST_PLACES: usize = 20;
/// A number at each place; what is beyond the places of a panel is not used.
pub type AtPlaces = [f64; MOST_PLACES];

/// Room for the moments that are wanted and those beyond.
pub type Room = [AtPlaces; MOST_MOMENTS + MOST_BEYOND];
/// Room before its first use.
pub const NO_MOMENTS: Room = [[0.0; MOST_PLACES]; MOST_MOMENTS + MOST_BEYOND];

/// κ above which the recurrence in k is run upwards: its errors grow as the product of (2k + 1)/κ.
const STIFF: f64 = 12.0;
/// Up to each κ, so many more moments than wanted, for what is said of the one after them to be forgotten to rounding:
/// an error falls by κ/(2k + 1) from one to the next lower.
const BEYOND: [(f64, usize); 3] = [(1.0, 10), (4.0, 17), (STIFF, MOST_BEYOND)];
const MOST_BEYOND: usize = 36;

/// The places t of a panel, and the Legendre polynomials there.
#[derive(Debug)]
pub struct Places {
    t: AtPlaces,
    /// P_0, P_1, …
    polynomials: Vec<AtPlaces>,
}

impl Places {
    /// These places, at most [`MOST_PLACES`].
    pub fn new(t: impl Iterator<Item = f64>) -> Self {
        let mut places =
            Self { t: [1.0; MOST_PLACES], polynomials: vec![[1.0; MOST_PLACES]; MOST_MOMENTS + MOST_BEYOND + 3] };
        let mut values = vec![0.0; places.polynomials.len()];
        for (place, t) in t.enumerate() {
            places.t[place] = t;
            legendre(t, &mut values);
            for (polynomial, value) in places.polynomials.iter_mut().zip(&values) {
                polynomial[place] = *value;
            }
        }
        places
    }

    /// e^{−κ(1 − t)}: what is left at each place of what is handed on at the right end.
    pub fn decay(&self, kappa: f64) -> AtPlaces {
        self.t.map(|t| (-kappa * (1.0 - t)).exp())
    }

    /// κ times the derivative of what is left with respect to κ.
    pub fn decay_derivative(&self, kappa: f64) -> AtPlaces {
        self.t.map(|t| -kappa * (1.0 - t) * (-kappa * (1.0 - t)).exp())
    }

    /// ∫_t^1 κ e^{−κ(s − t)} P_k(s) ds at all places, for k = 0, 1, … `count` − 1, at least two, into the first of
    /// `moments`; κ ≥ 0.
    #[inline(always)]
    pub fn exponential_moments(&self, kappa: f64, count: usize, moments: &mut Room) {
        if kappa > STIFF {
            self.stiff_moments(kappa, &mut moments[..count]);
        } else {
            self.soft_moments(kappa, &mut moments[..count + beyond(kappa)]);
        }
    }

    /// κ times the derivative of the moments with respect to κ (T50), into the first of `derivatives`.
    pub fn exponential_moment_derivatives(&self, kappa: f64, count: usize, derivatives: &mut Room) {
        let of_first = self.decay_derivative(kappa).map(|derivative| -derivative);
        if kappa > STIFF {
            let mut moments = NO_MOMENTS;
            self.stiff_moments(kappa, &mut moments[..count]);
            derivatives[0] = of_first;
            for lane in 0..MOST_PLACES {
                derivatives[1][lane] = of_first[lane] + (of_first[lane] - moments[0][lane]) / kappa;
            }
            for k in 1..count - 1 {
                for lane in 0..MOST_PLACES {
                    derivatives[k + 1][lane] = derivatives[k - 1][lane]
                        + (2 * k + 1) as f64 / kappa * (derivatives[k][lane] - moments[k][lane]);
                }
            }
            return;
        }
        let all = &mut derivatives[..count + beyond(kappa)];
        self.soft_moments(kappa, all);
        // the derivative of its three terms: (2k + 1) D_k + κ(D_{k−1} − D_{k+1}) = (2k + 1) M_k
        for (k, values) in all.iter_mut().enumerate() {
            *values = values.map(|value| (2 * k + 1) as f64 * value);
        }
        all[0] = of_first;
        // far up the moments are as κ
        let after = self.after(kappa, all.len());
        solve_three_terms(kappa, all, &after);
    }

    /// By parts, with (P_{k+1} − P_{k−1})′ = (2k + 1) P_k, which vanishes at 1 (T32): three moments in a row obey
    /// (2k + 1) M_k + κ(M_{k−1} − M_{k+1}) = κ(P_{k−1} − P_{k+1}).
    #[inline(always)]
    fn soft_moments(&self, kappa: f64, moments: &mut [AtPlaces]) {
        moments[0] = self.first_moment(kappa);
        for (moments, polynomials) in moments[1..].iter_mut().zip(self.polynomials.windows(3)) {
            for ((moment, below), above) in moments.iter_mut().zip(&polynomials[0]).zip(&polynomials[2]) {
                *moment = kappa * (below - above);
            }
        }
        let after = self.after(kappa, moments.len());
        solve_three_terms(kappa, moments, &after);
    }

    /// The same upwards.
    #[inline(always)]
    fn stiff_moments(&self, kappa: f64, moments: &mut [AtPlaces]) {
        let (first, decay) = (self.first_moment(kappa), self.decay(kappa));
        moments[0] = first;
        for lane in 0..MOST_PLACES {
            // ∫ κ e^{−κ(s−t)} s ds
            moments[1][lane] = self.t[lane] - decay[lane] + first[lane] / kappa;
        }
        for k in 1..moments.len() - 1 {
            let (below, above) = (&self.polynomials[k - 1], &self.polynomials[k + 1]);
            let factor = (2 * k + 1) as f64 / kappa;
            for lane in 0..MOST_PLACES {
                moments[k + 1][lane] = moments[k - 1][lane] + above[lane] - below[lane] + factor * moments[k][lane];
            }
        }
    }

    #[inline(always)]
    fn first_moment(&self, kappa: f64) -> AtPlaces {
        self.t.map(|t| -(-kappa * (1.0 - t)).exp_m1())
    }

    /// About the moment k, for large k.
    #[inline(always)]
    fn after(&self, kappa: f64, k: usize) -> AtPlaces {
        let (below, above) = (&self.polynomials[k - 1], &self.polynomials[k + 1]);
        let mut after = [0.0; MOST_PLACES];
        for lane in 0..MOST_PLACES {
            after[lane] = kappa / (2 * k + 1) as f64 * (below[lane] - above[lane]);
        }
        after
    }
}

/// Moments beyond those wanted at κ.
fn beyond(kappa: f64) -> usize {
    BEYOND.iter().find(|(most, _)| kappa <= *most).map_or(MOST_BEYOND, |&(_, more)| more)
}

/// Solves (2k + 1) x_k + κ(x_{k−1} − x_{k+1}) = b_k for k ≥ 1 in place, x_0 and the last but one x being known. All pivots
/// are positive.
#[inline(always)]
fn solve_three_terms(kappa: f64, values: &mut [AtPlaces], after: &AtPlaces) {
    let last = values.len() - 1;
    let mut inverses = [0.0; MOST_MOMENTS + MOST_BEYOND];
    let mut factor = kappa;
    for k in 1..=last {
        let (known, rest) = values.split_at_mut(k);
        for (value, below) in rest[0].iter_mut().zip(&known[k - 1]) {
            *value -= factor * below;
        }
        // x_0 is no unknown
        let below = if k == 1 { 0.0 } else { factor };
        inverses[k] = ((2 * k + 1) as f64 + kappa * below).recip();
        factor = kappa * inverses[k];
    }
    let mut above = after;
    for (values, inverse) in values[1..].iter_mut().zip(&inverses[1..]).rev() {
        for (value, above) in values.iter_mut().zip(above) {
            *value = inverse * (*value + kappa * above);
        }
        above = values;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::gauss;

    const COUNT: usize = 12;
    const PLACES: [f64; 5] = [-1.0, -0.5, 0.2, 0.93, 1.0];

    /// Both ways against quadrature on pieces so short that the rule is exact.
    #[test]
    fn moments_agree_with_quadrature_for_soft_and_stiff_panels() {
        for kappa in [0.0, 1e-8, 0.3, 0.99, 3.99, 5.0, 11.9, 12.1, 13.0, 40.0, 1e3] {
            let mut at_places = NO_MOMENTS;
            Places::new(PLACES.into_iter()).exponential_moments(kappa, COUNT, &mut at_places);
            for (place, t) in PLACES.into_iter().enumerate() {
                let moments = at_places[..COUNT].iter().map(|values| values[place]);
                let end = f64::min(1.0, t + 45.0 / f64::max(kappa, 1e-300));
                for (k, moment) in moments.enumerate() {
                    let integrand = |s: f64| {
                        let mut values = [0.0; 12];
                        legendre(s, &mut values);
                        kappa * (-kappa * (s - t)).exp() * values[k]
                    };
                    let pieces = 64;
                    let step = (end - t) / f64::from(pieces);
                    let at = |i: i32| t + f64::from(i) * step;
                    let exact: f64 = (0..pieces).map(|i| gauss::integrate(at(i), at(i + 1), integrand)).sum();
                    assert!((moment - exact).abs() < 2e-14, "κ {kappa}, t {t}, k {k}: {moment:e} {exact:e}");
                }
            }
        }
    }

    /// Derivatives against differences of fourth order, soft and stiff.
    #[test]
    fn moment_rates_are_derivatives() {
        for kappa in [1e-8, 0.3, 5.0, 11.0, 13.0, 40.0, 1e3] {
            let places = Places::new(PLACES.into_iter());
            let mut at_places = NO_MOMENTS;
            places.exponential_moment_derivatives(kappa, COUNT, &mut at_places);
            for (place, t) in PLACES.into_iter().enumerate() {
                let at = |ln: f64| {
                    let mut moments = NO_MOMENTS;
                    places.exponential_moments(kappa * ln.exp(), COUNT, &mut moments);
                    moments.map(|values| values[place])
                };
                let derivatives = at_places[..COUNT].iter().map(|values| values[place]);
                let step = 2e-3;
                let [near, far] = [step, 2.0 * step].map(|h| (at(h), at(-h)));
                for (k, derivative) in derivatives.enumerate() {
                    let difference = (8.0 * (near.0[k] - near.1[k]) - (far.0[k] - far.1[k])) / (12.0 * step);
                    assert!(
                        (derivative - difference).abs() < 1e-9,
                        "κ {kappa}, t {t}, k {k}: {derivative:e} {difference:e}"
                    );
                }
            }
        }
    }
}
