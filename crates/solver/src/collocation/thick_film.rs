//! The start from nothing: a film so thick that the substrate is nearly rigid.

use std::sync::Arc;

use super::adaptation::OUTLET_PANEL;
use super::displacement::Displacement;
use super::mesh::Mesh;
use super::state::State;
use crate::exact::RigidFilm;

/// Ends of panels that suit a rigid film, in units of the length √(2h₀) in which it doubles.
const PANELS: [f64; 10] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.2, 3.5, 6.0, 12.0];
/// Ratio of the ends of panels further ahead.
const GROWTH: f64 = 2.5;

/// A mesh for the rigid film at β, from the outlet to `reach`; `growth` is that of the panels behind it.
pub fn mesh(degree: usize, growth: f64, beta: f64, reach: f64) -> Arc<Mesh> {
    let film = RigidFilm::new(beta);
    let width = (2.0 * film.separation()).sqrt();
    let mut ends: Vec<f64> = PANELS.iter().map(|end| width * end).collect();
    let mut end = ends[PANELS.len() - 1] * GROWTH;
    while end * GROWTH.sqrt() < reach {
        ends.push(end);
        end *= GROWTH;
    }
    ends.push(reach);
    Mesh::new(degree, growth, ends)
}

/// The rigid film at β on a mesh, lifted by the displacement of its own pressure.
pub fn state(displacement: &Displacement, beta: f64) -> State {
    let film = RigidFilm::new(beta);
    let discretisation = &displacement.discretisation;
    let outlet = film.outlet();
    let nodes = discretisation.mesh.film.windows(2).enumerate().flat_map(|(panel, ends)| {
        let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        discretisation.reference.nodes.iter().skip(usize::from(panel > 0)).map(move |t| centre + half * t)
    });
    let mut pressure: Vec<f64> = nodes.map(|y| film.pressure(outlet + y)).collect();
    pressure[0] = 0.0;
    State {
        mesh: Arc::clone(&discretisation.mesh),
        film: discretisation.film_y().iter().map(|y| film.film(outlet + y)).collect(),
        pressure,
        c: film.c(),
        outlet,
        error: None,
        outlet_panel: OUTLET_PANEL,
    }
}
