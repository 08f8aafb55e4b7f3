//! Laws of sweep files, plan, engine and store: one module a subject.

mod bad_sweeps;
mod bodies;
mod engine;
mod extremes;
mod findings;
mod grids;
mod laws;
mod plan;
mod shards;
mod signals;
mod store;
mod surface;
mod survival;
mod sweep_file;
mod synthetic;
mod temperature;
