//! The program `stribeck`: its commands, the pictures and the page that they make, and studies of the methods.

pub mod commands;
mod format;
pub mod pictures;
pub mod report;
pub mod study;
