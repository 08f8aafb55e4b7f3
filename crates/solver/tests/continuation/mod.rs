//! How a chain is solved: lines between cases, steps along them, which seeds are tried in which order, and what a
//! failure or an interrupt, a panic or the end of its time does to the rest; and what is recorded of the way.

mod fake;
mod isolation;
mod line;
mod seeds;
mod trace;
mod walk;
