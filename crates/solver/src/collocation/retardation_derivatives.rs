//! Derivatives of the retarded displacement of one mode with respect to the mode's rate.

use std::array::from_fn;

use super::discretisation::Discretisation;
use super::exponential_moments::{AtPlaces, NO_MOMENTS};
use super::panel_filter::{PanelFilter, Weights};
use super::reference::dot;
use super::retardation::{RetardationFilter, far_field};
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
        let mut room = NO_MOMENTS;
        let panel = |ends: &[f64]| {
            PanelFilter::derivatives(&discretisation.reference, alpha, 0.5 * (ends[1] - ends[0]), &mut room)
        };
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
            let v_at = panel.pass(v, on_panel, ends);
            let derivative_at =
                of_product([panel, derivatives], [v, derivative], &derivatives.displacement, on_panel, ends);
            let slope_at: AtPlaces = match &panel.slope {
                Some(weights) => panel.add_handed_on(steep, weights.apply(on_panel, ends)),
                None => from_fn(|i| alpha * (v_at[i] - on_panel.get(i).copied().unwrap_or(ends[0]))),
            };
            let slope_rate_at: AtPlaces = match &derivatives.slope {
                Some(weights) => of_product([panel, derivatives], [steep, steep_derivative], weights, on_panel, ends),
                // of α(v − e)
                None => from_fn(|i| slope_at[i] + alpha * derivative_at[i]),
            };
            let points = index * degree - first..(index + 1) * degree - first;
            film[points.clone()].copy_from_slice(&derivative_at[..degree]);
            slope[points].copy_from_slice(&slope_rate_at[..degree]);
            (v, derivative, steep, steep_derivative) =
                (v_at[degree], derivative_at[degree], slope_at[degree], slope_rate_at[degree]);
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
            let mut derivative_at =
                of_product([panel, derivatives], [handed_on, derivative], &derivatives.displacement, &relative, ends);
            for (value, decay) in derivative_at.iter_mut().zip(&panel.decay) {
                // constants pass: what the panel takes of one is 1 less what it takes of what is handed on
                *value -= (1.0 - decay) * outlet_derivative;
            }
            values.copy_from_slice(&derivative_at[..degree]);
            (handed_on, derivative) = (panel.pass(handed_on, &relative, ends)[degree], derivative_at[degree]);
        }
        values
    }
}

/// The derivative of what the places of a panel have, from the derivative of the weights of e: `panels` are the panel
/// and its derivative, `handed_on` what it is handed and the derivative of that.
fn of_product(
    panels: [&PanelFilter; 2],
    handed_on: [f64; 2],
    weights: &Weights,
    e: &[f64],
    ends: [f64; 2],
) -> AtPlaces {
    let ([panel, derivatives], [value, derivative]) = (panels, handed_on);
    panel.add_handed_on(derivative, derivatives.add_handed_on(value, weights.apply(e, ends)))
}
