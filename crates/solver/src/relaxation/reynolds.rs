//! Reynolds' equation on the uniform grid (Eqs. 37–38) and its Gauss–Seidel pass (Eq. 42).

use super::stiffness::HALF_WIDTHS;

/// Coefficients A, B, C, D of one row A p_{i−1} + B p_i + C p_{i+1} = D (Eq. 38), for the film thicknesses `u` at
/// i−1, i, i+1.
#[inline]
pub fn row(u: [f64; 3], beta: f64, dx: f64) -> [f64; 4] {
    let [behind, here, ahead] = u;
    let scale = here * here / (dx * dx);
    let slope = 0.75 * (ahead - behind);
    [scale * (here - slope), -2.0 * scale * here, scale * (here + slope), -(ahead - behind) / (2.0 * beta * dx)]
}

/// Derivatives of A p_{i−1} + B p_i + C p_{i+1} − D (Eq. 38) with respect to the film thicknesses at i−1, i, i+1, for
/// the pressures `p` there.
pub fn film_derivatives(p: [f64; 3], u: [f64; 3], beta: f64, dx: f64) -> [f64; 3] {
    let [behind, here, ahead] = u;
    let slope = 0.75 * (ahead - behind);
    let curvature = p[0] - 2.0 * p[1] + p[2];
    let side = (0.75 * here * here * (p[2] - p[0]) / dx + 0.5 / beta) / dx;
    let middle = here * (3.0 * here * curvature + 2.0 * slope * (p[2] - p[0])) / (dx * dx);
    [-side, middle, side]
}

/// How far a pass moves a pressure towards its equation, λ_p of Eq. 42.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relaxation {
    /// The same factor everywhere, as in the paper.
    Uniform(f64),
    /// A factor for each point, between over-relaxation where the film is thick and what is stable where it is thin.
    ///
    /// Where the film is thin the displacement answers a pressure change at once, and a pass that ignores it multiplies
    /// the error by about 1 − iλ/S, S = 2βu³M/Δx²: M is the modulus at the length of the contact over the relaxed one.
    /// λ = ωκS/(ω + κS) keeps λ/S below κ.
    Local {
        /// ω, the factor for a thick film; below 2.
        over_relaxation: f64,
        /// κM, the factor for a thin film times S/M.
        thin_film: f64,
    },
}

/// Space for a pass over n points: each new pressure without the part of its new neighbour, and that part.
#[derive(Clone, Debug)]
pub struct PassSpace {
    target: Vec<f64>,
    weight: Vec<f64>,
}

impl PassSpace {
    /// Space for n points.
    pub fn new(points: usize) -> Self {
        Self { target: vec![0.0; points], weight: vec![0.0; points] }
    }
}

/// One Gauss–Seidel pass over the pressures `p` with the film `u`, projected on p ≥ 0 (Eq. 42): new values to the left,
/// old ones to the right. The first and the last pressure stay. Six arguments: the operands of Eq. 42, and a buffer.
pub fn pass(p: &mut [f64], u: &[f64], beta: f64, dx: f64, relaxation: Relaxation, space: &mut PassSpace) {
    match relaxation {
        Relaxation::Uniform(factor) => prepare(p, u, beta, dx, |b| factor / b, space),
        Relaxation::Local { over_relaxation, thin_film } => {
            // −βb = 2βu³/Δx²
            let (product, thin_film) = (-over_relaxation * thin_film * beta, thin_film * beta);
            prepare(p, u, beta, dx, |b| product / (over_relaxation - thin_film * b), space);
        }
    }
    let mut behind = p[0];
    let last = p.len() - 1;
    let coefficients = space.target[1..last].iter().zip(&space.weight[1..last]);
    for (p, (target, weight)) in p[1..last].iter_mut().zip(coefficients) {
        behind = f64::max(0.0, target - weight * behind);
        *p = behind;
    }
}

/// The part of a pass that does not need the new value to the left: p_i + s (D − B p_i − C p_{i+1}) and s A with s =
/// λ_p/B. Apart from the recurrence, so that the compiler can do several points at once. Six arguments: those of the
/// pass, with the factor as a function that is inlined.
#[inline]
fn prepare(p: &[f64], u: &[f64], beta: f64, dx: f64, step: impl Fn(f64) -> f64, space: &mut PassSpace) {
    let n = p.len();
    let (p, u) = (&p[..n], &u[..n]);
    let (target, weight) = (&mut space.target[..n], &mut space.weight[..n]);
    for i in 1..n - 1 {
        let [a, b, c, d] = row([u[i - 1], u[i], u[i + 1]], beta, dx);
        let step = step(b);
        target[i] = p[i] + step * (d - b * p[i] - c * p[i + 1]);
        weight[i] = step * a;
    }
}

/// Largest error of the flow that the discrete equations leave, as a part of the film thickness.
///
/// A row of Eq. 37 is the difference of the flow β p′u³ + u over one cell, so the sum of the residuals from the outlet
/// on, times βΔx, is the error q of the flow there. Unlike the change of p per pass it does not look small because λ_p
/// is small or the error smooth, and unlike the flow at mid-points it has no floor of the scheme's own.
///
/// It is taken relative to the film, q/u. Where the film is so thick that the pressure which drives q is worth less, q
/// ℓ/(βu³) over c, with the half width ℓ of the contact, it is taken so: far ahead q is no more than the rounding error
/// of p times βu³.
pub fn flow_residual(p: &[f64], u: &[f64], beta: f64, dx: f64, c: f64) -> f64 {
    let half_width = HALF_WIDTHS.recip() * dx * (p.len() - 1) as f64;
    let (mut flow, mut largest) = (0.0, 0.0);
    for i in 1..p.len() - 1 {
        let [behind, here, ahead, right] = row([u[i - 1], u[i], u[i + 1]], beta, dx);
        let residual = beta * dx * (right - behind * p[i - 1] - here * p[i] - ahead * p[i + 1]);
        let film = u[i];
        let worth = f64::min(1.0 / film, half_width / (beta * film.powi(3) * c));
        if p[i] > 0.0 {
            flow += residual;
            largest = larger(largest, flow.abs() * worth);
        } else if residual / here > 0.0 {
            // no pressure, but the next pass would give it one
            largest = larger(largest, residual.abs() * worth);
        }
    }
    largest
}

/// Largest |β p′u³ + u − c|/u at mid-points between points under pressure (T2): the error of conservation.
pub fn conservation_error(p: &[f64], u: &[f64], beta: f64, dx: f64, c: f64) -> f64 {
    let mut largest = 0.0;
    for i in 1..p.len() - 1 {
        if p[i] > 0.0 {
            let film = 0.5 * (u[i] + u[i + 1]);
            let flow = beta * (p[i + 1] - p[i]) / dx * film.powi(3) + film;
            largest = larger(largest, ((flow - c) / film).abs());
        }
    }
    largest
}

/// The larger of two numbers; NaN if either is, so that a comparison with a tolerance fails.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}
