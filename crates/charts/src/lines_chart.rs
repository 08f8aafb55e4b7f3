//! Curves in a plane: the layout.

use super::legend::{self, Entry, Swatch};
use super::lines::{Colour, Curve, Lines, Stroke};
use super::marker::{self, Form};
use super::paint::WIDTH;
use super::palette::{self, FAILED_CROSS, FRAME, GRID, Ink, TEXT};
use super::plane_axis::PlaneAxis;
use super::polyline::{clipped, dashes};
use super::scene::{Anchor, Area, Point, Scene};
use super::ticks::Ticks;
use super::{font, scene};

/// Size of the font of ticks: 6 points when the picture is 8.5 cm wide.
const EM: f64 = 40.0;
const MARGIN: f64 = 30.0;
/// Height of the plot.
const HEIGHT: f64 = 960.0;
/// Width of a curve.
const STROKE: f64 = 5.0;
/// Radius of a marker.
const MARKER: f64 = 9.0;
/// All points of a curve are marked if they are at most this many, else about half as many of them.
const MOST_MARKERS: usize = 24;

/// Where everything lies.
struct Layout {
    plot: Area,
    x: PlaneAxis,
    y: PlaneAxis,
}

impl Layout {
    fn at(&self, (x, y): Point) -> Point {
        let plot = &self.plot;
        (plot.left + plot.width() * self.x.share(x), plot.bottom - plot.height() * self.y.share(y))
    }
}

/// The chart; it has been checked and has something to show.
pub(super) fn draw(chart: &Lines) -> Scene {
    let mut scene = Scene::default();
    let right = f64::from(WIDTH) - MARGIN;
    let top = scene.heading(1.12 * EM, MARGIN, right - MARGIN, &chart.title, &chart.subtitle) + 0.5 * EM;

    let failed = || chart.curves.iter().flat_map(|curve| &curve.failed).copied();
    let x_room = if chart.curves.iter().any(|curve| curve.marked) { 0.02 } else { 0.0 };
    let x_values = chart.shown().map(|point| point.0).chain(failed());
    let x = PlaneAxis::new(x_values, chart.x.logarithmic, chart.x.range, x_room);
    // What lies outside the horizontal range does not stretch the vertical one.
    let inside = |value: f64| x.is_special(value) || (-1e-9..=1.0 + 1e-9).contains(&x.share(value));
    let y_values = || chart.shown().filter(|point| inside(point.0)).map(|point| point.1);
    let y = PlaneAxis::new(y_values(), chart.y.logarithmic, chart.y.range, 0.05);
    let y = if chart.y.range.is_none() { y.begun_at_zero(y_values()) } else { y };

    let y_ticks = y.ticks(HEIGHT, EM, true);
    let widest = y_ticks.major.iter().map(|tick| font::width(&tick.label, EM)).fold(0.0, f64::max);
    let left = MARGIN + scene::thickness(&chart.y.label, 1.1 * EM, HEIGHT) + 0.3 * EM + widest + 0.4 * EM;
    let x_ticks = x.ticks(right - left, EM, false);
    // Half of the last label of the horizontal axis may stand out to the right.
    let ends = x_ticks.major.iter().map(|tick| {
        let half = 0.5 * font::width(&tick.label, EM);
        half - (1.0 - x.share(tick.value)) * (right - left)
    });
    let plot = Area { left, top, right: right - ends.fold(0.3 * EM, f64::max), bottom: top + HEIGHT };
    let layout = Layout { plot, x, y };

    scene.upright((MARGIN, plot.centre().1), 1.1 * EM, TEXT, HEIGHT, &chart.y.label);
    draw_grid(&mut scene, &layout, &x_ticks, &y_ticks);
    for (curve, form) in chart.curves.iter().zip(forms(chart)) {
        draw_curve(&mut scene, &layout, chart, curve, form);
    }
    scene.frame(plot, 3.0, FRAME);
    let ticks_bottom = draw_labels(&mut scene, &layout, &x_ticks, &y_ticks);
    let names_top = ticks_bottom + 0.1 * EM;
    let below =
        scene.paragraph((plot.centre().0, names_top), Anchor::Middle, 1.1 * EM, TEXT, plot.width(), &chart.x.label);
    let entries = entries(chart);
    let bottom = if entries.is_empty() {
        below
    } else {
        legend::draw(&mut scene, &entries, (MARGIN, below + 0.5 * EM), right, EM)
    };
    scene.height = (bottom + 0.6 * EM).ceil();
    scene
}

/// The colour of a curve. The light end of viridis is left out: it is not seen on white.
fn ink(colour: Colour) -> Ink {
    match colour {
        Colour::Kind(index) => palette::line_colour(index),
        Colour::Family(share) => palette::viridis(0.88 * share.clamp(0.0, 1.0)),
        Colour::Black => TEXT,
    }
}

/// The marker of each curve: those that are marked differ.
fn forms(chart: &Lines) -> impl Iterator<Item = Form> {
    chart.curves.iter().scan(0, |marked, curve| {
        let form = Form::of(*marked);
        *marked += usize::from(curve.marked);
        Some(form)
    })
}

/// Lengths of dash and gap.
fn pattern(stroke: Stroke) -> Option<(f64, f64)> {
    match stroke {
        Stroke::Solid | Stroke::Points => None,
        Stroke::Dashed => Some((22.0, 13.0)),
        Stroke::Dotted => Some((5.0, 9.0)),
    }
}

fn draw_grid(scene: &mut Scene, layout: &Layout, x_ticks: &Ticks, y_ticks: &Ticks) {
    let plot = layout.plot;
    for tick in &x_ticks.major {
        let x = plot.left + plot.width() * layout.x.share(tick.value);
        scene.line((x, plot.top), (x, plot.bottom), 2.0, GRID);
    }
    for tick in &y_ticks.major {
        let y = plot.bottom - plot.height() * layout.y.share(tick.value);
        scene.line((plot.left, y), (plot.right, y), 2.0, GRID);
    }
    // What is beyond the ends of the axis is set off.
    let (from, to) = layout.x.span();
    for border in [from, to].into_iter().filter(|share| (0.0 < *share) && (*share < 1.0)) {
        let x = plot.left + plot.width() * border;
        scene.line((x, plot.top), (x, plot.bottom), 2.0, FRAME);
    }
}

/// Ticks and their labels; returns where those of the horizontal axis end.
fn draw_labels(scene: &mut Scene, layout: &Layout, x_ticks: &Ticks, y_ticks: &Ticks) -> f64 {
    let plot = layout.plot;
    let x = |value: f64| plot.left + plot.width() * layout.x.share(value);
    let y = |value: f64| plot.bottom - plot.height() * layout.y.share(value);
    for value in &x_ticks.minor {
        scene.line((x(*value), plot.bottom), (x(*value), plot.bottom + 6.0), 2.0, FRAME);
    }
    for value in &y_ticks.minor {
        scene.line((plot.left - 6.0, y(*value)), (plot.left, y(*value)), 2.0, FRAME);
    }
    let baseline = plot.bottom + 1.4 * EM;
    for tick in &x_ticks.major {
        scene.line((x(tick.value), plot.bottom), (x(tick.value), plot.bottom + 12.0), 3.0, FRAME);
        scene.text((x(tick.value), baseline), Anchor::Middle, EM, TEXT, tick.label.as_str());
    }
    for tick in &y_ticks.major {
        scene.line((plot.left - 12.0, y(tick.value)), (plot.left, y(tick.value)), 3.0, FRAME);
        scene.text((plot.left - 0.4 * EM, y(tick.value) + 0.36 * EM), Anchor::End, EM, TEXT, tick.label.as_str());
    }
    baseline + font::DESCENT * EM
}

fn draw_curve(scene: &mut Scene, layout: &Layout, chart: &Lines, curve: &Curve, form: Form) {
    let (ink, plot) = (ink(curve.colour), layout.plot);
    let joined = |point: &(f64, f64)| chart.has_place(*point) && !layout.x.is_special(point.0);
    for run in curve.points.split(|point| !joined(point)) {
        let places: Vec<Point> = run.iter().map(|point| layout.at(*point)).collect();
        for piece in clipped(&places, &plot).into_iter().filter(|_| curve.stroke != Stroke::Points) {
            match pattern(curve.stroke) {
                None => scene.path(piece, STROKE, ink),
                Some((dash, gap)) => {
                    dashes(&piece, dash, gap).into_iter().for_each(|dash| scene.path(dash, STROKE, ink));
                }
            }
        }
        // A point alone is no line.
        if let [place] = places[..]
            && !curve.marked
            && plot.contains(&Area::about(place, 0.0))
        {
            marker::marker(scene, Form::Disc, place, 0.8 * MARKER, ink);
        }
    }
    // A known value at 0 or ∞ is a dash there, a solution a marker.
    for point in curve.points.iter().filter(|point| chart.has_place(**point) && layout.x.is_special(point.0)) {
        let (x, y) = layout.at(*point);
        if matches!(curve.stroke, Stroke::Solid | Stroke::Points) {
            marker::rimmed(scene, form, (x, y), MARKER, ink);
        } else {
            scene.line((x - 2.0 * MARKER, y), (x + 2.0 * MARKER, y), STROKE, ink);
        }
    }
    if curve.marked {
        let thinned = curve.stroke != Stroke::Points && curve.points.len() > MOST_MARKERS;
        let step = if thinned { curve.points.len().div_ceil(MOST_MARKERS / 2) } else { 1 };
        let shown = curve.points.iter().step_by(step).filter(|point| joined(point));
        for place in shown.map(|point| layout.at(*point)).filter(|place| plot.contains(&Area::about(*place, 0.0))) {
            marker::rimmed(scene, form, place, MARKER, ink);
        }
    }
    for x in &curve.failed {
        let place = (plot.left + plot.width() * layout.x.share(*x), plot.bottom - 0.45 * EM);
        marker::cross(scene, place, 0.2 * EM, 0.09 * EM, FAILED_CROSS);
    }
}

fn entries(chart: &Lines) -> Vec<Entry> {
    let named = chart.curves.iter().zip(forms(chart)).filter(|(curve, _)| !curve.label.is_empty());
    let mut entries: Vec<Entry> = named
        .map(|(curve, form)| {
            let (marker, ink) = (curve.marked.then_some(form), ink(curve.colour));
            let swatch = match curve.stroke {
                Stroke::Points => Swatch::Marker { form, ink },
                stroke => Swatch::Stroke { pattern: pattern(stroke), form: marker, ink },
            };
            Entry { swatch, label: curve.label.clone() }
        })
        .collect();
    if chart.curves.iter().any(|curve| !curve.failed.is_empty()) {
        entries.push(Entry { swatch: Swatch::Cross { ink: FAILED_CROSS }, label: "failed".to_string() });
    }
    entries
}
