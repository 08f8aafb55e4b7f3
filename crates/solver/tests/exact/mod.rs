//! Laws of the limits with known answers: dry sliding, the rigid film, Hertz and the large-β approximation; and of
//! the formula for the film that is fitted between them.

mod displacement;
mod dry;
mod dry_modes;
mod film_formula;
mod hertz;
mod large_beta;
mod misprints;
mod quadrature;
mod rigid;
mod spectrum;
