//! A picture: a chart and the numbers behind it.

use super::table::Table;
use stribeck_charts::{ChartError, CrossSection, Curve, Lines, Map, Stroke, Surface3d, WIDTH, WorkPrecision};

/// A chart with its name and its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of its files, without extension.
    pub name: String,
    /// What is drawn.
    pub chart: Chart,
    /// The numbers that are drawn.
    pub table: Table,
}

impl Picture {
    /// True if points stand in it that were measured.
    pub fn shows_points(&self) -> bool {
        let is_points = |curve: &Curve| curve.stroke == Stroke::Points;
        matches!(&self.chart, Chart::Lines(lines) if lines.curves.iter().any(is_points))
    }
}

/// Any chart.
#[derive(Clone, Debug, PartialEq)]
pub enum Chart {
    /// Curves.
    Lines(Lines),
    /// A quantity as colour.
    Map(Map),
    /// A quantity as height.
    Surface3d(Surface3d),
    /// Stress below the surface.
    CrossSection(CrossSection),
    /// Error against run time.
    WorkPrecision(WorkPrecision),
}

/// Format of the files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Scalable, for papers and pages.
    #[default]
    Svg,
    /// Pixels.
    Png,
}

impl Format {
    /// The extension of files.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Png => "png",
        }
    }
}

/// True if a file that begins so is a picture of this program.
pub fn is_picture(beginning: &[u8]) -> bool {
    let svg = format!("<svg width=\"{WIDTH}\" ");
    // The header of a PNG: its signature, then the width, and the depth and kind of the pixels behind the height.
    let png = beginning.starts_with(b"\x89PNG\r\n\x1a\n")
        && beginning.get(16..20) == Some(&WIDTH.to_be_bytes()[..])
        && beginning.get(24..26) == Some(&[8, 3][..]);
    png || beginning.starts_with(svg.as_bytes())
}

impl Chart {
    /// The bytes of a file.
    ///
    /// # Errors
    /// [`ChartError`] if the chart cannot be drawn.
    pub fn paint(&self, format: Format) -> Result<Vec<u8>, ChartError> {
        let chart: &dyn stribeck_charts::Chart = match self {
            Chart::Lines(chart) => chart,
            Chart::Map(chart) => chart,
            Chart::Surface3d(chart) => chart,
            Chart::CrossSection(chart) => chart,
            Chart::WorkPrecision(chart) => chart,
        };
        match format {
            Format::Svg => chart.svg().map(String::into_bytes),
            Format::Png => chart.png(),
        }
    }
}
