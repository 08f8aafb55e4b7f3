//! A quantity as height over two axes: what the chart is given.

mod axes_box;
mod curve;
mod layout;
mod mesh;
mod projection;

use crate::ChartError;
use crate::chart::Drawing;
use crate::checks;
use crate::paint::scene::Scene;
use crate::paper::Paper;

/// A quantity as height over two logarithmic axes: a surface in space, in one panel or several side by side. Seen from
/// a fixed angle, from the side of large x and small y, a little to the right of the y-axis's direction: a ridge along
/// y shows both its flanks.
///
/// Each quadrilateral between four neighbours is drawn, in the colour of its mean height; the mesh is thinned to some
/// lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface3d {
    /// Heading.
    pub title: String,
    /// Second line of the heading; may be empty.
    pub subtitle: String,
    /// Name of the axis to the right: "α".
    pub x_label: String,
    /// Name of the axis to the back: "β".
    pub y_label: String,
    /// Name of the height.
    pub z_label: String,
    /// Values of the axis to the right: at least two, increasing, finite, above zero.
    pub x: Vec<f64>,
    /// Values of the axis to the back, likewise.
    pub y: Vec<f64>,
    /// Equal ratios, not equal differences, are equal differences of height. Zeros then have no place, as if they were
    /// no values.
    pub logarithmic: bool,
    /// Ends of the heights and of the colours, low < high (> 0 if logarithmic). From the values if none; then from
    /// zero, if they are not far above it and not logarithmic. Heights beyond lie flat at the end, and the colour bar
    /// ends in a point there.
    pub range: Option<(f64, f64)>,
    /// One to three surfaces with the same axes.
    pub panels: Vec<Surface3dPanel>,
}

/// One surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface3dPanel {
    /// Heading of the panel; may be empty.
    pub label: String,
    /// `y.len() * x.len()` heights, x running fastest. None leaves a hole. None is below zero if the axis is
    /// logarithmic.
    pub heights: Vec<Option<f64>>,
    /// Lines in space beside the surface.
    pub curves: Vec<Surface3dCurve>,
}

/// A line in space: a known limit at the edge of the surface, for instance. It is hidden where the surface lies before
/// it.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface3dCurve {
    /// Name in the legend. Curves of one name have one colour in all panels.
    pub label: String,
    /// What is joined: x and y inside the axes, and the height.
    pub points: Vec<(f64, f64, f64)>,
}

/// Most panels side by side.
const MOST_PANELS: usize = 3;

impl Drawing for Surface3d {
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError> {
        self.check()?;
        Ok(layout::draw(self, paper, stretch))
    }

    fn side_by_side(&self) -> usize {
        self.panels.len()
    }
}

impl Surface3d {
    /// Every height with a place in the chart, those of curves included.
    pub(crate) fn shown(&self) -> impl Iterator<Item = f64> {
        let surfaces = self.panels.iter().flat_map(|panel| panel.heights.iter().flatten().copied());
        let curves = self.panels.iter().flat_map(|panel| &panel.curves);
        surfaces.chain(curves.flat_map(|curve| curve.points.iter().map(|point| point.2))).filter(|z| self.has_place(*z))
    }

    /// False for what is left out of a logarithmic axis.
    pub(crate) fn has_place(&self, height: f64) -> bool {
        !self.logarithmic || height > 0.0
    }

    fn check(&self) -> Result<(), ChartError> {
        let chart = &self.title;
        checks::axis(chart, &self.x_label, &self.x, true)?;
        checks::axis(chart, &self.y_label, &self.y, true)?;
        checks::range(chart, &self.z_label, self.range, self.logarithmic)?;
        if self.panels.is_empty() {
            return Err(ChartError::Empty { chart: chart.clone(), what: "panel" });
        }
        if self.panels.len() > MOST_PANELS {
            checks::count(chart, "panels, where at most three have room side by side", self.panels.len(), MOST_PANELS)?;
        }
        for (i, panel) in self.panels.iter().enumerate() {
            let cells = self.x.len() * self.y.len();
            checks::count(chart, format!("heights in panel {}", i + 1), panel.heights.len(), cells)?;
            for (k, height) in panel.heights.iter().enumerate() {
                let Some(height) = height else { continue };
                let (x, y) = (self.x[k % self.x.len()], self.y[k / self.x.len()]);
                self.check_height(
                    *height,
                    format!("{} = {x}, {} = {y}, \"{}\"", self.x_label, self.y_label, panel.label),
                )?;
            }
            for curve in &panel.curves {
                for (x, y, z) in &curve.points {
                    self.check_place(*x, &self.x, &curve.label)?;
                    self.check_place(*y, &self.y, &curve.label)?;
                    self.check_height(*z, format!("the curve \"{}\"", curve.label))?;
                }
            }
        }
        if self.shown().next().is_none() {
            return Err(ChartError::Empty { chart: chart.clone(), what: "height with a place on its axis" });
        }
        Ok(())
    }

    fn check_height(&self, value: f64, place: String) -> Result<(), ChartError> {
        let wanted = if !value.is_finite() {
            "heights are finite; a place without one is None"
        } else if self.logarithmic && value < 0.0 {
            "nothing is below zero on a logarithmic axis"
        } else {
            return Ok(());
        };
        Err(ChartError::Value { chart: self.title.clone(), what: "a height", value, place, wanted })
    }

    fn check_place(&self, value: f64, axis: &[f64], curve: &str) -> Result<(), ChartError> {
        if (axis[0]..=axis[axis.len() - 1]).contains(&value) {
            return Ok(());
        }
        Err(ChartError::Value {
            chart: self.title.clone(),
            what: "a place",
            value,
            place: format!("the curve \"{curve}\""),
            wanted: "curves lie between the first and the last value of both axes",
        })
    }
}
