//! Laws of the relaxation solver: what it must give whatever it does inside.

mod cases;
mod convergence;
mod effort;
mod estimate;
mod failure;
mod far_cases;
mod identities;
mod invariance;
mod limits;
mod misprints;
mod reference;
