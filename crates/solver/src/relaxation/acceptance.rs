//! Which cases a grid can hold, before the first pass, and which converged states are solutions, after the last.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use super::iteration::{Iteration, index_of_largest};
use super::quantities::film_min;
use super::stiffness::thin_film_number;
use super::{Grid, reynolds};
use crate::exact::{RigidFilm, contact_bounds};
use crate::model::{Failure, Parameters};

/// Largest error of the flow at mid-points that a grid may leave: beyond it the grid does not resolve the film.
const MOST_UNRESOLVED: f64 = 0.1;
/// Smallest film over c: 0.74 to 1 in all solutions known. A dip at the outlet that falls between the points of a grid has left it.
const FILM_MIN: RangeInclusive<f64> = 0.65..=1.0;
/// Outlet and largest pressure lie at least so many points inside the grid.
const NEAREST_TO_AN_END: usize = 4;
/// The [`thin_film_number`] of the elastic film on the dry contact beyond which no grid resolves a film.
const HOPELESSLY_THIN: f64 = 10.0;

/// A guess at c of an elastic film for any β: the sum of its limits, 0.4458 β^{−3/5} for large β and 1/(πβ) for small.
pub fn elastic_film(beta: f64) -> f64 {
    0.4458 * beta.powf(-0.6) + (PI * beta).recip()
}

/// A guess at c of any film, for the compliance ā² of the dry contact. No film is thicker; where the inlet is so short that it
/// finds the substrate stiffer than the contact does, films are up to 200 times thinner.
pub fn film_on_contact(parameters: &Parameters) -> f64 {
    let half_width = contact_bounds(parameters).2;
    let compliance = half_width * half_width;
    compliance * elastic_film(compliance * parameters.beta)
}

/// Why a state, or a case before it has one, is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// Outlet or largest pressure of the state lie at an end of the grid.
    LongerThanGrid(Grid),
    /// Those of a rigid film do, and no film is shorter.
    SurelyLonger(Grid),
    /// The flow at mid-points is wrong by this part of the film.
    Unresolved(f64),
    /// The smallest film is this part of c, which that of no solution is.
    Dip(f64),
    /// The film is much too thin for the grid.
    SurelyUnresolved,
    /// The flow is wrong by more than the film.
    Astray,
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        let longer = |grid: Grid| {
            let Grid { x_min, x_max, .. } = grid;
            format!(
                "the film under pressure is longer than the grid, [{x_min:.3}, {x_max:.3}]; \
                 set a wider domain = [x_min, x_max] in [solver.relaxation]"
            )
        };
        let unresolved = "the grid does not resolve the film";
        match refusal {
            Refusal::LongerThanGrid(grid) => Failure::new(longer(grid)),
            Refusal::SurelyLonger(grid) => Failure { reason: longer(grid), conclusive: true },
            Refusal::Unresolved(error) => {
                let percent = 100.0 * error;
                let reason =
                    format!("{unresolved}: the flow at mid-points is wrong by {percent:.0} % of it; use more points");
                Failure { reason, conclusive: true }
            }
            Refusal::Dip(ratio) => {
                let reason = format!(
                    "{unresolved}: its dip at the outlet is narrower than a step (smallest film {ratio:.2} c); \
                     use more points"
                );
                Failure { reason, conclusive: true }
            }
            Refusal::SurelyUnresolved => {
                let reason = format!("{unresolved}: its inlet and outlet are narrower than a step; use more points");
                Failure { reason, conclusive: true }
            }
            Refusal::Astray => Failure::new(
                "the iteration ends in a state that does not conserve the flow at all; use more points".to_owned(),
            ),
        }
    }
}

/// Refuses what no iteration on the grid can solve.
///
/// A film so thick that the substrate hardly yields reaches from x_out to −x_out of the rigid film (T17), about the centre
/// of the dry contact at the farthest; yielding lengthens it. A film so thin that the number by which the displacement outweighs
/// the flow in a cell is large has its inlet and outlet within a step.
///
/// # Errors
/// [`Refusal::SurelyLonger`], [`Refusal::SurelyUnresolved`].
pub fn foresee(parameters: &Parameters, grid: &Grid, stiffness: f64) -> Result<(), Refusal> {
    let (trailing, leading, _) = contact_bounds(parameters);
    let rigid = RigidFilm::new(parameters.beta).outlet();
    if 0.5 * (trailing + leading) + rigid <= grid.x_min || -rigid >= grid.x_max {
        return Err(Refusal::SurelyLonger(*grid));
    }
    let number = thin_film_number(grid.spacing(), parameters.beta, film_on_contact(parameters), stiffness);
    if number > HOPELESSLY_THIN { Err(Refusal::SurelyUnresolved) } else { Ok(()) }
}

/// A converged state is a solution only on a grid that holds the film and resolves it.
///
/// Small residuals alone are not enough: a cylinder that leans its load on an end of the grid has them too.
///
/// # Errors
/// What is wrong with the state.
pub fn judge(state: &Iteration) -> Result<(), Refusal> {
    let grid = &state.shared.grid;
    let outlet = state.p.iter().position(|&p| p > 0.0).unwrap_or(0);
    if outlet < NEAREST_TO_AN_END || index_of_largest(&state.p) + NEAREST_TO_AN_END >= grid.points {
        return Err(Refusal::LongerThanGrid(*grid));
    }
    let error = reynolds::conservation_error(&state.p, &state.u, state.beta, grid.spacing(), state.c());
    let dip = film_min(state) / state.c();
    match error {
        _ if error <= MOST_UNRESOLVED && FILM_MIN.contains(&dip) => Ok(()),
        _ if error <= MOST_UNRESOLVED => Err(Refusal::Dip(dip)),
        _ if error <= 1.0 => Err(Refusal::Unresolved(error)),
        _ => Err(Refusal::Astray),
    }
}
