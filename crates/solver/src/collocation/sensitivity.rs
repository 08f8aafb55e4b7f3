//! How friction changes with α, β and f: the adjoint method on the converged equations.

use super::adjoint::{Adjoint, Multipliers};
use super::displacement::Displacement;
use super::factorisation::Factorisation;
use super::friction_partials::Partials;
use super::reference::dot;
use super::state::State;
use super::substrate_derivatives::DisplacementDerivatives;
use super::system::System;
use crate::model::{CavityShear, Sensitivities};

/// The derivatives of F_v, F_h and P of a solution on its mesh with respect to ln α, ln β and ln f (T49).
///
/// They are those of the discrete equations, panels and their ends being fixed in y: one factorisation, and one
/// solution of the transposed system for each friction. `system` and `factors` are buffers,
/// which with the operands of the equations makes six arguments.
pub fn sensitivities(
    system: &mut System,
    factors: &mut Factorisation,
    displacement: &Displacement,
    beta: f64,
    state: &State,
    cavity_shear: CavityShear,
) -> Sensitivities {
    let mut adjoint = Adjoint::new(system, factors, displacement, beta, state);
    let along = displacement.along(&state.pressure, true);
    let substrate = [
        displacement.derivatives_with_alpha(&state.pressure, &along),
        displacement.derivatives_with_f(&state.pressure, &along),
    ];
    let mut of = |partials: &Partials| {
        let multipliers = adjoint.multipliers(partials);
        let with_beta = adjoint.with_beta(partials, &multipliers);
        let [with_alpha, with_f] =
            substrate.each_ref().map(|derivatives| with_substrate(partials, &multipliers, derivatives));
        [with_alpha, with_beta, with_f]
    };
    Sensitivities {
        // without retardation F_v is 0 whatever the parameters are
        viscoelastic: match displacement.filters.is_empty() {
            true => [0.0; 3],
            false => of(&Partials::of_viscoelastic(displacement, state, &along)),
        },
        hydrodynamic: of(&Partials::of_hydrodynamic(displacement, beta, state, &along.behind, cavity_shear)),
        pressure: of(&Partials::of_pressure(displacement, beta, state)),
    }
}

/// A parameter of the substrate is in the film equation, u + W p = …, in the retarded slope and in the gap behind the
/// outlet.
fn with_substrate(of: &Partials, multipliers: &Multipliers, derivatives: &DisplacementDerivatives) -> f64 {
    dot(&of.retarded_slope, &derivatives.retarded_slope) + dot(&of.behind, &derivatives.behind)
        - dot(&multipliers.film, &derivatives.film)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::mesh::Mesh;
    use super::super::newton::Corrector;
    use super::super::quantities::quantities;
    use super::super::reference::ReferencePanel;
    use super::super::thick_film;
    use super::super::timings::Timings;
    use super::*;
    use crate::continuation::{Effort, Interrupt, SolveContext};
    use crate::model::{DisplacementKernel, Parameters, RetardationMode, Substrate};

    /// A solution on the mesh that the film at `mesh_beta` would have, so short that the inlet beyond it matters.
    fn solved(parameters: &Parameters, mesh_beta: f64) -> (Displacement, State) {
        let mut displacement = Displacement::new(&Arc::new(ReferencePanel::new(8)));
        let whole = thick_film::mesh(8, 3.0, mesh_beta, 1e3);
        let near = whole.film.iter().copied().take(9).collect();
        let kernel = DisplacementKernel::new(parameters);
        displacement.set_mesh(&Mesh::new(8, 3.0, near), &kernel, &mut Timings::default());
        let mut state = thick_film::state(&displacement, parameters.beta);
        let interrupt = Interrupt::new();
        let mut context = SolveContext::new(&interrupt);
        let beta = parameters.beta;
        Corrector::default().correct(&displacement, beta, &mut state, 1e-14, &mut context).expect("a thick film");
        (displacement, state)
    }

    /// Nothing of the discrete equations is left out: against differences of fourth order on one mesh.
    #[test]
    fn sensitivities_are_derivatives_on_the_mesh() {
        let modes = [(0.7, 1.0), (0.3, 100.0)].map(|(share, time)| RetardationMode { share, time });
        let two_modes = Substrate::new(modes.to_vec()).expect("shares add up to 1");
        let cases = [
            (Parameters::new(1.0, 0.05, 30.0), CavityShear::Full),
            (Parameters::new(0.01, 1.0, 100.0), CavityShear::Streamers),
            (Parameters { substrate: two_modes, ..Parameters::new(3.0, 0.3, 5.0) }, CavityShear::None),
            (Parameters::new(0.0, 0.5, 5.0), CavityShear::Streamers),
            (Parameters::new(200.0, 0.1, 2.0), CavityShear::Streamers),
        ];
        for (case, cavity_shear) in cases {
            let (displacement, state) = solved(&case, case.beta);
            let found = Corrector::default().sensitivities(
                &displacement,
                case.beta,
                &state,
                cavity_shear,
                &mut Effort::default(),
            );
            let friction = |parameters: Parameters| {
                let (displacement, state) = solved(&parameters, case.beta);
                let friction = quantities(&displacement, parameters.beta, &state, cavity_shear).friction;
                [friction.viscoelastic, friction.hydrodynamic(), friction.pressure]
            };
            let step = 2e-3_f64;
            let scaled = |theta: usize, steps: f64| {
                let factor = |of: usize| if of == theta { (steps * step).exp() } else { 1.0 };
                let (alpha, beta, f) = (case.alpha * factor(0), case.beta * factor(1), case.f * factor(2));
                friction(Parameters { alpha, beta, f, ..case.clone() })
            };
            let scale = friction(case.clone());
            for theta in 0..3 {
                let ([a, b], [c, d]) = ([-2.0, -1.0].map(|n| scaled(theta, n)), [1.0, 2.0].map(|n| scaled(theta, n)));
                for (of, derivatives) in
                    [found.viscoelastic, found.hydrodynamic, found.pressure].into_iter().enumerate()
                {
                    let difference = (8.0 * (c[of] - b[of]) - (d[of] - a[of])) / (12.0 * step);
                    let error = (derivatives[theta] - difference).abs();
                    assert!(
                        error <= 1e-8 * scale[of].abs(),
                        "{case:?}, {theta} of {of}: {} {difference}",
                        derivatives[theta]
                    );
                }
            }
        }
    }
}
