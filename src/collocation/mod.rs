//! The collocation method: fitted to the cavitation boundary, of high order, with its own error estimate.
#![allow(missing_docs, dead_code)]

mod adaptation;
mod discretisation;
mod displacement;
mod exponential_moments;
mod factorisation;
mod inlet;
mod legendre;
mod log_moments;
mod matrix;
mod mesh;
mod newton;
mod quantities;
mod reference;
mod retardation;
mod state;
mod system;
mod thick_film;
mod transfer;
#[cfg(test)]
mod trial;
