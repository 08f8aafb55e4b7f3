//! Normal stress below the deformed surface.

use super::cases::Cases;
use super::picture::{Chart, Picture};
use super::profiles::{X_LABEL, shown, suffix};
use super::request::{Kind, Request, spread};
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{ColourScale, CrossSection, CrossSectionPanel};
use stribeck_solver::stress::normal_stress;
use stribeck_sweep::Field;

/// The fields that stresses follow from.
const FIELDS: [Field; 3] = [Field::Pressure, Field::FilmThickness, Field::Displacement];
/// Points across and downwards.
const ACROSS: usize = 141;
const DOWN: usize = 61;
/// How much of the width the depth is.
const DEPTH: f64 = 0.55;
/// About how many bands of colour.
const BANDS: usize = 10;
/// Most cases in one picture.
const MOST_PANELS: usize = 4;

/// The points at which stresses are drawn: x and depths.
struct Points {
    x: Vec<f64>,
    depth: Vec<f64>,
    /// Index on the published x of the inlet end.
    inlet: usize,
}

impl Points {
    /// Points below the published x from `first` to `last`.
    fn between(sweep: &SweepData, first: usize, last: usize) -> Self {
        let (from, to) = (sweep.data.x[first], sweep.data.x[last]);
        let x = (0..ACROSS).map(|i| from + (to - from) * i as f64 / (ACROSS - 1) as f64).collect();
        // Dense below the surface, where stresses change most.
        let share = |i: usize| (i as f64 / (DOWN - 1) as f64).powf(1.5);
        let depth = (0..DOWN).map(|i| DEPTH * (to - from) * share(i)).collect();
        Points { x, depth, inlet: last }
    }
}

/// σ_yy under chosen cases. Heights are drawn as if a₀ were R: the shape of the surface over x/a₀ is w R/a₀².
pub(super) fn stress(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    sweep.check_fields(Kind::Stress, &FIELDS)?;
    let cases = cases(sweep, request)?;
    let range = request.x.unwrap_or((-1.6, 1.6));
    let inside = shown(sweep, &Request { x: Some(range), ..request.clone() }, Kind::Stress)?;
    let (first, last) = (inside[0], inside[inside.len() - 1]);
    if !(DEPTH * (sweep.data.x[last] - sweep.data.x[first])).is_finite() {
        return Err(Kind::Stress.missing("the x lie too far apart to be drawn; give nearer ones with --x"));
    }
    let points = Points::between(sweep, first, last);
    let mut table =
        Table::new(&[&sweep.coordinate_names()[..], &["x", "depth", "surface", "cylinder", "stress"]].concat());
    let mut panels: Vec<CrossSectionPanel> = Vec::new();
    for indices in &cases.indices {
        let panel = panel(sweep, *indices, &points, cases.label(sweep, *indices))?;
        let numbers = [&panel.values, &panel.surface, &panel.cylinder];
        if numbers.into_iter().flatten().any(|number| !number.is_finite()) {
            let what = format!("the numbers of {} lie beyond what can be drawn; choose other cases", panel.label);
            return Err(Kind::Stress.missing(what));
        }
        let coordinates = sweep.coordinates(*indices);
        for (i, value) in panel.values.iter().enumerate() {
            let (column, row) = (i % ACROSS, i / ACROSS);
            let numbers = [panel.x[column], panel.depth[row], panel.surface[column], panel.cylinder[column], *value];
            table.row(&[], &[&coordinates[..], &numbers].concat());
        }
        panels.push(panel);
    }
    let (from, to) = (sweep.data.x[first], sweep.data.x[last]);
    let (low, high) = heights(&panels);
    let deepest = DEPTH * (to - from);
    let (least, most) = pressures(&panels);
    for value in panels.iter_mut().flat_map(|panel| &mut panel.values) {
        *value = (-*value).max(least);
    }
    let chart = CrossSection {
        title: sweep.data.title.clone(),
        subtitle: cases.subtitle(sweep),
        x_label: X_LABEL.to_owned(),
        y_label: "depth y (a₀), surface w (a₀²/R)".to_owned(),
        panels,
        x_range: (from, to),
        // No deeper than each panel reaches.
        y_range: ((low - 0.5 * deepest).max(high - deepest), high + 0.25 * deepest),
        scale: ColourScale {
            label: "compressive stress −σ_{yy}  (2N/(πa₀))".to_owned(),
            logarithmic: true,
            range: Some((least, most)),
        },
        levels: BANDS,
    };
    let name = format!("stress{}", suffix(sweep, request, &cases));
    Ok(vec![Picture { name, chart: Chart::CrossSection(chart), table }])
}

/// The lowest place of surfaces, and the highest place of surfaces and of the lower side of each cylinder, so that all
/// of them are in view.
fn heights(panels: &[CrossSectionPanel]) -> (f64, f64) {
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let low = panels.iter().map(|panel| least(&panel.surface)).fold(f64::INFINITY, f64::min);
    let high = panels.iter().map(|panel| most(&panel.surface).max(least(&panel.cylinder)));
    (low, high.fold(f64::NEG_INFINITY, f64::max))
}

/// Ends of a logarithmic scale of pressures on which each panel is seen: a decade and a third of the weakest one.
fn pressures(panels: &[CrossSectionPanel]) -> (f64, f64) {
    const SEEN: f64 = 20.0;
    let peaks = || panels.iter().map(|panel| panel.values.iter().fold(f64::MIN_POSITIVE, |most, it| most.max(-it)));
    let weakest = peaks().fold(f64::INFINITY, f64::min);
    (weakest / SEEN, peaks().fold(weakest, f64::max))
}

/// The cases asked for, or a choice of as many as there is room for.
fn cases(sweep: &SweepData, request: &Request) -> Result<Cases, PictureError> {
    let mut cases = Cases::choose(sweep, request, Kind::Stress, Axis::Middle)?;
    if cases.indices.len() > MOST_PANELS {
        if request.asks(sweep, cases.varied) {
            return Err(
                Kind::Stress.missing(format!("one picture has room for {MOST_PANELS} cases; give fewer values"))
            );
        }
        let all: Vec<usize> = (0..cases.indices.len()).collect();
        cases.indices = spread(&all, MOST_PANELS).into_iter().map(|i| cases.indices[i]).collect();
    }
    Ok(cases)
}

/// The stresses of a case.
fn panel(
    sweep: &SweepData,
    indices: [usize; 3],
    points: &Points,
    label: String,
) -> Result<CrossSectionPanel, PictureError> {
    let [pressure, film, displacement] = FIELDS.map(|name| sweep.dimensionless_field(name, indices));
    let (pressure, film, displacement) = (pressure?, film?, displacement?);
    let (x, depth) = (points.x.clone(), points.depth.clone());
    let on = |field: &[f64]| -> Vec<f64> { x.iter().map(|at| interpolated(&sweep.data.x, field, *at)).collect() };
    // The surface is level with its inlet end: displacements have a constant that means nothing.
    let level = displacement[points.inlet];
    let surface: Vec<f64> = on(&displacement).into_iter().map(|w| w - level).collect();
    let cylinder: Vec<f64> = surface.iter().zip(on(&film)).map(|(w, u)| w + u).collect();
    let values: Vec<f64> =
        depth.iter().flat_map(|y| x.iter().map(|at| normal_stress(&sweep.data.x, &pressure, *at, *y))).collect();
    Ok(CrossSectionPanel { label, x, surface, cylinder, depth, values })
}

/// A field at x, between its points.
fn interpolated(x: &[f64], field: &[f64], at: f64) -> f64 {
    let right = x.partition_point(|x| *x < at).clamp(1, x.len() - 1);
    let share = (at - x[right - 1]) / (x[right] - x[right - 1]);
    field[right - 1] + (field[right] - field[right - 1]) * share
}
