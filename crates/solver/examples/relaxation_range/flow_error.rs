//! How well a grid resolves the film.

use stribeck_solver::Fields;

/// Largest |β p′u³ + u − c|/u at mid-points of the grid between points under pressure (T2).
pub fn flow_error(fields: &Fields, x: &[f64], beta: f64, c: f64) -> f64 {
    let (Some(p), Some(u)) = (&fields.pressure, &fields.film_thickness) else { return f64::NAN };
    let pressed = (1..x.len()).filter(|&i| p[i - 1] > 0.0);
    let error = pressed.map(|i| {
        let film = 0.5 * (u[i - 1] + u[i]);
        (beta * (p[i] - p[i - 1]) / (x[i] - x[i - 1]) * film.powi(3) + film - c).abs() / film
    });
    error.fold(0.0, f64::max)
}
