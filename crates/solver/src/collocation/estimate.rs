//! The error estimate: Newton's method with richer panels.

use std::sync::Arc;

use super::bounds::{ROUNDING, Sources};
use super::displacement::Displacement;
use super::parts::Parts;
use super::quantities::{Integrands, inlet, quantities_of};
use super::reference::evaluate;
use super::state::State;
use super::truncation::Truncation;
use super::workspace::Workspace;
use crate::continuation::Effort;
use crate::model::{CavityShear, Quantities, RelativeErrors};

/// How many times the tolerance the largest pressure, and the smallest film, may change when panels get richer. The
/// richer value is the one that is published, and is better by far.
const PRESSURE_SLACK: f64 = 50.0;
const FILM_SLACK: f64 = 500.0;
/// The same of friction behind the outlet over itself, and of the outlet over its distance from the largest pressure:
/// where the cavity is a small part of F_h no other error tells of them.
const OUTLET_SLACK: f64 = 5.0;
/// How many times the rounding of the film the outlet and the friction behind it may change by rounding alone.
const OUTLET_ROUNDING: f64 = 200.0;
/// Part of the tolerance that the nonlinearity may hide in an estimate.
const REMAINDER: f64 = 0.001;

/// The state on the same panels of a higher degree: p and ln u by their polynomials.
///
/// The film is not that of the interpolated pressure (T12): where it is thin, the displacements of the two degrees
/// differ by more than the film, and Newton's method mends that in one step only as long as the film is an unknown of
/// its own.
pub fn enriched(coarse: &Displacement, fine: &Displacement, state: &State) -> State {
    let (from, to) = (&coarse.discretisation.reference, &fine.discretisation.reference);
    let (degree, size) = (from.degree, from.degree + 1);
    let mut coefficients = vec![0.0; size];
    let mut pressure = Vec::with_capacity(fine.discretisation.nodes());
    let mut film = Vec::with_capacity(fine.discretisation.film_points());
    let mut logarithms = vec![0.0; degree];
    pressure.push(0.0);
    for (nodes, points) in state.pressure.windows(size).step_by(degree).zip(state.film.chunks_exact(degree)) {
        from.coefficients_of_nodes(nodes, &mut coefficients);
        pressure.extend(to.nodes[1..].iter().map(|&t| evaluate(&coefficients, t)));
        for (ln, u) in logarithms.iter_mut().zip(points) {
            *ln = u.ln();
        }
        from.coefficients_of_points(&logarithms, &mut coefficients[..degree]);
        film.extend(to.points.iter().map(|&t| evaluate(&coefficients[..degree], t).exp()));
    }
    State { mesh: Arc::clone(&fine.discretisation.mesh), pressure, film, error: None, ..*state }
}

/// The numbers of a solution with their errors.
pub struct Estimate {
    /// The numbers.
    pub quantities: Quantities,
    /// Their estimated errors.
    pub errors: RelativeErrors,
    /// The errors of μ_v, μ_h and c that the tolerance is about.
    controlled: [f64; 3],
    /// The largest part of them that a longer mesh would mend.
    pub cut: f64,
    /// The change of the largest pressure, the smallest film, the outlet and the friction behind it on richer panels,
    /// over the change that is accepted: extremes lie between the points, and converge more slowly than integrals.
    pub extremes: f64,
    /// The solution on the richer panels.
    pub richer: State,
    /// What lies beyond the mesh.
    pub beyond: Truncation,
}

impl Estimate {
    /// The largest error of μ_v, μ_h and c; infinite if one is not a number.
    pub fn worst(&self) -> f64 {
        self.controlled.into_iter().fold(0.0, larger)
    }

    /// No error of μ_v, μ_h and c is above what was accepted: the parts of the estimate that are there because errors
    /// may cancel do not make it larger than the tolerance, which is kept.
    #[must_use]
    pub fn accepted(mut self, most: f64) -> Self {
        let RelativeErrors { mu_v, mu_h, c, .. } = &mut self.errors;
        for error in [mu_v, mu_h, c] {
            *error = error.min(most);
        }
        self
    }
}

/// Estimates the errors of a solution.
///
/// The solution is interpolated to degree d + 2 on its own panels, a Newton step is taken there, and what that changes
/// is compared, panel by panel too. Friction and flow are known much better than the film at a point: where the square
/// of the step would be seen in them, chord steps follow.
pub fn estimate(
    workspace: &mut Workspace,
    (beta, state): (f64, &State),
    cavity_shear: CavityShear,
    tolerance: f64,
    effort: &mut Effort,
) -> Estimate {
    workspace.prepare_fine(&state.mesh, effort);
    let (coarse, fine, mut refiner) = workspace.estimating();
    let numbers = |displacement: &Displacement, state: &State| {
        let integrands = Integrands::of(displacement, state, cavity_shear);
        let parts = Parts::of(displacement, beta, state, &integrands, cavity_shear);
        (quantities_of(displacement, beta, state, &integrands, cavity_shear), parts)
    };
    let (solution, parts) = numbers(coarse, state);
    let mut richer = enriched(coarse, fine, state);
    let before = richer.clone();
    let remainder = refiner.refine(fine, beta, &mut richer, REMAINDER * tolerance, effort);
    let (corrected, richer_parts) = numbers(fine, &richer);
    let sources = Sources {
        spread: parts.spread(&richer_parts),
        cut: Truncation::new(coarse, beta, &inlet(coarse, beta, state), cavity_shear),
        beside_thinnest: beside_thinnest(fine.discretisation.reference.degree, &before.film, &richer.film),
        beside_largest: beside_largest(fine.discretisation.reference.degree, &before.pressure, &richer.pressure),
        remainder,
    };
    let pressure_change = (solution.p_max / corrected.p_max - 1.0).abs() / PRESSURE_SLACK;
    let film_change = (solution.film_min / corrected.film_min - 1.0).abs() / FILM_SLACK;
    let outlet_change = outlet_change(&solution, &corrected) / OUTLET_SLACK;
    // extremes lie between the points: the richer polynomials know them better
    let Quantities { film_min, p_max, x_p_max, .. } = corrected;
    Estimate {
        errors: sources.errors(&solution, &corrected),
        controlled: sources.controlled(&solution, &corrected),
        cut: sources.cut_of_controlled(&solution).into_iter().fold(0.0, larger),
        extremes: [pressure_change, film_change, outlet_change].into_iter().fold(0.0, larger),
        quantities: Quantities { film_min, p_max, x_p_max, ..solution },
        richer,
        beyond: sources.cut,
    }
}

/// The largest relative change of the film from one to the other on the panel where it is thinnest.
fn beside_thinnest(degree: usize, before: &[f64], after: &[f64]) -> f64 {
    let thinnest = (0..after.len()).fold(0, |best, i| if after[i] < after[best] { i } else { best });
    let panel = thinnest - thinnest % degree..thinnest - thinnest % degree + degree;
    panel.map(|i| (after[i] / before[i] - 1.0).abs()).fold(0.0, f64::max)
}

/// The largest change of the pressure from one to the other on the panel where it is largest, over the largest.
fn beside_largest(degree: usize, before: &[f64], after: &[f64]) -> f64 {
    let largest = (0..after.len()).fold(0, |best, i| if after[i] > after[best] { i } else { best });
    let first = (largest - largest % degree).min(after.len() - 1 - degree);
    (first..=first + degree).map(|i| (after[i] - before[i]).abs()).fold(0.0, f64::max) / after[largest]
}

/// The relative change of what lies at the outlet and behind it, without what rounding of a thin film makes of it.
fn outlet_change(solution: &Quantities, richer: &Quantities) -> f64 {
    let outlet = (richer.x_outlet - solution.x_outlet).abs() / (solution.x_p_max - solution.x_outlet);
    let (before, after) = (solution.friction.hydrodynamic_cavity, richer.friction.hydrodynamic_cavity);
    let change = if before == 0.0 { outlet } else { outlet.max((after / before - 1.0).abs()) };
    // NaN stays NaN.
    if change <= OUTLET_ROUNDING * ROUNDING / solution.c { 0.0 } else { change }
}

/// The larger of two numbers; infinite if the second is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
