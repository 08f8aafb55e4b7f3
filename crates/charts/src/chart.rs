//! What all charts can do: be painted.

use crate::paint::scene::Scene;
use crate::paint::{pdf, png, svg};
use crate::{ChartError, Paper};

/// A chart that can be painted in each format. The same chart on the same paper has the same bytes.
pub trait Chart: Drawing {
    /// The chart as SVG.
    ///
    /// # Errors
    ///
    /// [`ChartError`] if the chart has nothing to show, if lengths do not fit, if a value has no place on its axis, or
    /// if letters do not fit the paper.
    fn svg(&self, paper: &Paper) -> Result<String, ChartError> {
        paper.check(self.side_by_side())?;
        Ok(svg::svg(&self.scene(paper)?, paper))
    }

    /// The chart as PNG.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn png(&self, paper: &Paper) -> Result<Vec<u8>, ChartError> {
        paper.check(self.side_by_side())?;
        png::png(&self.scene(paper)?, paper)
    }

    /// The chart as a page of PDF, with its letters as text.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn pdf(&self, paper: &Paper) -> Result<Vec<u8>, ChartError> {
        paper.check(self.side_by_side())?;
        Ok(pdf::pdf(&self.scene(paper)?, paper))
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
    fn scene(&self, paper: &Paper) -> Result<Scene, ChartError>;

    /// How many panels stand side by side.
    fn side_by_side(&self) -> usize {
        1
    }
}
