//! What friction takes of each number of a solution: the partial derivatives that the adjoint method begins with.

use std::f64::consts::{FRAC_PI_2, PI};

use super::displacement::{Along, Body, Displacement};
use super::inlet_partials::InletPartials;
use super::quantities::{at_points, inlet};
use super::state::State;
use super::system::pressure_gradient;
use crate::model::{CavityShear, gauss};

/// Partial derivatives of one friction force with respect to the quantities in its integral; empty where it has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Partials {
    /// p at the film's Gauss points.
    pub pressure: Vec<f64>,
    /// p′ at the film's Gauss points.
    pub gradient: Vec<f64>,
    /// u at the film's Gauss points.
    pub film: Vec<f64>,
    /// Σ f_j/(1+f) v_j′ of the flat and of the roller at the film's Gauss points.
    pub retarded_slopes: [Vec<f64>; 2],
    /// w less w(0) at the Gauss points behind the outlet.
    pub behind: Vec<f64>,
    /// c.
    pub c: f64,
    /// x_out.
    pub outlet: f64,
    /// ln β, all else fixed.
    pub ln_beta: f64,
}

impl Partials {
    /// The partial derivatives of the part of F_v that is of a body (T53); `along` belongs to the pressure.
    pub fn of_viscoelastic(displacement: &Displacement, state: &State, along: &Along, body: Body) -> Self {
        let discretisation = &displacement.discretisation;
        let weights = &discretisation.weights[discretisation.film()];
        let weighted =
            |values: &[f64]| weights.iter().zip(values).map(|(weight, value)| weight * value / FRAC_PI_2).collect();
        let mut partials = Self { pressure: weighted(&along.slope(body)), ..Self::default() };
        partials.retarded_slopes[body as usize] = weighted(&at_points(displacement, &state.pressure));
        partials
    }

    /// The partial derivatives of P (T53).
    pub fn of_pressure(displacement: &Displacement, beta: f64, state: &State) -> Self {
        Self::of_film(displacement, beta, state, 0.0)
    }

    /// The partial derivatives of F_h (T25), the cavity included; `displaced` is w less w(0) at the Gauss points behind
    /// the outlet.
    pub fn of_hydrodynamic(
        displacement: &Displacement,
        beta: f64,
        state: &State,
        displaced: &[f64],
        cavity_shear: CavityShear,
    ) -> Self {
        let mut partials = Self::of_film(displacement, beta, state, 1.0);
        if cavity_shear != CavityShear::None {
            partials.add_cavity(displacement, beta, state, displaced, cavity_shear);
        }
        partials
    }

    /// The partial derivatives of ∫ [p′u/π + S/(3πβu)] dx from the outlet on.
    fn of_film(displacement: &Displacement, beta: f64, state: &State, slide_roll: f64) -> Self {
        let discretisation = &displacement.discretisation;
        let weights = &discretisation.weights[discretisation.film()];
        let mut slopes = Vec::new();
        pressure_gradient(displacement, &state.pressure, &mut slopes);
        let inlet = inlet(displacement, beta, state);
        let (film, last) = (&state.film, state.film.len() - 1);
        let of_film = |i: usize| weights[i] * (slopes[i] - slide_roll / (3.0 * beta * film[i] * film[i])) / PI;
        let shear = inlet.shear + (0..film.len()).map(|i| weights[i] / (beta * film[i])).sum::<f64>();
        let mut partials = Self {
            gradient: (0..film.len()).map(|i| weights[i] * film[i] / PI).collect(),
            film: (0..film.len()).map(of_film).collect(),
            ln_beta: -(inlet.pressure_flow + slide_roll * shear / 3.0) / PI,
            ..Self::default()
        };
        let last_x = state.outlet + discretisation.film_y()[last];
        let ahead = InletPartials::new(&inlet, beta, state.c);
        let [start, c, gap] = [ahead.start, ahead.c, ahead.gap]
            .map(|partial| (partial.pressure_flow + slide_roll * partial.shear / 3.0) / PI);
        // g = u − x²/2 at the last Gauss point
        partials.film[last] += gap;
        partials.c += c;
        partials.outlet += start - last_x * gap;
        partials
    }

    /// Adds the partial derivatives of F_h,cavity = ∫ θ/(3πβu) dx with θ = 1 or c/u; the gap is c + x_out y + y²/2 − (w
    /// − w(0)).
    fn add_cavity(
        &mut self,
        displacement: &Displacement,
        beta: f64,
        state: &State,
        displaced: &[f64],
        cavity_shear: CavityShear,
    ) {
        let discretisation = &displacement.discretisation;
        let rows = discretisation.behind();
        let (y, weights) = (&discretisation.points[rows.clone()], &discretisation.weights[rows.clone()]);
        let gap = |i: usize| state.c + state.outlet * y[i] + 0.5 * y[i] * y[i] - displaced[i];
        let streamers = cavity_shear == CavityShear::Streamers;
        // θ/u, and its derivatives with respect to u and c
        let shear = |u: f64| if streamers { state.c / (u * u) } else { 1.0 / u };
        let by_gap = |u: f64| if streamers { -2.0 * state.c / (u * u * u) } else { -1.0 / (u * u) };
        let by_c = |u: f64| if streamers { 1.0 / (u * u) } else { 0.0 };

        let x = state.outlet + discretisation.mesh.behind[0];
        let first_x = state.outlet + y[0];
        let g = gap(0) - 0.5 * first_x * first_x;
        let beyond = |of: &dyn Fn(f64) -> f64| {
            gauss::mean(0.0, 1.0, |t| of((0.5 * x * x + g * t * t) / (t * t)) * x.abs() / (t * t))
        };
        let beyond_by_gap = beyond(&by_gap);
        let mut of_gap: Vec<f64> = rows.clone().map(|i| weights[i] * by_gap(gap(i))).collect();
        of_gap[0] += beyond_by_gap;
        let factor = 1.0 / (3.0 * PI * beta);
        let whole = rows.clone().map(|i| weights[i] * shear(gap(i))).sum::<f64>() + beyond(&shear);
        self.ln_beta -= factor * whole;
        let at_fixed_gap = rows.map(|i| weights[i] * by_c(gap(i))).sum::<f64>() + beyond(&by_c);
        self.c += factor * (of_gap.iter().sum::<f64>() + at_fixed_gap);
        let by_outlet: f64 = of_gap.iter().zip(y).map(|(weight, y)| weight * y).sum();
        self.outlet += factor * (by_outlet + shear(0.5 * x * x + g) - first_x * beyond_by_gap);
        self.behind = of_gap.iter().map(|weight| -factor * weight).collect();
    }

    /// The derivatives with respect to p at the nodes, through everything that follows from p except u.
    pub fn of_nodes(&self, displacement: &Displacement) -> Vec<f64> {
        let discretisation = &displacement.discretisation;
        let reference = &discretisation.reference;
        let (degree, size) = (reference.degree, reference.degree + 1);
        let mut sum = vec![0.0; discretisation.nodes()];
        if !(self.retarded_slopes.iter().all(Vec::is_empty) && self.behind.is_empty()) {
            sum = displacement.transposed(&self.retarded_slopes, &self.behind);
        }
        for (panel, ends) in discretisation.mesh.film.windows(2).enumerate() {
            let parts = [
                (&self.pressure, &reference.values, 1.0),
                (&self.gradient, &reference.derivative, 2.0 / (ends[1] - ends[0])),
            ];
            for (weights, matrix, scale) in parts {
                let on_panel = weights.chunks_exact(degree).nth(panel).into_iter().flatten();
                for (weight, row) in on_panel.zip(matrix.chunks_exact(size)) {
                    for (sum, entry) in sum[panel * degree..].iter_mut().zip(row) {
                        *sum += scale * weight * entry;
                    }
                }
            }
        }
        sum
    }
}
