//! How friction changes with β, and with α and f of each body: the adjoint method on the converged equations.

use super::adjoint::{Adjoint, Multipliers};
use super::displacement::{Body, Displacement};
use super::friction_partials::Partials;
use super::reference::dot;
use super::state::State;
use super::substrate_derivatives::DisplacementDerivatives;
use super::system::System;
use crate::linear::Factorisation;
use crate::model::{CavityShear, Sensitivities};

/// The derivatives of F_v of each body, F_h and P of a solution on its mesh with respect to ln β, and to ln α and ln f of
/// each body (T49).
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
    let with_alpha = Body::BOTH.map(|body| displacement.derivatives_with_alpha(body, &state.pressure, &along));
    let with_f = displacement.derivatives_with_f(&state.pressure, &along);
    let mut of = |partials: &Partials| {
        let multipliers = adjoint.multipliers(partials);
        let with_beta = adjoint.with_beta(partials, &multipliers);
        let of_body = |derivatives: &DisplacementDerivatives| with_substrate(partials, &multipliers, derivatives);
        let ([alpha, roller_alpha], [f, roller_f]) =
            (with_alpha.each_ref().map(of_body), with_f.each_ref().map(of_body));
        [alpha, with_beta, f, roller_alpha, roller_f]
    };
    // without retardation F_v is 0 whatever the parameters are
    let [viscoelastic_flat, viscoelastic_roller] = Body::BOTH.map(|body| match displacement.modes(body).is_empty() {
        true => [0.0; 5],
        false => of(&Partials::of_viscoelastic(displacement, state, &along, body)),
    });
    Sensitivities {
        viscoelastic_flat,
        viscoelastic_roller,
        hydrodynamic: of(&Partials::of_hydrodynamic(displacement, beta, state, &along.behind, cavity_shear)),
        pressure: of(&Partials::of_pressure(displacement, beta, state)),
    }
}

/// A parameter of the substrate is in the film equation, u + W p = …, in the retarded slopes and in the gap behind the
/// outlet.
fn with_substrate(of: &Partials, multipliers: &Multipliers, derivatives: &DisplacementDerivatives) -> f64 {
    let slopes = of.retarded_slopes.iter().zip(&derivatives.retarded_slopes);
    slopes.map(|(partials, slope)| dot(partials, slope)).sum::<f64>() + dot(&of.behind, &derivatives.behind)
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

    /// A case with one of the five parameters multiplied by a number.
    fn moved(case: &Parameters, theta: usize, by: f64) -> Parameters {
        if theta == 1 {
            return Parameters { beta: case.beta * by, ..case.clone() };
        }
        let (modes, of_roller) = (case.substrate.modes(), case.substrate.of_roller());
        let of_flat = modes.len() - of_roller;
        let strengths: Vec<f64> = (0..modes.len())
            .map(|i| case.f * modes[i].share * if theta == if i < of_flat { 2 } else { 4 } { by } else { 1.0 })
            .collect();
        let f: f64 = strengths.iter().sum();
        let time = |i: usize| modes[i].time / if theta == if i < of_flat { 0 } else { 3 } { by } else { 1.0 };
        let all = (0..modes.len()).map(|i| RetardationMode { share: strengths[i] / f, time: time(i) });
        let (flat, roller) = all.enumerate().partition::<Vec<_>, _>(|(i, _)| *i < of_flat);
        let [flat, roller] = [flat, roller].map(|part| part.into_iter().map(|(_, mode)| mode).collect());
        Parameters { f, substrate: Substrate::of_two_bodies(flat, roller).expect("parts of f"), ..case.clone() }
    }

    fn two_bodies(flat: &[(f64, f64)], roller: &[(f64, f64)]) -> Substrate {
        let modes = |modes: &[(f64, f64)]| modes.iter().map(|&(share, time)| RetardationMode { share, time }).collect();
        Substrate::of_two_bodies(modes(flat), modes(roller)).expect("shares add up to 1")
    }

    /// Nothing of the discrete equations is left out: against differences of fourth order on one mesh.
    #[test]
    fn sensitivities_are_derivatives_on_the_mesh() {
        let of = |case: Parameters, flat: &[(f64, f64)], roller: &[(f64, f64)]| Parameters {
            substrate: two_bodies(flat, roller),
            ..case
        };
        let cases = [
            (Parameters::new(1.0, 0.05, 30.0), CavityShear::Full),
            (Parameters::new(0.01, 1.0, 100.0), CavityShear::Streamers),
            (of(Parameters::new(3.0, 0.3, 5.0), &[(0.7, 1.0), (0.3, 100.0)], &[]), CavityShear::None),
            (Parameters::new(0.0, 0.5, 5.0), CavityShear::Streamers),
            (Parameters::new(200.0, 0.1, 2.0), CavityShear::Streamers),
            (of(Parameters::new(2.0, 0.3, 10.0), &[(0.4, 1.0)], &[(0.6, 7.0)]), CavityShear::Full),
            (of(Parameters::new(1.0, 0.5, 40.0), &[(0.3, 1.0), (0.2, 20.0)], &[(0.5, 0.1)]), CavityShear::Streamers),
            (of(Parameters::new(1.0, 0.1, 20.0), &[], &[(0.5, 1.0), (0.5, 9.0)]), CavityShear::Full),
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
                let (flat, roller) = (friction.viscoelastic_flat(), friction.viscoelastic_roller);
                [flat, roller, friction.hydrodynamic(), friction.pressure]
            };
            let step = 2e-3_f64;
            let scaled = |theta: usize, steps: f64| friction(moved(&case, theta, (steps * step).exp()));
            let scale = friction(case.clone());
            for theta in 0..5 {
                let ([a, b], [c, d]) = ([-2.0, -1.0].map(|n| scaled(theta, n)), [1.0, 2.0].map(|n| scaled(theta, n)));
                let forces = [found.viscoelastic_flat, found.viscoelastic_roller, found.hydrodynamic, found.pressure];
                for (of, derivatives) in forces.into_iter().enumerate() {
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
