//! The kernel of the surface displacement for given parameters (T10).

use super::Parameters;
use super::kernel::{cell_average_log, cell_average_retarded_log, retarded_log, retarded_log_integral};

/// K(x) = ln|x| + Σ_j (f_j/(1+f)) S(α_j x), with which w(x) = (1/π) ∫ p(s) K(x − s) ds (Eq. 15, T10).
///
/// At α = 0 the substrate is elastic with the instantaneous modulus, K(x) = ln|x|/(1+f): the limit of (T10) but for the
/// constant, which h₀ absorbs.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplacementKernel {
    log_weight: f64,
    /// (f_j/(1+f), α_j)
    retarded: Vec<(f64, f64)>,
    /// How many of the modes, the last ones, are the roller's.
    of_roller: usize,
    /// A constant taken off K.
    level: f64,
}

impl DisplacementKernel {
    /// The kernel of a case; it does not depend on β.
    pub fn new(parameters: &Parameters) -> Self {
        let compliance = parameters.instantaneous_compliance();
        let frozen = parameters.alpha == 0.0 && !parameters.is_relaxed_elastic();
        let retarded = parameters.retardation();
        Self {
            log_weight: if frozen { compliance } else { 1.0 },
            of_roller: parameters.substrate.of_roller().min(retarded.len()),
            retarded: retarded.iter().map(|mode| (mode.strength * compliance, mode.rate)).collect(),
            level: 0.0,
        }
    }

    /// The part of the kernel that the roller's modes retard, Σ_j (f_1j/(1+f)) I(α_1j, x): all of its displacement that
    /// does work where it is not alone. `None` unless both bodies retard.
    pub fn roller_beside_flat(&self) -> Option<Self> {
        let of_flat = self.retarded.len() - self.of_roller;
        let retarded = self.retarded[of_flat..].to_vec();
        let log_weight = retarded.iter().map(|(weight, _)| weight).sum();
        let both = of_flat > 0 && self.of_roller > 0;
        both.then_some(Self { log_weight, retarded, of_roller: self.of_roller, level: 0.0 })
    }

    /// The kernel K − level with the level such that its mean at ±`length` is zero.
    ///
    /// A constant in K moves the whole surface in proportion to the load, and h₀ absorbs it (T3). At small α it is
    /// large, about ln(1/α): an iteration that holds h₀ would answer any change of load with a film of another
    /// thickness.
    pub fn levelled(self, length: f64) -> Self {
        let mean =
            |&(weight, rate): &(f64, f64)| 0.5 * weight * (retarded_mode(rate, length) + retarded_mode(rate, -length));
        let level = self.singular_weight() * length.ln() + self.retarded.iter().map(mean).sum::<f64>();
        Self { level, ..self }
    }

    /// The constant taken off K.
    pub fn level(&self) -> f64 {
        self.level
    }

    /// Mean of K over a cell of the given width centred at x; exact (T11), finite also around x = 0.
    pub fn cell_average(&self, x: f64, width: f64) -> f64 {
        let retarded = self.retarded.iter();
        self.log_weight * cell_average_log(x, width) - self.level
            + retarded.map(|&(weight, rate)| weight * cell_average_retarded_log(rate * x, rate * width)).sum::<f64>()
    }

    /// The weight of ln|x| in K where x → 0: the instantaneous compliance over the relaxed one. What is left of K is
    /// bounded.
    pub fn singular_weight(&self) -> f64 {
        self.log_weight - self.retarded.iter().map(|(weight, _)| weight).sum::<f64>()
    }

    /// The retarded modes, (f_j/(1+f), α_j) each, with K(x) = `singular_weight` ln|x| + Σ_j (f_j/(1+f)) I(α_j, x) −
    /// level and the bounded I of `retarded_mode`.
    pub fn retarded(&self) -> &[(f64, f64)] {
        &self.retarded
    }

    /// How many of the retarded modes, the last ones, are the roller's.
    pub fn of_roller(&self) -> usize {
        self.of_roller
    }
}

/// I(α, x) = S(αx) + ln|x|, bounded at x = 0; its derivative is α S(αx) (T11).
pub fn retarded_mode(rate: f64, x: f64) -> f64 {
    retarded_log_integral(rate * x) - rate.ln()
}

/// α ∂I/∂α of [`retarded_mode`], z S(z) − 1 with z = αx ≠ 0 (T11).
pub fn retarded_mode_derivative(rate: f64, x: f64) -> f64 {
    rate * x * retarded_log(rate * x) - 1.0
}
