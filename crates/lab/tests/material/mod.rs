//! Materials: spectra of relaxation and retardation, fits to measured moduli, and the command that makes them.

mod fit;
mod spectra;
