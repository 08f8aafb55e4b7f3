//! Materials: spectra of relaxation and retardation, fits to measured moduli, series that are passed on, master curves.

mod fit;
mod judgement;
mod master_curve;
mod prony;
mod spectra;
mod tables;

use stribeck_lab::{Measurement, Relaxation, RelaxationTerm};

/// A material by its relaxed modulus and (modulus, time) of its terms.
fn solid(relaxed_modulus: f64, terms: &[(f64, f64)]) -> Relaxation {
    let terms = terms.iter().map(|&(modulus, time)| RelaxationTerm { modulus, time }).collect();
    Relaxation::new(relaxed_modulus, terms).expect("a material")
}

/// A rubber with a term in each decade from 1e-6 to 1e3 s.
fn rubber() -> Relaxation {
    let moduli = [3e8, 2e8, 9e7, 3e7, 8e6, 2e6, 7e5, 3e5, 1e5, 5e4];
    let terms: Vec<_> = moduli.iter().zip(-6..).map(|(modulus, decade)| (*modulus, 10_f64.powi(decade))).collect();
    solid(1.5e6, &terms)
}

/// What a material shows in oscillation, at ten frequencies in each decade between two powers of ten in rad/s.
fn oscillation(material: &Relaxation, from: i32, to: i32) -> Vec<Measurement> {
    let at = |omega| material.answer(&Measurement::Oscillation { omega, storage: f64::NAN, loss: f64::NAN });
    decades(from, to).map(at).collect()
}

/// What it shows after a step of strain, at ten times in each decade between two powers of ten in s.
fn decay(material: &Relaxation, from: i32, to: i32) -> Vec<Measurement> {
    decades(from, to).map(|time| material.answer(&Measurement::Relaxation { time, modulus: f64::NAN })).collect()
}

/// Numbers between two powers of ten, ten in each decade.
fn decades(from: i32, to: i32) -> impl Iterator<Item = f64> {
    (10 * from..=10 * to).map(|tenth| 10_f64.powf(f64::from(tenth) / 10.0))
}
