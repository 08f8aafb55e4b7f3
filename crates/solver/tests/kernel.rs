//! Laws of the kernel of the surface displacement: S(z) and its integral.

use stribeck_solver::kernel::{retarded_log, retarded_log_integral};

const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// Rows (z, S) of the table made by `scripts/reference_kernel.py` with 60 digits.
fn table() -> Vec<(f64, f64)> {
    let rows = include_str!("reference/retarded_log.csv").lines().skip(1);
    let pairs = rows.map(|row| {
        let (z, s) = row.split_once(',').expect("two columns");
        (z.parse().expect("a number"), s.parse().expect("a number"))
    });
    pairs.collect()
}

#[test]
fn thirteen_digits_over_twenty_four_decades() {
    let table = table();
    assert!(table.len() >= 200);
    assert!(table.iter().any(|&(z, _)| z < -1e11) && table.iter().any(|&(z, _)| z > 1e11));
    for (z, exact) in table {
        // S has a zero at z = −0.3725: close to it the error is judged by S/(distance to the zero) ~ 1.
        let near_zero = (z + 0.3725).abs() < 0.05;
        let scale = if near_zero { 1.0 } else { exact.abs() };
        let error = (retarded_log(z) - exact).abs() / scale;
        assert!(error < 1e-13, "S({z}) = {} is not {exact}: {error:e}", retarded_log(z));
    }
}

#[test]
fn integral_is_continuous_at_zero() {
    assert_eq!(retarded_log_integral(0.0), -EULER_GAMMA);
    for z in [1e-300, -1e-300, 1e-15, -1e-15] {
        assert!((retarded_log_integral(z) + EULER_GAMMA).abs() < 1e-13, "at {z}");
    }
    // ∫S = −γ + z (1 − γ − ln|z|) + …
    for z in [1e-6_f64, -1e-6] {
        let expected = -EULER_GAMMA + z * (1.0 - EULER_GAMMA - z.abs().ln());
        assert!((retarded_log_integral(z) - expected).abs() < 3e-11, "at {z}");
    }
}

/// S′ = S − 1/z (T11), by differences of fourth order.
#[test]
fn derivative_is_the_function_less_the_reciprocal() {
    for z in [0.01, 0.3, 0.99, 1.01, 3.0, 20.0, 300.0, -0.01, -0.37, -1.0, -7.0, -49.9, -50.1, -300.0_f64] {
        let h = 1e-3 * z.abs().min(1.0);
        let s = |i: f64| retarded_log(z + i * h);
        let difference = (8.0 * (s(1.0) - s(-1.0)) - (s(2.0) - s(-2.0))) / (12.0 * h);
        let exact = retarded_log(z) - 1.0 / z;
        assert!(
            (difference - exact).abs() < 1e-9 * (1.0 + exact.abs()) / h.min(1.0) * 1e-3 + 1e-8 * exact.abs(),
            "{z}"
        );
    }
}

/// Composite Simpson's rule.
fn simpson(a: f64, b: f64, g: impl Fn(f64) -> f64) -> f64 {
    let cells = 4000;
    let h = (b - a) / f64::from(cells);
    let inner: f64 = (1..cells).map(|i| g(a + f64::from(i) * h) * if i % 2 == 1 { 4.0 } else { 2.0 }).sum();
    h / 3.0 * (g(a) + g(b) + inner)
}

/// ∫S dz = S + ln|z| and ∫∫S dz dz = S + ln|z| + z ln|z| − z (T11), by quadrature.
#[test]
fn integrals_are_those_of_the_function() {
    for (a, b) in [(0.2, 3.0), (0.9, 1.2), (5.0, 80.0), (-3.0, -0.2), (-60.0, -40.0), (-1.5, -0.5_f64)] {
        let once = retarded_log_integral(b) - retarded_log_integral(a);
        let quadrature = simpson(a, b, retarded_log);
        assert!((once - quadrature).abs() < 1e-9, "[{a}, {b}]: {once} is not {quadrature}");
        let second = |z: f64| retarded_log_integral(z) + z * z.abs().ln() - z;
        let twice = second(b) - second(a);
        let quadrature = simpson(a, b, retarded_log_integral);
        assert!((twice - quadrature).abs() < 1e-8, "[{a}, {b}]: {twice} is not {quadrature}");
    }
}

/// S = ∫₀^∞ e^{−ξ}(ln(z + ξ) − ln z)… for z > 0: the mean of the logarithm ahead, weighted with the fading of the creep
/// (T8).
#[test]
fn kernel_is_the_retarded_logarithm() {
    for z in [0.5, 2.0, 10.0_f64] {
        let mean = simpson(0.0, 60.0, |t| (-t).exp() * (z + t).ln());
        assert!((mean - z.ln() - retarded_log(z)).abs() < 1e-8, "z = {z}");
    }
}

#[test]
fn large_arguments_fall_as_the_reciprocal() {
    for z in [1e4_f64, 1e9, 1e15, 1e100] {
        for z in [z, -z] {
            let two_terms = (1.0 - 1.0 / z) / z;
            assert!((retarded_log(z) / two_terms - 1.0).abs() <= 3.0 / (z * z) + 1e-15, "z = {z}");
        }
    }
}
