//! How strongly the displacement answers a change of pressure: what limits a relaxation factor.

use super::Grid;
use crate::model::Parameters;

/// Length of the automatic domain in half widths of the dry contact: two behind it, three ahead, two of its own.
pub const HALF_WIDTHS: f64 = 7.0;

/// M ≥ 1, the modulus of the substrate at wavenumber q ≈ 1/ā over the relaxed one: |(1+f)/(1 + Σ f_j α_j/(α_j − iq))|,
/// by the Fourier transform of (T8), (T9). The length of the contact is the worst case: shorter waves find it stiffer.
pub fn stiffness(parameters: &Parameters, grid: Grid) -> f64 {
    if parameters.alpha == 0.0 {
        return 1.0 + parameters.f;
    }
    let q = HALF_WIDTHS / (grid.x_max - grid.x_min);
    let (mut real, mut imaginary) = (1.0, 0.0);
    let retardation = parameters.retardation();
    for mode in &retardation {
        let size = mode.strength / (1.0 + (q / mode.rate).powi(2));
        real += size;
        imaginary += size * q / mode.rate;
    }
    let strength: f64 = retardation.iter().map(|mode| mode.strength).sum();
    (1.0 + strength) / f64::hypot(real, imaginary)
}

/// Δx²/(2βu³M), by which a pass with λ = 1 that ignores the answer of the displacement turns an error of the pressure:
/// far above 1 where the film u is too thin for the grid.
pub fn thin_film_number(dx: f64, beta: f64, film: f64, stiffness: f64) -> f64 {
    dx * dx / (2.0 * beta * film.powi(3) * stiffness)
}
