//! The start from the table: a first guess at any case from the solutions around it.

use std::sync::Arc;

use super::adaptation::{Longest, Panels, equidistributed};
use super::mesh::{Mesh, growth_behind};
use super::reference::ReferencePanel;
use super::scaling::Scaling;
use super::settings::Settings;
use super::solver::{BEHIND, CollocationSolver};
use super::starting_solutions::{SOLVED_WITH, around, node};
use super::state::State;
use crate::exact::DryContact;
use crate::model::Parameters;

/// Times, over that of passing the half width, between which the creep of several modes counts as retardation: what is
/// faster counts as relaxed, what is slower as frozen.
const FASTEST: f64 = 0.03;
const SLOWEST: f64 = 30.0;
/// The estimated error over the tolerance that the first mesh is made for. It is less than that of later ones, for a
/// guess is not a solution: one case in twenty gets a second mesh.
const AIM: f64 = 0.08;
/// Errors of nodes below this one are taken as it: something else asked for their panels.
const LEAST_ERROR: f64 = 0.02;

/// A case with one retardation time whose solution is like that of another case.
pub struct Equivalent {
    /// The case.
    pub case: Parameters,
    /// Lengths of the other case over those of this one.
    pub length: f64,
    /// ā of the case.
    pub half_width: f64,
}

impl Equivalent {
    /// The case itself if it has one retardation time. With several, the one that has crept as much at three times, of
    /// which the middle one is that of passing the half width. The elastic limits are elastic cases.
    pub fn of(parameters: &Parameters) -> Self {
        let modes = parameters.retardation();
        let compliance = |time: f64| {
            let crept: f64 = modes.iter().map(|mode| -mode.strength * (-mode.rate * time).exp_m1()).sum();
            (1.0 + crept) * parameters.instantaneous_compliance()
        };
        let (relaxed, alpha, f) = match modes.as_slice() {
            [] if parameters.is_relaxed_elastic() => (1.0, f64::INFINITY, 0.0),
            [] => (parameters.instantaneous_compliance(), f64::INFINITY, 0.0),
            [mode, others @ ..] if others.iter().all(|other| other.rate == mode.rate) => (1.0, mode.rate, parameters.f),
            _ => {
                let time = (0..3).fold(1.0, |time, _| compliance(time).sqrt());
                let (instantaneous, relaxed) = (compliance(FASTEST * time), compliance(SLOWEST * time));
                // J(t) = J∞ − (J∞ − J₀) exp(−αt)
                let left = (relaxed - compliance(time)) / (relaxed - instantaneous);
                if left > 0.0 && left < 1.0 {
                    (relaxed, -left.ln() / time, relaxed / instantaneous - 1.0)
                } else {
                    (relaxed, f64::INFINITY, 0.0)
                }
            }
        };
        let length = relaxed.sqrt();
        let case = Parameters::new(alpha * length, parameters.beta * relaxed, f);
        let half_width = DryContact::new(case.alpha, case.f).half_width();
        Self { case, length, half_width }
    }
}

/// A state from the nodes around a case.
struct Guess {
    /// It, on the panels of the nearest node.
    state: State,
    /// Panels with which the error would be the tolerance of the table.
    panels: f64,
}

impl Guess {
    /// Nodes are rescaled to the case; pressures and logarithms of films are interpolated.
    fn new(reference: &ReferencePanel, growth: f64, parameters: &Parameters) -> Self {
        let Equivalent { case, length, half_width } = Equivalent::of(parameters);
        let to = Scaling::new(half_width, case.beta);
        let mut around = around(&case, half_width);
        around.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut nodes = around.iter().map(|&(index, weight)| (node(index, growth), weight)).map(|(node, weight)| {
            let state = node.state.fitted(Scaling::new(node.half_width, node.beta), to);
            let factor = node.error.max(LEAST_ERROR).powf(1.0 / (1.5 * reference.degree as f64));
            (state, weight, weight * factor * node.state.mesh.panels() as f64)
        });
        let (nearest, _, mut panels) = nodes.next().expect("a case has a nearest node");
        let mut state = nearest.clone();
        for (other, weight, of_node) in nodes {
            state.add_difference(weight, &other.on(reference, &nearest.mesh), &nearest);
            panels += of_node;
        }
        Self { state: if length == 1.0 { state } else { state.scaled(length) }, panels }
    }
}

impl CollocationSolver {
    /// A guess at a case from the table, on panels for the tolerance.
    pub(super) fn guess_from_table(&self, parameters: &Parameters, reach: f64) -> State {
        let Settings { degree, tolerance } = self.settings;
        let Guess { state, panels } = Guess::new(&self.of_table, growth_behind(degree, BEHIND * tolerance), parameters);
        // as many panels of this degree have this error, about; fewer are too rough for any tolerance
        let alike = SOLVED_WITH.tolerance.powf(degree as f64 / SOLVED_WITH.degree as f64);
        let panels = panels * (alike / (AIM * tolerance.min(alike))).powf(1.0 / (1.5 * degree as f64));
        let longest = Longest::of(parameters, &state);
        let mesh = equidistributed(&self.of_table, &state, Panels::Number(panels.round() as usize), reach, longest);
        let mesh = if degree == mesh.degree { mesh } else { Arc::new(Mesh { degree, ..(*mesh).clone() }) };
        state.with_degree(&self.of_table, &self.coarse, &mesh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{RetardationMode, Substrate};

    fn with_times(times: [f64; 2]) -> Parameters {
        let modes = times.map(|time| RetardationMode { share: 0.5, time });
        let substrate = Substrate::new(modes.to_vec()).expect("shares add up to 1");
        Parameters { substrate, ..Parameters::new(1.0, 100.0, 10.0) }
    }

    #[test]
    fn a_case_with_one_time_is_its_own_equivalent() {
        for case in [Parameters::new(0.3, 20.0, 5.0), Parameters::elastic(10.0)] {
            let Equivalent { case: found, length, .. } = Equivalent::of(&case);
            assert_eq!((found, length), (case, 1.0));
        }
        assert_eq!(Equivalent::of(&with_times([1.0, 1.0])).case, Parameters::new(1.0, 100.0, 10.0));
        let frozen = Equivalent::of(&Parameters::new(0.0, 110.0, 10.0));
        assert!((frozen.case.beta - 10.0).abs() < 1e-12 && frozen.case.f == 0.0);
    }

    /// Times that differ little are one; far apart, the fast mode is relaxed and the slow one frozen.
    #[test]
    fn several_times_become_one() {
        let near = Equivalent::of(&with_times([0.99, 1.01]));
        assert!((near.case.alpha / near.length - 1.0).abs() < 0.05 && near.case.f > 5.0, "{:?}", near.case);
        let far = Equivalent::of(&with_times([1e-6, 1e6]));
        assert!(far.case.f < 1e-3, "{:?}", far.case);
        assert!((far.length.powi(2) - 6.0 / 11.0).abs() < 1e-3, "half of the creep: {}", far.length);
    }
}
