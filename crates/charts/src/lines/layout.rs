//! Curves in a plane: where everything lies, and how it is drawn.

use super::{Colour, Curve, Lines, Stroke};
use crate::axes::Axis;
use crate::axes::scaled_axis::ScaledAxis;
use crate::axes::ticks::Ticks;
use crate::frame::legend::{Entry, Swatch};
use crate::frame::{self, MARGIN, RIGHT, Side, Style};
use crate::geometry::polygon;
use crate::geometry::polyline::{self, clipped, dashes};
use crate::paint::marker::{self, Form};
use crate::paint::palette::{self, FAILED_CROSS, FRAME, Ink, QUIET_TEXT, TEXT, faded};
use crate::paint::scene::{Area, Point, Scene, Shape};
use crate::paper::Paper;

/// Height of the plot by default.
const HEIGHT: f64 = 960.0;
/// Width of a curve, and of a faint one.
const STROKE: f64 = 5.0;
const FAINT_STROKE: f64 = 2.0;
/// Opacity of the shade of a band.
const SHADE: f64 = 0.4;
/// Radius of a marker.
const MARKER: f64 = 9.0;
/// All points of a curve are marked if they are at most this many, else about half as many of them.
const MOST_MARKERS: usize = 24;
/// So many curves have their markers at different points, if not all are marked.
const STAGGERED: usize = 5;

/// Where everything lies.
struct Layout {
    style: Style,
    plot: Area,
    x: ScaledAxis,
    y: ScaledAxis,
    x_ticks: Ticks,
    y_ticks: Ticks,
}

impl Layout {
    /// The widest plot of this height below `top` that leaves room for its labels.
    fn new(chart: &Lines, style: Style, top: f64, height: f64) -> Self {
        let (x, y) = axes(chart);
        let em = style.em;
        let y_ticks = y.ticks(height, em, true);
        let left = style.plot_left(&chart.y.label, height, y_ticks.widest(em));
        let x_ticks = x.ticks(RIGHT - left, em, false);
        // Half of the last label of the horizontal axis may stand out to the right.
        let (_, out) = frame::overhang(&x, &x_ticks, RIGHT - left, em);
        let plot = Area { left, top, right: RIGHT - out.max(0.3 * em), bottom: top + height };
        Layout { style, plot, x, y, x_ticks, y_ticks }
    }

    fn x(&self, value: f64) -> f64 {
        self.plot.left + self.plot.width() * self.x.share(value)
    }

    fn y(&self, value: f64) -> f64 {
        self.plot.bottom - self.plot.height() * self.y.share(value)
    }

    fn at(&self, (x, y): Point) -> Point {
        (self.x(x), self.y(y))
    }
}

/// The axes that show all points.
fn axes(chart: &Lines) -> (ScaledAxis, ScaledAxis) {
    let x_room = if chart.curves.iter().any(|curve| curve.mark.is_some()) { 0.02 } else { 0.0 };
    let x_values = chart.shown().map(|point| point.0).chain(chart.failed());
    let x = ScaledAxis::new(x_values, chart.x.logarithmic, chart.x.range, x_room);
    // What lies outside the horizontal range does not stretch the vertical one.
    let inside = |value: f64| x.is_special(value) || (-1e-9..=1.0 + 1e-9).contains(&x.share(value));
    let y_values = || chart.shown().filter(|point| inside(point.0)).map(|point| point.1);
    let y = ScaledAxis::new(y_values(), chart.y.logarithmic, chart.y.range, 0.05);
    let y = if chart.y.range.is_none() { y.begun_at_zero(y_values()) } else { y };
    (x, y)
}

/// Draws the chart, which has been checked and has something to show.
pub(crate) fn draw(chart: &Lines, paper: &Paper, stretch: f64) -> Scene {
    let mut scene = Scene::default();
    let style = Style::plot(paper);
    let top = style.heading(&mut scene, &chart.title, &chart.subtitle);
    let layout = Layout::new(chart, style, top, stretch * HEIGHT);
    let plot = layout.plot;
    let x = Side { ticks: &layout.x_ticks, at: &|value| layout.x(value) };
    let y = Side { ticks: &layout.y_ticks, at: &|value| layout.y(value) };
    style.grid(&mut scene, plot, &x, &y);
    // What is beyond the ends of the axis is set off.
    let (from, to) = layout.x.span();
    for border in [from, to].into_iter().filter(|share| (0.0 < *share) && (*share < 1.0)) {
        let x = plot.left + plot.width() * border;
        scene.line((x, plot.top), (x, plot.bottom), 2.0, FRAME);
    }
    let mut below = None;
    for curve in chart.curves.iter().filter(|curve| curve.stroke == Stroke::Band) {
        draw_shade(&mut scene, &layout, chart, curve, below.replace(curve));
    }
    for curve in &chart.curves {
        draw_line(&mut scene, &layout, chart, curve);
    }
    for curve in &chart.curves {
        draw_markers(&mut scene, &layout, chart, curve);
    }
    scene.frame(plot, 3.0, FRAME);
    style.ticks_below(&mut scene, plot, &x, true);
    style.ticks_beside(&mut scene, plot, &y, true);
    let below = style.names(&mut scene, plot, &chart.x.label, &chart.y.label);
    style.finish(&mut scene, &entries(chart), (MARGIN, below));
    scene
}

/// The colour of a curve.
fn ink(colour: Colour) -> Ink {
    match colour {
        Colour::Kind(index) => palette::line_colour(index),
        Colour::Family(share) => palette::family_colour(share),
        Colour::Black => TEXT,
        Colour::Faint => QUIET_TEXT,
    }
}

/// Lengths of dash and gap.
fn pattern(stroke: Stroke) -> Option<(f64, f64)> {
    match stroke {
        Stroke::Solid | Stroke::Points | Stroke::Band => None,
        Stroke::Dashed => Some((22.0, 13.0)),
        Stroke::Dotted => Some((5.0, 9.0)),
    }
}

/// Whether a point is joined to its neighbours: it has a place between the ends of the axes.
fn is_joined(chart: &Lines, layout: &Layout, point: &Point) -> bool {
    chart.has_place(*point) && !layout.x.is_special(point.0)
}

/// Draws what lies between a band and the one below, or zero.
fn draw_shade(scene: &mut Scene, layout: &Layout, chart: &Lines, curve: &Curve, below: Option<&Curve>) {
    let floor = |i: usize| below.map_or((curve.points[i].0, 0.0), |below| below.points[i]);
    let joined = |i: &usize| is_joined(chart, layout, &curve.points[*i]) && is_joined(chart, layout, &floor(*i));
    let all: Vec<usize> = (0..below.map_or(usize::MAX, |below| below.points.len()).min(curve.points.len())).collect();
    for run in all.split(|i| !joined(i)) {
        let upper = run.iter().map(|i| layout.at(curve.points[*i]));
        let corners: Vec<Point> = upper.chain(run.iter().rev().map(|i| layout.at(floor(*i)))).collect();
        let corners = polygon::clipped(&corners, &layout.plot);
        if !corners.is_empty() {
            scene.shapes.push(Shape::Polygon { corners, ink: faded(ink(curve.colour), SHADE) });
        }
    }
}

/// Draws the line of a curve, and the points that are joined to no other one.
fn draw_line(scene: &mut Scene, layout: &Layout, chart: &Lines, curve: &Curve) {
    let (ink, plot) = (ink(curve.colour), layout.plot);
    let width = if curve.colour == Colour::Faint { FAINT_STROKE } else { STROKE };
    let runs = curve.points.split(|point| !is_joined(chart, layout, point));
    let runs: Vec<Vec<Point>> = runs.map(|run| run.iter().map(|point| layout.at(*point)).collect()).collect();
    let length: f64 = runs.iter().flat_map(|places| clipped(places, &plot)).map(|piece| polyline::length(&piece)).sum();
    let has_room = |(dash, gap): &(f64, f64)| polyline::has_room_for_dashes(length, *dash, *gap);
    for places in runs {
        for piece in clipped(&places, &plot).into_iter().filter(|_| curve.stroke != Stroke::Points) {
            match pattern(curve.stroke).filter(has_room) {
                None => scene.path(piece, width, ink),
                Some((dash, gap)) => {
                    dashes(&piece, dash, gap).into_iter().for_each(|dash| scene.path(dash, width, ink));
                }
            }
        }
        // A point alone is no line.
        if let [place] = places[..]
            && curve.mark.is_none()
            && plot.contains(&Area::about(place, 0.0))
        {
            marker::marker(scene, Form::DISC, place, 0.8 * MARKER, ink);
        }
    }
}

/// Draws the markers of a curve: values at 0 and ∞, points if these are marked, cases that failed.
fn draw_markers(scene: &mut Scene, layout: &Layout, chart: &Lines, curve: &Curve) {
    let (ink, plot, em) = (ink(curve.colour), layout.plot, layout.style.em);
    let form = curve.mark.map_or(Form::DISC, Form::of);
    // A known value at 0 or ∞ is a dash there, a solution a marker.
    let inside = |at: &Point| plot.grown(1e-6).contains(&Area::about(*at, 0.0));
    let special = curve.points.iter().filter(|point| chart.has_place(**point) && layout.x.is_special(point.0));
    for (x, y) in special.map(|point| layout.at(*point)).filter(inside) {
        if matches!(curve.stroke, Stroke::Solid | Stroke::Points | Stroke::Band) {
            marker::rimmed(scene, form, (x, y), MARKER, ink);
        } else {
            scene.line((x - 2.0 * MARKER, y), (x + 2.0 * MARKER, y), STROKE, ink);
        }
    }
    if let Some(mark) = curve.mark {
        let thinned = curve.stroke != Stroke::Points && curve.points.len() > MOST_MARKERS;
        let step = if thinned { curve.points.len().div_ceil(MOST_MARKERS / 2) } else { 1 };
        // Those of neighbours stand beside each other.
        let first = step * (mark % STAGGERED) / STAGGERED;
        let shown = curve.points.iter().skip(first).step_by(step).filter(|point| is_joined(chart, layout, point));
        for place in shown.map(|point| layout.at(*point)).filter(|place| plot.contains(&Area::about(*place, 0.0))) {
            marker::rimmed(scene, form, place, MARKER, ink);
        }
    }
    let failed = curve.failed.iter().map(|x| (layout.x(*x), plot.bottom - 0.45 * em));
    for at in failed.filter(inside) {
        marker::cross(scene, at, 0.2 * em, 0.09 * em, FAILED_CROSS);
    }
}

/// The legend: curves with names, and what a cross means if there is one.
fn entries(chart: &Lines) -> Vec<Entry> {
    let named = chart.curves.iter().filter(|curve| !curve.label.is_empty());
    let mut entries: Vec<Entry> = named
        .map(|curve| {
            let (form, ink) = (curve.mark.map(Form::of), ink(curve.colour));
            let swatch = match curve.stroke {
                Stroke::Points => Swatch::Marker { form: form.unwrap_or(Form::DISC), ink },
                stroke => Swatch::Stroke { pattern: pattern(stroke), form, ink },
            };
            Entry { swatch, label: curve.label.clone() }
        })
        .collect();
    if chart.curves.iter().any(|curve| !curve.failed.is_empty()) {
        entries.push(Entry { swatch: Swatch::Cross { ink: FAILED_CROSS }, label: "failed".to_string() });
    }
    entries
}
