//! A quantity as height over α and β.

use super::curves::{friction, named_columns};
use super::picture::{Chart, Picture};
use super::quantity::Quantity;
use super::request::{Kind, Request, Selection, spread};
use super::surface_grid::SurfaceGrid;
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{Surface3d, Surface3dPanel};
use stribeck_sweep::Column;

/// Most surfaces side by side.
const MOST_PANELS: usize = 3;

/// A surface for each column asked for; the values of f stand side by side.
///
/// One surface alone of μᵥ has its dry limit beside it, one of μₕ its large-β approximation.
pub(super) fn surfaces(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let selection = Selection::of(sweep, request)?;
    let grid = SurfaceGrid::of(sweep, &selection, Kind::Surfaces)?;
    let retarded: Vec<usize> = selection.on(Axis::F).to_vec();
    let asked = selection.is_asked(Axis::F);
    // At f = 0 a surface is a cylinder over α: shown if asked for, or if there is nothing else.
    let varied: Vec<usize> =
        retarded.iter().copied().filter(|i_f| sweep.data.laboratory || sweep.point([*i_f, 0, 0])[0] > 0.0).collect();
    let strengths = if asked || varied.is_empty() { retarded } else { spread(&varied, MOST_PANELS) };
    if strengths.len() > MOST_PANELS {
        return Err(Kind::Surfaces
            .missing(format!("at most {MOST_PANELS} surfaces have room side by side; give fewer values with --f")));
    }
    named_columns(request, &friction(sweep, request))
        .into_iter()
        .filter_map(|column| surface(sweep, request, &grid, &strengths, column).transpose())
        .collect()
}

fn surface(
    sweep: &SweepData,
    request: &Request,
    grid: &SurfaceGrid,
    strengths: &[usize],
    column: Column,
) -> Result<Option<Picture>, PictureError> {
    let quantity = Quantity::from(column);
    let mut panels: Vec<(String, Column, usize)> =
        strengths.iter().map(|i_f| (sweep.words(Axis::F, *i_f), column, *i_f)).collect();
    if let ([i_f], false) = (strengths, request.bare) {
        let limit = match column {
            Column::MuV => Some(("dry limit", Column::DryMuV)),
            Column::MuH => Some(("large-β approximation", Column::ApproxMuH)),
            _ => None,
        };
        panels.extend(limit.map(|(label, column)| (label.to_owned(), column, *i_f)));
    }
    let mut table = Table::new(&[&["quantity"], &sweep.coordinate_names()[..], &["value"]].concat());
    let mut drawn = Vec::new();
    for (label, column, i_f) in panels {
        let values = sweep.data.column(column)?;
        let heights: Vec<Option<f64>> =
            grid.places(sweep, i_f).map(|(_, place)| Some(values[place]).filter(|value| value.is_finite())).collect();
        for (indices, place) in grid.places(sweep, i_f) {
            table.row(&[column.name()], &[&sweep.coordinates(indices)[..], &[values[place]]].concat());
        }
        if heights.iter().any(Option::is_some) {
            drawn.push(Surface3dPanel { label, heights, curves: vec![] });
        }
    }
    if drawn.is_empty() {
        return Ok(None);
    }
    let all = drawn.iter().flat_map(|panel| panel.heights.iter().flatten().copied());
    let logarithmic = request.scale.is_logarithmic(all);
    let chart = Surface3d {
        title: sweep.data.title.clone(),
        subtitle: grid.left_out(sweep),
        x_label: short_label(sweep, Axis::Middle),
        y_label: short_label(sweep, Axis::Inner),
        z_label: quantity.label(sweep.data.laboratory),
        x: grid.alphas(sweep),
        y: grid.betas(sweep),
        logarithmic,
        range: None,
        panels: drawn,
    };
    Ok(Some(Picture { name: format!("surface-{}", column.name()), chart: Chart::Surface3d(chart), table }))
}

/// Symbol and unit of an axis.
fn short_label(sweep: &SweepData, axis: Axis) -> String {
    let words = sweep.axis(axis);
    if words.unit.is_empty() { words.symbol.clone() } else { format!("{} ({})", words.symbol, words.unit) }
}
