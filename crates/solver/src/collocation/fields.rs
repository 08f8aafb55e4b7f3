//! Fields of a solution at the points of the output: from the panel polynomials and the kernel.

use std::f64::consts::FRAC_PI_2;

use super::displacement::Displacement;
use super::inlet::Inlet;
use super::quantities::inlet;
use super::reference::{evaluate, evaluate_slope};
use super::state::State;
use crate::model::{Fields, Lubricant, Output, shear_traction};

/// How far the film by its displacement may be from the one by its polynomial.
const THIN: f64 = 0.01;

/// The fields of the output: p is its own polynomial on each panel, w the displacement of this p at the very place, and
/// u follows (T3). There is no error of interpolation beyond that of the solution.
///
/// With one exception: the film equation holds at the Gauss points, and between them the displacement of a pressure
/// that is known well may still be off by a good part of a very thin film. Where that is more than a hundredth, u is
/// the polynomial of ln u through the Gauss points, and w what follows from it.
pub fn fields(displacement: &Displacement, beta: f64, state: &State, output: &Output) -> Fields {
    let wanted = output.fields;
    let mut fields = Fields::default();
    let places: Vec<f64> = output.x.iter().map(|x| x - state.outlet).collect();
    if wanted.pressure || wanted.hysteresis_traction {
        let pressure = pressure(displacement, beta, state, &places);
        if wanted.hysteresis_traction {
            let slope = slope(displacement, state, &places);
            let traction = pressure.iter().zip(slope).map(|(p, slope)| p * slope / FRAC_PI_2);
            fields.hysteresis_traction = Some(traction.collect());
        }
        fields.pressure = wanted.pressure.then_some(pressure);
    }
    if wanted.film_thickness || wanted.displacement || wanted.shear_traction {
        let (film, deformed) = film(displacement, beta, state, &places);
        if wanted.shear_traction {
            let cavity_shear = output.cavity_shear;
            let lubricant = Lubricant { beta, c: state.c, outlet: state.outlet, cavity_shear };
            let shear = output.x.iter().zip(&film).map(|(&x, &u)| shear_traction(&lubricant, x, u, 1.0));
            fields.shear_traction = Some(shear.collect());
        }
        fields.film_thickness = wanted.film_thickness.then_some(film);
        fields.displacement = wanted.displacement.then_some(deformed);
    }
    fields
}

/// ln u on each panel, as Legendre coefficients: the polynomial through the Gauss points and, at the outlet, c.
fn film_logarithms(displacement: &Displacement, state: &State) -> Vec<f64> {
    let reference = &displacement.discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    let mut coefficients = vec![0.0; displacement.discretisation.mesh.panels() * size];
    let logarithms: Vec<f64> = state.film.iter().map(|u| u.ln()).collect();
    for (coefficients, logarithms) in coefficients.chunks_exact_mut(size).zip(logarithms.chunks_exact(degree)) {
        reference.coefficients_of_points(logarithms, &mut coefficients[..degree]);
    }
    // the outlet is one more place where u is known: c. P_d, which is 0 at the Gauss points, takes the polynomial there
    let parity = if degree.is_multiple_of(2) { 1.0 } else { -1.0 };
    coefficients[degree] = parity * (state.c.ln() - evaluate(&coefficients[..degree], -1.0));
    coefficients
}

/// w′ at places y ahead of the outlet, x − u′ with the polynomials of ln u (T3); 0 behind it, where nothing presses.
fn slope(displacement: &Displacement, state: &State, places: &[f64]) -> Vec<f64> {
    let (mesh, size) = (&displacement.discretisation.mesh, displacement.discretisation.reference.degree + 1);
    let coefficients = film_logarithms(displacement, state);
    let on_mesh = |y: f64| {
        let (panel, t) = mesh.locate(y);
        let (of_panel, ends) = (&coefficients[panel * size..(panel + 1) * size], &mesh.film[panel..=panel + 1]);
        let film_slope = evaluate(of_panel, t).exp() * evaluate_slope(of_panel, t) * 2.0 / (ends[1] - ends[0]);
        state.outlet + y - film_slope
    };
    let at = |&y: &f64| {
        if y <= 0.0 {
            0.0
        } else if y <= mesh.reach() {
            on_mesh(y)
        } else {
            // so far ahead the surface is as a load at one place bends it
            on_mesh(mesh.reach()) * (state.outlet + mesh.reach()) / (state.outlet + y)
        }
    };
    places.iter().map(at).collect()
}

/// u and w at places y.
fn film(displacement: &Displacement, beta: f64, state: &State, places: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mesh, size) = (&displacement.discretisation.mesh, displacement.discretisation.reference.degree + 1);
    let coefficients = film_logarithms(displacement, state);
    let mut deformed = displacement.interpolate(&state.pressure, places).into_iter();
    let separation = state.c + displacement.at_outlet(&state.pressure);
    let ahead = displacement.of_load_ahead(&inlet(displacement, beta, state));
    let at = |&y: &f64| {
        let undeformed = separation + state.outlet * y + 0.5 * y * y;
        let deformed = deformed.next().expect("one for each place");
        let film = undeformed - deformed;
        if (0.0..=mesh.reach()).contains(&y) {
            let (panel, t) = mesh.locate(y);
            let known = evaluate(&coefficients[panel * size..(panel + 1) * size], t).exp();
            if (film - known).abs() > THIN * known {
                return (known, undeformed - known + ahead);
            }
        }
        (film, deformed + ahead)
    };
    places.iter().map(at).unzip()
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
