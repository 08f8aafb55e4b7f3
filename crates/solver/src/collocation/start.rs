//! The start from the table: a first guess at any case from the solutions around it.

use super::reference::ReferencePanel;
use super::scaling::Scaling;
use super::starting_solutions::{Node, around, node};
use super::state::State;
use crate::exact::DryContact;
use crate::model::Parameters;

/// Contact times, over that of passing the half width, between which the modes of a substrate count as retardation:
/// those that are faster are relaxed, those that are slower frozen.
const FASTEST: f64 = 0.1;
const SLOWEST: f64 = 10.0;

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
    /// The case itself if it has one retardation time. With several, the one that creeps as much up to the
    /// contact time and from there on; the elastic limits are elastic cases.
    pub fn of(parameters: &Parameters) -> Self {
        let modes = parameters.retardation();
        let compliance = |time: f64| {
            let crept: f64 = modes.iter().map(|mode| -mode.strength * (-mode.rate * time).exp_m1()).sum();
            (1.0 + crept) * parameters.instantaneous_compliance()
        };
        let (relaxed, alpha, f) = match modes.as_slice() {
            [] if parameters.is_relaxed_elastic() => (1.0, f64::INFINITY, 0.0),
            [] => (parameters.instantaneous_compliance(), f64::INFINITY, 0.0),
            [mode] => (1.0, mode.rate, parameters.f),
            _ => {
                let mut time = 1.0;
                for _ in 0..3 {
                    time = compliance(time).sqrt();
                }
                let (instantaneous, relaxed) = (compliance(FASTEST * time), compliance(SLOWEST * time));
                // J(t) = J∞ − (J∞ − J₀) exp(−αt)
                let left = (relaxed - compliance(time)) / (relaxed - instantaneous);
                (relaxed, -left.ln() / time, relaxed / instantaneous - 1.0)
            }
        };
        let length = relaxed.sqrt();
        let case = Parameters::new(alpha * length, parameters.beta * relaxed, f);
        let half_width = DryContact::new(case.alpha, case.f).half_width();
        Self { case, length, half_width }
    }
}

/// A guess at a case from the nodes around it, on the panels of the nearest one: each rescaled to the case, pressures
/// and logarithms of films interpolated. Panels are those of the table.
pub fn guess(reference: &ReferencePanel, growth: f64, parameters: &Parameters) -> State {
    let Equivalent { case, length, half_width } = Equivalent::of(parameters);
    let to = Scaling::new(half_width, case.beta);
    let rescaled = |index: usize| {
        let Node { half_width, beta, state } = node(index, growth);
        State { error: state.error, ..state.fitted(Scaling::new(half_width, beta), to) }
    };
    let mut nodes = around(&case, half_width);
    nodes.sort_by(|a, b| b.1.total_cmp(&a.1));
    let nearest = rescaled(nodes[0].0);
    let mut guess = nearest.clone();
    for &(index, weight) in &nodes[1..] {
        guess.add_difference(weight, &rescaled(index).on(reference, &nearest.mesh), &nearest);
    }
    State { error: nearest.error, ..if length == 1.0 { guess } else { guess.scaled(length) } }
}
