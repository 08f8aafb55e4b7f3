//! A material by its creep, as a case of a sweep needs it.

use stribeck_solver::{RetardationMode, Substrate};

/// Creep compliance C(t) = (1/E₀)[1 + Σ f_j (1 − e^{−t/τ_j})]: a chain of Kelvin elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// E∞, in Pa.
    pub relaxed_modulus: f64,
    /// f = E₀/E∞ − 1.
    pub f: f64,
    /// The mean of the retardation times, each weighted by its share, in s: the τ in α.
    pub retardation_time: f64,
    /// The retardation modes, with times over [`retardation_time`](Self::retardation_time).
    pub substrate: Substrate,
}

impl Material {
    /// E₀ = (1+f)E∞, in Pa.
    pub fn instantaneous_modulus(&self) -> f64 {
        (1.0 + self.f) * self.relaxed_modulus
    }

    /// (f_j, τ_j in s) of each mode.
    pub fn retardation(&self) -> impl Iterator<Item = (f64, f64)> {
        let mode = |mode: &RetardationMode| (mode.share * self.f, mode.time * self.retardation_time);
        self.substrate.modes().iter().map(mode)
    }

    /// (E′, E″) in Pa at the angular frequency ω in rad/s: the reciprocal of the complex compliance (T48).
    pub fn storage_and_loss(&self, omega: f64) -> (f64, f64) {
        let (stored, lost) = self.retardation().fold((1.0, 0.0), |(stored, lost), (strength, time)| {
            let x = omega * time;
            (stored + strength / (1.0 + x * x), lost + strength / (x + 1.0 / x))
        });
        let modulus = self.instantaneous_modulus() / (stored * stored + lost * lost);
        (modulus * stored, modulus * lost)
    }
}
