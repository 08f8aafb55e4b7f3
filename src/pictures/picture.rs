//! A picture: a chart and the numbers behind it.

use super::table::Table;
use stribeck_charts::{Curve, FigureError, Lines, Map, Relief, Section, Stroke, WorkPrecision};

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
    Relief(Relief),
    /// Stress below the surface.
    Section(Section),
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

impl Chart {
    /// The bytes of a file.
    ///
    /// # Errors
    /// [`FigureError`] if the chart cannot be drawn.
    pub fn paint(&self, format: Format) -> Result<Vec<u8>, FigureError> {
        match (self, format) {
            (Chart::Lines(chart), Format::Svg) => chart.svg().map(String::into_bytes),
            (Chart::Lines(chart), Format::Png) => chart.png(),
            (Chart::Map(chart), Format::Svg) => chart.svg().map(String::into_bytes),
            (Chart::Map(chart), Format::Png) => chart.png(),
            (Chart::Relief(chart), Format::Svg) => chart.svg().map(String::into_bytes),
            (Chart::Relief(chart), Format::Png) => chart.png(),
            (Chart::Section(chart), Format::Svg) => chart.svg().map(String::into_bytes),
            (Chart::Section(chart), Format::Png) => chart.png(),
            (Chart::WorkPrecision(chart), Format::Svg) => chart.svg().map(String::into_bytes),
            (Chart::WorkPrecision(chart), Format::Png) => chart.png(),
        }
    }
}
