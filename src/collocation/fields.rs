//! Fields of a solution at the points of the output: from the panel polynomials and the kernel.

use super::displacement::Displacement;
use super::inlet::Inlet;
use super::reference::evaluate;
use super::state::State;
use crate::model::{Fields, Output};

/// The fields asked for. There is no error of interpolation beyond that of the solution: p is its own polynomial, w the
/// displacement of this p at the very point, and u follows from (T3).
pub fn fields(displacement: &Displacement, beta: f64, state: &State, output: &Output) -> Fields {
    let wanted = output.fields;
    let mut fields = Fields::default();
    let places: Vec<f64> = output.x.iter().map(|x| x - state.outlet).collect();
    if wanted.pressure {
        fields.pressure = Some(pressure(displacement, beta, state, &places));
    }
    if wanted.film_thickness || wanted.displacement {
        let w = displacement.interpolate(&state.pressure, &places);
        if wanted.film_thickness {
            let film = |(y, w): (&f64, &f64)| state.separation + state.outlet * y + 0.5 * y * y - w;
            fields.film_thickness = Some(places.iter().zip(&w).map(film).collect());
        }
        if wanted.displacement {
            fields.displacement = Some(w);
        }
    }
    fields
}

/// p at places y: 0 behind the outlet, the panel polynomials on the mesh, the inlet film beyond it.
fn pressure(displacement: &Displacement, beta: f64, state: &State, places: &[f64]) -> Vec<f64> {
    let discretisation = &displacement.discretisation;
    let (reference, mesh) = (&discretisation.reference, &discretisation.mesh);
    let (degree, size) = (reference.degree, reference.degree + 1);
    let mut coefficients = vec![0.0; mesh.panels() * size];
    for (panel, coefficients) in coefficients.chunks_exact_mut(size).enumerate() {
        reference.coefficients_of_nodes(&state.pressure[panel * degree..panel * degree + size], coefficients);
    }
    let last_film = state.film[state.film.len() - 1];
    let last_x = state.outlet + discretisation.film_y()[state.film.len() - 1];
    let at = |&y: &f64| {
        if y <= 0.0 {
            return 0.0;
        }
        if y > mesh.reach() {
            let x = state.outlet + y;
            let film = last_film + 0.5 * (x * x - last_x * last_x);
            return Inlet::new(beta, x, film, state.c).pressure;
        }
        let (panel, t) = mesh.locate(y);
        evaluate(&coefficients[panel * size..(panel + 1) * size], t)
    };
    places.iter().map(at).collect()
}
