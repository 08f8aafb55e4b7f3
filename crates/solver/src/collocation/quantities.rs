//! Friction and film of a solution (section "Friction" of `docs/explanation/theory.md`).

use std::f64::consts::{FRAC_PI_2, PI};

use super::displacement::{Along, Displacement};
use super::inlet::Inlet;
use super::reference::{evaluate, evaluate_slope, multiply};
use super::state::State;
use super::system::pressure_gradient;
use crate::model::{CavityShear, Friction, Quantities};

/// What the integrals of a solution are made of.
pub struct Integrands {
    /// p′ at the film's Gauss points.
    pub gradient: Vec<f64>,
    /// p there.
    pub pressure: Vec<f64>,
    /// What follows from the displacement.
    pub along: Along,
}

impl Integrands {
    /// Those of a state.
    pub fn of(displacement: &Displacement, state: &State, cavity_shear: CavityShear) -> Self {
        let mut gradient = Vec::new();
        pressure_gradient(displacement, &state.pressure, &mut gradient);
        let along = displacement.along(&state.pressure, cavity_shear != CavityShear::None);
        Self { gradient, pressure: at_points(displacement, &state.pressure), along }
    }
}

/// Friction, film and load of a solution: integrals by the Gauss points of the panels, and to infinity beyond them.
#[cfg(test)]
pub fn quantities(displacement: &Displacement, beta: f64, state: &State, cavity_shear: CavityShear) -> Quantities {
    quantities_of(displacement, beta, state, &Integrands::of(displacement, state, cavity_shear), cavity_shear)
}

/// Friction, film and load of a solution: integrals by the Gauss points of the panels, and to infinity beyond them.
pub fn quantities_of(
    displacement: &Displacement,
    beta: f64,
    state: &State,
    integrands: &Integrands,
    cavity_shear: CavityShear,
) -> Quantities {
    let Integrands { gradient, pressure, along } = integrands;
    let discretisation = &displacement.discretisation;
    let film = discretisation.film();
    let (weights, y) = (&discretisation.weights[film.clone()], discretisation.film_y());
    let inlet = inlet(displacement, beta, state);

    let (mut pressure_flow, mut dissipation) = (inlet.pressure_flow, inlet.dissipation);
    let mut shear = inlet.shear;
    let (mut moment, mut load) = (inlet.moment, inlet.load);
    for i in 0..film.len() {
        pressure_flow += weights[i] * gradient[i] * state.film[i];
        dissipation += weights[i] * beta * state.film[i] * (state.film[i] * gradient[i]).powi(2);
        shear += weights[i] / (beta * state.film[i]);
        moment += weights[i] * pressure[i] * (state.outlet + y[i]);
        load += weights[i] * pressure[i];
    }
    let centroid = moment / FRAC_PI_2;
    let hydrodynamic_film = (pressure_flow + shear / 3.0) / PI;
    let hydrodynamic_cavity = cavity_friction(displacement, beta, state, &along.behind, cavity_shear);
    let viscoelastic_roller = match along.roller_slope.as_slice() {
        [] => 0.0,
        slope => viscoelastic_friction(weights, pressure, slope),
    };
    let friction = Friction {
        viscoelastic: viscoelastic_friction(weights, pressure, &along.retarded_slope),
        viscoelastic_roller,
        hydrodynamic_film,
        hydrodynamic_cavity,
        pressure: pressure_flow / PI,
        drag: hydrodynamic_film + hydrodynamic_cavity + centroid - viscoelastic_roller,
    };
    let (x_p_max, p_max) = extreme_pressure(displacement, state);
    Quantities {
        friction,
        c: state.c,
        film_min: smallest_film(displacement, state),
        p_max,
        x_p_max: state.outlet + x_p_max,
        x_outlet: state.outlet,
        centroid,
        dissipation: dissipation / PI,
        // u(x_out) = c in (T3), and the same for the load ahead of the mesh
        separation: state.c + displacement.at_outlet(&state.pressure) - 0.5 * state.outlet * state.outlet
            + displacement.of_load_ahead(&inlet),
        load_residual: (load / FRAC_PI_2 - 1.0).abs(),
    }
}

/// The film ahead of the mesh of a solution.
pub fn inlet(displacement: &Displacement, beta: f64, state: &State) -> Inlet {
    let discretisation = &displacement.discretisation;
    let x = state.outlet + discretisation.mesh.reach();
    let last = state.film.len() - 1;
    let last_x = state.outlet + discretisation.film_y()[last];
    Inlet::new(beta, x, state.film[last] + 0.5 * (x * x - last_x * last_x), state.c)
}

/// p at the Gauss points of the film.
pub fn at_points(displacement: &Displacement, nodes: &[f64]) -> Vec<f64> {
    let discretisation = &displacement.discretisation;
    let reference = &discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    let mut values = vec![0.0; discretisation.film_points()];
    for (panel, values) in values.chunks_exact_mut(degree).enumerate() {
        multiply(&reference.values, &nodes[panel * degree..panel * degree + size], values);
    }
    values
}

/// F_v = (2/π) ∫ p w′ dx (Eq. 22). The elastic part of w′ does no work, as its kernel is odd; what is left is
/// (2/π) Σ f_j/(1+f) ∫ p v_j′ dx with v_j′ = α_j (v_j − e) (T8).
fn viscoelastic_friction(weights: &[f64], pressure: &[f64], retarded_slope: &[f64]) -> f64 {
    let sum: f64 =
        weights.iter().zip(pressure).zip(retarded_slope).map(|((weight, p), slope)| weight * p * slope).sum();
    sum / FRAC_PI_2
}

/// θ/u behind the outlet, θ = 1, c/u or 0.
fn shear_behind(state: &State, cavity_shear: CavityShear) -> impl Fn(f64) -> f64 {
    let c = state.c;
    move |u| match cavity_shear {
        CavityShear::Full => 1.0 / u,
        CavityShear::Streamers => c / (u * u),
        CavityShear::None => 0.0,
    }
}

/// The gap at the Gauss points behind the outlet; `displaced` is w less w(0) there.
fn gap_behind<'a>(
    displacement: &'a Displacement,
    state: &'a State,
    displaced: &'a [f64],
) -> impl Iterator<Item = f64> + 'a {
    let y = &displacement.discretisation.points[displacement.discretisation.behind()];
    y.iter().zip(displaced).map(|(y, w)| state.c + state.outlet * y + 0.5 * y * y - w)
}

/// The terms of ∫ θ/u dx at the Gauss points behind the outlet; none where the cavity has no shear.
pub fn cavity_terms(
    displacement: &Displacement,
    state: &State,
    displaced: &[f64],
    cavity_shear: CavityShear,
) -> Vec<f64> {
    let discretisation = &displacement.discretisation;
    let weights = &discretisation.weights[discretisation.behind()];
    let shear = shear_behind(state, cavity_shear);
    weights.iter().zip(gap_behind(displacement, state, displaced)).map(|(weight, u)| weight * shear(u)).collect()
}

/// F_h,cavity = ∫ θ/(3πβu) dx behind the outlet (Eq. 20), θ = 1, c/u or 0; `displaced` is w less w(0) there.
fn cavity_friction(
    displacement: &Displacement,
    beta: f64,
    state: &State,
    displaced: &[f64],
    cavity_shear: CavityShear,
) -> f64 {
    if cavity_shear == CavityShear::None {
        return 0.0;
    }
    let discretisation = &displacement.discretisation;
    let inside: f64 = cavity_terms(displacement, state, displaced, cavity_shear).iter().sum();
    // beyond, u = x²/2 + g as for the inlet, with x = −X/t
    let x = state.outlet + discretisation.mesh.behind[0];
    let first_gap = gap_behind(displacement, state, displaced).next().expect("a mesh has panels behind the outlet");
    let g = first_gap - 0.5 * (state.outlet + discretisation.points[0]).powi(2);
    let shear = shear_behind(state, cavity_shear);
    let beyond =
        crate::model::gauss::mean(0.0, 1.0, |t| shear((0.5 * x * x + g * t * t) / (t * t)) * x.abs() / (t * t));
    (inside + beyond) / (3.0 * PI * beta)
}

/// Where between 0 and Y the pressure is largest, and how large.
fn extreme_pressure(displacement: &Displacement, state: &State) -> (f64, f64) {
    let discretisation = &displacement.discretisation;
    let reference = &discretisation.reference;
    let (degree, size) = (reference.degree, reference.degree + 1);
    let top =
        (0..state.pressure.len()).fold(0, |best, i| if state.pressure[i] > state.pressure[best] { i } else { best });
    let mut coefficients = vec![0.0; size];
    let panels = discretisation.mesh.panels();
    let mut best = (0.0, f64::NEG_INFINITY);
    // a node between two panels belongs to both
    for panel in (top.saturating_sub(1) / degree)..=(top / degree).min(panels - 1) {
        reference.coefficients_of_nodes(&state.pressure[panel * degree..panel * degree + size], &mut coefficients);
        let ends = &discretisation.mesh.film[panel..=panel + 1];
        let (t, value) = maximum(&coefficients, &reference.nodes);
        if value > best.1 {
            best = (0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * t, value);
        }
    }
    best
}

/// The smallest film of the polynomials through the Gauss points of each panel.
fn smallest_film(displacement: &Displacement, state: &State) -> f64 {
    let reference = &displacement.discretisation.reference;
    let degree = reference.degree;
    let low = (0..state.film.len()).fold(0, |best, i| if state.film[i] < state.film[best] { i } else { best });
    let mut coefficients = vec![0.0; degree];
    let mut smallest = state.film[low].min(state.c);
    let (panel, last) = (low / degree, state.film.len() / degree - 1);
    for panel in panel.saturating_sub(1)..=(panel + 1).min(last) {
        reference.coefficients_of_points(&state.film[panel * degree..(panel + 1) * degree], &mut coefficients);
        coefficients.iter_mut().for_each(|coefficient| *coefficient = -*coefficient);
        smallest = smallest.min(-maximum(&coefficients, &reference.nodes).1);
    }
    smallest
}

/// The largest value of a polynomial on [−1, 1] and its place, from its Legendre coefficients: where its slope is 0 beside
/// the best of `samples`, by regula falsi with halved values at an end that stays (Illinois).
fn maximum(coefficients: &[f64], samples: &[f64]) -> (f64, f64) {
    const MOST_STEPS: usize = 30;
    const NEAR: f64 = 1e-10;
    let values: Vec<f64> = samples.iter().map(|&t| evaluate(coefficients, t)).collect();
    let best = (0..values.len()).fold(0, |best, i| if values[i] > values[best] { i } else { best });
    let sampled = (samples[best], values[best]);
    let (mut a, mut b) = (samples[best.saturating_sub(1)], samples[(best + 1).min(samples.len() - 1)]);
    let (mut at_a, mut at_b) = (evaluate_slope(coefficients, a), evaluate_slope(coefficients, b));
    if !(at_a > 0.0 && at_b < 0.0) {
        return sampled;
    }
    let (mut t, mut stayed) = (sampled.0, 0.0);
    for _ in 0..MOST_STEPS {
        let next = (a * at_b - b * at_a) / (at_b - at_a);
        let (moved, slope) = ((next - t).abs(), evaluate_slope(coefficients, next));
        t = next;
        if moved < NEAR || slope == 0.0 {
            break;
        }
        let again = slope.signum() == stayed;
        let (moving, staying) =
            if slope > 0.0 { ((&mut a, &mut at_a), &mut at_b) } else { ((&mut b, &mut at_b), &mut at_a) };
        (*moving.0, *moving.1) = (t, slope);
        if again {
            *staying *= 0.5;
        }
        stayed = slope.signum();
    }
    let found = (t, evaluate(coefficients, t));
    if found.1 >= sampled.1 { found } else { sampled }
}
