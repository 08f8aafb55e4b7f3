//! Laws of the charts: one module a chart.

mod chart_files;
mod extremes;
mod fields;
mod laws;
mod numbers;
mod plots_and_maps;
mod surfaces;
