//! A small sweep whose numbers are made up: smooth, with failed cases, elastic rows and an infinite α.

#![allow(dead_code)]

pub use crate::grids::publish as publish_as;

use std::path::Path;

use stribeck_solver::continuation::Seed;
use stribeck_solver::{FieldSelection, Fields, Output, Sensitivities};
use stribeck_sweep::store::{CaseEntry, Published, Status, Store, StoreError, Timing};
use stribeck_sweep::{CaseId, Column, Values};

pub const F: [f64; 2] = [0.0, 100.0];
pub const ALPHA: [f64; 4] = [0.1, 1.0, 10.0, f64::INFINITY];
pub const BETA: [f64; 5] = [10.0, 31.622776601683793, 100.0, 316.22776601683796, 1000.0];

pub const SWEEP: &str = "title = \"synthetic, β from 10\"\n# a comment\n[axes]\nf = [0.0, 100.0]\n";

pub fn output() -> Output {
    Output { x: (0..41).map(|i| f64::from(i - 20) / 10.0).collect(), ..Output::default() }
}

/// Elastic cases (f = 0 or α = ∞) depend on β alone.
pub fn case_id(f: f64, alpha: f64, beta: f64) -> CaseId {
    let (f, alpha) = if f == 0.0 || alpha == f64::INFINITY { (0.0, f64::INFINITY) } else { (f, alpha) };
    let bits = [f, alpha, beta].map(f64::to_bits);
    CaseId(bits.iter().fold(7, |hash: u64, bits| hash.wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(23) ^ bits))
}

pub fn fails(f: f64, alpha: f64, beta: f64) -> bool {
    f > 0.0 && alpha == 0.1 && beta > 500.0
}

pub fn entry(f: f64, alpha: f64, beta: f64, output: &Output) -> CaseEntry {
    let failed = fails(f, alpha, beta);
    let mut values = Values::UNKNOWN;
    for (i, value) in values.0.iter_mut().enumerate().filter(|_| !failed) {
        *value = (1.0 + i as f64) * f.ln_1p() / (1.0 + alpha) - beta.powf(-0.6) / 3.0;
    }
    values[Column::ErrorMuV] = f64::NAN; // no estimate
    let shape = |scale: f64| -> Vec<f64> { output.x.iter().map(|x| scale * (-x * x * beta.ln()).exp()).collect() };
    let wanted = |selected: bool, scale: f64| (selected && !failed).then(|| shape(scale));
    let FieldSelection { pressure, film_thickness, displacement, shear_traction, hysteresis_traction } = output.fields;
    CaseEntry {
        id: case_id(f, alpha, beta),
        outcome: if failed { Status::Failed } else { Status::Converged },
        reason: if failed {
            "load residual 3e-2, \"stalled\" after 60000 passes, λ too small".into()
        } else {
            String::new()
        },
        failure_kind: failed.then(|| "stalled".to_owned()),
        values,
        fields: Fields {
            pressure: wanted(pressure, 1.0),
            film_thickness: wanted(film_thickness, 1e-3),
            displacement: wanted(displacement, -0.3),
            shear_traction: wanted(shear_traction, 2.0),
            hysteresis_traction: wanted(hysteresis_traction, 0.7),
        },
        sensitivities: (output.sensitivities && !failed).then(|| Sensitivities {
            viscoelastic_flat: [alpha, beta, f, 0.0, 0.0],
            viscoelastic_roller: [0.0; 5],
            hydrodynamic: [-alpha, 1.0 / beta, f / 3.0, 0.0, 0.0],
            pressure: [alpha / 3.0, -1.0 / beta, f, 0.0, 0.0],
        }),
        sensitivity_errors: (output.sensitivities && !failed).then(|| Sensitivities {
            viscoelastic_flat: [alpha, beta, f, 0.0, 0.0].map(|error| 1e-6 * error),
            viscoelastic_roller: [0.0; 5],
            hydrodynamic: [1e-6, 1e-6, 1e-6, 0.0, 0.0],
            pressure: [2e-6, 2e-6, 2e-6, 0.0, 0.0],
        }),
        timing: Timing {
            seconds: 0.125 + beta / 3.0,
            iterations: 300,
            factorisations: 0,
            seed: Some(Seed::Neighbour),
            time_limit: None,
        },
    }
}

/// The chains of the sweep: elastic first, then one for each α, cut in two.
pub fn chains(output: &Output) -> Vec<Vec<CaseEntry>> {
    let mut chains = Vec::new();
    for (f, alpha) in [(0.0, f64::INFINITY), (100.0, 0.1), (100.0, 1.0), (100.0, 10.0)] {
        for part in BETA.chunks(3) {
            chains.push(part.iter().map(|&beta| entry(f, alpha, beta, output)).collect());
        }
    }
    chains
}

pub fn row(i_f: usize, i_alpha: usize) -> Vec<CaseId> {
    BETA.iter().map(|&beta| case_id(F[i_f], ALPHA[i_alpha], beta)).collect()
}

pub fn open(directory: &Path) -> Store {
    Store::open(directory, SWEEP, &output()).unwrap()
}

pub fn publish(store: &mut Store) -> Result<Published, StoreError> {
    publish_as(store, ["synthetic, β from 10", SWEEP], [&F, &ALPHA, &BETA], &row)
}

/// The bytes of the two files that must be the same for every run.
pub fn published_bytes(directory: &Path) -> [Vec<u8>; 2] {
    ["results.h5", "summary.csv"].map(|name| std::fs::read(directory.join(name)).unwrap())
}

/// Commits everything in one go and publishes.
pub fn finished(directory: &Path) -> Store {
    let mut store = open(directory);
    store.begin("synthetic", 20, 2).unwrap();
    for chain in chains(&output()) {
        store.commit(&chain).unwrap();
    }
    publish(&mut store).unwrap();
    store
}

/// The published bytes of an undisturbed run.
pub fn reference() -> [Vec<u8>; 2] {
    let directory = tempfile::tempdir().unwrap();
    finished(directory.path());
    published_bytes(directory.path())
}

/// Resumes: commits the chains of which not all is held, publishes, and tells how many were missing.
pub fn resume(directory: &Path) -> usize {
    let mut store = open(directory);
    let mut missing = 0;
    for chain in chains(&output()) {
        if chain.iter().any(|entry| store.holds(entry.id).is_none()) {
            store.commit(&chain).unwrap();
            missing += 1;
        }
    }
    publish(&mut store).unwrap();
    missing
}
