//! The modulus of a body that is given, of the two that describe it.

/// Which of the two moduli of a substrate is given, in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Modulus {
    /// E∞.
    Relaxed(f64),
    /// E₀ = (1 + f) E∞.
    Instantaneous(f64),
}

impl Modulus {
    /// E∞ of a body with this f.
    pub fn relaxed(self, f: f64) -> f64 {
        match self {
            Self::Relaxed(modulus) => modulus,
            Self::Instantaneous(modulus) => modulus / (1.0 + f),
        }
    }

    /// E₀ of a body with this f.
    pub fn instantaneous(self, f: f64) -> f64 {
        match self {
            Self::Relaxed(modulus) => modulus * (1.0 + f),
            Self::Instantaneous(modulus) => modulus,
        }
    }

    /// d ln/d ln f of 1/E∞ and of 1/E₀.
    pub(super) fn compliances_with_strength(self, f: f64) -> [f64; 2] {
        match self {
            Self::Relaxed(_) => [0.0, -f / (1.0 + f)],
            Self::Instantaneous(_) => [f / (1.0 + f), 0.0],
        }
    }

    /// The same one, larger by a factor.
    pub fn times(self, factor: f64) -> Self {
        match self {
            Self::Relaxed(value) => Self::Relaxed(value * factor),
            Self::Instantaneous(value) => Self::Instantaneous(value * factor),
        }
    }
}
