//! A quantity along an axis, one curve for each value of another.

use super::bundle::{Bundle, bundles};
use super::family::{beside, colour};
use super::known::{self, Known, Values};
use super::overlay::overlay;
use super::picture::{Chart, Picture};
use super::quantity::Quantity;
use super::request::{Kind, Request, Selection};
use super::source::Source;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_sweep::Column;
use stribeck_sweep::store::Status;

/// Curves with more points than this have no markers.
const MOST_MARKED: usize = 45;

/// What curves show where nothing else is asked for.
const COLUMNS: [Column; 4] = [Column::MuTot, Column::MuV, Column::MuH, Column::C];
/// The same of errors.
const ERRORS: [Column; 3] = [Column::ErrorMuV, Column::ErrorMuH, Column::ErrorC];

/// The pictures of curves that are asked for.
pub(super) fn curves(source: &Source, request: &Request) -> Result<Vec<Picture>, PictureError> {
    along_each(source, request, Kind::Curves, &named_columns(request, &COLUMNS))
}

/// Errors along each axis: for sweeps that have no map of them.
pub(super) fn errors(source: &Source, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let request = Request { together: true, ..request.clone() };
    along_each(source, &request, Kind::Errors, &ERRORS)
}

/// The columns asked for, or a choice.
pub(super) fn named_columns(request: &Request, otherwise: &[Column]) -> Vec<Column> {
    let named: Vec<Column> = request.of.iter().filter_map(|name| Column::named(name)).collect();
    if named.is_empty() { otherwise.to_vec() } else { named }
}

fn along_each(
    source: &Source,
    request: &Request,
    kind: Kind,
    columns: &[Column],
) -> Result<Vec<Picture>, PictureError> {
    let selection = Selection::of(source, request)?;
    let long = |axis: &Axis| selection.on(*axis).len() > 1;
    let axes: Vec<Axis> = match request.along(source)? {
        Some(axis) if !long(&axis) => {
            let name = &source.axis(axis).name;
            return Err(kind.missing(format!("{name} has one value here, and a curve needs two")));
        }
        Some(axis) => vec![axis],
        None => Axis::ALL.into_iter().filter(long).collect(),
    };
    if axes.is_empty() {
        return Err(kind.missing("every axis has one value here, and a curve needs two"));
    }
    let mut pictures = Vec::new();
    for along in axes {
        let groups: Vec<&[Column]> = if request.together { vec![columns] } else { columns.chunks(1).collect() };
        for columns in groups {
            if let Some((one, other)) = Quantity::of_different_units(columns) {
                let (one, other) = (one.name(), other.name());
                return Err(kind.missing(format!(
                    "{one} and {other} have different units and no axis together; leave out --together"
                )));
            }
            let name = match kind {
                Kind::Errors => format!("errors-along-{}", source.axis(along).name),
                _ => format!(
                    "{}-along-{}",
                    columns.iter().map(|column| column.name()).collect::<Vec<_>>().join("-"),
                    source.axis(along).name
                ),
            };
            for bundle in bundles(source, request, &selection, along) {
                let name = format!("{name}{}", bundle.suffix);
                pictures.extend(draw(source, request, &bundle, columns, name)?);
            }
        }
    }
    Ok(pictures)
}

fn draw(
    source: &Source,
    request: &Request,
    bundle: &Bundle,
    columns: &[Column],
    name: String,
) -> Result<Option<Picture>, PictureError> {
    let mut table = Table::new(&[&["quantity", "kind"], &source.coordinate_names()[..], &["value"]].concat());
    let (mut solved, mut known_curves, mut measured) = (Vec::new(), Vec::new(), Vec::new());
    for (place, column) in columns.iter().copied().enumerate() {
        let colours: Vec<Colour> = (0..bundle.members.len())
            .map(|member| if columns.len() > 1 { Colour::Kind(place) } else { colour(member, bundle.members.len()) })
            .collect();
        solved.extend(solutions(source, bundle, column, &colours, columns.len() > 1, &mut table)?);
        measured.extend(overlay(source, bundle, column, &colours));
        let known = if request.bare { &[] } else { known::of_column(column) };
        for known in known {
            let mut members = Vec::new();
            for (member, colour) in bundle.members.iter().zip(&colours) {
                let points = known_points(source, known, column, bundle, *member)?;
                for (point, (_, value)) in bundle.points.iter().zip(&points) {
                    let coordinates = source.coordinates(bundle.at(*member, *point));
                    table.row(&[column.name(), known.label], &[&coordinates[..], &[*value]].concat());
                }
                members.push((*colour, points));
            }
            known_curves.extend(beside(known.label, known.stroke, members));
        }
    }
    let nothing = solved.iter().all(|curve| curve.failed.is_empty() && curve.points.iter().all(|p| p.1.is_nan()));
    if nothing {
        return Ok(None);
    }
    let logarithmic = request.scale.is_logarithmic(solved.iter().flat_map(|curve| &curve.points).map(|point| point.1));
    let wanted: Vec<Curve> = solved.iter().chain(&measured).cloned().collect();
    let range = request.y.or_else(|| vertical_range(&wanted, &known_curves, logarithmic));
    let x_label = source.axis(bundle.along).label.clone();
    let chart = Lines {
        title: source.data.title.clone(),
        subtitle: source.list(&bundle.fixed, bundle.start),
        x: LineAxis { label: x_label, logarithmic: is_logarithmic(source, bundle), range: None },
        y: LineAxis { label: Quantity::common_label(columns, source.data.laboratory), logarithmic, range },
        curves: solved.into_iter().chain(known_curves).chain(measured).collect(),
    };
    Ok(Some(Picture { name, chart: Chart::Lines(chart), table }))
}

/// The curve of each member of the family; `named` by the column where several stand together.
fn solutions(
    source: &Source,
    bundle: &Bundle,
    column: Column,
    colours: &[Colour],
    named: bool,
    table: &mut Table,
) -> Result<Vec<Curve>, PictureError> {
    let (statuses, values) = (source.data.statuses()?, source.data.column(column)?);
    let mut curves = Vec::new();
    for (member, colour) in bundle.members.iter().zip(colours) {
        let (mut points, mut failed) = (Vec::new(), Vec::new());
        for point in &bundle.points {
            let indices = bundle.at(*member, *point);
            let (x, place) = (source.value(bundle.along, *point), source.data.place(indices));
            points.push((x, values[place]));
            if statuses[place] == Status::Failed {
                failed.push(x);
            }
            table.row(&[column.name(), "solution"], &[&source.coordinates(indices)[..], &[values[place]]].concat());
        }
        let label = if named {
            Quantity::from(column).words.to_owned()
        } else if bundle.members.len() > 1 {
            source.words(bundle.family, *member)
        } else {
            "solution".to_owned()
        };
        let marked = points.len() <= MOST_MARKED;
        curves.push(Curve { label, points, failed, stroke: Stroke::Solid, colour: *colour, marked });
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
    Some(if logarithmic {
        (10_f64.powf(low), 10_f64.powf(high))
    } else {
        (if low < 0.0 && ends(solved).0 >= 0.0 { 0.0 } else { low }, high)
    })
}

/// True if the running axis spans more than a factor of five.
fn is_logarithmic(source: &Source, bundle: &Bundle) -> bool {
    let positive: Vec<f64> = bundle.points.iter().map(|point| source.value(bundle.along, *point)).collect();
    let finite = || positive.iter().copied().filter(|value| *value > 0.0 && value.is_finite());
    let (least, most) = (finite().fold(f64::INFINITY, f64::min), finite().fold(0.0, f64::max));
    most > 5.0 * least || positive.contains(&f64::INFINITY)
}

fn known_points(
    source: &Source,
    known: &Known,
    column: Column,
    bundle: &Bundle,
    member: usize,
) -> Result<Vec<(f64, f64)>, PictureError> {
    let places = bundle.points.iter().map(|point| (source.value(bundle.along, *point), bundle.at(member, *point)));
    match known.values {
        Values::Formula(formula) => {
            let value = |indices| {
                let value = source.parameters(indices).and_then(|case| formula(&case));
                value.map_or(f64::NAN, |value| value * source.factor(column.units(), indices))
            };
            Ok(places.map(|(x, indices)| (x, value(indices))).collect())
        }
        Values::Columns(columns) => {
            let columns = columns.iter().map(|column| source.data.column(*column)).collect::<Result<Vec<_>, _>>()?;
            let sum = |place: usize| columns.iter().map(|column| column[place]).sum();
            Ok(places.map(|(x, indices)| (x, sum(source.data.place(indices)))).collect())
        }
    }
}
