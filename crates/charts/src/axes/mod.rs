//! Axes: where a value lies on them, which values are labelled, and how a number is written.

pub(crate) mod cell_axis;
pub(crate) mod colour_scale;
pub(crate) mod log_axis;
pub(crate) mod number;
pub(crate) mod place;
pub(crate) mod scaled_axis;
pub(crate) mod ticks;

use ticks::Ticks;

/// An axis along one side of a plot.
pub(crate) trait Axis {
    /// The place of a value, from 0 at the lower end to 1 at the upper end.
    fn share(&self, value: f64) -> f64;

    /// The ticks of an axis of `length` pixels. Their labels (of font size `em`) lie along the axis or, `upright`,
    /// across it.
    fn ticks(&self, length: f64, em: f64, upright: bool) -> Ticks;
}
