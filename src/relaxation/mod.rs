//! The paper's solver (Sec. 3, Eqs. 37–44): Gauss–Seidel relaxation of Reynolds' equation on a uniform grid.

mod settings;

pub use settings::{Acceleration, Domain, Settings};
