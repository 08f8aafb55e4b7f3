//! The step between relaxation and creep, exact both ways.

use super::creep::Material;
use super::relaxation::{Relaxation, RelaxationTerm};
use stribeck_solver::exact::{Line, Spectrum};
use stribeck_solver::{RetardationMode, Substrate};

impl Relaxation {
    /// The same material by its creep (T40), (T41).
    pub fn material(&self) -> Material {
        let line = |term: &RelaxationTerm| Line { strength: term.modulus / self.relaxed_modulus, place: term.time };
        let spectrum = Spectrum::new(self.terms.iter().map(line));
        let retardation = spectrum.conjugate().spectrum;
        // Their own sum, so that the shares add up to 1.
        let f = retardation.total();
        let shares = || retardation.lines().iter().map(|line| (line.strength / f, line.place));
        let retardation_time = shares().map(|(share, time)| share * time).sum();
        let modes = shares().map(|(share, time)| RetardationMode { share, time: time / retardation_time });
        let substrate = Substrate::new(modes.collect()).expect("positive shares of a sum, positive times");
        Material { relaxed_modulus: self.relaxed_modulus, f, retardation_time, substrate }
    }
}

impl Material {
    /// The same material by its relaxation (T40), (T41); terms in ascending order of their times.
    pub fn relaxation(&self) -> Relaxation {
        let rates = Spectrum::new(self.retardation().map(|(strength, time)| Line { strength, place: 1.0 / time }));
        let conjugate = rates.conjugate().spectrum;
        let term =
            |line: &Line| RelaxationTerm { modulus: line.strength * self.relaxed_modulus, time: 1.0 / line.place };
        let terms = conjugate.lines().iter().rev().map(term).collect();
        Relaxation { relaxed_modulus: self.relaxed_modulus, terms }
    }
}
