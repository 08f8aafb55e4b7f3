//! Adapts the mesh: the panels that a solution needs.

use std::sync::Arc;

use super::discretisation::film_points;
use super::log_moments::MOST_MOMENTS;
use super::mesh::Mesh;
use super::reference::ReferencePanel;
use super::scaling::layer;
use super::state::State;
use crate::model::Parameters;

/// How fast the size of panels may change along y: neighbours differ by a factor of e^GRADING at most.
const GRADING: f64 = 1.7;
/// Indicators fall about as the (d/CONVERGENCE)-th power of the size of a panel: more slowly than the d-th, because the
/// peaks that matter are only just resolved.
const CONVERGENCE: f64 = 1.7;
/// The largest length of the first panel over the length of the layer at the outlet; smaller in states whose
/// pressure dipped below zero there.
pub const OUTLET_PANEL: f64 = 8.0;
/// The largest length of panels at the inlet over the length of the layer.
const INLET_PANEL: f64 = 8.0;
/// The shortest layer that a mesh is made for; films of shorter ones are too thin to be told from rounding.
const SHORTEST_LAYER: f64 = 1e-12;
/// The smallest indicator that counts; below it is rounding.
const LEAST: f64 = 1e-15;

/// How long panels may be where the film leaves and enters the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Longest {
    /// Longest panel at the outlet.
    pub at_outlet: f64,
    /// Longest panel at the inlet.
    pub at_inlet: f64,
}

impl Longest {
    /// As the layers of a state allow.
    pub fn of(parameters: &Parameters, state: &State) -> Self {
        let layer = layer(parameters, state.c);
        Self { at_outlet: state.outlet_panel * layer, at_inlet: INLET_PANEL * layer.max(SHORTEST_LAYER) }
    }
}

/// How many panels a new mesh has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Panels {
    /// This number, or the fewest panels whose sizes change gradually.
    Number(usize),
    /// The number with which each panel has this indicator.
    Indicator(f64),
}

/// How badly each panel resolves its part of a state.
///
/// The larger of the last two Legendre coefficients of p, over the largest p; plus the same of ln u, times the part of
/// ∫ dx/u, that is of the shear, that lies on the panel.
pub fn indicators(reference: &ReferencePanel, state: &State) -> Vec<f64> {
    let (degree, size) = (reference.degree, reference.degree + 1);
    let largest = state.pressure.iter().fold(0.0, |a: f64, p| a.max(p.abs()));
    let panels = state.mesh.film.windows(2).zip(state.film.chunks_exact(degree));
    let shear = |(ends, film): (&[f64], &[f64])| -> f64 {
        film.iter().zip(&reference.weights).map(|(u, weight)| 0.5 * (ends[1] - ends[0]) * weight / u).sum()
    };
    let whole_shear: f64 = panels.clone().map(shear).sum();
    let mut coefficients = [0.0; MOST_MOMENTS];
    let mut logarithms = [0.0; MOST_MOMENTS];
    let mut indicator = |(panel, (ends, film)): (usize, (&[f64], &[f64]))| {
        let nodes = &state.pressure[panel * degree..panel * degree + size];
        reference.coefficients_of_nodes(nodes, &mut coefficients[..size]);
        let pressure = last_two(&coefficients[..size]) / largest;
        for (ln, u) in logarithms.iter_mut().zip(film) {
            *ln = u.ln();
        }
        reference.coefficients_of_points(&logarithms[..degree], &mut coefficients[..degree]);
        let share = shear((ends, film)) / whole_shear;
        (pressure + share * last_two(&coefficients[..degree])).max(LEAST)
    };
    panels.enumerate().map(&mut indicator).collect()
}

fn last_two(coefficients: &[f64]) -> f64 {
    let count = coefficients.len();
    coefficients[count - 1].abs().max(coefficients[count - 2].abs())
}

/// Where the film begins to grow towards the inlet: the last place with less than twice c.
fn inlet(reference: &ReferencePanel, state: &State) -> f64 {
    let last = state.film.iter().rposition(|&u| u < 2.0 * state.c).unwrap_or(0);
    film_points(reference, &state.mesh).nth(last).unwrap_or(0.0)
}

/// The length of the panel where the film enters the contact.
pub fn panel_at_inlet(reference: &ReferencePanel, state: &State) -> f64 {
    let inlet = inlet(reference, state);
    let ends = state.mesh.film.windows(2).find(|ends| inlet <= ends[1]);
    ends.map_or(0.0, |ends| ends[1] - ends[0])
}

/// A mesh from 0 to `reach` on which each panel of the state would have the same indicator; sizes change gradually
/// along y.
///
/// The film leaves and enters the contact over short lengths. If they are not resolved the solution oscillates all over
/// the contact, and the indicators no longer tell where that came from; so panels there are never `longest` or more.
pub fn equidistributed(
    reference: &ReferencePanel,
    state: &State,
    panels: Panels,
    reach: f64,
    longest: Longest,
) -> Arc<Mesh> {
    let exponent = CONVERGENCE / reference.degree as f64;
    let old = &state.mesh.film;
    // the size at which the indicator would be 1, at the ends of the old panels
    let mut wanted = vec![f64::INFINITY; old.len()];
    for (panel, indicator) in indicators(reference, state).into_iter().enumerate() {
        let size = (old[panel + 1] - old[panel]) * indicator.powf(-exponent);
        wanted[panel] = wanted[panel].min(size);
        wanted[panel + 1] = wanted[panel + 1].min(size);
    }
    let kept = old.iter().take_while(|&&end| end < reach).count();
    let mut ends: Vec<f64> = old[..kept].iter().copied().chain([reach]).collect();
    wanted.resize(kept, 0.0);
    wanted.push(f64::INFINITY);

    // sizes are linear between these places: what is short at the inlet alone needs a place there
    let inlet = inlet(reference, state);
    let after = ends.partition_point(|&end| end < inlet);
    if (1..ends.len()).contains(&after) && inlet < ends[after] {
        wanted.insert(after, wanted[after - 1].min(wanted[after]));
        ends.insert(after, inlet);
    }
    let longest_at = |y: &f64| {
        let (from_outlet, from_inlet) = (GRADING * y, GRADING * (y - inlet).abs());
        f64::min(longest.at_outlet + from_outlet, longest.at_inlet + from_inlet)
    };
    let longest: Vec<f64> = ends.iter().map(longest_at).collect();
    let count_at = |ln_factor: f64| Sizes::graded(&ends, &wanted, &longest, ln_factor.exp()).count();
    let (number, ln_factor) = match panels {
        Panels::Indicator(indicator) => {
            let ln_factor = exponent * indicator.ln();
            (count_at(ln_factor).ceil().max(4.0), ln_factor)
        }
        Panels::Number(number) => {
            // the factor on all sizes that leads to the wanted number
            let (mut low, mut high) = (-60.0, 20.0);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if count_at(middle) > number as f64 { low = middle } else { high = middle }
            }
            // with fewer panels than gradual sizes need, neighbours would differ too much
            (f64::max(number as f64, count_at(high).ceil()), high)
        }
    };
    let film = Sizes::graded(&ends, &wanted, &longest, ln_factor.exp()).divide(number as usize);
    Mesh::new(reference.degree, state.mesh.growth, film)
}

/// The wanted size of panels, linear between given places.
struct Sizes<'a> {
    places: &'a [f64],
    sizes: Vec<f64>,
}

impl<'a> Sizes<'a> {
    /// A factor times the wanted sizes, but no longer than the longest and growing no faster than [`GRADING`].
    fn graded(places: &'a [f64], wanted: &[f64], longest: &[f64], factor: f64) -> Self {
        let mut sizes: Vec<f64> =
            wanted.iter().zip(longest).map(|(size, longest)| longest.min(factor * size)).collect();
        for i in 1..sizes.len() {
            sizes[i] = sizes[i].min(sizes[i - 1] + GRADING * (places[i] - places[i - 1]));
        }
        for i in (1..sizes.len()).rev() {
            sizes[i - 1] = sizes[i - 1].min(sizes[i] + GRADING * (places[i] - places[i - 1]));
        }
        Self { places, sizes }
    }

    /// The number of panels: ∫ dy/size.
    fn count(&self) -> f64 {
        (0..self.places.len() - 1).map(|interval| self.between(interval)).sum()
    }

    /// ∫ dy/size between two places.
    fn between(&self, interval: usize) -> f64 {
        let length = self.places[interval + 1] - self.places[interval];
        let (a, b) = (self.sizes[interval], self.sizes[interval + 1]);
        let growth = (b - a) / a;
        if growth.abs() < 1e-6 { length / a } else { length / (b - a) * growth.ln_1p() }
    }

    /// Ends of a number of panels, each with the same ∫ dy/size.
    fn divide(&self, number: usize) -> Vec<f64> {
        let last = self.places.len() - 1;
        let each = self.count() / number as f64;
        let mut ends = Vec::with_capacity(number + 1);
        ends.push(self.places[0]);
        let (mut interval, mut passed) = (0, 0.0);
        for i in 1..number {
            let target = each * i as f64;
            while interval + 1 < last && passed + self.between(interval) < target {
                passed += self.between(interval);
                interval += 1;
            }
            ends.push(self.places[interval] + self.reached(interval, target - passed));
        }
        ends.push(self.places[last]);
        ends
    }

    /// How far beyond a place ∫ dy/size reaches a number.
    fn reached(&self, interval: usize, number: f64) -> f64 {
        let length = self.places[interval + 1] - self.places[interval];
        let a = self.sizes[interval];
        let slope = (self.sizes[interval + 1] - a) / length;
        let y = if (slope * number).abs() < 1e-6 { a * number } else { a / slope * (slope * number).exp_m1() };
        y.clamp(0.0, length)
    }
}

#[cfg(test)]
mod tests {
    use super::super::displacement::Displacement;
    use super::super::thick_film;
    use super::super::timings::Timings;
    use super::*;
    use crate::model::{DisplacementKernel, Parameters};

    fn thick_film_state(reference: &Arc<ReferencePanel>) -> State {
        let mut displacement = Displacement::new(reference);
        let kernel = DisplacementKernel::new(&Parameters::elastic(1.0));
        displacement.set_mesh(&thick_film::mesh(reference.degree, 3.0, 1.0, 300.0), &kernel, &mut Timings::default());
        thick_film::state(&displacement, 1.0)
    }

    /// From 0 to the reach, as many panels as asked for, neighbours not too different, and none longer than the layer
    /// lets it be at the outlet.
    #[test]
    fn a_mesh_keeps_its_promises() {
        let reference = Arc::new(ReferencePanel::new(8));
        let state = thick_film_state(&reference);
        for panels in [6, 9, 15, 40] {
            for reach in [100.0, 300.0, 900.0] {
                for layer in [f64::INFINITY, 1e-3] {
                    let longest = Longest { at_outlet: layer, at_inlet: layer };
                    let mesh = equidistributed(&reference, &state, Panels::Number(panels), reach, longest);
                    assert_eq!((mesh.film[0], mesh.reach()), (0.0, reach));
                    assert!(mesh.film.windows(2).all(|ends| ends[0] < ends[1]), "{:?}", mesh.film);
                    let fewest = equidistributed(&reference, &state, Panels::Number(1), reach, longest).panels();
                    assert_eq!(mesh.panels(), panels.max(fewest));
                    let sizes: Vec<f64> = mesh.film.windows(2).map(|ends| ends[1] - ends[0]).collect();
                    let most = (1.01 * GRADING).exp();
                    for pair in sizes.windows(2) {
                        assert!(pair[0] / pair[1] < most && pair[1] / pair[0] < most, "{sizes:?}");
                    }
                }
            }
        }
    }

    /// On its own mesh for a number of panels a state comes near to the same indicator everywhere.
    #[test]
    fn panels_share_the_indicator() {
        let reference = Arc::new(ReferencePanel::new(8));
        let mut state = thick_film_state(&reference);
        let spread = |state: &State| {
            let near = indicators(&reference, state);
            let (least, most) = near.iter().fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), &i| (a.min(i), b.max(i)));
            most / least
        };
        let before = spread(&state);
        let free = Longest { at_outlet: f64::INFINITY, at_inlet: f64::INFINITY };
        for _ in 0..3 {
            let mesh = equidistributed(&reference, &state, Panels::Number(14), 300.0, free);
            state = state.on(&reference, &mesh);
        }
        assert!(spread(&state) < 0.3 * before, "{before:e} {:e}", spread(&state));
    }
}
