//! ∫ κ e^{−κ(s − t)} P_k(s) ds over the rest of the reference panel: the retardation filter (T8) of a polynomial.

use super::legendre::{legendre, legendre_together};
use super::log_moments::MOST_MOMENTS;
use crate::model::gauss;

/// κ above which the recurrence in k is run upwards: its errors grow as the product of (2k + 1)/κ.
const STIFF: f64 = 12.0;
/// κ times length over which the quadrature rule is exact to rounding with any panel polynomial.
const SMOOTH: f64 = 6.0;

/// ∫_t^1 κ e^{−κ(s − t)} P_k(s) ds for k = 0, 1, …, into `moments`; κ ≥ 0, −1 ≤ t ≤ 1.
pub fn exponential_moments(kappa: f64, t: f64, moments: &mut [f64]) {
    let count = moments.len();
    assert!(count <= MOST_MOMENTS, "no panel has so high a degree");
    let reach = kappa * (1.0 - t);
    if kappa > STIFF {
        // by parts, with (P_{k+1} − P_{k−1})′ = (2k + 1) P_k, which vanishes at 1 (T32)
        let mut polynomial = [0.0; MOST_MOMENTS];
        legendre(t, &mut polynomial[..count]);
        moments[0] = -(-reach).exp_m1();
        let mut two_below = moments[0];
        if count > 1 {
            // ∫ κ e^{−κ(s−t)} s ds
            moments[1] = t - (-reach).exp() + moments[0] / kappa;
        }
        for k in 1..count - 1 {
            let next = two_below + polynomial[k + 1] - polynomial[k - 1] + (2 * k + 1) as f64 / kappa * moments[k];
            two_below = moments[k];
            moments[k + 1] = next;
        }
        return;
    }
    by_quadrature(kappa, t, |_| 1.0, moments);
}

/// κ times the derivative of the [`exponential_moments`] with respect to κ (T50), into `derivatives`.
pub fn exponential_moment_derivatives(kappa: f64, t: f64, derivatives: &mut [f64]) {
    let count = derivatives.len();
    if kappa <= STIFF {
        return by_quadrature(kappa, t, |passed| 1.0 - passed, derivatives);
    }
    let mut moments = [0.0; MOST_MOMENTS];
    exponential_moments(kappa, t, &mut moments[..count]);
    let reach = kappa * (1.0 - t);
    derivatives[0] = reach * (-reach).exp();
    let mut two_below = derivatives[0];
    if count > 1 {
        derivatives[1] = derivatives[0] + (derivatives[0] - moments[0]) / kappa;
    }
    for k in 1..count - 1 {
        let next = two_below + (2 * k + 1) as f64 / kappa * (derivatives[k] - moments[k]);
        two_below = derivatives[k];
        derivatives[k + 1] = next;
    }
}

/// ∫_t^1 κ e^{−κ(s − t)} q(κ(s − t)) P_k(s) ds for a polynomial q, into `moments`.
fn by_quadrature(kappa: f64, t: f64, q: impl Fn(f64) -> f64, moments: &mut [f64]) {
    moments.fill(0.0);
    let count = moments.len();
    let pieces = (kappa * (1.0 - t) / SMOOTH).ceil().max(1.0);
    let length = (1.0 - t) / pieces;
    let mut polynomial = [[0.0; gauss::POINTS]; MOST_MOMENTS];
    for piece in 0..pieces as usize {
        let from = t + piece as f64 * length;
        let (mut places, mut factors) = ([0.0; gauss::POINTS], [0.0; gauss::POINTS]);
        for ((place, factor), (part, weight)) in places.iter_mut().zip(&mut factors).zip(gauss::unit_interval()) {
            *place = from + part * length;
            let passed = kappa * (*place - t);
            *factor = weight * length * kappa * (-passed).exp() * q(passed);
        }
        legendre_together(&places, &mut polynomial[..count]);
        for (moment, values) in moments.iter_mut().zip(&polynomial) {
            for (factor, value) in factors.iter().zip(values) {
                *moment += factor * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both ways against quadrature on pieces so short that the rule is exact.
    #[test]
    fn moments_agree_with_quadrature_for_soft_and_stiff_panels() {
        for kappa in [0.0, 1e-8, 0.3, 5.0, 11.9, 12.1, 13.0, 40.0, 1e3] {
            for t in [-1.0, -0.5, 0.2, 0.93, 1.0] {
                let mut moments = [0.0; 12];
                exponential_moments(kappa, t, &mut moments);
                let end = f64::min(1.0, t + 45.0 / f64::max(kappa, 1e-300));
                for (k, moment) in moments.iter().enumerate() {
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

    /// RetardationDerivatives against differences of fourth order, soft and stiff.
    #[test]
    fn moment_rates_are_derivatives() {
        for kappa in [1e-8, 0.3, 5.0, 11.0, 13.0, 40.0, 1e3] {
            for t in [-1.0, -0.5, 0.2, 0.93, 1.0] {
                let at = |ln: f64| {
                    let mut moments = [0.0; 12];
                    exponential_moments(kappa * ln.exp(), t, &mut moments);
                    moments
                };
                let mut derivatives = [0.0; 12];
                exponential_moment_derivatives(kappa, t, &mut derivatives);
                let step = 2e-3;
                let [near, far] = [step, 2.0 * step].map(|h| (at(h), at(-h)));
                for (k, derivative) in derivatives.iter().enumerate() {
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
