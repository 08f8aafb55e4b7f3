//! The retardation filter backwards: what a sum over its results takes of each value that goes into it.

use super::discretisation::Discretisation;
use super::retardation::RetardationFilter;

/// Weights of the values that go into the filter of one mode.
pub struct Taken<'a> {
    /// Of e relative to the outlet at the rows.
    pub e: &'a mut [f64],
    /// Of p at the nodes, by way of v ahead of the mesh.
    pub pressure: &'a mut [f64],
}

impl RetardationFilter {
    /// Adds what Σ `slope` v′ over the film's Gauss points and Σ `behind` (v − v(0)) over those behind the outlet take
    /// of what goes into the filter: the transpose of [`RetardationFilter::slope`] and [`RetardationFilter::behind`].
    /// The filter runs from right to left, so this runs from left to right. `behind` may be empty.
    pub fn transposed(&self, discretisation: &Discretisation, slope: &[f64], behind: &[f64], taken: Taken<'_>) {
        let degree = discretisation.reference.degree;
        let first = discretisation.film().start;
        // of v and v′ at the left end of the panel in hand
        let mut v = self.behind_transposed(discretisation, behind, taken.e);
        let mut steep = 0.0;
        for (index, panel) in self.panels.iter().enumerate().skip(first / degree) {
            let (left, right) = discretisation.ends(index);
            let slope = &slope[index * degree - first..(index + 1) * degree - first];
            let on_panel = &mut taken.e[index * degree..(index + 1) * degree];
            let mut ends = [0.0; 2];
            let (mut handed_on, mut steep_handed_on) = (panel.decay[degree] * v, 0.0);
            panel.displacement.add_transposed(degree, v, on_panel, &mut ends);
            let values = || slope.iter().copied().chain([steep]).enumerate();
            match &panel.slope {
                Some(weights) => {
                    for (i, value) in values() {
                        steep_handed_on += panel.decay[i] * value;
                        weights.add_transposed(i, value, on_panel, &mut ends);
                    }
                }
                None => {
                    for (i, value) in values() {
                        let value = self.alpha() * value;
                        handed_on += panel.decay[i] * value;
                        panel.displacement.add_transposed(i, value, on_panel, &mut ends);
                        match on_panel.get_mut(i) {
                            Some(e) => *e -= value,
                            None => ends[0] -= value,
                        }
                    }
                }
            }
            taken.e[left] += ends[0];
            taken.e[right] += ends[1];
            (v, steep) = (handed_on, steep_handed_on);
        }
        // v′ = α(v − e) at Y
        v += self.alpha() * steep;
        taken.e[discretisation.ends(self.panels.len() - 1).1] -= self.alpha() * steep;
        for (sum, weight) in taken.pressure.iter_mut().zip(&self.ahead) {
            *sum += v * weight;
        }
    }

    /// The part behind the outlet; what it takes of v(0) − e(0).
    fn behind_transposed(&self, discretisation: &Discretisation, behind: &[f64], e: &mut [f64]) -> f64 {
        let degree = discretisation.reference.degree;
        let (mut outlet, mut v) = (0.0, 0.0);
        for (index, values) in behind.chunks_exact(degree).enumerate() {
            let panel = &self.panels[index];
            let (left, right) = discretisation.ends(index);
            let on_panel = &mut e[index * degree..(index + 1) * degree];
            let (mut ends, mut handed_on) = ([0.0; 2], 0.0);
            for (i, value) in values.iter().copied().chain([v]).enumerate() {
                handed_on += panel.decay[i] * value;
                panel.displacement.add_transposed(i, value, on_panel, &mut ends);
                // constants pass: what the panel takes of one is 1 less what it takes of what is handed on
                outlet -= (1.0 - panel.decay[i]) * value;
            }
            e[left] += ends[0];
            e[right] += ends[1];
            v = handed_on;
        }
        outlet
    }
}
