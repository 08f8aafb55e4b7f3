//! Fields of a solution at the points of the output: from the polynomials on its panels.

use std::f64::consts::FRAC_PI_2;

use super::displacement::Displacement;
use super::gap::{Gap, Known};
use super::inlet::Inlet;
use super::reference::evaluate;
use super::state::State;
use crate::model::{Fields, Lubricant, Output, Quantities, shear_traction};

/// The fields of the output, from the solution on richer panels, whose polynomials know best what lies between the
/// points. They are laid over the published outlet, c and separation, from which those of the richer panels differ by
/// less than the errors: so p is 0 behind this outlet, where u is this c, and u + w − x²/2 is this separation
/// everywhere.
///
/// Beyond the mesh p is that of the inlet film, and w the displacement of a load so far away.
pub fn fields(
    displacement: &Displacement,
    beta: f64,
    richer: &State,
    published: &Quantities,
    output: &Output,
) -> Fields {
    let wanted = output.fields;
    let mut fields = Fields::default();
    if wanted.is_empty() {
        return fields;
    }
    let outlet = published.x_outlet;
    let places: Vec<f64> = output.x.iter().map(|x| x - outlet).collect();
    let gap = Gap::new(displacement, richer);
    if wanted.pressure || wanted.hysteresis_traction {
        let pressure = pressure(displacement, beta, richer, &places);
        if wanted.hysteresis_traction {
            let slopes = places.iter().map(|&y| slope(&gap, displacement, outlet, y));
            fields.hysteresis_traction = Some(pressure.iter().zip(slopes).map(|(p, w)| p * w / FRAC_PI_2).collect());
        }
        fields.pressure = wanted.pressure.then_some(pressure);
    }
    if wanted.film_thickness || wanted.displacement || wanted.shear_traction {
        let (film, deformed) = film(&gap, displacement, richer, published, output);
        if wanted.shear_traction {
            let lubricant = Lubricant { beta, c: published.c, outlet, cavity_shear: output.cavity_shear };
            let shear = output.x.iter().zip(&film).map(|(&x, &u)| shear_traction(&lubricant, x, u, 1.0));
            fields.shear_traction = Some(shear.collect());
        }
        fields.film_thickness = wanted.film_thickness.then_some(film);
        fields.displacement = wanted.displacement.then_some(deformed);
    }
    fields
}

/// w′ at a place y; 0 behind the outlet, where nothing presses.
fn slope(gap: &Gap, displacement: &Displacement, outlet: f64, y: f64) -> f64 {
    let reach = displacement.discretisation.mesh.reach();
    if y <= 0.0 {
        0.0
    } else if y <= reach {
        gap.slope(y)
    } else {
        // so far ahead the surface is as a load at one place bends it
        gap.slope(reach) * (outlet + reach) / (outlet + y)
    }
}

/// u and w at the places of the output.
fn film(
    gap: &Gap,
    displacement: &Displacement,
    richer: &State,
    published: &Quantities,
    output: &Output,
) -> (Vec<f64>, Vec<f64>) {
    let Quantities { c, x_outlet: outlet, separation, .. } = *published;
    // u = c at the outlet (T5)
    let at_outlet = separation + 0.5 * outlet * outlet - c;
    let richer_at_outlet = displacement.at_outlet(&richer.pressure);
    let at = |&x: &f64| {
        let (y, undeformed) = (x - outlet, separation + 0.5 * x * x);
        let known = match gap.holds(y) {
            true => gap.at(y),
            false => Known::Displacement(displacement.beyond(&richer.pressure, y) - richer_at_outlet),
        };
        match known {
            Known::Film(u) => {
                let u = u + (c - richer.c);
                (u, undeformed - u)
            }
            Known::Displacement(w) => (undeformed - (w + at_outlet), w + at_outlet),
        }
    };
    output.x.iter().map(at).unzip()
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
