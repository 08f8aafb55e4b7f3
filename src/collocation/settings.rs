//! Settings of the collocation solver.

use std::ops::RangeInclusive;

/// Settings of the collocation solver that change its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Relative error wanted in μ_v, μ_h and c; of μ_v relative to μ_tot/1000 where it is below that.
    pub tolerance: f64,
    /// Degree of the pressure on a panel.
    pub degree: usize,
}

impl Settings {
    /// Tolerances that the method can keep.
    pub const TOLERANCE: RangeInclusive<f64> = 1e-10..=1e-1;
    /// Degrees that make sense.
    pub const DEGREE: RangeInclusive<usize> = 3..=16;
}

impl Default for Settings {
    fn default() -> Self {
        Self { tolerance: 1e-5, degree: 8 }
    }
}
