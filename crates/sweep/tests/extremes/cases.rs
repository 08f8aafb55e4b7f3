//! The sets of extreme cases: those that are shipped as sweep files, and a sample of the whole box.

use std::path::Path;

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, SolvedCase, solve_chain};
use stribeck_solver::{FieldSelection, Output, Parameters, Quantities, RetardationMode, Substrate};
use stribeck_sweep::{Plan, Sweep};

use super::measure::{true_error, worst};

/// The shipped sweeps that are about extremes.
pub const SHIPPED: [&str; 7] = [
    "paper-range",
    "extreme-f",
    "extreme-alpha",
    "extreme-beta",
    "extreme-stiffness",
    "six-decades",
    "tight-tolerance",
];

/// Cases to be solved in chains, with the same settings.
pub struct Set {
    pub settings: Settings,
    pub chains: Vec<Vec<Parameters>>,
}

impl Set {
    /// The problems of a shipped sweep, in its chains.
    pub fn shipped(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps").join(name).with_extension("toml");
        let sweep = Sweep::read(path).expect("a shipped sweep is valid");
        let plan = Plan::new(&sweep);
        let chains = plan.chains().map(|chain| plan.parameters(&chain)).collect();
        Self { settings: sweep.solver.collocation(), chains }
    }

    /// So many cases of the whole box, each alone: α from 1e-8 to 1e8, β from 1e-4 to 1e10, f from 1e-2 to 1e6, all
    /// distributed evenly in their logarithms, and one to three modes up to six decades apart.
    ///
    /// They are the points of Halton's sequence: the same ones each time, with no gaps and no clusters.
    pub fn sample(count: u32) -> Self {
        let case = |index: u32| {
            let [alpha, beta, f, modes, rest @ ..] = BASES.map(|base| radical_inverse(base, index));
            let power = |part: f64, from: f64, to: f64| 10_f64.powf(from + (to - from) * part);
            let modes: Vec<(f64, f64)> = rest
                .chunks_exact(2)
                .take(1 + (3.0 * modes) as usize)
                .map(|pair| (0.05 + 0.95 * pair[0], power(pair[1], -3.0, 3.0)))
                .collect();
            let sum: f64 = modes.iter().map(|mode| mode.0).sum();
            let modes = modes.iter().map(|&(part, time)| RetardationMode { share: part / sum, time }).collect();
            let substrate = Substrate::new(modes).expect("shares add up to 1");
            let [alpha, beta, f] = [power(alpha, -8.0, 8.0), power(beta, -4.0, 10.0), power(f, -2.0, 6.0)];
            vec![Parameters { alpha, beta, f, substrate }]
        };
        Self { settings: Settings::default(), chains: (1..=count).map(case).collect() }
    }
}

const BASES: [u32; 10] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29];

/// The digits of a number in some base, mirrored at the point.
fn radical_inverse(base: u32, mut number: u32) -> f64 {
    let (mut value, mut unit) = (0.0, 1.0);
    while number > 0 {
        unit /= f64::from(base);
        value += unit * f64::from(number % base);
        number /= base;
    }
    value
}

/// What comes of a chain, numbers only.
pub fn outcomes(settings: Settings, chain: &[Parameters]) -> Vec<SolvedCase> {
    let output = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    solve_chain(&CollocationSolver::new(settings), chain, &output, &Interrupt::new()).expect("nobody interrupts")
}

/// What comes of a case alone.
pub fn outcome(settings: Settings, case: &Parameters) -> SolvedCase {
    outcomes(settings, std::slice::from_ref(case)).remove(0)
}

/// The case again with as little in common as possible: alone, on panels of another degree, with a hundredth of the
/// tolerance, or the least that can be reached from there on.
pub fn again(settings: Settings, case: &Parameters) -> Option<Quantities> {
    let degree = if settings.degree < 10 { 12 } else { 9 };
    let least = *Settings::TOLERANCE.start();
    let tolerances = [0.01, 0.1, 1.0].map(|part| f64::max(part * settings.tolerance, least));
    let mut solutions = tolerances.into_iter().map(|tolerance| outcome(Settings { tolerance, degree }, case).outcome);
    solutions.find_map(Result::ok).map(|solution| solution.quantities)
}

/// What became of a case of a set.
pub struct Verdict {
    pub case: Parameters,
    pub solved: SolvedCase,
    /// By how many times the tolerance the solution differs from the case solved [`again`].
    pub error: Option<f64>,
}

/// Solves a chain, and each case of it again.
pub fn verdicts(settings: Settings, chain: &[Parameters]) -> Vec<Verdict> {
    let verdict = |(solved, case): (SolvedCase, &Parameters)| {
        let known = solved.outcome.as_ref().ok().and_then(|solution| Some((solution, again(settings, case)?)));
        let error = known.map(|(solution, exact)| true_error(&solution.quantities, &exact) / settings.tolerance);
        Verdict { case: case.clone(), solved, error }
    };
    outcomes(settings, chain).into_iter().zip(chain).map(verdict).collect()
}

impl Verdict {
    /// Whether the case has a solution whose estimated errors are within the tolerance and all of whose numbers are
    /// numbers that a film may have.
    pub fn is_sound(&self, tolerance: f64) -> bool {
        let Ok(solution) = &self.solved.outcome else { return false };
        let Quantities { friction, c, film_min, p_max, x_p_max, x_outlet, centroid, separation, load_residual, .. } =
            solution.quantities;
        let numbers = [friction.viscoelastic, friction.drag, p_max, x_p_max, x_outlet, centroid, separation];
        numbers.iter().all(|number| number.is_finite())
            && worst(&solution.errors) <= tolerance
            && load_residual <= 1e-9
            && 0.0 < film_min
            && film_min < c
            && x_outlet < x_p_max
            && friction.hydrodynamic_cavity > 0.0
            // a creeping substrate takes energy and gives none, and so does a film
            && friction.viscoelastic >= -tolerance * friction.total()
            && friction.drag >= friction.viscoelastic - tolerance * friction.total()
    }
}
