//! Where the unknowns may be.

use super::{FrictionFitError, Unknown};

/// The farthest that an unknown may move from its start, in its logarithm: a factor of a million.
const FARTHEST: f64 = 13.8;
/// How near to a bound an unknown counts as being at it, over half of the distance between both, in the logarithm.
const AT_BOUND: f64 = 1e-3;

/// The least and the largest value of an unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The unknown.
    pub unknown: Unknown,
    /// Its least value; 0 is none, as unknowns are positive.
    pub least: Option<f64>,
    /// Its largest value.
    pub most: Option<f64>,
}

/// How a parameter of the search, 0 at the start, becomes ln(θ/θ₀).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Path {
    /// It is the logarithm.
    Free,
    /// The logarithm is c + h sin(p/h + p₀), between c − h and c + h.
    Between { centre: f64, half: f64, origin: f64 },
}

impl Path {
    /// The path of an unknown that begins at `start`.
    ///
    /// # Errors
    /// [`FrictionFitError::Task`] if it begins outside of its bounds.
    pub(super) fn new(unknown: Unknown, start: f64, bounds: &[Bounds]) -> Result<Self, FrictionFitError> {
        let Some(bounds) = bounds.iter().find(|bounds| bounds.unknown == unknown) else { return Ok(Self::Free) };
        let logarithm = |bound: f64| (bound / start).ln();
        let least = bounds.least.filter(|least| *least > 0.0).map_or(-FARTHEST, logarithm);
        let most = bounds.most.map_or(FARTHEST, logarithm);
        if !(least < 0.0 && 0.0 < most) {
            let what =
                format!("{} begins at {start:e}, which is not between its bounds; begin between them", unknown.name());
            return Err(FrictionFitError::Task { what });
        }
        let (centre, half) = (0.5 * (least + most), 0.5 * (most - least));
        Ok(Self::Between { centre, half, origin: (-centre / half).asin() })
    }

    /// ln(θ/θ₀), and how it changes with the parameter; `None` where it is too far.
    pub(super) fn at(self, parameter: f64) -> Option<(f64, f64)> {
        match self {
            Self::Free => (parameter.abs() <= FARTHEST).then_some((parameter, 1.0)),
            Self::Between { centre, half, origin } => {
                let angle = parameter / half + origin;
                Some((centre + half * angle.sin(), angle.cos()))
            }
        }
    }

    /// True if ln(θ/θ₀) is at a bound.
    pub(super) fn is_at_end(self, logarithm: f64) -> bool {
        match self {
            Self::Free => false,
            Self::Between { centre, half, .. } => (logarithm - centre).abs() > (1.0 - AT_BOUND) * half,
        }
    }
}
