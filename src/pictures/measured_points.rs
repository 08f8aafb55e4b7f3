//! Measured points over the curves of a quantity.

use super::curve_family::CurveFamily;
use super::curves::Look;
use super::quantity::Quantity;
use super::sweep_data::SweepData;
use super::table::Table;
use stribeck_charts::{Colour, Curve, Stroke};
use stribeck_lab::Measured;
use stribeck_sweep::Column;

/// The measured points of a column that belong to the curves of a family, with their standard errors: those that were
/// measured along its axis, and whose other coordinates, as far as the file has them, are those of a member.
///
/// Points that belong to one member of several have its colour and mark, which the legend shows. The table gets a row
/// for each, and one for its error.
pub(super) fn measured_points(
    sweep: &SweepData,
    family: &CurveFamily,
    column: Quantity,
    looks: &[Look],
    table: &mut Table,
) -> Vec<Curve> {
    let Some((measured, label)) =
        sweep.measured.as_ref().and_then(|measured| Some((measured, label(measured, column)?)))
    else {
        return Vec::new();
    };
    let Some(along) = measured.coordinate(&sweep.axis(family.along).name) else { return Vec::new() };
    let mut curves = Vec::new();
    let family_is_known = belongs_by(sweep, measured, family);
    for (i, member) in family.members.iter().enumerate() {
        let here: Vec<usize> = (0..along.len()).filter(|row| belongs(sweep, measured, family, *member, *row)).collect();
        if here.is_empty() {
            continue;
        }
        let black = Look { colour: Colour::Black, mark: 0 };
        let look = if family.members.len() > 1 && family_is_known { looks[i] } else { black };
        let curve = |points: Vec<(f64, f64)>, stroke, mark| Curve {
            label: String::new(),
            points,
            failed: vec![],
            stroke,
            colour: look.colour,
            mark,
        };
        for row in here.iter().copied() {
            add_rows(table, sweep, measured, row);
            if let Some(errors) = &measured.errors {
                let (x, mu, error) = (along[row], measured.friction[row], errors[row]);
                curves.push(curve(vec![(x, mu - error), (x, mu + error)], Stroke::Solid, None));
            }
        }
        let points = here.iter().map(|row| (along[*row], measured.friction[*row])).collect();
        curves.push(curve(points, Stroke::Points, Some(look.mark)));
        if look != black {
            let label = sweep.words(family.varied, *member);
            curves.push(Curve { label, points: vec![], ..curve(vec![], Stroke::Solid, Some(look.mark)) });
        }
        if !family_is_known {
            break;
        }
    }
    if !curves.is_empty() {
        let (label, points, failed) = (label.to_owned(), vec![], vec![]);
        curves.push(Curve { label, points, failed, stroke: Stroke::Points, colour: Colour::Black, mark: Some(0) });
    }
    curves
}

/// Adds a measured point to the table, and its standard error if it has one; a coordinate that the file lacks is NaN.
fn add_rows(table: &mut Table, sweep: &SweepData, measured: &Measured, row: usize) {
    let names = sweep.coordinate_names();
    let of = |name: &&str| measured.coordinate(name).map_or(f64::NAN, |values| values[row]);
    let coordinates: Vec<f64> = names.iter().map(of).collect();
    let mut add = |what, number| table.row(&[measured.column, what], &[&coordinates[..], &[number]].concat());
    add("measured", measured.friction[row]);
    if let Some(errors) = &measured.errors {
        add("standard error", errors[row]);
    }
}

/// What points are called in a picture of a column; none if they do not belong there. What an instrument reads is drawn
/// over the paper's total as well, and called what it is.
fn label(measured: &Measured, column: Quantity) -> Option<&'static str> {
    match measured.column {
        own if own == column.name => Some("measured"),
        drag if drag == Column::MuDrag.name() && column.column == Some(Column::MuTot) => Some("measured drag"),
        _ => None,
    }
}

/// True if the file says to which member of the family a point belongs.
fn belongs_by(sweep: &SweepData, measured: &Measured, family: &CurveFamily) -> bool {
    let names = sweep.dimension_names(family.varied);
    names.iter().any(|name| measured.coordinate(name).is_some())
}

/// True if a point's coordinates but that along the curve are those of a member.
fn belongs(sweep: &SweepData, measured: &Measured, family: &CurveFamily, member: usize, row: usize) -> bool {
    let indices = family.at(member, family.points[0]);
    let along = &sweep.axis(family.along).name;
    let fixed = sweep.data.fixed.iter().map(|(name, value)| (name.as_str(), *value));
    let known = sweep.coordinate_names().into_iter().zip(sweep.coordinates(indices)).chain(fixed);
    known.filter(|(name, _)| name != along).all(|(name, value)| match measured.coordinate(name) {
        // What follows from the quantities of the laboratory changes along the curve.
        Some(_) if sweep.data.laboratory && (name == "alpha" || name == "beta") => true,
        Some(values) => Measured::is_same(values[row], value),
        None => true,
    })
}
