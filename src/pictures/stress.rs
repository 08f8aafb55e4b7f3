//! Normal stress below the deformed surface.

use super::cases::Cases;
use super::picture::{Chart, Picture};
use super::profiles::{X_LABEL, shown, suffix};
use super::request::{Kind, Request};
use super::source::Source;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{ColourScale, Section, SectionPanel};
use stribeck_solver::stress::normal_stress;
use stribeck_sweep::Field;

/// Points across and downwards.
const ACROSS: usize = 141;
const DOWN: usize = 61;
/// How much of the width the depth is.
const DEPTH: f64 = 0.55;
/// About how many bands of colour.
const BANDS: usize = 10;
/// Most cases in one picture.
const MOST_PANELS: usize = 4;

/// σ_yy under chosen cases. Heights are drawn as if a₀ were R: the shape of the surface over x/a₀ is w R/a₀².
pub(super) fn stress(source: &Source, request: &Request) -> Result<Vec<Picture>, PictureError> {
    for field in Field::ALL {
        if !source.data.fields.contains(&field) {
            return Err(Kind::Stress.missing(format!(
                "the sweep has no field {}; add it to fields below [output] and run it again",
                field.name()
            )));
        }
    }
    let mut cases = Cases::choose(source, request, Kind::Stress, Axis::Middle)?;
    let asked = request.asks(source, cases.family);
    if cases.indices.len() > MOST_PANELS {
        if asked {
            return Err(
                Kind::Stress.missing(format!("one picture has room for {MOST_PANELS} cases; give fewer values"))
            );
        }
        let all: Vec<usize> = (0..cases.indices.len()).collect();
        cases.indices = super::request::spread(&all, MOST_PANELS).into_iter().map(|i| cases.indices[i]).collect();
    }
    let range = request.x.unwrap_or((-1.6, 1.6));
    let inside = shown(source, &Request { x: Some(range), ..request.clone() }, Kind::Stress)?;
    let (from, to) = (source.data.x[inside[0]], source.data.x[inside[inside.len() - 1]]);
    let step = |first: f64, last: f64, i: usize, count: usize| first + (last - first) * i as f64 / (count - 1) as f64;
    let x: Vec<f64> = (0..ACROSS).map(|i| step(from, to, i, ACROSS)).collect();
    let deepest = DEPTH * (to - from);
    // Dense below the surface, where stresses change most.
    let depth: Vec<f64> = (0..DOWN).map(|i| deepest * (i as f64 / (DOWN - 1) as f64).powf(1.5)).collect();

    let mut table =
        Table::new(&[&source.coordinate_names()[..], &["x", "depth", "surface", "cylinder", "stress"]].concat());
    let (mut panels, mut highest) = (Vec::new(), 0.0_f64);
    for indices in &cases.indices {
        let [pressure, film, displacement] = Field::ALL.map(|field| source.dimensionless_field(field, *indices));
        let (pressure, film, displacement) = (pressure?, film?, displacement?);
        let on = |field: &[f64]| -> Vec<f64> { x.iter().map(|at| interpolated(&source.data.x, field, *at)).collect() };
        // The surface is level with its inlet end: displacements have a constant that means nothing.
        let level = displacement[inside[inside.len() - 1]];
        let surface: Vec<f64> = on(&displacement).into_iter().map(|w| w - level).collect();
        let cylinder: Vec<f64> = surface.iter().zip(on(&film)).map(|(w, u)| w + u).collect();
        let values: Vec<f64> =
            depth.iter().flat_map(|y| x.iter().map(|at| normal_stress(&source.data.x, &pressure, *at, *y))).collect();
        let coordinates = source.coordinates(*indices);
        for (i, value) in values.iter().enumerate() {
            let (column, row) = (i % ACROSS, i / ACROSS);
            let numbers = [x[column], depth[row], surface[column], cylinder[column], *value];
            table.row(&[], &[&coordinates[..], &numbers].concat());
        }
        highest = surface.iter().copied().fold(highest, f64::max);
        panels.push(SectionPanel {
            label: cases.label(source, *indices),
            x: x.clone(),
            surface,
            cylinder,
            depth: depth.clone(),
            values,
        });
    }
    let chart = Section {
        title: source.data.title.clone(),
        subtitle: cases.subtitle(source),
        x_label: X_LABEL.to_owned(),
        y_label: "depth y (a₀), surface w (a₀²/R)".to_owned(),
        panels,
        x_range: (from, to),
        y_range: (-0.75 * deepest, highest + 0.25 * deepest),
        scale: ColourScale { label: "normal stress σ_yy (2N/(πa₀))".to_owned(), logarithmic: false, range: None },
        levels: BANDS,
    };
    Ok(vec![Picture {
        name: format!("stress{}", suffix(source, request, &cases)),
        chart: Chart::Section(chart),
        table,
    }])
}

/// A field at x, between its points.
fn interpolated(x: &[f64], field: &[f64], at: f64) -> f64 {
    let right = x.partition_point(|x| *x < at).clamp(1, x.len() - 1);
    let share = (at - x[right - 1]) / (x[right] - x[right - 1]);
    field[right - 1] + (field[right] - field[right - 1]) * share
}
