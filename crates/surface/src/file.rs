//! The file of a surface, `surface.json`, as it is written and read. docs/reference/surface-file.md has every key.

use serde::{Deserialize, Serialize};

use crate::map::Axis;

/// What the key `format` says.
pub const FORMAT: &str = "stribeck surface 1";

/// A surface as it stands in its file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SurfaceFile {
    /// [`FORMAT`].
    pub format: String,
    /// Title of the sweep.
    pub title: String,
    /// The program that made it, with its version.
    pub program: String,
    /// Version of the solver's results.
    pub results_version: u32,
    /// The relative error that was asked for.
    pub tolerance: f64,
    /// One to three axes, in the order of the coordinates of a point.
    pub axes: Vec<Axis>,
    /// What a point has, in the order of the values.
    pub quantities: Vec<QuantityRecord>,
    /// How far the surface was measured to be from solutions.
    pub certificate: Certificate,
    /// Points with their values, for readers to compare theirs with.
    pub checks: Vec<CheckPoint>,
    /// The text of the sweep file.
    pub sweep: String,
}

/// A quantity: a Chebyshev series of a function y of it, in Tucker form.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct QuantityRecord {
    /// Its name, as in `summary.csv`.
    pub name: String,
    /// Its unit; `1` for pure numbers.
    pub units: String,
    /// What a dimensionless number is over, as in `a0/R`; none for SI units.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub scale: Option<String>,
    /// What it is, in words.
    pub long_name: String,
    /// How the quantity follows from y.
    #[serde(flatten)]
    pub transform: Transform,
    /// Numbers of Chebyshev polynomials, and ranks, along each axis.
    pub shape: Vec<[usize; 2]>,
    /// What the numbers below are.
    pub numbers: NumberKind,
    /// For each axis the factor: polynomials by ranks, the last index fastest, in base64.
    pub factors: Vec<String>,
    /// The core: ranks of all axes, the last index fastest, in base64.
    pub core: String,
}

/// How a quantity follows from its series y.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "transform", rename_all = "snake_case")]
pub enum Transform {
    /// y.
    Identity,
    /// e^y: a quantity that is positive.
    Exp,
    /// share · (the quantity `of`) · sinh y: a part that may vanish or change its sign beside a whole.
    Sinh {
        /// The whole: a quantity before this one.
        of: String,
        /// Where parts begin to count: below this share of the whole errors are relative to it.
        share: f64,
    },
    /// share · (the quantity `of`) · (r² − offset), r = e^(y/2) − 1 + √offset: a part that vanishes in limits.
    Root {
        /// As for `sinh`.
        of: String,
        /// As for `sinh`.
        share: f64,
        /// Above 0, and small.
        offset: f64,
    },
}

/// Floating-point numbers, little-endian.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum NumberKind {
    /// Of single precision.
    Float32,
    /// Of double precision.
    Float64,
}

/// How far the surface was from solutions at random points that it was not made from: measured, not proved.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Number of points.
    pub points: usize,
    /// Seed of the points.
    pub seed: u64,
    /// Tolerance at which they were solved.
    pub solver_tolerance: f64,
    /// Cases that the surface was made from.
    pub cases: usize,
    /// The errors, in the order of the quantities.
    pub errors: Vec<ErrorRecord>,
}

/// Measured errors of a quantity, relative to the quantity; those of a part below its share of the whole to that share.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorRecord {
    /// The largest.
    pub largest: f64,
    /// What 99 % of the points do not exceed.
    pub percentile_99: f64,
    /// The median.
    pub median: f64,
}

/// A point with its values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CheckPoint {
    /// A value of each axis.
    pub point: Vec<f64>,
    /// A value of each quantity.
    pub values: Vec<f64>,
}
