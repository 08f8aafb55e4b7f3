//! Derivatives of the retarded displacement of one mode with respect to the mode's rate.

use super::discretisation::Discretisation;
use super::reference::dot;
use super::retardation::{PanelFilter, RetardationFilter, far_field};
use crate::model::retarded_mode_derivative;

/// α times the derivative of a [`RetardationFilter`] with respect to α (T50).
pub struct FilterDerivatives {
    panels: Vec<PanelFilter>,
    ahead: Vec<f64>,
}

/// α times derivatives with respect to α along the mesh, at one pressure.
pub struct RetardationDerivatives {
    /// Derivatives of v − v(0) at the film's Gauss points.
    pub film: Vec<f64>,
    /// Derivatives of v′ at the same points.
    pub slope: Vec<f64>,
    /// Derivatives of v − v(0) at the Gauss points behind the outlet.
    pub behind: Vec<f64>,
}

impl FilterDerivatives {
    /// The derivatives of the filter of a mode of rate α on a mesh.
    pub fn new(discretisation: &Discretisation, alpha: f64) -> Self {
        let mesh = &discretisation.mesh;
        let ends = mesh.behind.windows(2).chain(mesh.film.windows(2));
        let panel =
            |ends: &[f64]| PanelFilter::derivatives(&discretisation.reference, alpha, 0.5 * (ends[1] - ends[0]));
        let ahead = far_field(discretisation, mesh.reach(), |x| retarded_mode_derivative(alpha, x));
        Self { panels: ends.map(panel).collect(), ahead }
    }

    /// The derivatives of one solution: `e` is its elastic displacement relative to the outlet at the rows, `pressure`
    /// its pressure at the nodes.
    pub fn along(
        &self,
        filter: &RetardationFilter,
        discretisation: &Discretisation,
        e: &[f64],
        pressure: &[f64],
    ) -> RetardationDerivatives {
        let (alpha, degree) = (filter.alpha(), discretisation.reference.degree);
        let first = discretisation.film().start;
        let points = discretisation.film_points();
        let (mut film, mut slope) = (vec![0.0; points], vec![0.0; points]);
        // what is handed on: v and v′, and their derivatives
        let (mut v, mut derivative) = (dot(&filter.ahead, pressure), dot(&self.ahead, pressure));
        let mut steep = alpha * (v - e[discretisation.ends(self.panels.len() - 1).1]);
        let mut steep_derivative = steep + alpha * derivative;
        for (index, (panel, derivatives)) in
            filter.panels.iter().zip(&self.panels).enumerate().skip(first / degree).rev()
        {
            let (on_panel, ends) = discretisation.on_panel(e, index);
            let at = |i: usize| panel.decay[i] * v + panel.displacement.apply(i, on_panel, ends);
            let derivative_at = |i: usize| {
                panel.decay[i] * derivative
                    + derivatives.decay[i] * v
                    + derivatives.displacement.apply(i, on_panel, ends)
            };
            let e_at = |i: usize| if i < degree { on_panel[i] } else { ends[0] };
            let slope_at = |i: usize| match &panel.slope {
                Some(weights) => panel.decay[i] * steep + weights.apply(i, on_panel, ends),
                None => alpha * (at(i) - e_at(i)),
            };
            let slope_rate_at = |i: usize| match &derivatives.slope {
                Some(weights) => {
                    panel.decay[i] * steep_derivative + derivatives.decay[i] * steep + weights.apply(i, on_panel, ends)
                }
                // of α(v − e)
                None => slope_at(i) + alpha * derivative_at(i),
            };
            for i in 0..degree {
                film[index * degree - first + i] = derivative_at(i);
                slope[index * degree - first + i] = slope_rate_at(i);
            }
            (v, derivative, steep, steep_derivative) =
                (at(degree), derivative_at(degree), slope_at(degree), slope_rate_at(degree));
        }
        for value in &mut film {
            *value -= derivative;
        }
        RetardationDerivatives { film, slope, behind: self.behind(filter, discretisation, e, v, derivative) }
    }

    /// Behind the outlet; `outlet` is v(0) − e(0) and `outlet_derivative` its derivative. As
    /// [`RetardationFilter::behind`] filters e − v(0), a constant that grows by −`outlet_derivative` joins e.
    fn behind(
        &self,
        filter: &RetardationFilter,
        discretisation: &Discretisation,
        e: &[f64],
        outlet: f64,
        outlet_derivative: f64,
    ) -> Vec<f64> {
        let degree = discretisation.reference.degree;
        let mut values = vec![0.0; discretisation.behind().len()];
        let mut relative = vec![0.0; degree];
        let (mut handed_on, mut derivative) = (0.0, 0.0);
        for (index, values) in values.chunks_exact_mut(degree).enumerate().rev() {
            let (panel, derivatives) = (&filter.panels[index], &self.panels[index]);
            let (on_panel, ends) = discretisation.on_panel(e, index);
            for (relative, e) in relative.iter_mut().zip(on_panel) {
                *relative = e - outlet;
            }
            let ends = ends.map(|e| e - outlet);
            let derivative_at = |i: usize| {
                // constants pass: what the panel takes of one is 1 less what it takes of what is handed on
                panel.decay[i] * derivative
                    + derivatives.decay[i] * handed_on
                    + derivatives.displacement.apply(i, &relative, ends)
                    - (1.0 - panel.decay[i]) * outlet_derivative
            };
            for (i, value) in values.iter_mut().enumerate() {
                *value = derivative_at(i);
            }
            let left = panel.decay[degree] * handed_on + panel.displacement.apply(degree, &relative, ends);
            (handed_on, derivative) = (left, derivative_at(degree));
        }
        values
    }
}
