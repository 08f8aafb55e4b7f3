//! Laws of the charts: one module a chart.

mod chart_files;
mod figures;
mod figures_in_space;
mod figures_of_fields;
