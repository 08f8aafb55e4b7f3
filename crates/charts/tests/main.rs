//! Laws of the charts: one module a chart.

mod chart_files;
mod fields;
mod laws;
mod plots_and_maps;
mod surfaces;
