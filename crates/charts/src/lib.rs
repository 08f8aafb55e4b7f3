//! Charts: plain numbers in, SVG or PNG out. The room knows nothing of solvers, sweeps or files.
//!
//! | file | what it holds |
//! | --- | --- |
//! | [`WorkPrecision`] | error against run time, one line for each method |
//! | [`Lines`] | curves in a plane |
//! | [`Map`] | one quantity over two axes, a panel for each third value and method |
//! | [`Relief`] | one quantity as height over two axes, a surface in space |
//! | [`Section`] | a field below a deformed surface |
//! | [`geometric_median`] | the median on a logarithmic axis |
//! | `ticks`, `number` | where an axis is labelled, and how a number is written |
//! | `log_axis`, `cell_axis`, `plane_axis`, `colour_bar` | from a value to a place or a colour |
//! | `contours`, `map_contours`, `bands` | lines of equal value, and the areas between them |
//! | `palette`, `marker`, `legend` | what marks look like |
//! | `setting_label`, `placement` | labels beside points, and where they find room |
//! | `space`, `relief_surface`, `relief_curve`, `relief_box` | a box in space; what is in it, from back to front; what is around it |
//! | `polyline`, `polygon` | cut at a border; in dashes |
//! | `checks` | of what charts are given |
//! | `scene`, `paint`, `indexed`, `font` | shapes in pixels; the two formats they are painted in; colours of a PNG; widths of text |
//!
//! A chart lays itself out as a list of shapes (`scene`), which does not depend on the format: the SVG and the PNG of one
//! chart show the same. Same input, same bytes.

mod bands;
mod cell_axis;
mod checks;
mod colour_bar;
mod contours;
mod error;
mod font;
mod indexed;
#[cfg(test)]
mod layout_laws;
mod legend;
mod lines;
mod lines_chart;
mod log_axis;
mod map;
mod map_chart;
mod map_contours;
mod marker;
mod median;
mod number;
mod paint;
mod palette;
mod placement;
mod plane_axis;
mod polygon;
mod polyline;
mod relief;
mod relief_box;
mod relief_chart;
mod relief_curve;
mod relief_surface;
mod scene;
mod section;
mod section_chart;
mod setting_label;
mod space;
mod ticks;
mod work_precision;
mod work_precision_chart;

pub use error::FigureError;
pub use lines::{Colour, Curve, LineAxis, Lines, Stroke};
pub use map::{Cell, ColourScale, Map, Panel};
pub use median::geometric_median;
pub use paint::WIDTH;
pub use relief::{Relief, ReliefCurve, ReliefPanel};
pub use section::{Section, SectionPanel};
pub use work_precision::{MethodLine, Outcome, SettingPoint, WorkPrecision};
