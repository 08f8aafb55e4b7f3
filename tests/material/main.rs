//! Materials: spectra of relaxation and retardation, fits to measured moduli, and the command that makes them.

mod command;
mod fit;
#[path = "../program/mod.rs"]
mod program;
mod spectra;
