//! What solving costs, and stopping it.

use std::thread;
use std::time::{Duration, Instant};

use stribeck_solver::continuation::{Interrupt, Interrupted, solve_chain};
use stribeck_solver::relaxation::{Acceleration, RelaxationSolver, Settings};

use crate::relaxation::cases::{chain, no_fields, outcomes, settings};

/// The passes of a small sweep, seeds included: half as many again as the solver needed when this was written. More
/// means that something in it has become worse.
#[test]
fn a_small_sweep_needs_no_more_passes_than_it_did() {
    const MOST: u64 = 26_000;
    let sweep = [(1.0, 0.0), (1.0, 10.0), (10.0, 10.0), (10.0, 100.0)];
    let cases = sweep.map(|(alpha, f)| chain(alpha, f, &[10.0, 30.0, 100.0, 300.0]));
    let solved = cases.iter().flat_map(|cases| outcomes(settings(401), cases, &no_fields()));
    let passes: u64 = solved.map(|case| case.effort.iterations).sum();
    println!("{passes} passes");
    assert!(passes > 0 && passes < MOST, "{passes} passes, at most {MOST}");
}

/// Acceleration saves passes: at least three quarters of those of the plain iteration.
#[test]
fn acceleration_saves_passes() {
    for (alpha, f) in [(1.0, 0.0), (10.0, 10.0)] {
        let cases = chain(alpha, f, &[10.0, 30.0]);
        let passes = |acceleration| -> u64 {
            let solved = outcomes(Settings { acceleration, ..settings(201) }, &cases, &no_fields());
            solved.iter().map(|case| case.effort.iterations).sum()
        };
        let (plain, accelerated) = (passes(Acceleration::None), passes(Acceleration::Anderson));
        assert!(4 * accelerated < plain, "α = {alpha}, f = {f}: {accelerated} accelerated, {plain} plain");
    }
}

#[test]
fn a_chain_that_is_interrupted_before_it_begins_is_given_up_at_once() {
    let interrupt = Interrupt::new();
    interrupt.request();
    let cases = chain(1.0, 10.0, &[10.0, 100.0]);
    let solver = RelaxationSolver::new(settings(401));
    assert_eq!(solve_chain(&solver, &cases, &no_fields(), &interrupt).unwrap_err(), Interrupted);
}

#[test]
fn a_chain_is_interrupted_within_a_moment() {
    let (interrupt, begin) = (Interrupt::new(), Instant::now());
    let plain = Settings { acceleration: Acceleration::None, tolerance: 1e-13, ..settings(1601) };
    let cases = chain(1.0, 100.0, &[100.0, 200.0, 500.0]);
    let (result, requested) = thread::scope(|scope| {
        let user = scope.spawn(|| {
            thread::sleep(Duration::from_millis(300));
            interrupt.request();
            Instant::now()
        });
        let result = solve_chain(&RelaxationSolver::new(plain), &cases, &no_fields(), &interrupt);
        (result, user.join().unwrap())
    });
    assert_eq!(result.unwrap_err(), Interrupted);
    assert!(
        requested > begin && requested.elapsed() < Duration::from_secs(5),
        "{:?} after the request",
        requested.elapsed()
    );
}
