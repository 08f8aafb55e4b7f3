//! The parabola through three neighbouring values.

/// Place of the parabola's extremum in steps from the middle value, at most half a step: continuous where the extreme
/// value passes from one point to the next.
pub fn vertex(values: &[f64]) -> f64 {
    let curvature = values[0] - 2.0 * values[1] + values[2];
    let t = 0.5 * (values[0] - values[2]) / curvature;
    if t.is_finite() { t.clamp(-0.5, 0.5) } else { 0.0 }
}

/// Value of the parabola `t` steps from the middle value.
pub fn parabola(values: &[f64], t: f64) -> f64 {
    values[1] + 0.5 * t * (values[2] - values[0]) + 0.5 * t * t * (values[0] - 2.0 * values[1] + values[2])
}
