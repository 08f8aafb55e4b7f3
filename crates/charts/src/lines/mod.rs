//! Curves in a plane: what the chart is given.

mod layout;

use crate::ChartError;
use crate::chart::Drawing;
use crate::checks;
use crate::paint::scene::Scene;
use crate::paper::Paper;

/// Curves of one quantity over another.
///
/// On a logarithmic horizontal axis 0 and ∞ have places of their own, set off at its ends; points there are marked and
/// not joined to the others. Cases that failed are × along the lower edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// Heading.
    pub title: String,
    /// Second line of the heading; may be empty.
    pub subtitle: String,
    /// Horizontal axis.
    pub x: LineAxis,
    /// Vertical axis.
    pub y: LineAxis,
    /// The curves, in the order of painting and of the legend.
    pub curves: Vec<Curve>,
}

/// An axis of a chart of curves.
#[derive(Clone, Debug, PartialEq)]
pub struct LineAxis {
    /// Name with unit: "film thickness u R/a₀²".
    pub label: String,
    /// Equal ratios, not equal differences, are equal lengths.
    pub logarithmic: bool,
    /// Ends, low < high (> 0 if logarithmic); curves are cut there. From the values if none.
    pub range: Option<(f64, f64)>,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Name in the legend; none there if empty. A curve without points is a line of the legend alone.
    pub label: String,
    /// What is joined, in this order. A y that is NaN, or has no place on a logarithmic axis, leaves a gap.
    pub points: Vec<(f64, f64)>,
    /// Where cases failed, on the horizontal axis. What has no place there is left out.
    pub failed: Vec<f64>,
    /// How it is drawn.
    pub stroke: Stroke,
    /// In which colour.
    pub colour: Colour,
    /// Number of the form of markers, which show some of the points, or all if there are few; none without markers. Ten
    /// forms differ.
    pub mark: Option<usize>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A firm line.
    Solid,
    /// – – –, for what is known beside a solution.
    Dashed,
    /// · · ·, for a third kind.
    Dotted,
    /// Markers alone, for what was measured.
    Points,
    /// A firm line above a shade that reaches down to the band before it, or to zero: one of several parts of a sum.
    /// The points of all bands of a chart have the same places across.
    Band,
}

/// The colour of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colour {
    /// One of several things without an order.
    Kind(usize),
    /// One of a family with an order, from 0 to 1.
    Family(f64),
    /// Black.
    Black,
    /// Grey, for what stands behind the others.
    Faint,
}

impl Drawing for Lines {
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError> {
        self.check()?;
        Ok(layout::draw(self, paper, stretch))
    }
}

impl Lines {
    /// The points with a place in the chart, 0 and ∞ on a logarithmic horizontal axis included.
    pub(crate) fn shown(&self) -> impl Iterator<Item = (f64, f64)> {
        self.curves.iter().flat_map(|curve| &curve.points).copied().filter(|point| self.has_place(*point))
    }

    /// Where cases failed, as far as that has a place on the horizontal axis.
    pub(crate) fn failed(&self) -> impl Iterator<Item = f64> {
        self.curves.iter().flat_map(|curve| &curve.failed).copied().filter(|x| self.has_place_across(*x))
    }

    /// True if a point can be shown, as far as the kinds of the axes say.
    pub(crate) fn has_place(&self, (x, y): (f64, f64)) -> bool {
        self.has_place_across(x) && y.is_finite() && (y > 0.0 || !self.y.logarithmic)
    }

    fn has_place_across(&self, x: f64) -> bool {
        if self.x.logarithmic { x >= 0.0 } else { x.is_finite() }
    }

    fn check(&self) -> Result<(), ChartError> {
        for axis in [&self.x, &self.y] {
            checks::range(&self.title, &axis.label, axis.range, axis.logarithmic)?;
        }
        if self.shown().chain(self.failed().map(|x| (x, 0.0))).next().is_none() {
            return Err(ChartError::Empty { chart: self.title.clone(), what: "point with a place on its axes" });
        }
        Ok(())
    }
}
