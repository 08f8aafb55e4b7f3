//! The error estimate: one Newton step with richer panels.

use std::sync::Arc;

use super::displacement::Displacement;
use super::newton::Corrector;
use super::quantities::quantities;
use super::reference::{evaluate, multiply};
use super::state::State;
use crate::continuation::Effort;
use crate::model::{CavityShear, Quantities, RelativeErrors};

/// How many degrees richer the panels of the estimate are.
pub const ENRICHMENT: usize = 2;

/// The state with its pressure on the same panels of a higher degree, and the film of that pressure (T12).
fn enriched(coarse: &Displacement, fine: &Displacement, state: &State) -> State {
    let (from, to) = (&coarse.discretisation.reference, &fine.discretisation.reference);
    let size = from.degree + 1;
    let mut coefficients = vec![0.0; size];
    let mut pressure = Vec::with_capacity(fine.discretisation.nodes());
    pressure.push(0.0);
    for nodes in state.pressure.windows(size).step_by(from.degree) {
        multiply(&from.node_coefficients, nodes, &mut coefficients);
        pressure.extend(to.nodes[1..].iter().map(|&t| evaluate(&coefficients, t)));
    }
    let mut displaced = vec![0.0; fine.discretisation.film_points()];
    fine.matrix.multiply_rows(fine.discretisation.film().start, &pressure, &mut displaced);
    let y = fine.discretisation.film_y();
    let film = y.iter().zip(&displaced).map(|(y, w)| state.separation + state.outlet * y + 0.5 * y * y - w).collect();
    State { mesh: Arc::clone(&fine.discretisation.mesh), pressure, film, error: None, ..*state }
}

/// What is known of a solution, and the estimated errors of it.
///
/// The solution is interpolated to degree d + 2 on its own panels, one Newton step is taken there, and what that changes in
/// μ_v, μ_h and c is reported. μ_v vanishes on an elastic substrate: below a thousandth of μ_tot its error is relative to that.
pub fn estimate(
    corrector: &mut Corrector,
    coarse: &Displacement,
    fine: &Displacement,
    beta: f64,
    state: &State,
    cavity_shear: CavityShear,
    effort: &mut Effort,
) -> (Quantities, RelativeErrors) {
    let solution = quantities(coarse, beta, state, cavity_shear);
    let mut better = enriched(coarse, fine, state);
    if better.film.iter().any(|&u| u <= 0.0) {
        return (solution, RelativeErrors { mu_v: f64::INFINITY, mu_h: f64::INFINITY, c: f64::INFINITY });
    }
    corrector.newton_step(fine, beta, &mut better, effort);
    let corrected = quantities(fine, beta, &better, cavity_shear);
    // extremes lie between the points: the richer polynomials know them better
    let Quantities { film_min, p_max, x_p_max, .. } = corrected;
    let solution = Quantities { film_min, p_max, x_p_max, ..solution };
    let (before, after) = (&solution.friction, &corrected.friction);
    let scale = before.viscoelastic.abs().max(1e-3 * before.total());
    let errors = RelativeErrors {
        mu_v: (after.viscoelastic - before.viscoelastic).abs() / scale,
        mu_h: (after.hydrodynamic() / before.hydrodynamic() - 1.0).abs(),
        c: (corrected.c / solution.c - 1.0).abs(),
    };
    (solution, errors)
}

/// The largest of the three errors; infinite if one is not a number.
pub fn worst(errors: &RelativeErrors) -> f64 {
    [errors.mu_v, errors.mu_h, errors.c].into_iter().fold(0.0, |a, error| if error.is_nan() { f64::INFINITY } else { a.max(error) })
}
