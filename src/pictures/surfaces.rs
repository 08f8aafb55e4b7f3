//! A quantity as height over α and β.

use super::axis::typeset;
use super::curves::{friction, named_columns};
use super::picture::{Chart, Picture};
use super::quantity::Quantity;
use super::reference_curves::is_large_beta;
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
    named_columns(sweep, request, &friction(sweep, request))
        .into_iter()
        .filter_map(|column| surface(sweep, request, &grid, &strengths, column).transpose())
        .collect()
}

fn surface(
    sweep: &SweepData,
    request: &Request,
    grid: &SurfaceGrid,
    strengths: &[usize],
    quantity: Quantity,
) -> Result<Option<Picture>, PictureError> {
    let mut panels: Vec<(String, Quantity, usize)> =
        strengths.iter().map(|i_f| (sweep.words(Axis::F, *i_f), quantity, *i_f)).collect();
    if let ([i_f], false) = (strengths, request.bare) {
        let limit = match quantity.column {
            Some(Column::MuV) => Some(("dry limit", Column::DryMuV)),
            Some(Column::MuH) => Some(("large-β approximation, where β is large", Column::ApproxMuH)),
            _ => None,
        };
        panels.extend(limit.map(|(label, column)| (label.to_owned(), column.into(), *i_f)));
    }
    let mut table = Table::new(&[&["quantity"], &sweep.coordinate_names()[..], &["value"]].concat());
    let mut drawn = Vec::new();
    for (label, column, i_f) in panels {
        let values = column.values(&sweep.data)?;
        let is_limit = column != quantity && column.column == Some(Column::ApproxMuH);
        let holds = |indices| !is_limit || sweep.parameters(indices).is_none_or(|case| is_large_beta(&case));
        let mut heights = Vec::new();
        for (indices, place) in grid.places(sweep, i_f) {
            let value = if holds(indices) { values[place] } else { f64::NAN };
            heights.push(Some(value).filter(|value| value.is_finite()));
            table.row(&[column.name], &[&sweep.coordinates(indices)[..], &[value]].concat());
        }
        if heights.iter().any(Option::is_some) {
            drawn.push(Surface3dPanel { label, heights, curves: vec![] });
        }
    }
    if drawn.is_empty() {
        return Ok(None);
    }
    let shown = drawn.iter().flat_map(|panel| panel.heights.iter().flatten());
    let unit = quantity.unit(sweep.data.laboratory, shown.fold(0.0, |most: f64, height| most.max(height.abs())));
    for height in drawn.iter_mut().flat_map(|panel| panel.heights.iter_mut().flatten()) {
        *height = unit.shown(*height);
    }
    let all = drawn.iter().flat_map(|panel| panel.heights.iter().flatten().copied());
    let logarithmic = request.scale.is_logarithmic(all);
    let (x_label, x) = on(sweep, Axis::Middle, grid.alphas(sweep));
    let (y_label, y) = on(sweep, Axis::Inner, grid.betas(sweep));
    let chart = Surface3d {
        title: sweep.data.title.clone(),
        subtitle: sweep.held().into_iter().chain(grid.left_out(sweep)).collect::<Vec<_>>().join(", "),
        x_label,
        y_label,
        z_label: unit.label(&quantity.title()),
        x,
        y,
        logarithmic,
        range: None,
        panels: drawn,
    };
    Ok(Some(Picture { name: format!("surface-{}", quantity.name), chart: Chart::Surface3d(chart), table }))
}

/// Symbol and unit of an axis, and its values in that unit.
fn on(sweep: &SweepData, axis: Axis, values: Vec<f64>) -> (String, Vec<f64>) {
    let words = sweep.axis(axis);
    let (unit, _) = words.shown(values.iter().copied());
    let label = if unit.name.is_empty() { words.symbol.clone() } else { format!("{} ({})", words.symbol, unit.name) };
    (typeset(&label), values.into_iter().map(|value| unit.shown(value)).collect())
}
