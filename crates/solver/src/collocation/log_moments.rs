//! ∫ P_k(t) ln|s − t| dt over the reference panel: the logarithmic kernel of the displacement (T7) in closed form.

/// |s| beyond which Q_k falls so fast with k that its recurrence must be run downwards.
const FORWARD: f64 = 1.2;
/// Largest number of moments: one more than the degree of a panel polynomial.
pub const MOST_MOMENTS: usize = 24;
/// Places that are done together: their recurrences are independent and overlap in the processor.
pub const LANES: usize = 8;
/// What is done beyond each |s|, for rounding errors alone to be left: steps of the downward recurrence before its first
/// use, whose error falls by (|s| + √(s² − 1))² a step; and terms of the series of s Q_0, beyond [`LOGARITHM`].
const BEYOND: [(f64, usize, usize); 7] =
    [(1.2, 31, 16), (1.5, 20, 16), (2.0, 15, 16), (LOGARITHM, 11, 16), (6.0, 8, 10), (20.0, 6, 6), (300.0, 4, 3)];
/// |s| up to which Q_0 is taken as a logarithm.
const LOGARITHM: f64 = 3.0;
/// A place far from the panel, for lanes whose own place is done otherwise.
pub const ELSEWHERE: f64 = 1e3;

/// (2k + 1)/k and (k + 1)/k for the downward recurrence.
const DOWNWARD: [(f64, f64); MOST_MOMENTS + 32] = {
    let mut factors = [(0.0, 0.0); MOST_MOMENTS + 32];
    let mut k = 1;
    while k < factors.len() {
        factors[k] = ((2 * k + 1) as f64 / k as f64, (k + 1) as f64 / k as f64);
        k += 1;
    }
    factors
};

/// ∫ P_k(t) ln|s − t| dt over [−1, 1] for k = 0, 1, …, into `moments`; s anywhere on the real line.
///
/// For k ≥ 1 it is 2 (Q_{k+1}(s) − Q_{k−1}(s))/(2k + 1) with the Legendre functions of the second kind (T31), for k = 0
/// (1 − s) ln|1 − s| + (1 + s) ln|1 + s| − 2. Both have limits at s = ±1.
pub fn log_moments(s: f64, moments: &mut [f64]) {
    if s.abs() > FORWARD {
        let mut together = [[0.0; LANES]; MOST_MOMENTS + 1];
        far_moments(&[s; LANES], &mut together[..=moments.len()]);
        for (moment, values) in moments.iter_mut().zip(&together) {
            *moment = values[0];
        }
    } else {
        near_moments(s, moments);
    }
}

/// [`log_moments`] at several places: one list of values for each k, and room for one more.
#[inline(always)]
pub fn log_moments_together(s: &[f64; LANES], moments: &mut [[f64; LANES]]) {
    let far = s.map(|s| if s.abs() > FORWARD { s } else { ELSEWHERE });
    far_moments(&far, moments);
    if far == *s {
        return;
    }
    let mut single = [0.0; MOST_MOMENTS];
    for (lane, &s) in s.iter().enumerate().filter(|(_, s)| s.abs() <= FORWARD) {
        let single = &mut single[..moments.len() - 1];
        near_moments(s, single);
        for (values, moment) in moments.iter_mut().zip(&*single) {
            values[lane] = *moment;
        }
    }
}

/// Within and just beside the panel: Q_k upwards.
fn near_moments(s: f64, moments: &mut [f64]) {
    let count = moments.len();
    let (left, right) = ((1.0 + s).abs(), (1.0 - s).abs());
    if left == 0.0 || right == 0.0 {
        moments[0] = 2.0 * std::f64::consts::LN_2 - 2.0;
        for (k, moment) in moments.iter_mut().enumerate().skip(1) {
            let parity = if s < 0.0 && k % 2 == 1 { -1.0 } else { 1.0 };
            *moment = -2.0 * parity / (k * (k + 1)) as f64;
        }
        return;
    }
    let (ln_left, ln_right) = (left.ln(), right.ln());
    let mut q = [0.0; MOST_MOMENTS + 1];
    q[0] = 0.5 * (ln_left - ln_right);
    q[1] = s * q[0] - 1.0;
    for k in 1..count {
        q[k + 1] = ((2 * k + 1) as f64 * s * q[k] - k as f64 * q[k - 1]) / (k + 1) as f64;
    }
    moments[0] = (1.0 - s) * ln_right + (1.0 + s) * ln_left - 2.0;
    for k in 1..count {
        moments[k] = 2.0 * (q[k + 1] - q[k - 1]) / (2 * k + 1) as f64;
    }
}

/// Far from the panel: Q_k downwards from where it is nothing, in proportion to the known Q_0 (Miller's algorithm).
///
/// The recurrence is that of G_k = s^{k+1} Q_k, which has r = 1/s² alone in it and neither over- nor underflows. There is
/// room for one moment more than is wanted.
#[inline(always)]
fn far_moments(s: &[f64; LANES], moments: &mut [[f64; LANES]]) {
    let count = moments.len() - 1;
    let nearest = s.iter().fold(f64::INFINITY, |a, s| a.min(s.abs()));
    let (_, steps, terms) = *BEYOND.iter().rev().find(|(from, ..)| nearest >= *from).unwrap_or(&BEYOND[0]);
    let inverse = s.map(f64::recip);
    let r = inverse.map(|inverse| inverse * inverse);
    let (mut above, mut here) = ([0.0; LANES], [1.0; LANES]);
    for k in (1..=count + steps).rev() {
        if k <= count {
            moments[k] = here;
        }
        let (outer, inner) = DOWNWARD[k];
        for lane in 0..LANES {
            let below = f64::mul_add(here[lane], outer, -inner * (r[lane] * above[lane]));
            above[lane] = here[lane];
            here[lane] = below;
        }
    }
    // s Q_0 − 1 = Σ rⁿ/(2n + 1) from n = 1 on
    let mut beyond_one = [0.0; LANES];
    for n in (1..=terms).rev() {
        let coefficient = INVERSE_ODD[n];
        for lane in 0..LANES {
            beyond_one[lane] = r[lane] * (coefficient + beyond_one[lane]);
        }
    }
    if nearest < LOGARITHM {
        let logarithm = ln_together(&s.map(|s| (s.abs() + 1.0) / (s.abs() - 1.0)));
        for lane in 0..LANES {
            if s[lane].abs() < LOGARITHM {
                beyond_one[lane] = 0.5 * s[lane].abs() * logarithm[lane] - 1.0;
            }
        }
    }
    let argument = s.map(|s| (s.abs() - 1.0) * (s.abs() + 1.0));
    let logarithm = ln_together(&argument);
    let mut scale = [0.0; LANES];
    for lane in 0..LANES {
        // (1−s) ln|1−s| + (1+s) ln|1+s| − 2 = ln(s² − 1) + 2 s Q_0 − 2, without the digits that s ln|s| would cost
        moments[0][lane] = logarithm[lane] + 2.0 * beyond_one[lane];
        scale[lane] = (1.0 + beyond_one[lane]) / here[lane];
    }
    let mut below = here;
    for k in 1..count {
        let factor = 2.0 / (2 * k + 1) as f64;
        let (here, above) = (moments[k], moments[k + 1]);
        for lane in 0..LANES {
            scale[lane] *= inverse[lane];
            moments[k][lane] = factor * scale[lane] * (r[lane] * above[lane] - below[lane]);
        }
        below = here;
    }
}

/// 1/(2n + 1).
const INVERSE_ODD: [f64; 17] = {
    let mut inverse = [0.0; 17];
    let mut n = 0;
    while n < inverse.len() {
        inverse[n] = 1.0 / (2 * n + 1) as f64;
        n += 1;
    }
    inverse
};

/// ln x for positive normal numbers, to some 10⁻¹⁶ of the larger of it and 1.
///
/// With x = 2^e m and m from √½ to √2, ln m = 2 artanh t with t = (m − 1)/(m + 1), whose series in t² < 0.03 is short.
#[inline(always)]
fn ln_together(x: &[f64; LANES]) -> [f64; LANES] {
    const TERMS: usize = 11;
    /// The bits of √½, and what an exponent of 1 and the integer 2⁵² are as bits.
    const HALF_ROOT: u64 = 0x3fe6_a09e_667f_3bcd;
    const ONE: u64 = 1 << 52;
    const INTEGER: u64 = 0x4330_0000_0000_0000;
    let (mut exponent, mut t) = ([0.0; LANES], [0.0; LANES]);
    for lane in 0..LANES {
        // the exponent of x/√½, shifted so that it is positive
        let shifted = x[lane].to_bits() + (1024 * ONE - HALF_ROOT);
        let whole = shifted >> 52;
        let m = f64::from_bits((shifted & (ONE - 1)) + HALF_ROOT);
        exponent[lane] = f64::from_bits(INTEGER | whole) - (f64::from_bits(INTEGER) + 1024.0);
        t[lane] = (m - 1.0) / (m + 1.0);
    }
    let square = t.map(|t| t * t);
    let mut series = [0.0; LANES];
    for n in (1..=TERMS).rev() {
        for lane in 0..LANES {
            series[lane] = square[lane] * (INVERSE_ODD[n] + series[lane]);
        }
    }
    std::array::from_fn(|lane| exponent[lane] * std::f64::consts::LN_2 + 2.0 * (t[lane] + t[lane] * series[lane]))
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
    fn logarithms_are_those_of_the_library() {
        for i in -3000..3000 {
            let x = (0.1 * f64::from(i)).exp() * (1.0 + 1e-3 * f64::from(i % 7));
            for x in [x, 1.0 + 1e-9 * f64::from(i)] {
                let error = (ln_together(&[x; LANES])[3] - x.ln()).abs();
                assert!(error <= 3e-16 * x.ln().abs().max(1.0), "{x:e}: {error:e}");
            }
        }
    }

    #[test]
    fn closed_form_agrees_with_graded_quadrature() {
        let apart = [1e-9, 1e-3, 0.1, 0.19, 0.21, 0.3, 0.51, 1.0, 2.1, 5.1, 19.1, 100.0, 300.0, 1e5, 1e9];
        let outside = apart.iter().flat_map(|d| [1.0 + d, -1.0 - d]);
        for s in [-1.0, -0.999, -0.4, 0.0, 0.1, 0.7, 1.0].into_iter().chain(outside) {
            let (mut moments, mut together) = ([0.0; 15], [[0.0; LANES]; 16]);
            log_moments(s, &mut moments);
            let mut places = [3.0; LANES];
            places[5] = s;
            log_moments_together(&places, &mut together);
            for (k, moment) in moments.iter().enumerate() {
                assert!((moment - together[k][5]).abs() <= 1e-15 * moment.abs().max(1.0), "s {s}, k {k}");
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
