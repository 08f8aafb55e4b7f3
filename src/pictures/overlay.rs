//! Measured points over the curves of a quantity.

use super::bundle::Bundle;
use super::source::Source;
use stribeck_charts::{Colour, Curve, Stroke};
use stribeck_lab::Measured;
use stribeck_sweep::Column;

/// The measured points of a column that belong to the curves of a bundle, with their standard errors: those that were measured
/// along its axis, and whose other coordinates, as far as the file has them, are those of a member.
///
/// Points that belong to one member of several have its colour.
pub(super) fn overlay(source: &Source, bundle: &Bundle, column: Column, colours: &[Colour]) -> Vec<Curve> {
    let Some(measured) = source.measured.as_ref().filter(|measured| measured.column == column.name()) else {
        return Vec::new();
    };
    let Some(along) = measured.coordinate(&source.axis(bundle.along).name) else { return Vec::new() };
    let mut curves = Vec::new();
    let family_is_known = belongs_by(source, measured, bundle);
    for (i, member) in bundle.members.iter().enumerate() {
        let here: Vec<usize> =
            (0..along.len()).filter(|row| belongs(source, measured, bundle, *member, *row)).collect();
        if here.is_empty() {
            continue;
        }
        let colour = if bundle.members.len() > 1 && family_is_known { colours[i] } else { Colour::Black };
        let curve = |points: Vec<(f64, f64)>, label: &str, stroke, marked| Curve {
            label: label.to_owned(),
            points,
            failed: vec![],
            stroke,
            colour,
            marked,
        };
        for row in here.iter().copied() {
            if let Some(errors) = &measured.errors {
                let (x, mu, error) = (along[row], measured.friction[row], errors[row]);
                curves.push(curve(vec![(x, mu - error), (x, mu + error)], "", Stroke::Solid, false));
            }
        }
        let points = here.iter().map(|row| (along[*row], measured.friction[*row])).collect();
        let label = if curves.iter().any(|curve: &Curve| !curve.label.is_empty()) { "" } else { "measured" };
        curves.push(curve(points, label, Stroke::Points, true));
        if !family_is_known {
            break;
        }
    }
    curves
}

/// True if the file says to which member of the family a point belongs.
fn belongs_by(source: &Source, measured: &Measured, bundle: &Bundle) -> bool {
    let names = source.dimension_names(bundle.family);
    names.iter().any(|name| measured.coordinate(name).is_some())
}

/// True if a point's coordinates but that along the curve are those of a member.
fn belongs(source: &Source, measured: &Measured, bundle: &Bundle, member: usize, row: usize) -> bool {
    let indices = bundle.at(member, bundle.points[0]);
    let along = &source.axis(bundle.along).name;
    let fixed = source.data.fixed.iter().map(|(name, value)| (name.as_str(), *value));
    let known = source.coordinate_names().into_iter().zip(source.coordinates(indices)).chain(fixed);
    known.filter(|(name, _)| name != along).all(|(name, value)| match measured.coordinate(name) {
        // What follows from the quantities of the laboratory changes along the curve.
        Some(_) if source.data.laboratory && (name == "alpha" || name == "beta") => true,
        Some(values) => Measured::is_same(values[row], value),
        None => true,
    })
}
