//! Settings of the collocation solver.

use std::ops::RangeInclusive;

use crate::model::SettingOutOfRange;

/// Settings of the collocation solver that change its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Relative error wanted in μ_v, μ_h and c; of μ_v relative to μ_tot/1000 where it is below that.
    pub tolerance: f64,
    /// Degree of the pressure on a panel.
    pub degree: usize,
}

impl Settings {
    /// Settings for a tolerance: panels of degree 8 or, below 1e-8, of degree 12, which need fewer unknowns there.
    pub fn for_tolerance(tolerance: f64) -> Self {
        let degree = if tolerance < 1e-8 { 12 } else { 8 };
        Self { tolerance, degree }
    }

    /// Checks that both are in their ranges.
    ///
    /// # Errors
    /// [`SettingOutOfRange`] names the one that is not.
    pub fn check(&self) -> Result<(), SettingOutOfRange> {
        SettingOutOfRange::check("collocation", "tolerance", self.tolerance, &Self::TOLERANCE)?;
        SettingOutOfRange::check("collocation", "degree", self.degree, &Self::DEGREE)
    }

    /// Numbers of panels of the film that a mesh may have.
    pub const PANELS: RangeInclusive<usize> = 4..=160;
    /// Tolerances that the method can keep where films are not too thin for double precision.
    pub const TOLERANCE: RangeInclusive<f64> = 1e-10..=1e-1;
    /// Degrees that make sense.
    pub const DEGREE: RangeInclusive<usize> = 4..=16;
}

impl Default for Settings {
    fn default() -> Self {
        Self::for_tolerance(1e-5)
    }
}
