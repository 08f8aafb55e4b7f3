//! What defines a case: α, β, f and the retardation modes of the substrate.

use std::ops::RangeInclusive;
use std::sync::Arc;

/// One retardation time of the substrate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RetardationMode {
    /// Part of f that belongs to this mode; the shares of a substrate add up to 1.
    pub share: f64,
    /// Retardation time of this mode, over the time τ that defines α.
    pub time: f64,
}

/// The retardation spectrum of the contact: at least one mode, shares adding up to 1.
///
/// Each mode belongs to the flat or to the roller. Pressure and film do not know which: compliances add (T59). It
/// decides on which body hysteresis works.
#[derive(Clone, Debug, PartialEq)]
pub struct Substrate {
    modes: Arc<[RetardationMode]>,
    /// How many of the modes, the last ones, are the roller's.
    of_roller: usize,
}

/// Why a list of retardation modes is not a substrate.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SubstrateError {
    /// No mode at all.
    #[error("a substrate needs at least one retardation mode")]
    Empty,
    /// A share that is not a positive number.
    #[error("mode {mode}: the share must be a number above 0 and at most 1, not {share}")]
    Share {
        /// Place in the list, from 1.
        mode: usize,
        /// The share found.
        share: f64,
    },
    /// A time that is not a positive number.
    #[error("mode {mode}: the time must be a finite number above 0, not {time}")]
    Time {
        /// Place in the list, from 1.
        mode: usize,
        /// The time found.
        time: f64,
    },
    /// Shares that do not add up to 1 within 1e-9.
    #[error("the shares of the modes must add up to 1, not {sum}")]
    Sum {
        /// Their sum.
        sum: f64,
    },
}

impl Substrate {
    /// A flat of the given modes under a rigid or elastic roller.
    ///
    /// # Errors
    /// [`SubstrateError`] if the list is empty, a share or time is not positive, or the shares do not add up to 1.
    pub fn new(modes: Vec<RetardationMode>) -> Result<Self, SubstrateError> {
        Self::of_two_bodies(modes, Vec::new())
    }

    /// The modes of the flat and those of the roller, one of which may have none.
    ///
    /// # Errors
    /// As [`Substrate::new`]; modes are counted through both lists.
    pub fn of_two_bodies(flat: Vec<RetardationMode>, roller: Vec<RetardationMode>) -> Result<Self, SubstrateError> {
        let of_roller = roller.len();
        let modes = [flat, roller].concat();
        if modes.is_empty() {
            return Err(SubstrateError::Empty);
        }
        for (i, &RetardationMode { share, time }) in modes.iter().enumerate() {
            if !(share > 0.0 && share <= 1.0) {
                return Err(SubstrateError::Share { mode: i + 1, share });
            }
            if !(time > 0.0 && time.is_finite()) {
                return Err(SubstrateError::Time { mode: i + 1, time });
            }
        }
        let sum: f64 = modes.iter().map(|mode| mode.share).sum();
        if (sum - 1.0).abs() > 1e-9 {
            return Err(SubstrateError::Sum { sum });
        }
        Ok(Self { modes: modes.into(), of_roller })
    }

    /// The modes, the flat's before the roller's.
    pub fn modes(&self) -> &[RetardationMode] {
        &self.modes
    }

    /// How many of the modes, the last ones, are the roller's.
    pub fn of_roller(&self) -> usize {
        self.of_roller
    }
}

impl Default for Substrate {
    /// One retardation time, the one in α.
    fn default() -> Self {
        Self { modes: Arc::new([RetardationMode { share: 1.0, time: 1.0 }]), of_roller: 0 }
    }
}

/// The dimensionless parameters of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// α = a₀/(Vτ), slide time over retardation time (Eq. 13); 0 and +∞ are the two elastic limits.
    pub alpha: f64,
    /// β = E∞* a₀⁴/(12 η V R³), inverse Hersey number (Eq. 14); positive.
    pub beta: f64,
    /// f = E₀/E∞ − 1, strength of retardation; 0 for an elastic substrate.
    pub f: f64,
    /// The retardation spectrum.
    pub substrate: Substrate,
}

/// A parameter that is outside of the range that double precision can be used with.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OutOfRange {
    /// α of a retardation mode.
    #[error(
        "alpha of a mode = {0:e} is beyond what double precision can be used with: \
         it must be 0, inf, or between {least:e} and {most:e}",
        least = Parameters::MAGNITUDES.start(),
        most = Parameters::MAGNITUDES.end()
    )]
    Alpha(f64),
    /// β.
    #[error(
        "beta = {0:e} is beyond what double precision can be used with: it must be between {least:e} and {most:e}",
        least = Parameters::MAGNITUDES.start(),
        most = Parameters::MAGNITUDES.end()
    )]
    Beta(f64),
    /// f.
    #[error(
        "f = {0:e} is beyond what double precision can be used with: it must be between 0 and {most:e}",
        most = Parameters::MAGNITUDES.end()
    )]
    Strength(f64),
}

/// A mode as the equations use it: strength f_j and rate α_j of (T8), (T9).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Retardation {
    /// f_j, the mode's part of f.
    pub strength: f64,
    /// α_j = a₀/(Vτ_j).
    pub rate: f64,
}

impl Parameters {
    /// A case with one retardation time.
    pub fn new(alpha: f64, beta: f64, f: f64) -> Self {
        Self { alpha, beta, f, substrate: Substrate::default() }
    }

    /// The relaxed elastic (EHL) case at the given β: f = 0, so α means nothing and is set to +∞.
    pub fn elastic(beta: f64) -> Self {
        Self::new(f64::INFINITY, beta, 0.0)
    }

    /// The case of two bodies that move at speeds of their own (T59).
    ///
    /// The modes of each body are parts of f, with times over the one in α: the speed of a body is in its times. A time
    /// of 0 is that of a body at rest in the contact, whose modes are relaxed. They belong to the elastic part, which
    /// leaves the strength f′ = f s/(1 + f (1 − s)) to the modes that move, s being their part of f.
    ///
    /// # Errors
    /// As [`Substrate::of_two_bodies`], of the modes that are left.
    pub fn of_two_bodies(
        [alpha, beta, f]: [f64; 3],
        flat: &[RetardationMode],
        roller: &[RetardationMode],
    ) -> Result<Self, SubstrateError> {
        let moving = |modes: &[RetardationMode]| modes.iter().copied().filter(|mode| mode.time > 0.0).collect();
        let [flat_moves, roller_moves]: [Vec<RetardationMode>; 2] = [moving(flat), moving(roller)];
        if flat_moves.len() + roller_moves.len() == flat.len() + roller.len() {
            return Ok(Self { alpha, beta, f, substrate: Substrate::of_two_bodies(flat_moves, roller_moves)? });
        }
        let part: f64 = flat_moves.iter().chain(&roller_moves).map(|mode| mode.share).sum();
        if part == 0.0 {
            return Ok(Self::elastic(beta));
        }
        let of_rest = |modes: Vec<RetardationMode>| {
            modes.into_iter().map(|mode| RetardationMode { share: mode.share / part, ..mode }).collect()
        };
        let substrate = Substrate::of_two_bodies(of_rest(flat_moves), of_rest(roller_moves))?;
        Ok(Self { alpha, beta, f: f * part / (1.0 + f * (1.0 - part)), substrate })
    }

    /// True where the substrate responds as the relaxed elastic one: f = 0 or α = ∞. Such cases depend on β alone.
    pub fn is_relaxed_elastic(&self) -> bool {
        self.f == 0.0 || self.alpha == f64::INFINITY
    }

    /// The retardation modes that the displacement (T9) needs; none in the elastic limits (f = 0, α = ∞, α = 0).
    pub fn retardation(&self) -> Vec<Retardation> {
        if self.is_relaxed_elastic() || self.alpha == 0.0 {
            return Vec::new();
        }
        let modes = self.substrate.modes().iter();
        modes.map(|mode| Retardation { strength: mode.share * self.f, rate: self.alpha / mode.time }).collect()
    }

    /// The range of α, β and 1 + f in which products of parameters, lengths and films stay within double precision. It
    /// has no physical meaning: solvers give up long before.
    pub const MAGNITUDES: RangeInclusive<f64> = 1e-50..=1e50;

    /// Checks that α, β and f lie in the range that double precision can represent: β and the α of each mode within
    /// [`MAGNITUDES`](Self::MAGNITUDES) (or α = 0 or ∞), f between 0 and its end.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first number that does not.
    pub fn computable(&self) -> Result<(), OutOfRange> {
        if !Self::MAGNITUDES.contains(&self.beta) {
            return Err(OutOfRange::Beta(self.beta));
        }
        if !(0.0..=*Self::MAGNITUDES.end()).contains(&self.f) {
            return Err(OutOfRange::Strength(self.f));
        }
        let limit = self.alpha == 0.0 || self.alpha == f64::INFINITY;
        let mut rates = self.substrate.modes().iter().map(|mode| self.alpha / mode.time);
        let outside = rates.find(|rate| !limit && !Self::MAGNITUDES.contains(rate));
        outside.map_or(Ok(()), |rate| Err(OutOfRange::Alpha(rate)))
    }

    /// Compliance at once over relaxed compliance, E∞/E₀ = 1/(1 + f).
    pub fn instantaneous_compliance(&self) -> f64 {
        1.0 / (1.0 + self.f)
    }
}
