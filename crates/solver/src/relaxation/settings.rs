//! Settings of the relaxation solver.

use std::fmt;
use std::ops::RangeInclusive;

use crate::model::{SettingOutOfRange, shortest};

/// Where the uniform grid lies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Domain {
    /// On the dry contact of each case: from x_trail − 2ā to x_lead + 3ā.
    #[default]
    Auto,
    /// The same [x_min, x_max] for every case.
    Fixed {
        /// Left end, behind the outlet.
        x_min: f64,
        /// Right end, ahead of the inlet.
        x_max: f64,
    },
}

impl Domain {
    /// How far a fixed domain may reach to either side, in units of a₀; the contact lies within ±1.
    pub const ENDS: RangeInclusive<f64> = -100.0..=100.0;
}

impl fmt::Display for Domain {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Domain::Auto => formatter.write_str("auto"),
            Domain::Fixed { x_min, x_max } => write!(formatter, "[{}, {}]", shortest(*x_min), shortest(*x_max)),
        }
    }
}

/// How the iteration is accelerated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Acceleration {
    /// Anderson acceleration of the map (p, h₀) → (p, h₀), with the plain iteration to fall back on.
    #[default]
    Anderson,
    /// The paper's plain iteration.
    None,
}

impl fmt::Display for Acceleration {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Acceleration::Anderson => "anderson",
            Acceleration::None => "none",
        })
    }
}

/// Settings of the relaxation solver that change its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Settings {
    /// Where the grid lies.
    pub domain: Domain,
    /// Grid points; odd, so that the grid of half as many intervals exists.
    pub points: usize,
    /// Residuals of the Reynolds equation and the load at which a case is converged.
    pub tolerance: f64,
    /// Acceleration of the iteration.
    pub acceleration: Acceleration,
    /// Whether Richardson's error estimate from the grid of half as many intervals is wanted. It is the error of the
    /// grid and no bound: what the ends of the domain leave, most of it in F_v at small α, is the same on both grids.
    pub estimate: bool,
}

impl Settings {
    /// Numbers of grid points from the fewest that resolve a film to the most that a computer can handle.
    pub const POINTS: RangeInclusive<usize> = 51..=20_001;
    /// Fewest grid points with which errors can be estimated: the second grid has half as many intervals, and below 101
    /// points it is of no use.
    pub const ESTIMATE_POINTS: usize = 201;
    /// Tolerances that double precision can meet and that are small enough to be of use.
    pub const TOLERANCE: RangeInclusive<f64> = 1e-12..=1e-2;

    /// Checks that all are in their ranges, and that the number of points is odd.
    ///
    /// # Errors
    /// [`SettingOutOfRange`] names the first one that is not.
    pub fn check(&self) -> Result<(), SettingOutOfRange> {
        const METHOD: &str = "relaxation";
        SettingOutOfRange::check(METHOD, "tolerance", self.tolerance, &Self::TOLERANCE)?;
        let least = if self.estimate { Self::ESTIMATE_POINTS } else { *Self::POINTS.start() };
        SettingOutOfRange::check(METHOD, "points", self.points, &(least..=*Self::POINTS.end()))?;
        if self.points.is_multiple_of(2) {
            let (value, allowed) = (self.points.to_string(), "odd".to_owned());
            return Err(SettingOutOfRange { method: METHOD, setting: "points", value, allowed });
        }
        match self.domain {
            Domain::Auto => Ok(()),
            Domain::Fixed { x_min, x_max } => {
                SettingOutOfRange::check(METHOD, "x_min", x_min, &(*Domain::ENDS.start()..=-f64::MIN_POSITIVE))?;
                SettingOutOfRange::check(METHOD, "x_max", x_max, &(f64::MIN_POSITIVE..=*Domain::ENDS.end()))
            }
        }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            domain: Domain::Auto,
            points: 801,
            tolerance: 1e-8,
            acceleration: Acceleration::Anderson,
            estimate: false,
        }
    }
}
