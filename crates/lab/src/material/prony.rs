//! Prony series as they are passed on: terms as moduli or as fractions, beside one of two moduli.

use super::modulus_kind::ModulusKind;
use super::relaxation::{MaterialError, Relaxation, RelaxationTerm};
use crate::Modulus;

/// What the terms of a series are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PronyParts {
    /// Moduli E_i, in Pa.
    Moduli,
    /// Fractions g_i = E_i/E₀ of the instantaneous modulus.
    Fractions,
}

/// The terms of a relaxation modulus, and what is known of the modulus beside them.
#[derive(Clone, Debug, PartialEq)]
pub struct PronySeries {
    /// What the terms are.
    pub parts: PronyParts,
    /// (E_i or g_i, τ_i in s) of each term; none of them is zero.
    pub terms: Vec<(f64, f64)>,
    /// E∞ or E₀, in Pa; fractions may do without.
    pub modulus: Option<Modulus>,
    /// What the moduli are of.
    pub kind: ModulusKind,
}

impl PronySeries {
    /// The most terms of a series.
    pub const MOST_TERMS: usize = 1000;

    /// The material. Where no modulus is known the instantaneous one is 1: f and the times are the same whatever it is.
    ///
    /// # Errors
    /// [`PronyError`] if there are too many terms, moduli stand without E∞ or E₀, the terms leave nothing for E∞, or
    /// [`Relaxation::new`] refuses them.
    pub fn relaxation(&self) -> Result<Relaxation, PronyError> {
        if self.terms.len() > Self::MOST_TERMS {
            return Err(PronyError::TooMany { terms: self.terms.len() });
        }
        let sum: f64 = self.terms.iter().map(|(part, _)| part).sum();
        let (relaxed, unit) = match (self.modulus, self.parts) {
            (None, PronyParts::Fractions) => (1.0 - sum, 1.0),
            (None, PronyParts::Moduli) => return Err(PronyError::NoModulus),
            (Some(Modulus::Relaxed(modulus)), PronyParts::Moduli) => (modulus, 1.0),
            (Some(Modulus::Relaxed(modulus)), PronyParts::Fractions) => (modulus, modulus / (1.0 - sum)),
            (Some(Modulus::Instantaneous(modulus)), PronyParts::Moduli) => (modulus - sum, 1.0),
            (Some(Modulus::Instantaneous(modulus)), PronyParts::Fractions) => (modulus * (1.0 - sum), modulus),
        };
        match self.parts {
            PronyParts::Fractions if sum.is_nan() || sum >= 1.0 => return Err(PronyError::NoFractionLeft { sum }),
            PronyParts::Moduli if sum.is_nan() || relaxed <= 0.0 => {
                return Err(PronyError::NoModulusLeft { sum, instantaneous: sum + relaxed });
            }
            _ => {}
        }
        let terms = self.terms.iter().map(|(part, time)| RelaxationTerm { modulus: part * unit, time: *time });
        Ok(Relaxation::new(relaxed, terms.collect())?)
    }

    /// The terms as a list of TOML, one in a line, below a comment if there is one.
    pub fn toml_terms(&self, comment: Option<&str>) -> String {
        let name = match self.parts {
            PronyParts::Moduli => "modulus",
            PronyParts::Fractions => "fraction",
        };
        let comment = comment.map(|comment| format!("    # {comment}\n")).unwrap_or_default();
        let term = |(part, time): &(f64, f64)| format!("    {{ {name} = {part:?}, time = {time:?} }},\n");
        format!("[\n{comment}{}]", self.terms.iter().map(term).collect::<String>())
    }

    /// The modulus as a key of TOML with its value; `None` where it is not known.
    pub fn toml_modulus(&self) -> Option<String> {
        let shear = match self.kind {
            ModulusKind::Young => "",
            ModulusKind::Shear => "shear_",
        };
        self.modulus.map(|modulus| match modulus {
            Modulus::Relaxed(value) => format!("relaxed_{shear}modulus = {value:?}"),
            Modulus::Instantaneous(value) => format!("instantaneous_{shear}modulus = {value:?}"),
        })
    }
}

/// Why a series is no material.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PronyError {
    /// Too many terms.
    #[error(
        "a series may have at most {} terms, not {terms}: one or two for each decade of time describe any material",
        PronySeries::MOST_TERMS
    )]
    TooMany {
        /// How many there are.
        terms: usize,
    },
    /// Moduli without E∞ or E₀.
    #[error("terms that are moduli need a modulus beside them, relaxed or instantaneous")]
    NoModulus,
    /// Fractions that add up to 1 or more.
    #[error(
        "the fractions add up to {sum:.4}, and what is left of 1 is the relaxed modulus: nothing. Fractions in per cent \
         are a hundred times too large; fractions whose sum is 1 are a liquid, which carries no load at rest, or are \
         rounded so that their sum is"
    )]
    NoFractionLeft {
        /// Their sum.
        sum: f64,
    },
    /// Terms as large as the instantaneous modulus.
    #[error(
        "the terms add up to {sum:.4e} Pa of an instantaneous modulus of {instantaneous:.4e} Pa and leave no relaxed \
         modulus: a liquid, which carries no load at rest; or one of the two has another unit"
    )]
    NoModulusLeft {
        /// The sum of the terms, in Pa.
        sum: f64,
        /// E₀, in Pa.
        instantaneous: f64,
    },
    /// A modulus or a time is no such thing.
    #[error(transparent)]
    Material(#[from] MaterialError),
}
