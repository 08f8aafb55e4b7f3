//! The kernel of the surface displacement (T10) and its exact cell averages (T11).

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

/// Ei(y) = γ + ln|y| + Σ_{k≥1} y^k/(k·k!), for −2.5 ≤ y ≤ 50; to the right of its zero all terms are positive, and to the
/// left of −1 it loses little more than a digit but is faster than the continued fraction.
fn ei_series(y: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    for k in 1..200 {
        power *= y / f64::from(k);
        let term = power / f64::from(k);
        sum += term;
        if term.abs() <= 0.25 * f64::EPSILON * f64::abs(sum) {
            break;
        }
    }
    EULER_GAMMA + y.abs().ln() + sum
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
