//! The program from outside, and what it draws: one module a subject.

mod bad_input;
#[path = "../crates/sweep/tests/bad_sweeps/mod.rs"]
mod bad_sweeps;
mod batch;
mod beginners;
mod bodies;
mod cli;
mod dependencies;
mod examples;
mod explain;
mod extension;
mod faults;
mod field_precision;
mod fit;
#[path = "../crates/sweep/tests/grids/mod.rs"]
mod grids;
mod hostile_sweeps;
mod in_python;
mod instrument_files;
mod laboratory;
mod material;
mod own_tables;
mod parts;
mod plot;
mod program;
mod published;
mod reference_pages;
mod refinement;
mod report;
mod report_surface;
mod resume;
mod schema;
mod scripts;
mod slurm;
mod solve_laboratory;
mod study;
mod surface;
#[path = "../crates/sweep/tests/synthetic/mod.rs"]
mod synthetic;
mod systems;
mod temperatures;
mod terminal_width;
mod torture;
