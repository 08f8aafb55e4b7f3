//! A picture: a chart and the numbers behind it.

use super::table::Table;
use stribeck_charts::{ChartError, CrossSection, Curve, Lines, MARK, Map, Paper, Stroke, Surface3d, WorkPrecision};

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
    /// A page, for papers.
    Pdf,
}

impl Format {
    /// The extension of files.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Svg => "svg",
            Format::Png => "png",
            Format::Pdf => "pdf",
        }
    }
}

/// True if a file that begins so is a picture of this program.
pub fn is_picture(beginning: &[u8]) -> bool {
    made_with(beginning).is_some()
}

/// The options by which the picture in a file that begins so differs from the one that is drawn without any; `None` if
/// it is no picture of this program.
pub fn made_with(beginning: &[u8]) -> Option<String> {
    // Of versions before 0.2, which kept no options: their width, and the depth and kind of pixels.
    let is_earlier_png = beginning.starts_with(b"\x89PNG\r\n\x1a\n")
        && beginning.get(16..20) == Some(&1600_u32.to_be_bytes()[..])
        && beginning.get(24..26) == Some(&[8, 3][..]);
    let begun = |head: &[u8]| beginning.starts_with(head);
    if begun(b"<svg width=\"1600\" ") {
        return Some(String::new());
    }
    let mark = beginning.windows(MARK.len()).position(|word| word == MARK.as_bytes());
    let known = mark.filter(|_| begun(b"<svg data-made=") || begun(b"\x89PNG\r\n") || begun(b"%PDF-"));
    let note = known.map(|place| {
        let rest = beginning[place + MARK.len()..].iter();
        rest.take_while(|byte| matches!(byte, b'a'..=b'z' | b'-' | b' '))
            .map(|byte| char::from(*byte))
            .collect::<String>()
    });
    note.map(|note| note.trim().to_owned()).or_else(|| is_earlier_png.then(String::new))
}

impl Chart {
    /// The bytes of a file.
    ///
    /// # Errors
    /// [`ChartError`] if the chart cannot be drawn.
    pub fn paint(&self, format: Format, paper: &Paper) -> Result<Vec<u8>, ChartError> {
        let chart: &dyn stribeck_charts::Chart = match self {
            Chart::Lines(chart) => chart,
            Chart::Map(chart) => chart,
            Chart::Surface3d(chart) => chart,
            Chart::CrossSection(chart) => chart,
            Chart::WorkPrecision(chart) => chart,
        };
        match format {
            Format::Svg => chart.svg(paper).map(String::into_bytes),
            Format::Png => chart.png(paper),
            Format::Pdf => chart.pdf(paper),
        }
    }

    /// Gives the chart another title.
    pub fn set_title(&mut self, title: &str) {
        let own = match self {
            Chart::Lines(chart) => &mut chart.title,
            Chart::Map(chart) => &mut chart.title,
            Chart::Surface3d(chart) => &mut chart.title,
            Chart::CrossSection(chart) => &mut chart.title,
            Chart::WorkPrecision(chart) => &mut chart.title,
        };
        title.clone_into(own);
    }
}
