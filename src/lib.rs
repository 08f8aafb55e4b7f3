//! The program `stribeck`: its commands, the pictures and the page that they make, and studies of the methods.

pub mod commands;
pub mod fit_beginning;
mod format;
pub mod pictures;
pub mod report;
pub mod study;
pub mod universe;

/// The version of the program, with the commit that it is built from where that is known: `0.1.0 (1a2b3c4d5e6f)`.
pub const VERSION: &str = env!("STRIBECK_VERSION");
