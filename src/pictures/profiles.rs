//! Pressure, film and displacement of chosen cases over x.

use super::cases::Cases;
use super::curve_family::{beside, member_colour};
use super::curves::in_units;
use super::engineering::ShownUnit;
use super::picture::{Chart, Picture};
use super::quantity::Quantity;
use super::reference_curves;
use super::request::{Kind, Request};
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{Curve, LineAxis, Lines, Stroke};
use stribeck_sweep::Field;

/// A profile for each field asked for that is there.
pub(super) fn profiles(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let there = &sweep.data.fields;
    if there.is_empty() {
        return Err(Kind::Profiles.missing(
            "the sweep has no fields; add fields = [\"pressure\", \"film_thickness\"] below [output] to it and run it \
             again",
        ));
    }
    let asked = |field: &Field| request.of.iter().any(|name| name == field.name());
    let named: Vec<Field> = there.iter().copied().filter(asked).collect();
    let fields = if named.is_empty() { there.clone() } else { named };
    let cases = Cases::choose(sweep, request, Kind::Profiles, Axis::Middle)?;
    fields.into_iter().map(|field| profile(sweep, request, &cases, field)).collect()
}

fn profile(sweep: &SweepData, request: &Request, cases: &Cases, field: Field) -> Result<Picture, PictureError> {
    let quantity = Quantity::from(field);
    let inside = shown(sweep, request, Kind::Profiles)?;
    let (from, to) = (sweep.data.x[inside[0]], sweep.data.x[inside[inside.len() - 1]]);
    let mut table = Table::new(&[&["kind"], &sweep.coordinate_names()[..], &["x", field.name()]].concat());
    let (mut curves, mut known_label, mut members) = (Vec::new(), "", Vec::new());
    for (i, indices) in cases.indices.iter().enumerate() {
        let values = sweep.data.field(field, *indices)?;
        let coordinates = sweep.coordinates(*indices);
        let points: Vec<(f64, f64)> = inside.iter().map(|i| (sweep.data.x[*i], values[*i])).collect();
        let mut rows = |kind: &str, points: &[(f64, f64)]| {
            for (x, value) in points {
                table.row(&[kind], &[&coordinates[..], &[*x, *value]].concat());
            }
        };
        rows("solution", &points);
        let colour = member_colour(i, cases.indices.len());
        if let Some(case) = sweep.parameters(*indices).filter(|_| !request.bare)
            && let Some((label, mut known)) = reference_curves::of_field(field, &case)
        {
            known.retain(|(x, _)| (from..=to).contains(x));
            let factor = sweep.factor(quantity.units, *indices);
            known.iter_mut().for_each(|(_, value)| *value *= factor);
            rows(label, &known);
            known_label = label;
            members.push((colour, known));
        }
        let label = cases.label(sweep, *indices);
        let mark = Some(i).filter(|_| cases.indices.len() > 1);
        curves.push(Curve { label, points, failed: vec![], stroke: Stroke::Solid, colour, mark });
    }
    let drawn = || curves.iter().flat_map(|curve| &curve.points).map(|point| point.1);
    let logarithmic = request.scale.is_logarithmic(drawn());
    let largest = drawn().filter(|value| value.is_finite()).fold(0.0, |largest: f64, it| largest.max(it.abs()));
    curves.extend(beside(known_label, Stroke::Dashed, members));
    let mut chart = Lines {
        title: sweep.data.title.clone(),
        subtitle: cases.subtitle(sweep),
        x: LineAxis { label: X_LABEL.to_owned(), logarithmic: false, range: Some((from, to)) },
        y: LineAxis { label: quantity.title(), logarithmic, range: request.y },
        curves,
    };
    in_units(&mut chart, &ShownUnit::scale(""), &quantity.unit(sweep.data.laboratory, largest));
    Ok(Picture {
        name: format!("profile-{}{}", field.name(), suffix(sweep, request, cases)),
        chart: Chart::Lines(chart),
        table,
    })
}

/// Name of the horizontal axis of fields.
pub(super) const X_LABEL: &str = "position x (a₀), inlet on the right";

/// Indices of the x that are shown, at least two.
pub(super) fn shown(sweep: &SweepData, request: &Request, kind: Kind) -> Result<Vec<usize>, PictureError> {
    let x = &sweep.data.x;
    let (from, to) = request.x.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let inside: Vec<usize> = (0..x.len()).filter(|i| (from..=to).contains(&x[*i])).collect();
    if inside.len() < 2 {
        let (first, last) = (x[0], x[x.len() - 1]);
        return Err(kind.missing(format!(
            "--x {from},{to} holds {} of the x of this sweep, from {first} to {last}; a profile needs two",
            inside.len()
        )));
    }
    Ok(inside)
}

/// Tells pictures of cases apart that were chosen by hand.
pub(super) fn suffix(sweep: &SweepData, request: &Request, cases: &Cases) -> String {
    let by_hand = |axis: &Axis| cases.fixed.contains(axis) && request.asks(sweep, *axis);
    let fixed = Axis::ALL.into_iter().filter(by_hand);
    fixed.map(|axis| sweep.name_part(axis, cases.indices[0])).collect()
}
