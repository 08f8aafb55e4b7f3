//! Runs chains in parallel and hands what they yield to one writer, in bounded memory.
//!
//! The engine knows neither solver nor store: both are closures. Chains are independent of each other, so their results
//! do not depend on the number of threads; only the order in which they are committed does.

mod pool;
mod progress;
mod signals;
mod tally;

pub use pool::solver_threads;
pub use pool::{Engine, Finished, Report, Solved, ThreadsError};
pub(crate) use pool::{GROUP_CASES, GROUP_WAIT};
pub use progress::{Progress, ProgressStyle};
pub use signals::{Signals, StopSignal};
pub use tally::rate;
