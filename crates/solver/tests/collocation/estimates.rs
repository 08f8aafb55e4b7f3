//! Every published estimate against the true error of its own column, on random cases of a box wider than any use.

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, Solution, solve_chain};
use stribeck_solver::{Output, Parameters, Quantities, RelativeErrors, viscoelastic_error_scale};

use crate::collocation::cases::{numbers, relative, settings, with_modes};
use crate::collocation::measure::quantile;

const CASES: usize = 200;
const TOLERANCES: [f64; 3] = [1e-3, 1e-5, 1e-7];
/// What is no error: solutions that count as exact are known no better.
const ROUNDING: f64 = 1e-10;
const COLUMNS: [&str; 8] = ["mu_drag", "mu_pressure", "mu_shear", "mu_v", "mu_h", "c", "film_min", "p_max"];

/// Numbers from 0 to 1 that follow from a seed (SplitMix64).
struct Random(u64);

impl Random {
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Ten to a power between two.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10_f64.powf(from + (to - from) * self.part())
    }
}

/// α from 10⁻⁶ to 10⁶, β from 10⁻³ to 10⁹, f from 10⁻³ to 10⁶, one to four modes over eight decades.
fn random_cases(seed: u64) -> Vec<Parameters> {
    let mut random = Random(seed);
    let case = |_| {
        let [alpha, beta, f] = [(-6.0, 6.0), (-3.0, 9.0), (-3.0, 6.0)].map(|(from, to)| random.decades(from, to));
        let count = 1 + (4.0 * random.part()) as usize;
        let modes: Vec<(f64, f64)> = (0..count).map(|_| (0.05 + random.part(), random.decades(-4.0, 4.0))).collect();
        let sum: f64 = modes.iter().map(|mode| mode.0).sum();
        let modes: Vec<(f64, f64)> = modes.iter().map(|&(share, time)| (share / sum, time)).collect();
        if count == 1 { Parameters::new(alpha, beta, f) } else { with_modes(alpha, beta, f, &modes) }
    };
    (0..CASES).map(case).collect()
}

/// The seed of STRIBECK_SEED, or a fixed one; printed.
fn seed() -> u64 {
    let seed = std::env::var("STRIBECK_SEED").map_or(2022, |seed| seed.parse().expect("a seed is a whole number"));
    println!("STRIBECK_SEED={seed}");
    seed
}

fn output() -> Output {
    Output { sensitivities: true, ..numbers() }
}

fn solved(solver: &CollocationSolver, case: &Parameters) -> Option<Solution> {
    let solved = solve_chain(solver, std::slice::from_ref(case), &output(), &Interrupt::new());
    solved.expect("nobody interrupts").remove(0).outcome.ok()
}

/// The least tolerance that thin films leave, panels of degree 12, an inlet four times as long.
fn exactly(case: &Parameters) -> Solution {
    let tolerances = [1e-10, 1e-9, 1e-8];
    let exact = |tolerance| solved(&CollocationSolver::new(Settings { tolerance, degree: 12 }).reaching(4.0), case);
    tolerances.into_iter().find_map(exact).unwrap_or_else(|| panic!("{case:?}"))
}

/// Relative errors of the columns.
fn true_errors(found: &Quantities, exact: &Quantities) -> [f64; 8] {
    let (here, there) = (&found.friction, &exact.friction);
    [
        relative(here.drag, there.drag),
        relative(here.pressure, there.pressure),
        relative(here.shear(), there.shear()),
        (here.viscoelastic - there.viscoelastic).abs() / there.viscoelastic_error_scale(),
        relative(here.hydrodynamic(), there.hydrodynamic()),
        relative(found.c, exact.c),
        relative(found.film_min, exact.film_min),
        relative(found.p_max, exact.p_max),
    ]
}

fn estimates(errors: &RelativeErrors) -> [f64; 8] {
    let RelativeErrors { mu_v, mu_h, c, drag, pressure, shear, film_min, p_max } = *errors;
    [drag, pressure, shear, mu_v, mu_h, c, film_min, p_max]
}

/// True error, the estimate, and which case.
type Pair = (f64, f64, usize);

/// What of the true error is more than what is not known of the exact solution, over the estimate.
fn excess(&(error, estimate, _): &Pair) -> f64 {
    (error - ROUNDING).max(0.0) / estimate
}

/// One line of a table; the part of the pairs whose error is below twice the estimate, and the largest ratio.
fn summarise(name: &str, pairs: &[Pair], cases: &[Parameters]) -> (f64, f64) {
    let ratios: Vec<f64> = pairs.iter().map(excess).collect();
    let within = ratios.iter().filter(|&&ratio| ratio < 2.0).count() as f64 / ratios.len() as f64;
    let largest = ratios.iter().fold(0.0, |a: f64, &b| if b.is_nan() || b > a { b } else { a });
    let over: Vec<f64> = pairs.iter().map(|&(error, estimate, _)| estimate / error.max(ROUNDING)).collect();
    let median = |of: fn(&Pair) -> f64| quantile(&pairs.iter().map(of).collect::<Vec<_>>(), 0.5);
    println!(
        "| {name} | {:.1} % | {:.2} | {:.2} | {largest:.2} | {:.2} | {:.1e} | {:.1e} |",
        100.0 * within,
        quantile(&ratios, 0.95),
        quantile(&ratios, 0.99),
        quantile(&over, 0.5),
        median(|pair| pair.0),
        median(|pair| pair.1)
    );
    if std::env::var_os("STRIBECK_WORST").is_some() {
        let mut sorted: Vec<&Pair> = pairs.iter().collect();
        sorted.sort_by(|a, b| excess(b).total_cmp(&excess(a)));
        for pair in sorted.iter().take(6).filter(|pair| excess(pair) > 2.0) {
            println!("    error {:.1e}, estimate {:.1e}: {:?}", pair.0, pair.1, cases[pair.2]);
        }
    }
    (within, largest)
}

/// Prints for each column and tolerance how the estimates compare with the true errors of random cases.
#[test]
#[ignore = "slow: 200 solutions at a tolerance of 1e-10"]
fn every_estimate_is_a_bound_for_its_own_column() {
    let cases = random_cases(seed());
    let exact: Vec<Solution> = cases.par_iter().map(exactly).collect();
    for tolerance in TOLERANCES {
        let solver = CollocationSolver::new(settings(tolerance));
        let found: Vec<Option<Solution>> = cases.par_iter().map(|case| solved(&solver, case)).collect();
        let failed = found.iter().filter(|found| found.is_none()).count();
        println!("\ntolerance {tolerance:.0e}, {failed} of {CASES} not solved");
        println!("| column | error < 2 estimates | largest error/estimate | median estimate/error | error | estimate |");
        println!("| --- | --- | --- | --- | --- | --- |");
        let mut pairs = vec![Vec::new(); COLUMNS.len()];
        let mut of_derivatives = vec![Vec::new(); 3];
        for (place, (found, exact)) in found.iter().zip(&exact).enumerate() {
            let Some(found) = found else { continue };
            let errors = true_errors(&found.quantities, &exact.quantities);
            for (pairs, (error, estimate)) in pairs.iter_mut().zip(errors.into_iter().zip(estimates(&found.errors))) {
                pairs.push((error, estimate, place));
            }
            let friction = &exact.quantities.friction;
            let scales = [
                viscoelastic_error_scale(friction.viscoelastic, friction.total()),
                friction.hydrodynamic(),
                friction.pressure.abs(),
            ];
            let rows = [found, exact].map(|solution| solution.sensitivities.expect("asked for").row());
            for (i, (here, there)) in rows[0].iter().zip(&rows[1]).enumerate() {
                of_derivatives[i / 3].push(((here - there).abs() / scales[i / 3], f64::NAN, place));
            }
        }
        for limit in [0.5, 0.9, 1.0, 2.0, 4.0] {
            let over = found.iter().flatten().filter(|s| [s.errors.mu_v, s.errors.mu_h, s.errors.c].iter().any(|e| *e > limit * tolerance)).count();
            print!("{over} over {limit} T; ");
        }
        println!();
        for (name, pairs) in COLUMNS.iter().zip(&pairs) {
            summarise(name, pairs, &cases);
        }
        for (name, pairs) in ["mu_v", "mu_h", "mu_pressure"].iter().zip(&of_derivatives) {
            let errors: Vec<f64> = pairs.iter().map(|pair| pair.0).collect();
            println!(
                "d{name}: median {:.1e}, 95 % {:.1e}, largest {:.1e}",
                quantile(&errors, 0.5),
                quantile(&errors, 0.95),
                quantile(&errors, 1.0)
            );
        }
    }
}
