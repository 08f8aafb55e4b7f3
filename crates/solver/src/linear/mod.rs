//! Dense matrices and their factors, as the methods need them.

mod factorisation;
mod matrix;
mod wide;

pub use factorisation::Factorisation;
pub use matrix::Matrix;
pub use wide::wide;
