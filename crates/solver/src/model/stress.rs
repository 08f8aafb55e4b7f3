//! Stress below the surface.

use std::f64::consts::PI;

/// σ_yy at depth `depth` ≥ 0 below the point `at` of the surface, over 2N/(πa₀):
///
/// ```text
/// σ_yy = −(2/π) ∫ p(s) y³/((x − s)² + y²)² ds
/// ```
///
/// It does not depend on the material. The pressure, given at the ascending `x`, is taken to be linear between them and
/// zero outside; its integrals are exact, so that depths far below the distance of the points are no harder than
/// others.
///
/// # Panics
/// If `x` and `pressure` differ in length.
pub fn normal_stress(x: &[f64], pressure: &[f64], at: f64, depth: f64) -> f64 {
    assert_eq!(x.len(), pressure.len(), "a pressure for each x");
    let mut sum = 0.0;
    for (s, p) in x.windows(2).zip(pressure.windows(2)) {
        if p[0] == 0.0 && p[1] == 0.0 {
            continue;
        }
        let (from, to) = (s[0] - at, s[1] - at);
        let slope = (p[1] - p[0]) / (to - from);
        let level = p[0] - slope * from;
        sum +=
            level * (constant(to, depth) - constant(from, depth)) + slope * (linear(to, depth) - linear(from, depth));
    }
    -2.0 / PI * sum
}

/// ∫ y³/(t² + y²)² dt = ½ [y t/(t² + y²) + atan(t/y)].
fn constant(t: f64, y: f64) -> f64 {
    if y == 0.0 {
        // The integrand becomes π/2 times a delta function.
        return if t == 0.0 { 0.0 } else { 0.25 * PI * t.signum() };
    }
    0.5 * (y * t / (t * t + y * y) + (t / y).atan())
}

/// ∫ y³ t/(t² + y²)² dt = −½ y³/(t² + y²).
fn linear(t: f64, y: f64) -> f64 {
    if y == 0.0 { 0.0 } else { -0.5 * y * y * y / (t * t + y * y) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hertz() -> (Vec<f64>, Vec<f64>) {
        let x: Vec<f64> = (0..=4000).map(|i| -(PI * f64::from(i) / 4000.0).cos()).collect();
        let pressure = x.iter().map(|x| (1.0 - x * x).max(0.0).sqrt()).collect();
        (x, pressure)
    }

    /// σ_yy = −1/√(1 + y²) on the axis of a Hertzian contact (Johnson, Contact Mechanics, Eq. 4.46).
    #[test]
    fn below_a_hertzian_contact_it_is_the_closed_form() {
        let (x, pressure) = hertz();
        for depth in [1e-4, 0.1, 0.5, 1.0, 3.0] {
            let exact = -1.0 / (1.0_f64 + depth * depth).sqrt();
            assert!((normal_stress(&x, &pressure, 0.0, depth) - exact).abs() < 1e-6, "{depth}");
        }
    }

    #[test]
    fn at_the_surface_it_is_the_pressure() {
        let (x, pressure) = hertz();
        for place in [100, 1000, 2500, 3999] {
            assert!((normal_stress(&x, &pressure, x[place], 0.0) + pressure[place]).abs() < 1e-12);
        }
        assert_eq!(normal_stress(&x, &pressure, 1.5, 0.0), 0.0);
    }

    /// Every plane below carries the load: ∫ σ_yy dx = −∫ p dx.
    #[test]
    fn every_depth_carries_the_load() {
        let (x, pressure) = hertz();
        for depth in [0.3, 1.0] {
            let step = 0.01;
            let sum: f64 = (-5000..=5000).map(|i| normal_stress(&x, &pressure, step * f64::from(i), depth)).sum();
            assert!((step * sum + 0.5 * PI).abs() < 1e-5);
        }
    }
}
