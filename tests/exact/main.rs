//! Laws of the limits with known answers: dry sliding, the rigid film, Hertz and the large-β approximation.

mod dry;
mod quadrature;
