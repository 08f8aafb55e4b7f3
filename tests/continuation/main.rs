//! How a chain is solved: lines between cases, steps along them, which seeds are tried in which order, and what a failure or
//! an interrupt does to the rest.

mod fake;
mod ladder;
mod line;
mod walk;
