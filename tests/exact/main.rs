//! Laws of the limits with known answers: dry sliding, the rigid film, Hertz and the large-β approximation.

mod displacement;
mod dry;
mod hertz;
mod large_beta;
mod misprints;
mod quadrature;
mod rigid;
