//! Fields of a converged state at the points of the output, on the grid and beyond it.

use std::f64::consts::FRAC_PI_2;

use super::far_field::FarField;
use super::iteration::Iteration;
use crate::model::{Fields, Lubricant, Output, shear_traction};

/// The fields asked for. On the grid they are interpolated by cubics, which adds less than the scheme's own error;
/// beyond it the displacement is that of the pressure on the grid, and p falls as x⁻³ ahead and is zero behind.
///
/// `beyond` holds the points of the output that are not on the grid, in their order.
pub fn fields(state: &Iteration, lubricant: &Lubricant, beyond: &FarField, output: &Output) -> Fields {
    let grid = &state.shared.grid;
    let last = state.p.len() - 1;
    let wanted = output.fields;
    let mut fields = Fields::default();
    let pressure = |x: f64| {
        if grid.contains(x) {
            grid.cubic(&state.p, x).max(0.0)
        } else if x > grid.x_max {
            state.p[last] * (grid.x_max / x).powi(3)
        } else {
            0.0
        }
    };
    if wanted.pressure {
        fields.pressure = Some(output.x.iter().map(|&x| pressure(x)).collect());
    }
    if wanted.hysteresis_traction {
        let slope = slope(state);
        // ahead of the grid the surface is as a load at one place bends it
        let slope = |x: f64| if grid.contains(x) { grid.cubic(&slope, x) } else { slope[last] * grid.x_max / x };
        fields.hysteresis_traction = Some(output.x.iter().map(|&x| pressure(x) * slope(x) / FRAC_PI_2).collect());
    }
    if wanted.film_thickness || wanted.displacement || wanted.shear_traction {
        let mut next_beyond = 0;
        let displacement: Vec<f64> = output
            .x
            .iter()
            .map(|&x| {
                if grid.contains(x) {
                    return grid.cubic(&state.w, x);
                }
                next_beyond += 1;
                beyond.displacement(next_beyond - 1, &state.p, state.tail_load)
            })
            .collect();
        let film = output.x.iter().zip(&displacement).map(|(x, w)| state.separation + 0.5 * x * x - w);
        let film: Vec<f64> = film.collect();
        if wanted.shear_traction {
            let shear = output.x.iter().zip(&film).map(|(&x, &u)| shear_traction(lubricant, x, u, 1.0));
            fields.shear_traction = Some(shear.collect());
        }
        fields.film_thickness = wanted.film_thickness.then_some(film);
        if wanted.displacement {
            let level = state.level();
            fields.displacement = Some(displacement.into_iter().map(|w| w + level).collect());
        }
    }
    fields
}

/// w′ at the points of the grid, by differences of second order.
fn slope(state: &Iteration) -> Vec<f64> {
    let (w, dx, last) = (&state.w, state.shared.grid.spacing(), state.w.len() - 1);
    let mut slope: Vec<f64> = w.windows(3).map(|w| (w[2] - w[0]) / (2.0 * dx)).collect();
    slope.insert(0, (w[1] - w[0]) / dx);
    slope.push((w[last] - w[last - 1]) / dx);
    slope
}
