//! Cases reached along chains: in any direction, the same numbers as alone, and always the same bits.

use rayon::prelude::*;
use stribeck_solver::collocation::CollocationSolver;
use stribeck_solver::continuation::{Interrupt, Seed, solve_chain};
use stribeck_solver::{Output, Parameters};

use crate::collocation::cases::{numbers, outcomes, settings, solution};
use crate::collocation::measure::{EXACT, true_error, worst};

const TOLERANCE: f64 = 1e-5;

/// Straight lines in (ln α, ln β, ln(1+f)), each from one end to the other.
fn lines() -> Vec<(&'static str, Vec<Parameters>)> {
    let steps = |count: i32| (0..=count).map(move |i| f64::from(i) / f64::from(count));
    let power = |from: f64, to: f64, t: f64| 10_f64.powf(from + (to - from) * t);
    vec![
        ("β", steps(30).map(|t| Parameters::new(1.0, power(0.0, 4.0, t), 100.0)).collect()),
        ("β, falling", steps(30).map(|t| Parameters::new(1.0, power(4.0, 0.0, t), 100.0)).collect()),
        ("α", steps(40).map(|t| Parameters::new(power(-3.0, 3.0, t), 100.0, 100.0)).collect()),
        ("α, falling", steps(40).map(|t| Parameters::new(power(3.0, -3.0, t), 1e3, 10.0)).collect()),
        ("f", steps(30).map(|t| Parameters::new(1.0, 1e3, power(0.0, 3.0, t) - 1.0)).collect()),
        ("speed", steps(40).map(|t| Parameters::new(power(2.0, -2.0, t), power(4.0, 0.0, t), 100.0)).collect()),
        ("speed, falling", steps(40).map(|t| Parameters::new(power(-2.0, 2.0, t), power(0.0, 4.0, t), 10.0)).collect()),
        ("coarse steps", steps(3).map(|t| Parameters::new(power(-2.0, 2.0, t), power(5.0, 0.0, t), 30.0)).collect()),
    ]
}

/// Within the tolerance of the exact numbers, as a case alone is; and nearly every case starts from those before it.
#[test]
fn any_straight_line_leads_to_the_numbers_of_each_case() {
    lines().par_iter().with_max_len(1).for_each(|(name, cases)| {
        let solved = outcomes(settings(TOLERANCE), cases, &numbers());
        let from_start = solved.iter().filter(|case| matches!(case.seed, Seed::ThickFilm | Seed::March(_))).count();
        for (case, parameters) in solved.iter().zip(cases) {
            let found = case.outcome.as_ref().unwrap_or_else(|why| panic!("{name}, {parameters:?}: {why}"));
            let exact = solution(EXACT, parameters, &numbers()).quantities;
            let error = true_error(&found.quantities, &exact);
            assert!(error <= 3.0 * TOLERANCE, "{name}, {parameters:?}: off by {error:.1e}");
            assert!(worst(&found.errors) <= TOLERANCE, "{name}, {parameters:?}: {:?}", found.errors);
        }
        assert!(from_start <= 1 + cases.len() / 10, "{name}: {from_start} cases of {} start anew", cases.len());
    });
}

/// A solver keeps the memory of chains that are over, and nothing else of them: the same bits as by a new one.
#[test]
fn a_chain_leaves_nothing_to_the_next() {
    let others = [Parameters::new(0.01, 3e4, 1e3), Parameters::elastic(10.0), Parameters::new(1e4, 2.0, 0.1)];
    let output = Output { sensitivities: true, ..numbers() };
    let chain: Vec<Parameters> = [30.0, 40.0, 50.0].map(|beta| Parameters::new(1.0, beta, 10.0)).to_vec();
    let solve = |solver: &CollocationSolver, cases: &[Parameters]| {
        solve_chain(solver, cases, &output, &Interrupt::new()).expect("nobody interrupts")
    };
    let used = CollocationSolver::new(settings(1e-6));
    let before = solve(&used, &chain);
    solve(&used, &others);
    for (before, after) in before.iter().zip(solve(&used, &chain)) {
        assert_eq!(format!("{:?}", before.outcome), format!("{:?}", after.outcome));
        assert_eq!(before.effort.factorisations, after.effort.factorisations);
    }
}

/// The same chain twice, on whatever thread: the same bits.
#[test]
fn a_chain_has_the_same_bits_each_time() {
    let twice: Vec<_> = lines().into_iter().chain(lines()).collect();
    let bits: Vec<Vec<String>> = twice
        .par_iter()
        .with_max_len(1)
        .map(|(_, cases)| {
            let output = Output { limits: false, ..Output::default() };
            let solved = outcomes(settings(TOLERANCE), &cases[..4.min(cases.len())], &output);
            // the shortest text that reads back as the same number is as good as the bits
            solved.iter().map(|case| format!("{:?} {} {:?}", case.outcome, case.seed, case.path)).collect()
        })
        .collect();
    let (first, second) = bits.split_at(bits.len() / 2);
    assert_eq!(first, second);
}

/// A chain's beginning does not know how it goes on.
#[test]
fn a_shorter_chain_is_the_beginning_of_a_longer_one() {
    let (_, cases) = lines().remove(0);
    let numbers_of = |cases: &[Parameters]| -> Vec<_> {
        let solved = outcomes(settings(TOLERANCE), cases, &numbers()).into_iter();
        solved.map(|case| case.outcome.expect("it converges").quantities).collect()
    };
    let whole = numbers_of(&cases);
    assert_eq!(whole[..7], numbers_of(&cases[..7])[..]);
}
