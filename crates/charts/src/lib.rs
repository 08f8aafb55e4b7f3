//! Charts of scientific data: plain numbers in, SVG, PDF or PNG out, the same bytes for the same numbers.
//!
//! ```
//! use stribeck_charts::{Chart, Colour, Curve, LineAxis, Lines, Paper, Stroke};
//!
//! let points = (1..50).map(f64::from).map(|x| (x, x.sqrt())).collect();
//! let (stroke, colour) = (Stroke::Solid, Colour::Black);
//! let curves = vec![Curve { label: "√x".into(), points, failed: vec![], stroke, colour, mark: None }];
//! let axis = |label: &str| LineAxis { label: label.into(), logarithmic: true, range: None };
//! let (title, subtitle) = ("A root".into(), String::new());
//! let chart = Lines { title, subtitle, x: axis("x"), y: axis("y"), curves };
//! assert!(chart.svg(&Paper::default())?.starts_with("<svg"));
//! # Ok::<(), stribeck_charts::ChartError>(())
//! ```
//!
//! Each kind of chart is a struct that holds all it shows; [`Chart`] paints it.
//!
//! | chart | what it shows |
//! | --- | --- |
//! | [`Lines`] | curves in a plane |
//! | [`Map`] | one quantity as colour over two axes, a panel for each third value and method |
//! | [`Surface3d`] | one quantity as height over two axes, a surface in space |
//! | [`CrossSection`] | a field below a deformed surface |
//! | [`WorkPrecision`] | error against run time, one line for each method |
//!
//! Each chart has a folder, which says where its parts lie and draws them on a `frame` (heading, ticks, names of axes,
//! panels, legend). It becomes a list of shapes, which does not depend on the format, so that all formats show the
//! same; `paint` writes them. `axes` leads from values to places and labels, `geometry` cuts lines and areas and finds
//! them on a grid.

mod axes;
mod chart;
mod checks;
mod cross_section;
mod error;
mod frame;
mod geometry;
#[cfg(test)]
#[path = "../tests/laws/mod.rs"]
mod laws;
#[cfg(test)]
mod layout_laws;
mod lines;
mod map;
mod median;
#[cfg(test)]
#[path = "../tests/numbers/mod.rs"]
mod numbers;
mod paint;
mod paper;
mod surface3d;
mod work_precision;

pub use chart::Chart;
pub use cross_section::{CrossSection, CrossSectionPanel};
pub use error::ChartError;
pub use lines::{Colour, Curve, LineAxis, Lines, Stroke};
pub use map::{Cell, ColourScale, Map, Panel};
pub use median::geometric_median;
pub use paper::{MARK, Paper};
pub use surface3d::{Surface3d, Surface3dCurve, Surface3dPanel};
pub use work_precision::{MethodLine, Outcome, SettingPoint, WorkPrecision};
