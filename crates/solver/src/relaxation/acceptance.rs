//! Checks whether a grid can hold and resolve the film: of a case before the first pass, of a converged state after the
//! last.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use super::iteration::{Iteration, index_of_largest};
use super::quantities::film_min;
use super::stiffness::thin_film_number;
use super::{Grid, reynolds};
use crate::continuation::FailureKind;
use crate::exact::{RigidFilm, contact_bounds};
use crate::model::Parameters;

/// Largest error of the flow at mid-points that a grid may leave: beyond it the grid does not resolve the film.
const MOST_UNRESOLVED: f64 = 0.1;
/// Smallest film over c: 0.74 to 1 in all solutions known. A dip at the outlet that falls between the points of a grid
/// has left it.
const FILM_MIN: RangeInclusive<f64> = 0.65..=1.0;
/// Outlet and largest pressure lie at least so many points inside the grid.
const NEAREST_TO_AN_END: usize = 4;
/// The [`thin_film_number`] of the elastic film on the dry contact beyond which no grid resolves a film.
const HOPELESSLY_THIN: f64 = 10.0;

/// A guess at c of an elastic film for any β: the sum of its limits, 0.4458 β^{−3/5} for large β and 1/(πβ) for small.
pub fn elastic_film(beta: f64) -> f64 {
    0.4458 * beta.powf(-0.6) + (PI * beta).recip()
}

/// A guess at c of any film, for the compliance ā² of the dry contact. No film is thicker; where the inlet is so short
/// that it finds the substrate stiffer than the contact does, films are up to 200 times thinner.
pub fn film_on_contact(parameters: &Parameters) -> f64 {
    let half_width = contact_bounds(parameters).2;
    let compliance = half_width * half_width;
    compliance * elastic_film(compliance * parameters.beta)
}

/// Checks that the film of a case is neither longer than the grid nor so thin that no iteration on the grid can solve
/// it.
///
/// A film so thick that the substrate hardly yields reaches from x_out to −x_out of the rigid film (T17), about the
/// centre of the dry contact at the farthest; yielding lengthens it. A film so thin that the number by which the
/// displacement outweighs the flow in a cell is large has its inlet and outlet within a step.
///
/// # Errors
/// [`FailureKind::FilmLongerThanGrid`], [`FailureKind::FilmThinnerThanGrid`].
pub fn check_resolvable(parameters: &Parameters, grid: &Grid, stiffness: f64) -> Result<(), FailureKind> {
    let (trailing, leading, _) = contact_bounds(parameters);
    let rigid = RigidFilm::new(parameters.beta).outlet();
    if 0.5 * (trailing + leading) + rigid <= grid.x_min || -rigid >= grid.x_max {
        return Err(FailureKind::FilmLongerThanGrid { grid: grid.ends(), certain: true });
    }
    let number = thin_film_number(grid.spacing(), parameters.beta, film_on_contact(parameters), stiffness);
    if number > HOPELESSLY_THIN { Err(FailureKind::FilmThinnerThanGrid) } else { Ok(()) }
}

/// Checks that the grid holds the film of a converged state and resolves it; only then the state is a solution.
///
/// Small residuals alone are not enough: a cylinder that leans its load on an end of the grid has them too.
///
/// # Errors
/// What is wrong with the state.
pub fn check_accepted(state: &Iteration) -> Result<(), FailureKind> {
    let grid = &state.shared.grid;
    let outlet = state.p.iter().position(|&p| p > 0.0).unwrap_or(0);
    if outlet < NEAREST_TO_AN_END || index_of_largest(&state.p) + NEAREST_TO_AN_END >= grid.points {
        return Err(FailureKind::FilmLongerThanGrid { grid: grid.ends(), certain: false });
    }
    let error = reynolds::conservation_error(&state.p, &state.u, state.beta, grid.spacing(), state.c());
    let dip = film_min(state) / state.c();
    match error {
        _ if error <= MOST_UNRESOLVED && FILM_MIN.contains(&dip) => Ok(()),
        _ if error <= MOST_UNRESOLVED => Err(FailureKind::NarrowDip { ratio: dip }),
        _ if error <= 1.0 => Err(FailureKind::FlowError { error }),
        _ => Err(FailureKind::FlowLost),
    }
}
