//! What each panel gives to the integrals of a solution, and how far two solutions differ panel by panel.

use std::f64::consts::{FRAC_PI_2, PI};

use super::displacement::Displacement;
use super::quantities::{Integrands, cavity_terms};
use super::state::State;
use crate::model::CavityShear;

/// What each panel gives to an integral.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// To F_v.
    viscoelastic: Vec<f64>,
    /// To P.
    pressure: Vec<f64>,
    /// To C, with the panels behind the outlet.
    shear: Vec<f64>,
    /// To the load, over the whole of it.
    load: Vec<f64>,
}

/// Sums over panels of the absolute differences of what two solutions have there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Of F_v.
    pub viscoelastic: f64,
    /// Of P.
    pub pressure: f64,
    /// Of C.
    pub shear: f64,
    /// Of the load, over the whole of it.
    pub load: f64,
}

impl Parts {
    /// The parts of a solution.
    pub fn of(
        displacement: &Displacement,
        beta: f64,
        state: &State,
        integrands: &Integrands,
        cavity_shear: CavityShear,
    ) -> Self {
        let discretisation = &displacement.discretisation;
        let degree = discretisation.reference.degree;
        let weights = &discretisation.weights[discretisation.film()];
        let Integrands { gradient, pressure, along } = integrands;
        let by_panel = |term: &dyn Fn(usize) -> f64| -> Vec<f64> {
            (0..weights.len()).step_by(degree).map(|first| (first..first + degree).map(term).sum()).collect()
        };
        let of_shear = 3.0 * PI * beta;
        let cavity = cavity_terms(displacement, state, &along.behind, cavity_shear);
        let mut shear = by_panel(&|i| weights[i] / (of_shear * state.film[i]));
        shear.extend(cavity.chunks_exact(degree).map(|terms| terms.iter().sum::<f64>() / of_shear));
        Self {
            viscoelastic: by_panel(&|i| weights[i] * pressure[i] * along.retarded_slope[i] / FRAC_PI_2),
            pressure: by_panel(&|i| weights[i] * gradient[i] * state.film[i] / PI),
            shear,
            load: by_panel(&|i| weights[i] * pressure[i] / FRAC_PI_2),
        }
    }

    /// How far another solution on the same panels differs.
    pub fn spread(&self, other: &Self) -> Spread {
        let sum = |of: fn(&Self) -> &[f64]| of(self).iter().zip(of(other)).map(|(a, b)| (a - b).abs()).sum();
        Spread {
            viscoelastic: sum(|parts| &parts.viscoelastic),
            pressure: sum(|parts| &parts.pressure),
            shear: sum(|parts| &parts.shear),
            load: sum(|parts| &parts.load),
        }
    }
}
