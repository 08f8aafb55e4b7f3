//! The kernel of the surface displacement (T10) and its exact cell averages (T11).

use super::gauss;

const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// S(z) = −e^z Ei(−z) (T10), the retarded part of the kernel; relative error below 1e-13, except at its zero
/// z ≈ −0.3725, where the absolute error is below 1e-15. Infinite at z = 0.
///
/// S ~ 1/z for |z| → ∞ on both sides. For large |z| the scaled product is formed directly, never e^z times Ei(−z):
/// the continued fraction of e^z E₁(z) to the right, the asymptotic series to the left.
pub fn retarded_log(z: f64) -> f64 {
    if z > 2.5 {
        scaled_e1_fraction(z)
    } else if z > -50.0 {
        -(z.exp() * ei_series(-z))
    } else {
        asymptotic_series(z)
    }
}

/// Ei(y) = γ + ln|y| + Σ_{k≥1} y^k/(k·k!), for −2.5 ≤ y ≤ 50; to the right of its zero all terms are positive, and to
/// the left of −1 it loses little more than a digit but is faster than the continued fraction.
fn ei_series(y: f64) -> f64 {
    EULER_GAMMA + y.abs().ln() + ei_sum(y)
}

/// Σ_{k≥1} y^k/(k·k!), for −1 ≤ y ≤ 50.
fn ei_sum(y: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    for k in 1..200 {
        power *= y / f64::from(k);
        let term = power / f64::from(k);
        sum += term;
        if term.abs() <= 0.25 * f64::EPSILON * f64::abs(sum) {
            break;
        }
    }
    sum
}

/// e^z E₁(z) = 1/(z+1 − 1/(z+3 − 4/(z+5 − 9/(z+7 − …)))) for z > 2.5, by Lentz's method.
fn scaled_e1_fraction(z: f64) -> f64 {
    let mut b = z + 1.0;
    let mut d = 1.0 / b;
    let mut value = d;
    let mut c = f64::INFINITY;
    for k in 1..200 {
        let a = -f64::from(k) * f64::from(k);
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        let factor = c * d;
        value *= factor;
        if (factor - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    value
}

/// −e^z Ei(−z) ~ (1/z) Σ (−1)^k k!/z^k for z ≤ −50, where the smallest term is below e^{−50}.
fn asymptotic_series(z: f64) -> f64 {
    let (mut sum, mut term) = (1.0, 1.0);
    for k in 1..50 {
        term *= -f64::from(k) / z;
        sum += term;
        if term.abs() < 0.25 * f64::EPSILON {
            break;
        }
    }
    sum / z
}

/// ∫ S dz = S + ln|z| (T11), continuous at z = 0 with value −γ.
pub fn retarded_log_integral(z: f64) -> f64 {
    if z == 0.0 { -EULER_GAMMA } else { retarded_log(z) + z.abs().ln() }
}

/// Mean of ln|z| over a cell of width `h` centred at `m`; finite also where the cell holds z = 0.
pub fn cell_average_log(m: f64, h: f64) -> f64 {
    let r = h / (2.0 * m.abs());
    if r < 0.5 {
        // relative to ln|m|, so that nothing cancels far away
        return m.abs().ln() + ((1.0 + r) * r.ln_1p() - (1.0 - r) * (-r).ln_1p()) / (2.0 * r) - 1.0;
    }
    let z_ln_z = |z: f64| if z == 0.0 { 0.0 } else { z * z.abs().ln() };
    (z_ln_z(m + h / 2.0) - z_ln_z(m - h / 2.0)) / h - 1.0
}

/// Mean of S over a cell of width `h` centred at `m` (T11); finite also where the cell holds z = 0.
///
/// The difference of the antiderivative loses digits in proportion to 1/h, so narrow cells are done otherwise: by Gauss
/// quadrature away from the singularity, by the integrals of e^z ln|z| term by term at it.
pub fn cell_average_retarded_log(m: f64, h: f64) -> f64 {
    const NARROW: f64 = 1e-2;
    let (a, b) = (m - h / 2.0, m + h / 2.0);
    if h > NARROW {
        (retarded_log_integral(b) - retarded_log_integral(a)) / h
    } else if m.abs() > 4.0 * h {
        gauss::mean(a, b, retarded_log)
    } else {
        // S = −e^z ln|z| − [e^z (γ + Σ (−z)^k/(k·k!))], the bracket being analytic
        let entire = |z: f64| z.exp() * (EULER_GAMMA + ei_sum(-z));
        (exp_log_integral(a) - exp_log_integral(b)) / h - gauss::mean(a, b, entire)
    }
}

/// ∫₀^z e^s ln|s| ds for |z| ≪ 1, by the series of e^s.
fn exp_log_integral(z: f64) -> f64 {
    if z == 0.0 {
        return 0.0;
    }
    let log = z.abs().ln();
    let (mut sum, mut power) = (0.0, z);
    for k in 0..10 {
        let exponent = f64::from(k + 1);
        sum += power / exponent * (log - 1.0 / exponent);
        power *= z / exponent;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ of a function with at most a logarithmic singularity at 0 over [a, b], by graded Gauss panels.
    fn graded_integral(a: f64, b: f64, function: &dyn Fn(f64) -> f64) -> f64 {
        if a < 0.0 && b > 0.0 {
            return graded_integral(a, 0.0, function) + graded_integral(0.0, b, function);
        }
        if a < 0.0 {
            return graded_integral(-b, -a, &|z| function(-z));
        }
        let mut sum = 0.0;
        let mut right = b;
        for _ in 0..120 {
            let left = f64::max(a, right / 2.0);
            sum += (right - left) * gauss::mean(left, right, function);
            if left == a {
                return sum;
            }
            right = left;
        }
        sum
    }

    #[test]
    fn cell_averages_agree_with_graded_quadrature() {
        for h in [1e-7, 1e-4, 3e-3, 0.02, 0.4, 3.0, 50.0] {
            for cells in [-400.0, -30.0, -5.0, -4.0, -3.0, -1.0, -0.5, -0.2, 0.0, 0.3, 0.5, 1.0, 4.0, 9.0, 300.0] {
                let m = cells * h;
                let (a, b) = (m - h / 2.0, m + h / 2.0);
                let log = graded_integral(a, b, &|z| z.abs().ln()) / h;
                let error = (cell_average_log(m, h) - log).abs();
                assert!(error < 1e-13 * log.abs().max(1.0), "ln: h {h}, m {m}: error {error:e}");
                let retarded = graded_integral(a, b, &retarded_log) / h;
                let error = (cell_average_retarded_log(m, h) - retarded).abs();
                assert!(error < 1e-12 * retarded.abs().max(1.0), "S: h {h}, m {m}: error {error:e}");
            }
        }
    }
}
