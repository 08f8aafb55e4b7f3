//! Friction and film of a converged state (section "Friction" of `docs/explanation/theory.md`), on the grid and beyond
//! it.

use std::f64::consts::PI;

use super::deformation::Deformation;
use super::far_field::FarField;
use super::iteration::{Hysteresis, Iteration, index_of_largest};
use super::parabola::{parabola, vertex};
use crate::model::{CavityShear, Friction, Quantities};

/// All numbers of a converged state. Second order in Δx where the film is resolved; what lies beyond the grid is
/// integrated to infinity.
pub fn quantities(state: &Iteration, cavity_shear: CavityShear) -> Quantities {
    let peak = Peak::of(state);
    let outlet = Outlet::of(state, peak.c);
    let inlet = Inlet::of(state, peak.c);
    let viscoelastic = viscoelastic_friction(&state.p, &state.w, inlet.hysteresis);
    let viscoelastic_roller = match &state.shared.hysteresis {
        Hysteresis::Flat => 0.0,
        Hysteresis::Roller => viscoelastic,
        Hysteresis::Both(roller) => friction_of_roller(state, roller, peak.c),
    };
    let friction = Friction {
        viscoelastic,
        viscoelastic_roller,
        pressure: (pressure_flow(state) + inlet.pressure_flow) / PI,
        hydrodynamic_film: film_friction(state, &outlet, &inlet),
        hydrodynamic_cavity: cavity_friction(state, &outlet, peak.c, cavity_shear),
        drag: 0.0,
    };
    let centroid = centroid(state, &inlet);
    Quantities {
        friction: Friction { drag: friction.hydrodynamic() + centroid - viscoelastic_roller, ..friction },
        c: peak.c,
        film_min: film_min(state),
        p_max: peak.pressure,
        x_p_max: peak.x,
        x_outlet: outlet.x,
        centroid,
        dissipation: (dissipation(state) + inlet.dissipation) / PI,
        separation: state.separation + state.level(),
        load_residual: state.load_residual().abs(),
    }
}

/// Largest pressure, by the parabola through the three highest points.
struct Peak {
    x: f64,
    pressure: f64,
    c: f64,
}

impl Peak {
    fn of(state: &Iteration) -> Self {
        let grid = &state.shared.grid;
        let i = index_of_largest(&state.p).clamp(1, grid.points - 2);
        let t = vertex(&state.p[i - 1..=i + 1]);
        Self {
            x: grid.x(i) + t * grid.spacing(),
            pressure: parabola(&state.p[i - 1..=i + 1], t),
            c: parabola(&state.u[i - 1..=i + 1], t),
        }
    }
}

/// Smallest film thickness, by the parabola through the three lowest points.
pub fn film_min(state: &Iteration) -> f64 {
    let u = &state.u;
    let i = (0..u.len()).fold(0, |best, i| if u[i] < u[best] { i } else { best }).clamp(1, u.len() - 2);
    parabola(&u[i - 1..=i + 1], vertex(&u[i - 1..=i + 1]))
}

/// The outlet, beside the first point under pressure: u = c there (T2 with T5).
struct Outlet {
    x: f64,
    /// The first grid point ahead of it.
    ahead: usize,
}

impl Outlet {
    /// Second order from u = c. Where the film is so flat that u meets c nowhere near, first order from √p, which grows
    /// in proportion to the distance.
    fn of(state: &Iteration, c: f64) -> Self {
        const NEAR: usize = 4;
        let (grid, p, u) = (&state.shared.grid, &state.p, &state.u);
        let first = p.iter().position(|&p| p > 0.0).unwrap_or(1).clamp(1, p.len() - 2);
        let window = first.saturating_sub(NEAR)..(first + NEAR).min(u.len() - 2);
        let crossing = window.rev().find(|&i| u[i] >= c && u[i + 1] < c);
        let place = crossing.map_or_else(
            || {
                let (root, next) = (p[first].sqrt(), p[first + 1].sqrt());
                first as f64 - (root / (next - root)).clamp(0.0, 1.0)
            },
            |behind| behind as f64 + crossing_part(u, behind, c),
        );
        Self { x: grid.x_min + place * grid.spacing(), ahead: place as usize + 1 }
    }
}

/// Where between points i and i + 1 the parabola through u at i − 1, i, i + 1 is c, as a part of the step.
fn crossing_part(u: &[f64], i: usize, c: f64) -> f64 {
    let values = [u[i.max(1) - 1], u[i], u[i + 1]];
    let mut t = (values[1] - c) / (values[1] - values[2]);
    for _ in 0..4 {
        let slope = 0.5 * (values[2] - values[0]) + t * (values[0] - 2.0 * values[1] + values[2]);
        let step = (parabola(&values, t) - c) / slope;
        if step.is_finite() {
            t = (t - step).clamp(0.0, 1.0);
        }
    }
    t
}

/// Contributions of the film ahead of the grid to the integrals of section 7, by quadrature to infinity.
struct Inlet {
    /// ∫ p w′ dx.
    hysteresis: f64,
    /// ∫ [p′u/π + 1/(3πβu)] dx.
    shear: f64,
    /// ∫ p x dx.
    moment: f64,
    /// ∫ p′u dx.
    pressure_flow: f64,
    /// ∫ βu³p′² dx.
    dissipation: f64,
}

impl Inlet {
    fn of(state: &Iteration, c: f64) -> Self {
        let (beta, end) = (state.beta, state.shared.grid.x_max);
        let last = state.p.len() - 1;
        let mut inlet = Self { hysteresis: 0.0, shear: 0.0, moment: 0.0, pressure_flow: 0.0, dissipation: 0.0 };
        for (x, weight, u) in state.film_ahead() {
            let gradient = -(u - c) / (beta * u.powi(3));
            let displacement = state.separation + 0.5 * x * x - u;
            // by parts: ∫ p w′ = −∫ p′ (w − w(X)),  ∫ p x = ½ p(X) (0 − X²) … = −½ ∫ p′ (x² − X²)
            inlet.hysteresis -= weight * gradient * (displacement - state.w[last]);
            inlet.moment -= weight * gradient * 0.5 * (x * x - end * end);
            inlet.pressure_flow += weight * gradient * u;
            inlet.dissipation -= weight * gradient * (u - c);
            inlet.shear += weight * (gradient * u + 1.0 / (3.0 * beta * u)) / PI;
        }
        inlet
    }
}

/// F_v = (2/π) ∫ p w′ dx, central differences of w: on an elastic substrate the kernel is even and the sum vanishes.
/// `ahead` is the integral ahead of the grid.
fn viscoelastic_friction(p: &[f64], w: &[f64], ahead: f64) -> f64 {
    let last = p.len() - 1;
    let inside: f64 = (1..last).map(|i| 0.5 * p[i] * (w[i + 1] - w[i - 1])).sum();
    let half_cell = 0.5 * p[last] * (w[last] - w[last - 1]);
    2.0 / PI * (inside + half_cell + ahead)
}

/// F_v,1, the roller's part of F_v beside that of the flat, from its displacement on the grid and ahead of it.
fn friction_of_roller(state: &Iteration, (deformation, field): &(Deformation, FarField), c: f64) -> f64 {
    let (p, tail_load) = (&state.p, state.tail_load);
    let mut w = vec![0.0; p.len()];
    deformation.displace(p, tail_load, &mut w, &mut deformation.space());
    let last = w[w.len() - 1];
    let slopes = state.film_ahead().enumerate().map(|(q, (_, weight, u))| {
        let gradient = -(u - c) / (state.beta * u.powi(3));
        weight * gradient * (field.displacement(q, p, tail_load) - last)
    });
    viscoelastic_friction(p, &w, -slopes.sum::<f64>())
}

/// F_h,film = ∫ [p′u/π + 1/(3πβu)] dx from the outlet on (Eq. 20).
fn film_friction(state: &Iteration, outlet: &Outlet, inlet: &Inlet) -> f64 {
    let shear = shear_ahead_of(state, outlet) / (3.0 * PI * state.beta);
    pressure_flow(state) / PI + shear + inlet.shear
}

/// ∫ p′u dx on the grid.
fn pressure_flow(state: &Iteration) -> f64 {
    let (p, u) = (&state.p, &state.u);
    (0..p.len() - 1).map(|i| 0.5 * (p[i + 1] - p[i]) * (u[i] + u[i + 1])).sum()
}

/// β ∫ u³p′² dx on the grid.
fn dissipation(state: &Iteration) -> f64 {
    let (p, u, dx) = (&state.p, &state.u, state.shared.grid.spacing());
    let between = |i: usize| (0.5 * (u[i] + u[i + 1])).powi(3) * (p[i + 1] - p[i]).powi(2);
    state.beta / dx * (0..p.len() - 1).map(between).sum::<f64>()
}

/// ∫ dx/u from the outlet to the end of the grid.
fn shear_ahead_of(state: &Iteration, outlet: &Outlet) -> f64 {
    let (grid, u) = (&state.shared.grid, &state.u);
    let dx = grid.spacing();
    let part = grid.x(outlet.ahead) - outlet.x;
    let t = 1.0 - part / dx;
    let u_outlet = u[outlet.ahead - 1] + t * (u[outlet.ahead] - u[outlet.ahead - 1]);
    let inside: f64 = (outlet.ahead..u.len() - 1).map(|i| 0.5 * dx * (1.0 / u[i] + 1.0 / u[i + 1])).sum();
    inside + 0.5 * part * (1.0 / u_outlet + 1.0 / u[outlet.ahead])
}

/// F_h,cavity = ∫ θ/(3πβu) dx behind the outlet, θ = 1, c/u or 0.
fn cavity_friction(state: &Iteration, outlet: &Outlet, c: f64, cavity_shear: CavityShear) -> f64 {
    let shear = |u: f64| match cavity_shear {
        CavityShear::Full => 1.0 / u,
        CavityShear::Streamers => c / (u * u),
        CavityShear::None => 0.0,
    };
    if cavity_shear == CavityShear::None {
        return 0.0;
    }
    let (grid, u) = (&state.shared.grid, &state.u);
    let (dx, behind) = (grid.spacing(), outlet.ahead - 1);
    let part = outlet.x - grid.x(behind);
    let inside: f64 = (0..behind).map(|i| 0.5 * dx * (shear(u[i]) + shear(u[i + 1]))).sum();
    let beyond: f64 = state.film_behind().map(|(_, weight, u)| weight * shear(u)).sum();
    (inside + 0.5 * part * (shear(u[behind]) + shear(c)) + beyond) / (3.0 * PI * state.beta)
}

/// (2/π) ∫ p x dx.
fn centroid(state: &Iteration, inlet: &Inlet) -> f64 {
    let grid = &state.shared.grid;
    let last = state.p.len() - 1;
    let inside: f64 = (1..last).map(|i| state.p[i] * grid.x(i)).sum();
    // half a cell, whose centre is a quarter of a step inside
    let half_cell = 0.5 * state.p[last] * (grid.x_max - 0.25 * grid.spacing());
    2.0 / PI * ((inside + half_cell) * grid.spacing() + inlet.moment)
}

#[cfg(test)]
mod tests {
    use super::super::{RelaxationSolver, Settings};
    use super::*;
    use crate::continuation::{CaseSolver, Interrupt, SolveContext};
    use crate::model::{FieldSelection, Output, Parameters};

    /// F_drag = F_h + (2/π) ∫ p x dx on the cylinder, F_v + F_h − (2/π) ∫ p′u dx on the substrate: equal up to the
    /// error of the grid, which falls by four when Δx is halved.
    #[test]
    fn drag_is_the_same_by_both_routes() {
        let output = Output { fields: FieldSelection::default(), ..Output::default() };
        let interrupt = Interrupt::new();
        for (alpha, f) in [(f64::INFINITY, 0.0), (1.0, 10.0), (10.0, 100.0)] {
            let parameters = Parameters::new(alpha, 100.0, f);
            let difference = [201, 401, 801].map(|points| {
                let solver = RelaxationSolver::new(Settings { points, ..Settings::default() });
                let mut workspace = solver.prepare(&parameters, &output).expect("the automatic domain fits");
                let mut context = SolveContext::new(&interrupt);
                let (guess, _) = solver.start(&mut workspace, &parameters, &mut context).expect("a start");
                let state = solver.solve(&mut workspace, &parameters, guess, &mut context).expect("a solution");
                let iteration = Iteration::new(workspace.finest(), parameters.beta, &state);
                let result = quantities(&iteration, CavityShear::Full);
                let inlet = Inlet::of(&iteration, result.c);
                let wedge = 2.0 / PI * (pressure_flow(&iteration) + inlet.pressure_flow);
                let from_substrate = result.friction.total() - wedge;
                ((from_substrate - result.friction.drag) / result.friction.drag).abs()
            });
            assert!(difference[2] < 2e-3, "α {alpha}, f {f}: {difference:?}");
            assert!(difference[2] < 0.4 * difference[1] + 1e-5, "α {alpha}, f {f}: {difference:?}");
            assert!(difference[1] < 0.4 * difference[0] + 1e-5, "α {alpha}, f {f}: {difference:?}");
        }
    }
}
