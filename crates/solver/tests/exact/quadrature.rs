//! Quadrature of the tests, apart from the one of the library.

use stribeck_solver::exact::DryContact;

/// ∫ p(x) g(x) dx over a dry contact: the trapezoidal rule in η = ln tan(θ/2), which gathers points at both edges and
/// converges exponentially.
pub fn over_dry_contact(contact: &DryContact, g: impl Fn(f64) -> f64) -> f64 {
    let k_most = 1e8_f64;
    let (start, end, step) = (-0.5 * k_most.ln() - 9.0, 9.0, 0.02);
    let count = ((end - start) / step) as u32;
    let width = 2.0 * contact.half_width();
    // Ascending x is descending η.
    let shares = (0..=count).rev().map(|i| {
        let squared = (2.0 * (start + f64::from(i) * step)).exp();
        (squared / (1.0 + squared), 1.0 / (1.0 + squared))
    });
    let shares: Vec<(f64, f64)> = shares.collect();
    let x: Vec<f64> = shares.iter().map(|(lead, _)| contact.leading_edge() - width * lead).collect();
    let p = contact.pressure_on(&x);
    let terms = x.iter().zip(&p).zip(&shares);
    terms.map(|((&x, &p), (lead, trail))| p * g(x) * 2.0 * width * lead * trail * step).sum()
}
