//! What is wrong with a file or a point.

use std::io;

/// A file that is no surface.
#[derive(Debug, thiserror::Error)]
pub enum SurfaceError {
    /// The file cannot be read.
    #[error("cannot read the surface: {0}; is it the right path?")]
    Unreadable(io::Error),
    /// The text is no JSON of this form.
    #[error("not a surface: {0}; `stribeck surface` makes the file")]
    NotASurface(#[from] serde_json::Error),
    /// A format of another version.
    #[error("the format is `{found}`, and this reader knows `{known}`; take a version of stribeck that fits")]
    Format {
        /// What the file says.
        found: String,
        /// What is known.
        known: &'static str,
    },
    /// Parts that do not fit together.
    #[error("{quantity}: {what}; the file is damaged, make it again with `stribeck surface`")]
    Damaged {
        /// The quantity concerned, or `axes`.
        quantity: String,
        /// What does not fit.
        what: String,
    },
    /// A check point that does not have the value that stands in the file.
    #[error(
        "{quantity} at check point {number} is {found:e}, and the file says {expected:e}; the file is damaged, make it \
         again with `stribeck surface`"
    )]
    CheckPoint {
        /// The quantity.
        quantity: String,
        /// Which check point, from 1.
        number: usize,
        /// What came out.
        found: f64,
        /// What the file says.
        expected: f64,
    },
}

/// A point outside the domain of a surface.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Outside {
    /// A value beyond an axis.
    #[error("{axis} = {value} is outside the surface, which has {axis} from {from} to {to}")]
    Axis {
        /// The axis.
        axis: String,
        /// The value.
        value: f64,
        /// The least value of the axis.
        from: f64,
        /// The largest one.
        to: f64,
    },
    /// A point with too few or too many coordinates.
    #[error("a point of this surface has {expected} coordinates ({names}), and {found} were given")]
    Coordinates {
        /// How many there must be.
        expected: usize,
        /// How many were given.
        found: usize,
        /// Names of the axes.
        names: String,
    },
}
