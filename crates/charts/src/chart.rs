//! What all charts can do: be painted.

use crate::ChartError;
use crate::paint;
use crate::paint::scene::Scene;

/// A chart that can be painted in both formats. The same chart has the same bytes.
pub trait Chart: Drawing {
    /// The chart as SVG, [`WIDTH`](crate::WIDTH) wide.
    ///
    /// # Errors
    ///
    /// [`ChartError`] if the chart has nothing to show, if lengths do not fit, or if a value has no place on its axis.
    fn svg(&self) -> Result<String, ChartError> {
        paint::svg(&self.scene()?)
    }

    /// The chart as PNG, [`WIDTH`](crate::WIDTH) pixels wide.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn png(&self) -> Result<Vec<u8>, ChartError> {
        paint::png(&self.scene()?)
    }
}

impl<T: Drawing> Chart for T {}

/// The private half of a chart: it is checked and laid out.
pub trait Drawing {
    /// The shapes of the chart.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn scene(&self) -> Result<Scene, ChartError>;
}
