//! Every published estimate against the true error of its own column, on random cases of a box wider than any use.

use rayon::prelude::*;
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, Solution, solve_chain};
use stribeck_solver::{Output, Parameters, Quantities, RelativeErrors};

use crate::collocation::cases::{numbers, relative, settings, solutions, with_modes};
use crate::collocation::measure::quantile;

/// What is no error: solutions that count as exact are known no better, and where their own estimate is larger, no
/// better than that.
const UNKNOWN: f64 = 1e-10;
const COLUMNS: [&str; 8] = ["mu_drag", "mu_pressure", "mu_shear", "mu_v", "mu_h", "c", "film_min", "p_max"];
const SENSITIVITIES: [&str; 3] = ["sensitivities of mu_v", "of mu_h", "of mu_pressure"];

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
fn random_cases(seed: u64, count: usize) -> Vec<Parameters> {
    let mut random = Random(seed);
    let case = |_| {
        let [alpha, beta, f] = [(-6.0, 6.0), (-3.0, 9.0), (-3.0, 6.0)].map(|(from, to)| random.decades(from, to));
        let modes = 1 + (4.0 * random.part()) as usize;
        let modes: Vec<(f64, f64)> = (0..modes).map(|_| (0.05 + random.part(), random.decades(-4.0, 4.0))).collect();
        let sum: f64 = modes.iter().map(|mode| mode.0).sum();
        let modes: Vec<(f64, f64)> = modes.iter().map(|&(share, time)| (share / sum, time)).collect();
        with_modes(alpha, beta, f, &modes)
    };
    (0..count).map(case).collect()
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
    let tolerances = [1e-10, 1e-9, 1e-8, 1e-7];
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

/// A difference to the exact number, its estimate, and what is not known of the exact number.
type Triple = (f64, f64, f64);

/// What of the difference is more than what is not known of the exact number, over the estimate.
fn excess(&(error, estimate, unknown): &Triple) -> f64 {
    (error - unknown.max(UNKNOWN)).max(0.0) / estimate
}

/// How estimates compare with true errors, as a line of a table.
struct Summary {
    /// The part whose true error is below twice the estimate.
    within: f64,
    /// The largest true error over its estimate.
    largest: f64,
    /// The median of estimates over true errors.
    over: f64,
    /// The median of estimates.
    estimate: f64,
}

impl Summary {
    fn print(name: &str, pairs: &[Triple]) -> Self {
        let ratios: Vec<f64> = pairs.iter().map(excess).collect();
        let median = |of: fn(&Triple) -> f64| quantile(&pairs.iter().map(of).collect::<Vec<_>>(), 0.5);
        let summary = Self {
            within: ratios.iter().filter(|&&ratio| ratio < 2.0).count() as f64 / ratios.len() as f64,
            largest: ratios.iter().fold(0.0, |a: f64, &b| if b.is_nan() || b > a { b } else { a }),
            over: median(|(error, estimate, _)| estimate / error.max(UNKNOWN)),
            estimate: median(|pair| pair.1),
        };
        let Self { within, largest, over, estimate } = summary;
        let percent = 100.0 * within;
        let error = median(|pair| pair.0);
        println!("| {name} | {percent:.1} % | {largest:.2} | {over:.1} | {error:.1e} | {estimate:.1e} |");
        summary
    }
}

/// The summaries of the columns and of the sensitivities of three frictions, over the friction.
struct Table {
    columns: [Summary; 8],
    sensitivities: [Summary; 3],
}

/// Solves the cases at a tolerance, alone, and prints their table.
fn table(tolerance: f64, cases: &[Parameters], exact: &[Solution]) -> Table {
    let solver = CollocationSolver::new(settings(tolerance));
    let found: Vec<Option<Solution>> = cases.par_iter().map(|case| solved(&solver, case)).collect();
    let failed = found.iter().filter(|found| found.is_none()).count();
    assert!(failed as f64 <= 0.01 * cases.len() as f64, "{failed} not solved");
    println!("\ntolerance {tolerance:.0e}, {failed} of {} not solved\n", cases.len());
    println!("| column | error < 2 estimates | largest error/estimate | median estimate/error | error | estimate |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut pairs = vec![Vec::new(); COLUMNS.len()];
    let mut of_sensitivities = vec![Vec::new(); 3];
    for ((found, exact), case) in found.iter().zip(exact).zip(cases) {
        let Some(found) = found else { continue };
        let errors = true_errors(&found.quantities, &exact.quantities);
        let bars = estimates(&found.errors).into_iter().zip(estimates(&exact.errors));
        let of_columns: Vec<Triple> =
            errors.into_iter().zip(bars).map(|(error, (here, there))| (error, here, there)).collect();
        if of_columns.iter().any(|pair| excess(pair) >= 10.0) {
            println!("far off: {case:?}");
        }
        pairs.iter_mut().zip(of_columns).for_each(|(pairs, pair)| pairs.push(pair));
        let friction = &exact.quantities.friction;
        let scales = [friction.viscoelastic_error_scale(), friction.hydrodynamic(), friction.pressure.abs()];
        let [here, there] = [found, exact].map(|solution| solution.sensitivities.expect("asked for").named());
        let estimates = found.sensitivity_errors.expect("asked for").named();
        for (i, estimate) in estimates.into_iter().enumerate() {
            of_sensitivities[i / 3].push(((here[i] - there[i]).abs() / scales[i / 3], estimate / scales[i / 3], 0.0));
        }
    }
    Table {
        columns: std::array::from_fn(|i| Summary::print(COLUMNS[i], &pairs[i])),
        sensitivities: std::array::from_fn(|i| Summary::print(SENSITIVITIES[i], &of_sensitivities[i])),
    }
}

/// The true error is below twice the estimate in 95 % of the cases and below ten times it everywhere; the estimate is
/// below so many times the true error in the median, or below 10⁻¹⁰.
fn are_bounds(table: &Table, most: f64) {
    for (summary, name) in table.columns.iter().zip(COLUMNS) {
        assert!(summary.within >= 0.95, "{name}: {:.3} within", summary.within);
        assert!(summary.largest < 10.0, "{name}: {:.1} times the estimate", summary.largest);
        assert!(summary.over < most || summary.estimate < 1e-10, "{name}: {:.1} times the error", summary.over);
    }
    for (summary, name) in table.sensitivities.iter().zip(SENSITIVITIES) {
        assert!(summary.within >= 0.95, "{name}: {:.3} within", summary.within);
    }
}

/// Prints for each column and tolerance how the estimates compare with the true errors of random cases.
#[test]
#[ignore = "slow: 200 solutions at a tolerance of 1e-10"]
fn every_estimate_is_a_bound_for_its_own_column() {
    let cases = random_cases(seed(), 200);
    let exact: Vec<Solution> = cases.par_iter().map(exactly).collect();
    let tables = [1e-3, 1e-5, 1e-7].map(|tolerance| table(tolerance, &cases, &exact));
    tables.iter().for_each(|table| are_bounds(table, 40.0));
}

#[test]
fn estimates_are_bounds_for_their_own_columns() {
    let cases = random_cases(18, 20);
    let exact: Vec<Solution> = cases.par_iter().map(exactly).collect();
    are_bounds(&table(1e-5, &cases, &exact), 100.0);
}

/// Where μ_v is a small part of friction nearly all of its error is what the inlet leaves out, which is known to some
/// per cent.
#[test]
fn what_lies_beyond_the_mesh_is_known() {
    for (alpha, beta, f) in [(2.7e-5, 0.083, 4644.0), (4.5e-5, 5.1, 7.7e4), (3.2e-6, 0.52, 1037.0)] {
        let case = Parameters::new(alpha, beta, f);
        let found = solved(&CollocationSolver::new(settings(1e-5)), &case).expect("a solution");
        let error = true_errors(&found.quantities, &exactly(&case).quantities)[3];
        let ratio = found.errors.mu_v / error;
        assert!((0.9..1.3).contains(&ratio), "{case:?}: {error:.1e}, estimate {:.1e}", found.errors.mu_v);
    }
}

/// Cases whose film enters the contact within a small part of a panel of the first mesh: richer panels alone saw a tenth
/// of the error there.
#[test]
fn the_inlet_is_resolved() {
    let spectrum = [(0.347, 42.404), (0.471, 0.024_823), (0.182, 0.162_37)];
    let cases = [
        with_modes(9122.491, 1.027_617_147e8, 0.424_729_92, &[(1.0, 68.477_622)]),
        with_modes(1.540_165e-4, 1.359_409_569e8, 1.199_844_6e-3, &spectrum),
    ];
    for (case, tolerance) in cases.iter().flat_map(|case| [1e-3, 1e-4].map(|tolerance| (case, tolerance))) {
        let found = solved(&CollocationSolver::new(settings(tolerance)), case).expect("a solution");
        let errors = true_errors(&found.quantities, &exactly(case).quantities);
        for ((error, estimate), name) in errors.into_iter().zip(estimates(&found.errors)).zip(COLUMNS) {
            assert!(error < 2.0 * estimate, "{name} of {case:?} at {tolerance:e}: {error:.1e}, {estimate:.1e}");
        }
        assert!(errors[4].max(errors[5]) < tolerance, "{case:?}: {errors:?} at {tolerance:e}");
    }
}

/// A case whose sensitivities on the panels of the solution are off by five per cents, though μ_h is right to 2e-7.
#[test]
fn sensitivities_are_those_of_richer_panels() {
    let case = Parameters::new(0.678_237_621_283_86, 1_240_709.617_905_05, 704.728_571_203_094_8);
    let found = solved(&CollocationSolver::new(settings(1e-5)), &case).expect("a solution");
    let exact = exactly(&case).sensitivities.expect("asked for").hydrodynamic[0];
    let here = found.sensitivities.expect("asked for").hydrodynamic[0];
    let estimate = found.sensitivity_errors.expect("asked for").hydrodynamic[0];
    assert!((here / exact - 1.0).abs() < 2e-3, "{here} {exact}");
    assert!((here - exact).abs() < estimate && estimate < 0.06 * exact, "{here} {exact} {estimate:e}");
}

/// Along a long chain the outlet and the friction behind it are as good as those of a case alone.
#[test]
fn a_long_chain_is_as_good_as_a_case_alone() {
    let settings = Settings { tolerance: 1e-8, ..Settings::default() };
    let chain: Vec<Parameters> =
        (0..=120).map(|step| Parameters::new(1.0, 10_f64.powf(-2.0 + f64::from(step) / 20.0), 100.0)).collect();
    let along = solutions(settings, &chain, &numbers());
    for place in (92..=120).step_by(4) {
        let (here, exact) = (&along[place].quantities, exactly(&chain[place]).quantities);
        let cavity = relative(here.friction.hydrodynamic_cavity, exact.friction.hydrodynamic_cavity);
        let outlet = (here.x_outlet - exact.x_outlet).abs() / (exact.x_p_max - exact.x_outlet);
        assert!(cavity < 1e-7 && outlet < 2e-8, "{:?}: cavity {cavity:.1e}, outlet {outlet:.1e}", chain[place]);
    }
}
