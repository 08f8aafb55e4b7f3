//! Cases that start from the table of solutions: the same numbers as by a march, and none lost.

use std::thread;

use proptest::prelude::*;
use rayon::prelude::*;
use stribeck_solver::collocation::CollocationSolver;
use stribeck_solver::continuation::{Interrupt, Seed, SolvedCase, solve_chain};
use stribeck_solver::{Parameters, Quantities};

use crate::collocation::cases::{numbers, outcomes, quantities, settings, with_modes};
use crate::collocation::measure::true_error;
use crate::property::with_seed;

const TOLERANCE: f64 = 1e-5;

fn alone(case: &Parameters) -> SolvedCase {
    outcomes(settings(TOLERANCE), std::slice::from_ref(case), &numbers()).remove(0)
}

fn by_march(case: &Parameters) -> Quantities {
    let solver = CollocationSolver::new(settings(TOLERANCE)).marching();
    let solved = solve_chain(&solver, std::slice::from_ref(case), &numbers(), &Interrupt::new());
    let solved = solved.expect("nobody interrupts").remove(0);
    assert!(matches!(solved.seed, Seed::ThickFilm | Seed::March(_)), "{case:?}: {}", solved.seed);
    solved.outcome.expect("it converges").quantities
}

/// α, β and f as powers of ten.
fn powers(alpha: f64, beta: f64, f: f64) -> Parameters {
    Parameters::new(10_f64.powf(alpha), 10_f64.powf(beta), 10_f64.powf(f))
}

proptest! {
    #![proptest_config(with_seed(200, 24))]

    /// Every case of the table's box is solved at the first try.
    #[test]
    fn the_table_and_the_march_lead_to_the_same_numbers(alpha in -4.0..4.0, beta in 0.0..7.0, f in -2.0..4.0) {
        let case = powers(alpha, beta, f);
        let solved = alone(&case);
        prop_assert!(matches!(solved.seed, Seed::Table | Seed::ThickFilm), "{}", solved.seed);
        prop_assert!(solved.path.points.is_empty());
        let error = true_error(&solved.outcome.expect("it converges").quantities, &by_march(&case));
        prop_assert!(error <= 3.0 * TOLERANCE, "off by {:.1e}", error);
    }
}

proptest! {
    #![proptest_config(with_seed(300, 25))]

    #[test]
    fn no_case_of_a_wide_box_is_lost(alpha in -6.0..6.0, beta in -3.0..9.0, f in -3.0..6.0) {
        let solved = alone(&powers(alpha, beta, f));
        prop_assert!(solved.outcome.is_ok(), "{:?}", solved.outcome);
    }

    /// Four in five start from the table; the others march, and are solved too.
    #[test]
    fn no_case_with_several_modes_is_lost(
        alpha in -4.0..4.0,
        beta in 0.0..7.0,
        f in -2.0..4.0,
        share in 0.1..0.9,
        times in [-2.0..2.0, -2.0..2.0],
    ) {
        let Parameters { alpha, beta, f, .. } = powers(alpha, beta, f);
        let times = times.map(|time: f64| 10_f64.powf(time));
        let case = with_modes(alpha, beta, f, &[(share, times[0]), (1.0 - share, times[1])]);
        let solved = alone(&case);
        prop_assert!(solved.outcome.is_ok(), "{:?}", solved.outcome);
    }
}

/// The elastic limits, the corners of the table and what lies beyond them.
#[test]
fn limits_and_edges_start_from_the_table() {
    let edges = [1e-5, 1e-3, 1e4, 1e5].into_iter().flat_map(|alpha| [1e-3, 1e4].map(|f| (alpha, f)));
    let pairs = edges.chain([(0.0, 100.0), (f64::INFINITY, 100.0), (1.0, 0.0), (f64::INFINITY, 0.0)]);
    let cases: Vec<Parameters> =
        pairs.flat_map(|(alpha, f)| [10.0, 1e7, 3e7].map(|beta| Parameters::new(alpha, beta, f))).collect();
    cases.par_iter().for_each(|case| {
        let solved = alone(case);
        assert!(matches!(solved.seed, Seed::Table | Seed::ThickFilm), "{case:?}: {}", solved.seed);
        let found = solved.outcome.unwrap_or_else(|why| panic!("{case:?}: {why}")).quantities;
        let error = true_error(&found, &by_march(case));
        assert!(error <= 3.0 * TOLERANCE, "{case:?}: off by {error:.1e}");
    });
}

/// A case has the same bits in every thread, whatever was solved there before.
#[test]
fn a_case_alone_has_the_same_bits_in_every_thread() {
    let case = Parameters::new(0.3, 3e3, 30.0);
    let here = quantities(TOLERANCE, &case);
    let there = thread::scope(|scope| {
        let solve = |before: f64| {
            let case = &case;
            scope.spawn(move || {
                quantities(TOLERANCE, &Parameters::new(before, 1e4, 5.0));
                quantities(TOLERANCE, case)
            })
        };
        [0.1, 1.0, 10.0].map(solve).map(|thread| thread.join().expect("no panic"))
    });
    assert_eq!(there, [here; 3]);
}

/// With few points a decade the table is nearer than the last case; with many it is not.
#[test]
fn chains_with_few_points_a_decade_start_from_the_table() {
    let along_beta =
        |ratio: f64| -> Vec<Parameters> { (0..6).map(|i| Parameters::new(1.0, 30.0 * ratio.powi(i), 100.0)).collect() };
    let solved = outcomes(settings(TOLERANCE), &along_beta(10_f64.sqrt()), &numbers());
    for (case, parameters) in solved.iter().zip(along_beta(10_f64.sqrt())) {
        assert_eq!(case.seed, Seed::Table);
        // what was solved before has left no trace
        let quantities = case.outcome.as_ref().expect("it converges").quantities;
        assert_eq!(quantities, alone(&parameters).outcome.expect("it converges").quantities);
    }
    let seeds = outcomes(settings(TOLERANCE), &along_beta(1.5), &numbers()).into_iter().map(|case| case.seed);
    let expected = [Seed::Table, Seed::Neighbour].into_iter().chain([Seed::Predictor; 4]);
    assert_eq!(seeds.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
}
