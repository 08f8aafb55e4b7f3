//! What a point of the surface goes through: pressure against its height, from the inlet to the outlet.

use std::f64::consts::PI;

use super::cases::Cases;
use super::family::{beside, colour};
use super::known::dry_pressure;
use super::picture::{Chart, Picture};
use super::profiles::suffix;
use super::request::{Kind, Request};
use super::source::{Source, rounded};
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{Curve, LineAxis, Lines, Stroke};
use stribeck_solver::exact::DryContact;
use stribeck_sweep::{Column, Field};

/// The loops of chosen cases in one picture.
///
/// The height of the surface is w − h₀ = x²/2 − u (T3): where it starts from is the same in all cases. The area of a loop is
/// F_v = (2/π) ∫ p dw (Eq. 22), here by trapezia over the published x, beside the μᵥ of the solver.
pub(super) fn loops(source: &Source, request: &Request) -> Result<Vec<Picture>, PictureError> {
    for field in [Field::Pressure, Field::FilmThickness] {
        if !source.data.fields.contains(&field) {
            return Err(Kind::Loops.missing(format!(
                "the sweep has no field {}; add it to fields below [output] and run it again",
                field.name()
            )));
        }
    }
    let cases = Cases::choose(source, request, Kind::Loops, Axis::Inner)?;
    let friction = source.data.column(Column::MuV)?;
    let mut table = Table::new(&[&["kind"], &source.coordinate_names()[..], &["x", "height", "pressure"]].concat());
    let (mut curves, mut dry_loops) = (Vec::new(), Vec::new());
    for (i, indices) in cases.indices.iter().enumerate() {
        let pressure = source.dimensionless_field(Field::Pressure, *indices)?;
        let film = source.dimensionless_field(Field::FilmThickness, *indices)?;
        let x = &source.data.x;
        let heights: Vec<f64> = x.iter().zip(&film).map(|(x, u)| height(*x, *u)).collect();
        let coordinates = source.coordinates(*indices);
        // Without pressure nothing happens: the loop from a point before the outlet to where the pressure is below a thousandth.
        let peak = pressure.iter().copied().fold(0.0, f64::max);
        let loaded = |i: &usize| pressure[*i] > 1e-3 * peak;
        let first = (0..x.len()).find(loaded).map_or(0, |i| i.saturating_sub(1));
        let last = (0..x.len()).rfind(loaded).map_or(x.len() - 1, |i| (i + 1).min(x.len() - 1));
        let points: Vec<(f64, f64)> = (first..=last).map(|i| (heights[i], pressure[i])).collect();
        for i in first..=last {
            table.row(&["solution"], &[&coordinates[..], &[x[i], heights[i], pressure[i]]].concat());
        }
        let colour = colour(i, cases.indices.len());
        let label = format!(
            "{}: area {}, μᵥ {}",
            cases.label(source, *indices),
            rounded(area(&heights, &pressure)),
            rounded(friction[source.data.place(*indices)] / source.factor(Column::MuV.units(), *indices)),
        );
        curves.push(Curve { label, points, failed: vec![], stroke: Stroke::Solid, colour, marked: false });
        if let Some(case) = source.parameters(*indices).filter(|_| !request.bare)
            && let Some(contact) = DryContact::of(&case)
        {
            let (at, pressure) = dry_pressure(&contact);
            // β is the last coordinate, and ∞ in dry sliding.
            let mut dry_coordinates = coordinates.clone();
            *dry_coordinates.last_mut().expect("there are coordinates") = f64::INFINITY;
            for (x, p) in at.iter().zip(&pressure) {
                table.row(&["dry limit"], &[&dry_coordinates[..], &[*x, height(*x, 0.0), *p]].concat());
            }
            dry_loops.push((colour, at.iter().zip(pressure).map(|(x, p)| (height(*x, 0.0), p)).collect()));
        }
    }
    let dry_area = match (&cases.indices[..], source.parameters(cases.indices[0])) {
        ([_, ..], Some(case)) => DryContact::of(&case).map(|contact| contact.friction()),
        _ => None,
    };
    let mut dry = beside("dry limit", Stroke::Dotted, dry_loops);
    // One dry loop for all has one area.
    if let ([only], Some(area)) = (&mut dry[..], dry_area) {
        only.label += &format!(": area {}", rounded(area));
    }
    curves.extend(dry);
    let chart = Lines {
        title: source.data.title.clone(),
        subtitle: cases.subtitle(source),
        x: LineAxis {
            label: "height of the surface w − h₀ (a₀²/R)".to_owned(), logarithmic: false, range: None
        },
        y: LineAxis { label: "pressure p (2N/(πa₀))".to_owned(), logarithmic: false, range: request.y },
        curves,
    };
    let name = format!("loop{}", suffix(source, request, &cases));
    Ok(vec![Picture { name, chart: Chart::Lines(chart), table }])
}

/// w − h₀ (T3).
fn height(x: f64, film: f64) -> f64 {
    0.5 * x * x - film
}

/// (2/π) ∫ p dw by trapezia.
fn area(heights: &[f64], pressure: &[f64]) -> f64 {
    let steps = heights.windows(2).zip(pressure.windows(2));
    2.0 / PI * steps.map(|(w, p)| 0.5 * (p[0] + p[1]) * (w[1] - w[0])).sum::<f64>()
}
