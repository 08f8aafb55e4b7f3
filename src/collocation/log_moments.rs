//! ∫ P_k(t) ln|s − t| dt over the reference panel: the logarithmic kernel of the displacement (T7) in closed form.

/// |s| beyond which Q_k falls so fast with k that its recurrence must be run downwards.
const FORWARD: f64 = 1.2;
/// Largest degree of a panel polynomial, plus one.
pub const MOST_MOMENTS: usize = 24;

/// ∫ P_k(t) ln|s − t| dt over [−1, 1] for k = 0, 1, …, into `moments`; s anywhere on the real line.
///
/// For k ≥ 1 it is 2 (Q_{k+1}(s) − Q_{k−1}(s))/(2k + 1) with the Legendre functions of the second kind (T31), for k = 0
/// (1 − s) ln|1 − s| + (1 + s) ln|1 + s| − 2. Both have limits at s = ±1.
pub fn log_moments(s: f64, moments: &mut [f64]) {
    let count = moments.len();
    assert!(count <= MOST_MOMENTS, "no panel has so high a degree");
    let (left, right) = ((1.0 + s).abs(), (1.0 - s).abs());
    if left == 0.0 || right == 0.0 {
        for (k, moment) in moments.iter_mut().enumerate() {
            let k = k as f64;
            let parity = if s < 0.0 && k % 2.0 == 1.0 { -1.0 } else { 1.0 };
            *moment = if k == 0.0 { 2.0 * std::f64::consts::LN_2 - 2.0 } else { -2.0 * parity / (k * (k + 1.0)) };
        }
        return;
    }
    let mut q = [0.0; MOST_MOMENTS + 1];
    if s.abs() <= FORWARD {
        let (ln_left, ln_right) = (left.ln(), right.ln());
        q[0] = 0.5 * (ln_left - ln_right);
        q[1] = s * q[0] - 1.0;
        for k in 1..count {
            q[k + 1] = ((2 * k + 1) as f64 * s * q[k] - k as f64 * q[k - 1]) / (k + 1) as f64;
        }
        moments[0] = (1.0 - s) * ln_right + (1.0 + s) * ln_left - 2.0;
    } else {
        q[0] = 0.5 * s.signum() * (2.0 / (s.abs() - 1.0)).ln_1p();
        // (1−s) ln|1−s| + (1+s) ln|1+s| − 2 = ln(s² − 1) + 2 s Q_0 − 2, without the digits that s ln|s| would cost
        moments[0] = (left * right).ln() + 2.0 * (s * q[0] - 1.0);
        // the ratio Q_k/Q_{k−1} from above: its error falls by ρ² a step
        let rho = s.abs() + (s * s - 1.0).sqrt();
        let extra = (19.0 / rho.ln()).ceil().min(60.0) as usize;
        let mut ratio = s.signum() / rho;
        let mut ratios = [0.0; MOST_MOMENTS + 1];
        for k in (1..=count + extra).rev() {
            ratio = k as f64 / ((2 * k + 1) as f64 * s - (k + 1) as f64 * ratio);
            if k <= count {
                ratios[k] = ratio;
            }
        }
        for k in 1..=count {
            q[k] = q[k - 1] * ratios[k];
        }
    }
    for k in 1..count {
        moments[k] = 2.0 * (q[k + 1] - q[k - 1]) / (2 * k + 1) as f64;
    }
}

#[cfg(test)]
mod tests {
    use super::super::legendre::legendre;
    use super::*;
    use crate::model::gauss;

    /// By quadrature on panels that shrink towards the singularity.
    fn graded(s: f64, k: usize) -> f64 {
        let integrand = |t: f64| {
            let mut values = [0.0; MOST_MOMENTS];
            legendre(t, &mut values[..=k]);
            values[k] * (s - t).abs().max(f64::MIN_POSITIVE).ln()
        };
        let near = s.clamp(-1.0, 1.0);
        let mut sum = 0.0;
        for end in [-1.0, 1.0] {
            let mut far = end;
            for _ in 0..60 {
                if far == near {
                    break;
                }
                let closer = near + 0.5 * (far - near);
                sum += gauss::integrate(f64::min(far, closer), f64::max(far, closer), integrand);
                far = closer;
            }
        }
        sum
    }

    #[test]
    fn closed_form_agrees_with_graded_quadrature() {
        let apart = [1e-9, 1e-3, 0.1, 0.19, 0.21, 0.3, 1.0, 5.0, 100.0, 1e5];
        let outside = apart.iter().flat_map(|d| [1.0 + d, -1.0 - d]);
        for s in [-1.0, -0.999, -0.4, 0.0, 0.1, 0.7, 1.0].into_iter().chain(outside) {
            let mut moments = [0.0; 15];
            log_moments(s, &mut moments);
            for (k, moment) in moments.iter().enumerate() {
                let error = (moment - graded(s, k)).abs();
                assert!(error < 2e-13 * s.abs().ln().max(1.0), "s {s}, k {k}: {error:e}");
            }
        }
    }

    /// Far away the moments fall as s^{−k}; they keep their relative accuracy.
    #[test]
    fn far_moments_are_relatively_accurate() {
        for s in [3.0, -30.0, 1e3_f64] {
            let mut moments = [0.0; 9];
            log_moments(s, &mut moments);
            // ∫ P_k ln|s − t| = −Σ_j s^{−j}/j ∫ P_k t^j
            for (k, moment) in moments.iter().enumerate().skip(1) {
                let mut series = 0.0;
                for j in (k..200).step_by(2) {
                    series -= power_moment(k, j) * s.powi(-(j as i32)) / j as f64;
                }
                assert!((moment / series - 1.0).abs() < 1e-12, "s {s}, k {k}: {moment:e} {series:e}");
            }
        }
    }

    /// ∫ P_k(t) t^j dt over [−1, 1], from ∫ P_k t^j = ∫ P_{k−1} t^{j−1} · j/(j + k + 1).
    fn power_moment(k: usize, j: usize) -> f64 {
        if k > j || (j - k) % 2 == 1 {
            return 0.0;
        }
        if k == 0 { 2.0 / (j + 1) as f64 } else { power_moment(k - 1, j - 1) * j as f64 / (j + k + 1) as f64 }
    }
}
