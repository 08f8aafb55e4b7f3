//! The tolerance is kept, and the estimated error is the error.

use std::sync::LazyLock;

use rayon::prelude::*;
use stribeck_solver::Parameters;

use crate::collocation::cases::{EXACTLY, ROWS, numbers, relative, settings, solutions};
use crate::collocation::measure::{TOLERANCES, quantile, reference, true_error, worst};

/// True error and estimate of each reference case.
type Errors = Vec<(f64, f64)>;

/// The errors of the reference cases, solved as these chains.
fn errors(tolerance: f64, chains: &[&[Parameters]]) -> Errors {
    let solved: Vec<_> =
        chains.par_iter().flat_map_iter(|chain| solutions(settings(tolerance), chain, &numbers())).collect();
    assert_eq!(solved.len(), EXACTLY.len());
    let pairs = solved.iter().zip(&*EXACTLY);
    pairs.map(|(solution, exact)| (true_error(&solution.quantities, exact), worst(&solution.errors))).collect()
}

/// The same of each case alone, for each tolerance.
static ALONE: LazyLock<Vec<(f64, Errors)>> = LazyLock::new(|| {
    let alone: Vec<&[Parameters]> = ROWS.chunks(1).collect();
    TOLERANCES.map(|tolerance| (tolerance, errors(tolerance, &alone))).to_vec()
});

/// What is taken as exact here is so: another method, mesh and program agree on it.
#[test]
fn exact_is_what_the_reference_has() {
    for ((case, [c, _, _, _, viscoelastic, film, cavity, ..]), exactly) in reference().into_iter().zip(&*EXACTLY) {
        let friction = &exactly.friction;
        assert!(relative(exactly.c, c) < 5e-8, "{case:?}: c");
        assert!(relative(friction.hydrodynamic(), film + cavity) < 5e-8, "{case:?}: F_h");
        let error = (friction.viscoelastic - viscoelastic).abs();
        assert!(error <= 1e-7 * viscoelastic, "{case:?}: F_v off by {error:.1e}");
    }
}

/// The true error is below the tolerance in 95 % of the cases, and nowhere above three times it.
///
/// So is every estimate, without exception: it is what stops the solver.
#[test]
fn every_tolerance_is_kept() {
    for (tolerance, errors) in &*ALONE {
        let within = errors.iter().filter(|(error, _)| error <= tolerance).count();
        assert!(within as f64 >= 0.95 * errors.len() as f64, "{tolerance:e}: {within} of {}", errors.len());
        for ((error, estimate), case) in errors.iter().zip(&*ROWS) {
            assert!(*error <= 3.0 * tolerance, "{tolerance:e}, {case:?}: off by {error:.1e}");
            assert!(estimate <= tolerance, "{tolerance:e}, {case:?}: estimate {estimate:.1e}");
        }
    }
}

/// So is it by cases that start from their neighbours, on meshes carried along.
#[test]
fn every_tolerance_is_kept_along_chains() {
    let chains: Vec<&[Parameters]> = ROWS.chunk_by(|a, b| (a.f, a.alpha) == (b.f, b.alpha)).collect();
    for tolerance in TOLERANCES {
        let errors = errors(tolerance, &chains);
        let within = errors.iter().filter(|(error, _)| *error <= tolerance).count();
        assert!(within as f64 >= 0.95 * errors.len() as f64, "{tolerance:e}: {within} of {}", errors.len());
        let largest = errors.iter().map(|(error, _)| *error).fold(0.0, f64::max);
        assert!(largest <= 3.0 * tolerance, "{tolerance:e}: off by {largest:.1e}");
    }
}

/// The median of estimated over true error lies between one half and six, for each tolerance: a bound that is near.
#[test]
fn the_estimate_is_the_error() {
    for (tolerance, errors) in &*ALONE {
        let ratios: Vec<f64> = errors.iter().map(|(error, estimate)| estimate / error).collect();
        let median = quantile(&ratios, 0.5);
        assert!((0.5..=6.0).contains(&median), "{tolerance:e}: {median}");
    }
}
