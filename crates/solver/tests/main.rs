//! Laws of the solvers: one module a subject.

mod collocation;
mod continuation;
mod exact;
mod kernel;
mod property;
mod relaxation;
mod solve;
