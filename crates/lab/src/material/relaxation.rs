//! A material by its relaxation: what a step of strain leaves of the stress, and how it answers to oscillation.

use super::measurement::Measurement;
use stribeck_solver::Parameters;

/// One relaxation term (a Maxwell element).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelaxationTerm {
    /// E_i, in Pa.
    pub modulus: f64,
    /// τ_i, in s.
    pub time: f64,
}

/// E(t) = E∞ + Σ_i E_i e^{−t/τ_i} (T47), a generalized Maxwell solid ("Prony series").
///
/// All moduli may be those of another kind (shear, plane strain) if all are: with Poisson's ratio constant, f and the
/// times are the same.
#[derive(Clone, Debug, PartialEq)]
pub struct Relaxation {
    pub(super) relaxed_modulus: f64,
    pub(super) terms: Vec<RelaxationTerm>,
}

impl Relaxation {
    /// The material with relaxed modulus E∞, in Pa, and these terms, in any order.
    ///
    /// # Errors
    /// [`MaterialError`] if there is no term, or a modulus or time is not a number from 1e-50 to 1e50.
    pub fn new(relaxed_modulus: f64, terms: Vec<RelaxationTerm>) -> Result<Self, MaterialError> {
        let allowed = |value: f64| Parameters::MAGNITUDES.contains(&value);
        if terms.is_empty() {
            return Err(MaterialError::Empty);
        }
        if !allowed(relaxed_modulus) {
            return Err(MaterialError::RelaxedModulus { value: relaxed_modulus });
        }
        for (i, &RelaxationTerm { modulus, time }) in terms.iter().enumerate() {
            if !allowed(modulus) {
                return Err(MaterialError::Modulus { term: i + 1, value: modulus });
            }
            if !allowed(time) {
                return Err(MaterialError::Time { term: i + 1, value: time });
            }
        }
        Ok(Self { relaxed_modulus, terms })
    }

    /// E∞, in Pa.
    pub fn relaxed_modulus(&self) -> f64 {
        self.relaxed_modulus
    }

    /// The terms, in the order they were given in.
    pub fn terms(&self) -> &[RelaxationTerm] {
        &self.terms
    }

    /// E₀ = E∞ + Σ E_i, in Pa.
    pub fn instantaneous_modulus(&self) -> f64 {
        self.relaxed_modulus + self.terms.iter().map(|term| term.modulus).sum::<f64>()
    }

    /// (E′, E″) in Pa at the angular frequency ω in rad/s (T47).
    pub fn storage_and_loss(&self, omega: f64) -> (f64, f64) {
        let start = (self.relaxed_modulus, 0.0);
        self.terms.iter().fold(start, |(storage, loss), term| {
            let (stored, lost) = term.response(omega);
            (storage + term.modulus * stored, loss + term.modulus * lost)
        })
    }

    /// E(t) in Pa at the time t in s after a step of strain (T47).
    pub fn modulus(&self, time: f64) -> f64 {
        self.terms.iter().fold(self.relaxed_modulus, |modulus, term| modulus + term.modulus * (-time / term.time).exp())
    }

    /// What this material would have shown in place of a measurement.
    pub fn answer(&self, measurement: &Measurement) -> Measurement {
        match *measurement {
            Measurement::Oscillation { omega, .. } => {
                let (storage, loss) = self.storage_and_loss(omega);
                Measurement::Oscillation { omega, storage, loss }
            }
            Measurement::Relaxation { time, .. } => Measurement::Relaxation { time, modulus: self.modulus(time) },
        }
    }

    /// |E*_this − E*|/|E*| of a measurement, or |E_this(t) − E(t)|/E(t).
    pub(super) fn residual(&self, measurement: &Measurement) -> f64 {
        Measurement::distance(self.answer(measurement).moduli(), measurement.moduli())
    }
}

impl RelaxationTerm {
    /// Storage and loss modulus over E_i: x²/(1 + x²) and x/(1 + x²) with x = ωτ_i, written so that no x² overflows.
    pub(super) fn response(&self, omega: f64) -> (f64, f64) {
        let x = omega * self.time;
        (x / (x + 1.0 / x), 1.0 / (x + 1.0 / x))
    }

    /// The part of E_i in what is measured: storage and loss, or e^{−t/τ_i} and zero.
    pub(super) fn response_at(&self, measurement: &Measurement) -> [f64; 2] {
        match *measurement {
            Measurement::Oscillation { omega, .. } => self.response(omega).into(),
            Measurement::Relaxation { time, .. } => [(-time / self.time).exp(), 0.0],
        }
    }
}

/// The reason why a list of relaxation terms is not a material.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// There is no term.
    #[error("a viscoelastic material needs at least one relaxation term; without any it is elastic, f = 0")]
    Empty,
    /// The relaxed modulus is not a positive number.
    #[error(
        "the relaxed modulus must be a number of pascals {}, not {value}: a material that relaxes to nothing is \
         a liquid, and carries no load at rest",
        allowed()
    )]
    RelaxedModulus {
        /// What was given.
        value: f64,
    },
    /// The modulus of a term is not a positive number.
    #[error("relaxation term {term}: the modulus must be a number of pascals {}, not {value}", allowed())]
    Modulus {
        /// Place in the list, from 1.
        term: usize,
        /// What was given.
        value: f64,
    },
    /// The time of a term is not a positive number.
    #[error("relaxation term {term}: the time must be a number of seconds {}, not {value}", allowed())]
    Time {
        /// Place in the list, from 1.
        term: usize,
        /// What was given.
        value: f64,
    },
}

fn allowed() -> String {
    let magnitudes = Parameters::MAGNITUDES;
    format!("from {:e} to {:e}", magnitudes.start(), magnitudes.end())
}
