//! Charts: plain numbers in, SVG or PNG out. The room knows nothing of solvers, sweeps or files.
//!
//! | file | what it holds |
//! | --- | --- |
//! | [`WorkPrecision`] | error against run time, one line for each method |
//! | [`Map`] | one quantity over two axes, a panel for each third value and method |
//! | [`geometric_median`] | the median on a logarithmic axis |
//! | `ticks`, `number` | where an axis is labelled, and how a number is written |
//! | `log_axis`, `cell_axis`, `colour_bar` | from a value to a place or a colour |
//! | `palette`, `marker`, `legend` | what marks look like |
//! | `setting_label`, `placement` | labels beside points, and where they find room |
//! | `scene`, `paint`, `indexed`, `font` | shapes in pixels; the two formats they are painted in; colours of a PNG; widths of text |
//!
//! A chart lays itself out as a list of shapes (`scene`), which does not depend on the format: the SVG and the PNG of one
//! chart show the same. Same input, same bytes.

mod cell_axis;
mod colour_bar;
mod error;
mod font;
mod indexed;
#[cfg(test)]
mod layout_laws;
mod legend;
mod log_axis;
mod map;
mod map_chart;
mod marker;
mod median;
mod number;
mod paint;
mod palette;
mod placement;
mod scene;
mod setting_label;
mod ticks;
mod work_precision;
mod work_precision_chart;

pub use error::FigureError;
pub use map::{Cell, ColourScale, Map, Panel};
pub use median::geometric_median;
pub use paint::WIDTH;
pub use work_precision::{MethodLine, Outcome, SettingPoint, WorkPrecision};
