//! Why there is no picture.

use stribeck_charts::ChartError;
use stribeck_input::printable;
use stribeck_sweep::store::StoreError;

/// What was asked for is not in the data set, or cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The data set cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The chart cannot be drawn.
    #[error(transparent)]
    Chart(#[from] ChartError),
    /// A column or field that does not exist.
    #[error("--of {}: there is no such column or field here; give some of {allowed}", printable(name))]
    Unknown {
        /// What was asked for.
        name: String,
        /// What there is.
        allowed: String,
    },
    /// A value that lies outside its axis.
    #[error("{option}: the sweep has {axis} {there}; give a value in this range, the nearest one is taken")]
    Outside {
        /// The option with the value.
        option: String,
        /// The axis.
        axis: String,
        /// What there is.
        there: String,
    },
    /// An axis that the data set has not.
    #[error("{}: this data set has the axes {there}; name one of them", printable(option))]
    NoAxis {
        /// The option with the name.
        option: String,
        /// What there is.
        there: String,
    },
    /// A kind of picture that the data set has nothing for.
    #[error("--what {kind}: {why}")]
    Missing {
        /// The kind asked for.
        kind: &'static str,
        /// What is missing, and what to do.
        why: String,
    },
}
