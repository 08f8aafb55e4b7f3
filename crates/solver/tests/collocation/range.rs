//! The range in which every case must converge.

use std::sync::LazyLock;

use rayon::prelude::*;
use stribeck_solver::continuation::Solution;
use stribeck_solver::exact::contact_bounds;
use stribeck_solver::{FieldSelection, Output, Parameters};

use crate::collocation::cases::{settings, solution, solutions};
use crate::collocation::measure::worst;

const TOLERANCE: f64 = 1e-5;

/// Chains of eleven β from 10⁻² to 10⁸: α from 10⁻⁴ to 10⁴, 0 and ∞; f from 1 to 10⁴; and f = 0, where α means nothing.
fn the_box() -> Vec<Vec<Parameters>> {
    let alphas = (-4..=4).map(|exponent| 10_f64.powi(exponent)).chain([0.0, f64::INFINITY]);
    let strengths = (0..=4).map(|exponent| 10_f64.powi(exponent));
    let pairs = alphas.flat_map(|alpha| strengths.clone().map(move |f| (alpha, f))).chain([(1.0, 0.0)]);
    let betas = (-2..=8).map(|exponent| 10_f64.powi(exponent));
    pairs.map(|(alpha, f)| betas.clone().map(|beta| Parameters::new(alpha, beta, f)).collect()).collect()
}

/// The pressure of the cases of a chain, at places that gather at both edges of their dry contact.
fn pressure(chain: &[Parameters]) -> Output {
    let (trailing, leading, half_width) = contact_bounds(&chain[0]);
    let distances = (0..=280).map(|i| half_width * 10_f64.powf(-4.0 + 0.025 * f64::from(i)));
    let mut x: Vec<f64> =
        distances.flat_map(|far| [trailing - far, trailing + far, leading - far, leading + far]).collect();
    x.sort_by(f64::total_cmp);
    let fields = FieldSelection { pressure: true, ..FieldSelection::default() };
    Output { fields, x: x.into(), limits: false, ..Output::default() }
}

fn is_a_solution(case: &Parameters, solution: &Solution) {
    let quantities = &solution.quantities;
    assert!(worst(&solution.errors) <= TOLERANCE, "{case:?}: {:?}", solution.errors);
    assert!(quantities.load_residual <= 1e-10, "{case:?}: load {:.1e}", quantities.load_residual);
    let most = solution.fields.pressure.as_ref().expect("asked for").iter().copied().fold(0.0, f64::max);
    assert!(most <= quantities.p_max * 1.001 && most > 0.5 * quantities.p_max, "{case:?}: {most} {quantities:?}");
    assert!(0.0 < quantities.film_min && quantities.film_min < quantities.c, "{case:?}: {quantities:?}");
}

/// The cases of the box with their solutions, solved in chains.
static IN_CHAINS: LazyLock<Vec<(Parameters, Solution)>> = LazyLock::new(|| {
    let chains = the_box();
    let solved = |chain: Vec<Parameters>| {
        let solutions = solutions(settings(TOLERANCE), &chain, &pressure(&chain));
        chain.into_iter().zip(solutions)
    };
    chains.into_par_iter().with_max_len(1).flat_map_iter(solved).collect()
});

#[test]
fn every_case_of_the_box_is_solved_in_chains() {
    assert_eq!(IN_CHAINS.len(), 11 * 56);
    for (case, solution) in &*IN_CHAINS {
        is_a_solution(case, solution);
    }
}

#[test]
fn every_case_of_the_box_is_solved_alone() {
    the_box().par_iter().flatten_iter().for_each(|case| {
        let output = pressure(std::slice::from_ref(case));
        is_a_solution(case, &solution(settings(TOLERANCE), case, &output));
    });
}

/// p ≥ 0, but for a millionth of the largest: everywhere, not at the nodes alone.
#[test]
fn no_film_of_the_box_is_under_tension() {
    let lacking = IN_CHAINS.iter().filter_map(|(case, solution)| {
        let field = solution.fields.pressure.as_ref().expect("asked for");
        let least = field.iter().copied().fold(0.0, f64::min) / solution.quantities.p_max;
        (least < -1e-6).then(|| format!("α = {}, β = {:e}, f = {}: {least:.1e}", case.alpha, case.beta, case.f))
    });
    let lacking: Vec<String> = lacking.collect();
    assert!(lacking.is_empty(), "{} of {}: {lacking:#?}", lacking.len(), IN_CHAINS.len());
}
