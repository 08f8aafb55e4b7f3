//! Fields of a converged state at the points of the output, on the grid and beyond it.

use super::far_field::FarField;
use super::iteration::Iteration;
use crate::model::{Fields, Output};

/// The fields asked for. On the grid they are interpolated by cubics, which adds less than the scheme's own error;
/// beyond it the displacement is that of the pressure on the grid, and p falls as x⁻³ ahead and is zero behind.
///
/// `beyond` holds the points of the output that are not on the grid, in their order.
pub fn fields(state: &Iteration, beyond: &FarField, output: &Output) -> Fields {
    let grid = &state.shared.grid;
    let last = state.p.len() - 1;
    let wanted = output.fields;
    let mut fields = Fields::default();
    if wanted.pressure {
        let at = |x: f64| {
            if grid.contains(x) {
                grid.cubic(&state.p, x).max(0.0)
            } else if x > grid.x_max {
                state.p[last] * (grid.x_max / x).powi(3)
            } else {
                0.0
            }
        };
        fields.pressure = Some(output.x.iter().map(|&x| at(x)).collect());
    }
    if wanted.film_thickness || wanted.displacement {
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
        if wanted.film_thickness {
            let film = output.x.iter().zip(&displacement).map(|(x, w)| state.separation + 0.5 * x * x - w);
            fields.film_thickness = Some(film.collect());
        }
        if wanted.displacement {
            let level = state.level();
            fields.displacement = Some(displacement.into_iter().map(|w| w + level).collect());
        }
    }
    fields
}
