//! The three axes of a sweep.

use crate::store::DataSet;

/// An axis of a sweep, in the order of the data set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Axis {
    /// Strength of retardation.
    F,
    /// Slide time over retardation time.
    Alpha,
    /// Inverse Hersey number.
    Beta,
}

impl Axis {
    /// All, in the order of the dimensions.
    pub const ALL: [Self; 3] = [Self::F, Self::Alpha, Self::Beta];

    /// Its dimension.
    pub fn dimension(self) -> usize {
        self as usize
    }

    /// Name in files and options.
    pub fn name(self) -> &'static str {
        ["f", "alpha", "beta"][self as usize]
    }

    /// Symbol in pictures.
    pub fn symbol(self) -> &'static str {
        ["f", "α", "β"][self as usize]
    }

    /// Symbol and definition, beside an axis of a picture.
    pub fn label(self) -> &'static str {
        ["f = E₀/E∞ − 1", "α = a₀/(Vτ)", "β = E∞* a₀⁴/(12ηVR³)"][self as usize]
    }

    /// Its values in a data set.
    pub fn values(self, data: &DataSet) -> &[f64] {
        match self {
            Axis::F => &data.f,
            Axis::Alpha => &data.alpha,
            Axis::Beta => &data.beta,
        }
    }

    /// The two others.
    pub fn others(self) -> [Self; 2] {
        match self {
            Axis::F => [Axis::Alpha, Axis::Beta],
            Axis::Alpha => [Axis::F, Axis::Beta],
            Axis::Beta => [Axis::F, Axis::Alpha],
        }
    }
}
