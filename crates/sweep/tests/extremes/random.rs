//! A sample of the whole box: every case a sound solution, and the same one whichever way it is solved.

use rayon::prelude::*;

use crate::extremes::cases::{Set, Verdict, verdicts};

/// Most iterations of a march from a thick film to a case.
const MOST_ITERATIONS: u64 = 300;

/// Solves so many cases of the box at 1e-5 and again at 1e-7.
fn check(count: u32) {
    let Set { settings, chains } = Set::sample(count);
    let compared: Vec<Verdict> = chains.par_iter().flat_map_iter(|chain| verdicts(settings, chain)).collect();
    for verdict in &compared {
        let Verdict { case, solved, error } = verdict;
        assert!(verdict.is_sound(settings.tolerance), "{case:?}: {:?}", solved.outcome);
        assert!(solved.effort.iterations <= MOST_ITERATIONS, "{case:?}: {} iterations", solved.effort.iterations);
        // the second solution is there for all, at least with the same tolerance
        let error = error.unwrap_or_else(|| panic!("{case:?} has no second solution"));
        assert!(error <= 2.0, "{case:?}: {error:.2} times the tolerance");
    }
}

#[test]
fn every_case_is_solved_and_right() {
    check(40);
}

#[test]
#[ignore = "slow: 2000 cases of the box, twice"]
fn every_case_of_a_large_sample_is_solved_and_right() {
    check(2000);
}
