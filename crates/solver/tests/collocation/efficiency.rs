//! What a fixed sweep costs, in counts and not in seconds: efficiency cannot be lost unseen.

use stribeck_solver::Parameters;
use stribeck_solver::continuation::{Effort, Seed};

use crate::collocation::cases::{ROWS, numbers, outcomes, settings};

/// The chains of `benches/collocation.rs`: f = 100, seven α, 20 β a decade, tolerance 1e-5. A bound is some percent
/// above what was counted; who makes the method cheaper lowers it.
#[test]
fn a_fixed_sweep_costs_no_more_than_it_did() {
    let (mut cases, mut predicted) = (0.0, 0.0);
    let (mut iterations, mut factorisations, mut meshes, mut unknowns) = (0.0, 0.0, 0.0, 0.0);
    for alpha in (-3..=3).map(|i| 10_f64.powi(i)) {
        let beta = (0..=60).map(|i| 10_f64.powf(1.0 + f64::from(i) / 20.0));
        let chain: Vec<Parameters> = beta.map(|beta| Parameters::new(alpha, beta, 100.0)).collect();
        for case in outcomes(settings(1e-5), &chain, &numbers()) {
            assert!(case.outcome.is_ok(), "{case:?}");
            cases += 1.0;
            predicted += f64::from(u8::from(case.seed == Seed::Predictor));
            iterations += case.effort.iterations as f64;
            factorisations += case.effort.factorisations as f64;
            meshes += case.effort.meshes as f64;
            unknowns += case.effort.unknowns as f64;
        }
    }
    let counts = [iterations / cases, factorisations / cases, meshes / cases, unknowns / cases];
    println!("iterations, factorisations, meshes and unknowns a case: {counts:.3?}");
    // all but the first two of a chain come from the predictor
    assert!(cases - predicted <= 14.0, "{} of {cases} cases not predicted", cases - predicted);
    for (count, bound) in counts.into_iter().zip([5.0, 0.6, 0.27, 107.0]) {
        assert!(count <= bound, "{counts:?}");
    }
}

/// The cases of the reference, each alone. A bound is some percent above what was counted.
#[test]
fn a_case_alone_costs_no_more_than_it_did() {
    let solved: Vec<_> =
        ROWS.iter().map(|case| outcomes(settings(1e-5), std::slice::from_ref(case), &numbers())).collect();
    let cases: Vec<_> = solved.into_iter().flatten().collect();
    assert!(cases.iter().all(|case| case.outcome.is_ok() && case.seed == Seed::Table));
    let mean = |number: fn(&Effort) -> f64| cases.iter().map(|case| number(&case.effort)).sum::<f64>() / 84.0;
    let counts = [
        mean(|effort| effort.iterations as f64),
        mean(|effort| effort.factorisations as f64),
        mean(|effort| effort.meshes as f64),
        mean(|effort| effort.unknowns as f64),
    ];
    println!("iterations, factorisations, meshes and unknowns of a case alone: {counts:.3?}");
    for (count, bound) in counts.into_iter().zip([4.8, 1.2, 2.2, 97.0]) {
        assert!(count <= bound, "{counts:?}");
    }
}
