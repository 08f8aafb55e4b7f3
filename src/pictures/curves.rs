//! A quantity along an axis, one curve for each value of another.

use super::curve_family::{CurveFamily, beside, curve_families, member_colour};
use super::engineering::ShownUnit;
use super::error_bars::error_bars;
use super::measured_points::measured_points;
use super::picture::{Chart, Picture};
use super::quantity::Quantity;
use super::reference_curves::{self, ReferenceCurve, Values};
use super::request::{AxisScale, Kind, Request, Selection};
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, AxisWords, PictureError};
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_solver::shortest;
use stribeck_sweep::store::Status;
use stribeck_sweep::{Column, GridIndex};

/// A single curve with more points than this has no markers.
const MOST_MARKED: usize = 45;

/// What errors show where nothing else is asked for.
pub(super) const ERRORS: [Column; 4] = [Column::ErrorMuV, Column::ErrorMuH, Column::ErrorMuDrag, Column::ErrorC];

/// The pictures of curves that are asked for.
pub(super) fn curves(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    along_each(sweep, request, Kind::Curves, &columns(sweep, request))
}

/// The drag with its parts along the speed of an experiment: what its reader looks for first.
pub(super) fn drag_with_parts(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let along = Some(sweep.axis(Axis::Inner).name.clone());
    let scale = if request.scale == AxisScale::Auto { AxisScale::Linear } else { request.scale };
    let request = Request { together: true, bare: true, along, scale, ..request.clone() };
    along_each(sweep, &request, Kind::Curves, &sweep.drag_and_parts().map(Quantity::from))
}

/// The columns that curves show.
pub(super) fn columns(sweep: &SweepData, request: &Request) -> Vec<Quantity> {
    named_columns(sweep, request, &[&friction(sweep, request)[..], &[Column::C]].concat())
}

/// Errors along each axis: for sweeps that have no map of them.
pub(super) fn errors(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let request = Request { together: true, ..request.clone() };
    along_each(sweep, &request, Kind::Errors, &ERRORS.map(Quantity::from))
}

/// The friction that is shown where nothing else is asked for: of an experiment the drag, which an instrument reads,
/// and its parts, but that by pressure, which is negative, on a logarithmic axis; else that of the paper, with the drag
/// beside it.
pub(super) fn friction(sweep: &SweepData, request: &Request) -> Vec<Column> {
    let mut columns = match sweep.data.laboratory {
        true => sweep.drag_and_parts().to_vec(),
        false => vec![Column::MuTot, Column::MuV, Column::MuH, Column::MuDrag],
    };
    columns.retain(|column| *column != Column::MuPressure || request.scale != AxisScale::Log);
    columns
}

/// The columns asked for, or a choice.
pub(super) fn named_columns(sweep: &SweepData, request: &Request, otherwise: &[Column]) -> Vec<Quantity> {
    let named = |name: &String| Quantity::all(&sweep.data).find(|quantity| quantity.name == name);
    let named: Vec<Quantity> = request.of.iter().filter_map(named).collect();
    if named.is_empty() { otherwise.iter().copied().map(Quantity::from).collect() } else { named }
}

/// What all curves of a picture have in common.
fn subtitle(sweep: &SweepData, family: &CurveFamily, columns: &[Quantity]) -> String {
    let held = sweep.held_along(family.along, family.start[family.along.dimension()]);
    let fixed = Some(sweep.list(&family.fixed, family.start)).filter(|words| !words.is_empty());
    sweep
        .held()
        .into_iter()
        .chain(held)
        .chain(fixed)
        .chain(sum_of_parts(sweep, family, columns))
        .collect::<Vec<_>>()
        .join(", ")
}

/// How the drag is made of its parts (T54), where all of them are drawn: the ratio S stands before the shear.
fn sum_of_parts(sweep: &SweepData, family: &CurveFamily, columns: &[Quantity]) -> Option<String> {
    let grid = &sweep.sweep.as_ref()?.grid;
    let parts = sweep.drag_and_parts().map(Quantity::from);
    if !parts.iter().all(|part| columns.contains(part)) {
        return None;
    }
    let [drag, hysteresis, sliding, pressure] = parts.map(|part| part.symbol());
    let ratio = |member, point| grid.slide_roll(GridIndex::from(family.at(member, point)));
    let mut ratios = family.members.iter().flat_map(|member| family.points.iter().map(|point| ratio(*member, *point)));
    let first = ratios.next()?;
    let shear = match ratios.all(|ratio| ratio == first) {
        true if first == 1.0 => "+ ".to_owned(),
        true if first < 0.0 => format!("− {} ", shortest(-first)),
        true => format!("+ {} ", shortest(first)),
        false => "+ S ".to_owned(),
    };
    Some(format!("{drag} = {hysteresis} {shear}{sliding} − {pressure}"))
}

/// The pictures of these columns along the axis asked for, or along each that has several values.
fn along_each(
    sweep: &SweepData,
    request: &Request,
    kind: Kind,
    columns: &[Quantity],
) -> Result<Vec<Picture>, PictureError> {
    let selection = Selection::of(sweep, request)?;
    let long = |axis: &Axis| selection.on(*axis).len() > 1;
    let axes: Vec<Axis> = match request.along(sweep)? {
        Some(axis) if !long(&axis) => {
            let name = &sweep.axis(axis).name;
            return Err(kind.missing(format!("{name} has one value here, and a curve needs two")));
        }
        Some(axis) => vec![axis],
        None => {
            let all: Vec<Axis> = Axis::ALL.into_iter().filter(long).collect();
            // The numbers of combinations are no quantity to draw along, if there is another.
            let is_quantity = |axis: &Axis| sweep.axis(*axis).name != AxisWords::COMBINATION;
            let quantities: Vec<Axis> = all.iter().copied().filter(is_quantity).collect();
            if quantities.is_empty() { all } else { quantities }
        }
    };
    if axes.is_empty() {
        return Err(kind.missing("every axis has one value here, and a curve needs two"));
    }
    let mut pictures = Vec::new();
    for along in axes {
        let groups: Vec<&[Quantity]> = if request.together { vec![columns] } else { columns.chunks(1).collect() };
        for columns in groups {
            if let Some((one, other)) = Quantity::of_different_units(columns) {
                let (one, other) = (one.name, other.name);
                return Err(kind.missing(format!(
                    "{one} and {other} have different units and no axis together; leave out --together"
                )));
            }
            let name = match kind {
                Kind::Errors => format!("errors-along-{}", sweep.axis(along).name),
                _ => format!(
                    "{}-along-{}",
                    columns.iter().map(|column| column.name).collect::<Vec<_>>().join("-"),
                    sweep.axis(along).name
                ),
            };
            for family in curve_families(sweep, request, &selection, along) {
                let name = format!("{name}{}", family.suffix);
                pictures.extend(draw(sweep, request, &family, columns, name)?);
            }
        }
    }
    Ok(pictures)
}

/// The picture of a family of curves of these columns; none if it has nothing to show.
fn draw(
    sweep: &SweepData,
    request: &Request,
    family: &CurveFamily,
    columns: &[Quantity],
    name: String,
) -> Result<Option<Picture>, PictureError> {
    let mut table = Table::new(&[&["quantity", "kind"], &sweep.coordinate_names()[..], &["value"]].concat());
    let (mut solved, mut references, mut measured) = (Vec::new(), Vec::new(), Vec::new());
    for (place, column) in columns.iter().copied().enumerate() {
        let looks = looks(family, columns, place);
        let mut curves = solutions(sweep, family, column, &looks, &mut table)?;
        if columns.len() > 1 {
            curves.iter_mut().for_each(|curve| curve.label = column.title());
        }
        let points = measured_points(sweep, family, column, &looks, &mut table);
        // Lines among points have no marks of their own.
        if !points.is_empty() {
            let is_named = |label: &str| points.iter().any(|points| points.label == label);
            for curve in &mut curves {
                curve.mark = None;
                // What is measured beside it has its name.
                curve.label =
                    Some(std::mem::take(&mut curve.label)).filter(|label| !is_named(label)).unwrap_or_default();
            }
        }
        solved.extend(curves);
        measured.extend(points);
        if !request.bare {
            references.extend(reference_curves(sweep, family, column, &looks, &mut table)?);
        }
    }
    let nothing = solved.iter().all(|curve| curve.failed.is_empty() && curve.points.iter().all(|p| p.1.is_nan()));
    if nothing {
        return Ok(None);
    }
    let logarithmic = request.scale.is_logarithmic(solved.iter().flat_map(|curve| &curve.points).map(|point| point.1));
    let wanted: Vec<Curve> = solved.iter().chain(&measured).cloned().collect();
    let span = span(&solved, logarithmic);
    let mut bars = Vec::new();
    for (place, column) in columns.iter().copied().enumerate() {
        let looks = looks(family, columns, place);
        bars.extend(error_bars(sweep, (family, column), &looks, (span, logarithmic), &mut table)?);
    }
    let range = request.y.or_else(|| vertical_range(&wanted, &references, logarithmic));
    let mut chart = Lines {
        title: sweep.data.title.clone(),
        subtitle: subtitle(sweep, family, columns),
        x: LineAxis { label: String::new(), logarithmic: is_logarithmic(sweep, family), range: None },
        y: LineAxis { label: Quantity::common_title(columns), logarithmic, range },
        curves: solved.into_iter().chain(bars).chain(references).chain(measured).collect(),
    };
    let values = wanted.iter().flat_map(|curve| &curve.points);
    let (unit, label) = sweep.axis(family.along).shown(values.clone().map(|point| point.0));
    chart.x.label = label;
    let largest = values.map(|point| point.1.abs()).filter(|value| value.is_finite()).fold(0.0, f64::max);
    in_units(&mut chart, &unit, &columns[0].unit(sweep.data.laboratory, largest));
    Ok(Some(Picture { name, chart: Chart::Lines(chart), table }))
}

/// Shows the numbers of a chart in these units. The name of the vertical axis gets its unit.
pub(super) fn in_units(chart: &mut Lines, x: &ShownUnit, y: &ShownUnit) {
    chart.y.label = y.label(&chart.y.label);
    chart.y.range = chart.y.range.map(|(from, to)| (y.shown(from), y.shown(to)));
    for curve in &mut chart.curves {
        curve.points.iter_mut().for_each(|point| *point = (x.shown(point.0), y.shown(point.1)));
        curve.failed.iter_mut().for_each(|at| *at = x.shown(*at));
    }
}

/// Colour and mark of the members of a family for the column at a place of those that are drawn together.
fn looks(family: &CurveFamily, columns: &[Quantity], place: usize) -> Vec<Look> {
    let count = family.members.len();
    let look = |member| match columns.len() {
        1 => Look { colour: member_colour(member, count), mark: member },
        _ => Look { colour: Colour::Kind(place), mark: place },
    };
    (0..count).map(look).collect()
}

/// By what a curve is known among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    pub(super) colour: Colour,
    pub(super) mark: usize,
}

/// What curves span on a vertical axis: decades if it is logarithmic.
fn span(curves: &[Curve], logarithmic: bool) -> f64 {
    let values = curves.iter().flat_map(|curve| &curve.points).map(|point| point.1);
    let places = values.map(|value| if logarithmic { value.log10() } else { value }).filter(|value| value.is_finite());
    let (low, high) =
        places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    high - low
}

/// The curve of each member of a family, named by the member.
fn solutions(
    sweep: &SweepData,
    family: &CurveFamily,
    column: Quantity,
    looks: &[Look],
    table: &mut Table,
) -> Result<Vec<Curve>, PictureError> {
    let (statuses, values) = (sweep.data.statuses()?, column.values(&sweep.data)?);
    let mut curves = Vec::new();
    for (member, look) in family.members.iter().zip(looks) {
        let (mut points, mut failed) = (Vec::new(), Vec::new());
        for point in &family.points {
            let indices = family.at(*member, *point);
            let (x, place) = (sweep.value(family.along, *point), sweep.data.place(indices));
            points.push((x, values[place]));
            if statuses[place] == Status::Failed {
                failed.push(x);
            }
            table.row(&[column.name, "solution"], &[&sweep.coordinates(indices)[..], &[values[place]]].concat());
        }
        let label = match family.members.len() {
            1 => "solution".to_owned(),
            _ => sweep.words(family.varied, *member),
        };
        let is_alone = family.members.len() == 1 && look.mark == 0;
        let mark = Some(look.mark).filter(|_| points.len() <= MOST_MARKED || !is_alone);
        curves.push(Curve { label, points, failed, stroke: Stroke::Solid, colour: look.colour, mark });
    }
    Ok(curves)
}

/// The reference curves of a column beside the members of a family, which look so.
fn reference_curves(
    sweep: &SweepData,
    family: &CurveFamily,
    quantity: Quantity,
    looks: &[Look],
    table: &mut Table,
) -> Result<Vec<Curve>, PictureError> {
    let mut curves = Vec::new();
    let Some(column) = quantity.column else { return Ok(curves) };
    for reference in reference_curves::of_column(column) {
        let mut members = Vec::new();
        for (member, look) in family.members.iter().zip(looks) {
            let points = reference_points(sweep, reference, column, family, *member)?;
            for (point, (_, value)) in family.points.iter().zip(&points) {
                let coordinates = sweep.coordinates(family.at(*member, *point));
                table.row(&[column.name(), reference.label], &[&coordinates[..], &[*value]].concat());
            }
            members.push((look.colour, points));
        }
        curves.extend(beside(reference.label, reference.stroke, members));
    }
    Ok(curves)
}

/// Where the vertical axis ends if what is known goes far away from the solutions, which are what the picture is for.
fn vertical_range(solved: &[Curve], known: &[Curve], logarithmic: bool) -> Option<(f64, f64)> {
    /// What known curves may take beyond the solutions, over their span.
    const BEYOND: f64 = 0.35;
    let place = |value: f64| if logarithmic { value.log10() } else { value };
    let ends = |curves: &[Curve]| {
        let values = curves.iter().flat_map(|curve| &curve.points).map(|point| place(point.1));
        values
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let ((low, high), (known_low, known_high)) = (ends(solved), ends(known));
    let span = high - low;
    let (least, most) = (low - BEYOND * span, high + BEYOND * span);
    if span.is_nan() || span <= 0.0 || (known_low >= least && known_high <= most) {
        return None;
    }
    let (low, high) = (low.min(known_low.max(least)) - 0.05 * span, high.max(known_high.min(most)) + 0.05 * span);
    // Room may reach beyond all numbers.
    Some(if logarithmic {
        (10_f64.powf(low).max(0.0_f64.next_up()), 10_f64.powf(high).min(f64::MAX))
    } else {
        (if low < 0.0 && ends(solved).0 >= 0.0 { 0.0 } else { low.max(f64::MIN) }, high.min(f64::MAX))
    })
}

/// True if the running axis spans more than a factor of five, and has no value below 0.
fn is_logarithmic(sweep: &SweepData, family: &CurveFamily) -> bool {
    let all: Vec<f64> = family.points.iter().map(|point| sweep.value(family.along, *point)).collect();
    let finite = || all.iter().copied().filter(|value| *value > 0.0 && value.is_finite());
    let (least, most) = (finite().fold(f64::INFINITY, f64::min), finite().fold(0.0, f64::max));
    all.iter().all(|value| *value >= 0.0) && (most > 5.0 * least || all.contains(&f64::INFINITY))
}

/// The points of a reference curve for a member of a family; NaN where it does not hold.
fn reference_points(
    sweep: &SweepData,
    reference: &ReferenceCurve,
    column: Column,
    family: &CurveFamily,
    member: usize,
) -> Result<Vec<(f64, f64)>, PictureError> {
    let places = family.points.iter().map(|point| (sweep.value(family.along, *point), family.at(member, *point)));
    match reference.values {
        Values::Formula(formula) => {
            let value = |indices| {
                let value = sweep.parameters(indices).and_then(|case| formula(&case));
                value.map_or(f64::NAN, |value| value * sweep.factor(column.units(), indices))
            };
            Ok(places.map(|(x, indices)| (x, value(indices))).collect())
        }
        Values::Columns(columns) => {
            let columns = columns.iter().map(|column| sweep.data.column(*column)).collect::<Result<Vec<_>, _>>()?;
            let sum = |place: usize| columns.iter().map(|column| column[place]).sum();
            let value = |indices| {
                let is_known = sweep.parameters(indices).is_none_or(|case| reference.holds(&case));
                if is_known { sum(sweep.data.place(indices)) } else { f64::NAN }
            };
            let mut points: Vec<(f64, f64)> = places.map(|(x, indices)| (x, value(indices))).collect();
            drop_lone_points(&mut points);
            Ok(points)
        }
    }
}

/// Leaves out what is known between two places where it is not: it holds there by chance.
fn drop_lone_points(points: &mut [(f64, f64)]) {
    let known: Vec<bool> = points.iter().map(|point| !point.1.is_nan()).collect();
    let is_known = |i: usize| known.get(i).copied().unwrap_or(false);
    for (i, point) in points.iter_mut().enumerate().filter(|_| known.len() > 2) {
        if (i == 0 || !is_known(i - 1)) && !is_known(i + 1) {
            point.1 = f64::NAN;
        }
    }
}
