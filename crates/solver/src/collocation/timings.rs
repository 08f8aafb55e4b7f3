//! The seconds that each kind of work takes.

use std::time::Instant;

/// Seconds spent on each kind of work.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timings {
    /// The elastic displacement of new meshes.
    pub kernel: f64,
    /// The retardation filter on them.
    pub filter: f64,
    /// Residuals and matrices.
    pub assembly: f64,
    /// LU factorisations.
    pub factorisation: f64,
    /// Solutions with the factors, and steps.
    pub step: f64,
    /// Derivatives of friction, where they are asked for.
    pub sensitivities: f64,
}

impl Timings {
    /// The sums of two timings.
    pub fn and(self, other: Self) -> Self {
        Self {
            kernel: self.kernel + other.kernel,
            filter: self.filter + other.filter,
            assembly: self.assembly + other.assembly,
            factorisation: self.factorisation + other.factorisation,
            step: self.step + other.step,
            sensitivities: self.sensitivities + other.sensitivities,
        }
    }

    /// The sum of all seconds.
    pub fn total(&self) -> f64 {
        self.kernel + self.filter + self.assembly + self.factorisation + self.step + self.sensitivities
    }
}

/// Does some work and adds the seconds that it took to a sum.
pub fn timed<T>(seconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *seconds += start.elapsed().as_secs_f64();
    result
}
