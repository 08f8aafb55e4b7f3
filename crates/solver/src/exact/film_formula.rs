//! A formula for the film thickness c: a fit of its own, neither a limit nor a solution.

use std::f64::consts::{PI, SQRT_2};

use super::bessel_ratio::i2_over_i1;
use super::dry::DryContact;
use super::root::bracketed_root;
use crate::model::Parameters;

/// c β^{3/5} of the elastic film for β → ∞.
const ASYMPTOTE: f64 = 0.44583;
/// Of the elastic film at any β, (T35).
const ELASTIC: [f64; 4] = [8.99, 32.27, 2.35, 7.088];
/// Of an inlet that is short beside the contact, (T38).
const INLET: [f64; 5] = [0.5546, 1.163, 1.661, 2.153, 1.015];
/// Of the way from there to an inlet that is long, (T39).
const BLEND: [f64; 4] = [0.03872, 1.032, 1.478, 2.3];

/// c from a formula for one retardation time, (T34) to (T39) of `docs/explanation/theory.md`; `None` for several.
///
/// The film is made in the inlet. What matters of the contact is the slope S of the dry gap ahead of its leading edge,
/// u′ ≈ S√d, and the dry pressure P√d behind it. A film fills a length ℓ there, with β P S² ℓ^{5/2} = 1, and c is S
/// ℓ^{3/2} times a number; P is (1 + f)S at places that are passed before the stress relaxes, and less further away. S
/// and both ends of P are exact, from [`DryContact`]; thirteen coefficients describe the elastic film and the ways in
/// between. They are fitted to collocation solutions with a tolerance of 1e-7, by `scripts/fit_film.py` to
/// `sweeps/film.toml`.
///
/// | over | largest error | rms |
/// | --- | --- | --- |
/// | elastic, every β | 0.2 % | 0.1 % |
/// | any α, f up to 10⁴, β from 10 to 10⁸ (the range that was fitted) | 2 % | 0.4 % |
/// | any α, f up to 10⁶, β from 10⁻⁴ to 10¹⁰ | 5.1 % near α = 1 for β from 0.1 to 1, 2 % elsewhere | 0.4 % |
///
/// on cases that were not fitted (`cargo run --release -p stribeck-solver --example film_formula`); 1.95 % is at
/// α = 0.231, f = 200, β = 10, 5.06 % at α = 0.548, f = 100, β = 1. Two limits are
/// exact at any α and f: 1/(πβ) for β → 0, and for β → ∞ the power −3/5 with its factor, but for the five digits of
/// 0.44583. For α → 0 (instantaneous modulus) and α → ∞ (relaxed) it becomes the formula of the elastic film, with the
/// errors of the first row.
///
/// # Panics
/// If β is not a positive finite number, α or f negative or not a number, or f infinite.
pub fn fitted_c(parameters: &Parameters) -> Option<f64> {
    let &[mode] = parameters.substrate.modes() else { return None };
    let Parameters { beta, f, .. } = *parameters;
    assert!(beta > 0.0 && beta.is_finite(), "beta must be a positive number, not {beta}");
    let alpha = parameters.alpha / mode.time;
    let contact = DryContact::new(alpha, f);
    // an elastic contact answers with the modulus that makes its width
    if contact.elastic {
        let compliance = contact.half_width() * contact.half_width();
        return Some(compliance * elastic_c(compliance * beta));
    }
    let inlet = Inlet::new(&contact, alpha, f);
    // (T36); ℓ lies between its values for the largest and the least P
    let balance =
        |ln_length: f64| 2.5 * ln_length + (beta * inlet.slope.powi(3) * inlet.stiffness(ln_length.exp())).ln();
    let least = -0.4 * (beta * inlet.slope.powi(3) * (1.0 + f)).ln();
    if !least.is_finite() {
        return None;
    }
    let length = bracketed_root(balance, least, least + 0.4 * f.ln_1p()).exp();
    // (T34) with the elastic film whose inlet has the same part of the contact's width
    let effective_beta = (length / contact.half_width()).powf(-2.5) / (2.0 * SQRT_2);
    let finite = elastic_c(effective_beta) * effective_beta.powf(0.6);
    Some(2_f64.powf(0.4) * inlet.slope * length.powf(1.5) * finite)
}

/// c of the elastic film with the relaxed modulus (T35), from 1/(πβ) to 0.44583 β^{−3/5}.
fn elastic_c(beta: f64) -> f64 {
    let [linear, factor, power, sharpness] = ELASTIC;
    let thin = (ASYMPTOTE * PI * beta.powf(0.4)).powf(sharpness);
    (1.0 + linear * beta + factor * beta.powf(power) + thin).powf(sharpness.recip()) / (PI * beta)
}

/// What the film knows of a dry contact.
struct Inlet {
    alpha: f64,
    f: f64,
    /// k = (1+f)αā.
    k: f64,
    /// S, the gap's slope over the root of the distance from the leading edge (T37).
    slope: f64,
    /// X for an inlet much longer than the contact (T39).
    thick: f64,
}

impl Inlet {
    fn new(contact: &DryContact, alpha: f64, f: f64) -> Self {
        let (half_width, k) = (contact.half_width(), contact.k);
        let strength = 1.0 + contact.gamma2() * (2.0 + k + k * i2_over_i1(k));
        // P/S − 1, from 0 to f, where PSā = 2 as in every elastic contact
        let excess = ((1.0 + f) / (half_width * strength)).powi(2) - 1.0;
        Self {
            alpha,
            f,
            k,
            slope: (2.0 * half_width).sqrt() * strength / (1.0 + f),
            thick: if excess > 0.0 { ((f - excess) / excess).max(0.0) } else { f64::INFINITY },
        }
    }

    /// P/S = 1 + f/(1 + X) at a distance from the leading edge; from 1 + f to 1.
    fn stiffness(&self, length: f64) -> f64 {
        1.0 + self.f / (1.0 + self.softening(length))
    }

    /// X (T38, T39).
    fn softening(&self, length: f64) -> f64 {
        let [level, onset, sharpness, rate, power] = INLET;
        let creep = self.alpha * length;
        let lag = level + (1.0 - level) / (1.0 + (onset * creep).powf(sharpness));
        let relaxation = (rate * (1.0 + self.f) * creep).powf(power);
        let near = ((relaxation.ln_1p() / power).exp() / lag - 1.0).max(0.0);
        if near == 0.0 || self.thick == 0.0 {
            return 0.0;
        }
        let ratio = near / self.thick;
        let nearness = BLEND[0] + BLEND[1] * self.k / (BLEND[2] + self.k) + BLEND[3] * near / (near + self.thick);
        near * (1.0 + ratio.powf(nearness)).powf(-nearness.recip())
    }
}
