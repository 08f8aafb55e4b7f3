//! Estimated errors of solutions: bars where they can be seen.

use super::PictureError;
use super::curve_family::CurveFamily;
use super::curves::Look;
use super::quantity::Quantity;
use super::sweep_data::SweepData;
use super::table::Table;
use stribeck_charts::{Curve, Stroke};
use stribeck_sweep::Column;

/// Half a bar over the height of the curves from which on it is drawn: about the width of a line.
const VISIBLE: f64 = 0.005;

/// What a curve is taken to span at least, in decades or over its value: bars of one that is constant are no news.
const FLAT: f64 = 0.01;

/// The estimated errors of a column at all places, in its unit; NaN where there is none, `None` where a column has
/// none.
///
/// That of μ_v is over μ_v, or over a thousandth of μ_tot at S = 1 where μ_v is below that.
pub(super) fn errors(sweep: &SweepData, quantity: Quantity) -> Result<Option<Vec<f64>>, PictureError> {
    let Some((column, error)) = quantity.column.and_then(|column| Some((column, column.error()?))) else {
        return Ok(None);
    };
    let (errors, mut scales) = (sweep.data.column(error)?, sweep.data.column(column)?);
    if column == Column::MuV {
        let (shear, pressure) = (sweep.data.column(Column::MuShear)?, sweep.data.column(Column::MuPressure)?);
        for (scale, (shear, pressure)) in scales.iter_mut().zip(shear.iter().zip(pressure)) {
            *scale = scale.abs().max(1e-3 * (*scale + shear + pressure).abs());
        }
    }
    Ok(Some(errors.iter().zip(scales).map(|(error, scale)| error * scale.abs()).collect()))
}

/// The largest estimated error of some columns, each over its largest value; `None` where none is known.
pub(super) fn largest(sweep: &SweepData, columns: &[Quantity]) -> Result<Option<f64>, PictureError> {
    let most = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut largest = 0.0;
    for column in columns {
        if let Some(errors) = errors(sweep, *column)? {
            // 0 over 0 is no error
            largest = f64::max(largest, most(&errors) / most(&column.values(&sweep.data)?));
        }
    }
    Ok(Some(largest).filter(|largest| *largest > 0.0))
}

/// The bars of the curves of a column, one curve for each member of the family that look so, in a picture whose
/// curves span `span` on its vertical axis. The table gets a row for each.
pub(super) fn error_bars(
    sweep: &SweepData,
    (family, column): (&CurveFamily, Quantity),
    looks: &[Look],
    (span, logarithmic): (f64, bool),
    table: &mut Table,
) -> Result<Vec<Curve>, PictureError> {
    let Some(errors) = errors(sweep, column)? else { return Ok(Vec::new()) };
    let values = column.values(&sweep.data)?;
    let mut bars = Vec::new();
    for (member, look) in family.members.iter().zip(looks) {
        for point in &family.points {
            let indices = family.at(*member, *point);
            let (x, place) = (sweep.value(family.along, *point), sweep.data.place(indices));
            let (value, error) = (values[place], errors[place]);
            let half = if logarithmic { (1.0 + error / value).log10() } else { error };
            let height = span.max(if logarithmic { FLAT } else { FLAT * value.abs() });
            if half.is_nan() || half <= VISIBLE * height {
                continue;
            }
            let least = if logarithmic { (value - error).max(1e-3 * value) } else { value - error };
            let points = vec![(x, least), (x, value + error)];
            let (label, failed, stroke, mark) = (String::new(), Vec::new(), Stroke::Solid, None);
            bars.push(Curve { label, points, failed, stroke, colour: look.colour, mark });
            table.row(&[column.name, "estimated error"], &[&sweep.coordinates(indices)[..], &[error]].concat());
        }
    }
    Ok(bars)
}
