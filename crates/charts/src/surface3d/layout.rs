//! A quantity as height over two axes: where everything lies, and how it is drawn.

use super::axes_box::{Axes, BoxTicks};
use super::curve::{self, Piece};
use super::mesh::Surface;
use super::projection::{Place, Space};
use super::{Surface3d, Surface3dCurve, Surface3dPanel};
use crate::axes::colour_scale::ColourRange;
use crate::axes::log_axis::LogAxis;
use crate::frame::legend::{Entry, Swatch};
use crate::frame::{MARGIN, RIGHT, Style};
use crate::paint::palette::{self, Ink, TEXT};
use crate::paint::scene::{Anchor, Scene, thickness};
use crate::paper::Paper;

/// Lengths of dash and gap of a curve over the size of the font.
const PATTERN: (f64, f64) = (0.5, 0.3);

/// Most rounds in which the room for labels is found.
const MOST_ROUNDS: usize = 12;

/// Where everything lies.
struct Layout {
    style: Style,
    axes: Axes,
    ticks: BoxTicks,
    /// The left side of the first box.
    left: f64,
    /// Width of a box, and from one to the next.
    width: f64,
    gap: f64,
    /// Room at the right of a box for the labels of y.
    beside: f64,
    /// Room along the name of the height.
    name_room: f64,
    bar_length: f64,
}

impl Layout {
    /// The widest boxes that leave room for their labels.
    ///
    /// The height of a box follows from its width, and the room that labels take follows from both, so the width is
    /// found in rounds, which start with a guess of that room. It grows from round to round until the labels of the
    /// width that is left fit it.
    fn new(chart: &Surface3d, paper: &Paper, stretch: f64) -> Self {
        let count = chart.panels.len() as f64;
        let style = Style { below_all: 0.5, ..Style::panels(chart.panels.len(), paper) };
        let em = style.em;
        let ends = |values: &[f64]| LogAxis::between(values[0], values[values.len() - 1]);
        let axes = Axes { x: ends(&chart.x), y: ends(&chart.y), z: range(chart), em, stretch };
        let mut width = (RIGHT - MARGIN - 8.0 * em) / count;
        let (mut left, mut gap, mut beside, mut bar) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        let (mut name_room, mut bar_length) = (0.0, 0.0);
        for _ in 0..MOST_ROUNDS {
            let (before, height) = ((left, gap, beside, bar), Space::height(width, stretch));
            (name_room, bar_length) = (height.max(8.0 * em), (0.9 * height).max(8.0 * em));
            let (of_heights, of_x, of_y) = axes.overhang(&axes.ticks(width));
            let names = axes.height_name_width(name_room, &chart.z_label) + 0.3 * em;
            left = left.max(MARGIN + names + of_heights.max(of_x));
            (gap, beside) = (gap.max(of_y + of_x.max(0.4 * em) + 0.4 * em), beside.max(of_y));
            bar = bar.max(axes.z.width(bar_length, em, &chart.z_label) + 0.8 * em);
            if (left, gap, beside, bar) == before {
                break;
            }
            // Where labels leave no room the box stays a box, and the picture is cut.
            width = ((RIGHT - bar - beside - left - (count - 1.0) * gap) / count).max(em);
        }
        let ticks = axes.ticks(width);
        Layout { style, axes, ticks, left, width, gap, beside, name_room, bar_length }
    }

    /// The left side of a box.
    fn left(&self, panel: usize) -> f64 {
        self.left + panel as f64 * (self.width + self.gap)
    }
}

/// Draws the chart, which has been checked and has a height to show.
pub(crate) fn draw(chart: &Surface3d, paper: &Paper, stretch: f64) -> Scene {
    let mut scene = Scene::default();
    let layout = Layout::new(chart, paper, stretch);
    let (em, width, bar_length) = (layout.style.em, layout.width, layout.bar_length);
    let box_height = Space::height(width, stretch);
    let top = layout.style.heading(&mut scene, &chart.title, &chart.subtitle);
    let label_height = |panel: &Surface3dPanel| thickness(&panel.label, em, width);
    let labels_bottom = top + chart.panels.iter().map(label_height).fold(0.0, f64::max);
    let box_top = labels_bottom + 0.3 * em + 0.5 * (bar_length - box_height).max(0.0);
    let mut bottom = box_top;
    for (i, panel) in chart.panels.iter().enumerate() {
        let centre = layout.left(i) + 0.5 * width;
        let at = (centre, labels_bottom - label_height(panel));
        scene.paragraph(at, Anchor::Middle, em, TEXT, width, &panel.label);
        bottom = f64::max(bottom, draw_panel(&mut scene, chart, &layout, i, box_top));
    }
    let scale = &layout.axes.z;
    let bar_left = RIGHT - scale.width(bar_length, em, &chart.z_label);
    let bar_top = box_top + 0.5 * (box_height - bar_length);
    scale.draw(&mut scene, (bar_left, bar_top), bar_length, em, &chart.z_label);
    bottom = bottom.max(bar_top + bar_length + 0.7 * em);
    layout.style.finish(&mut scene, &entries(chart, em), (MARGIN, bottom));
    scene
}

/// Draws a surface with its curves and its box, whose top is there. Returns where its names end.
fn draw_panel(scene: &mut Scene, chart: &Surface3d, layout: &Layout, i: usize, top: f64) -> f64 {
    let (axes, ticks, em) = (&layout.axes, &layout.ticks, layout.style.em);
    let panel = &chart.panels[i];
    let space = Space::new((layout.left(i), top), layout.width, axes.stretch);
    axes.draw_walls(scene, &space, ticks);
    let surface = surface(chart, panel, axes);
    let names = curve_names(chart);
    let style = |curve: &Surface3dCurve| curve::Style {
        width: 0.13 * em,
        pattern: (PATTERN.0 * em, PATTERN.1 * em),
        ink: colour(&names, &curve.label),
    };
    let pieces: Vec<Piece> = panel
        .curves
        .iter()
        .flat_map(|curve| runs(chart, curve, axes).into_iter().map(move |run| (run, curve)))
        .flat_map(|(run, curve)| curve::pieces(&run, &surface, &space, style(curve)))
        .collect();
    surface.draw(scene, &space, &pieces);
    let mut labels = axes.draw_labels(scene, &space, ticks, i == 0);
    if i == 0 {
        labels.extend(axes.draw_height_name(scene, &space, layout.name_room, &chart.z_label));
    }
    let right = |panel: usize| layout.left(panel) + layout.width + layout.beside;
    let sides = (if i == 0 { MARGIN } else { right(i - 1) + 0.2 * em }, right(i));
    axes.draw_names(scene, &space, (ticks, &labels), sides, (&chart.x_label, &chart.y_label))
}

/// The legend: the names of curves.
fn entries(chart: &Surface3d, em: f64) -> Vec<Entry> {
    let names = curve_names(chart);
    let entry = |name: &&str| Entry {
        swatch: Swatch::Stroke { pattern: Some((0.4 * em, 0.25 * em)), form: None, ink: colour(&names, name) },
        label: (*name).to_string(),
    };
    names.iter().map(entry).collect()
}

/// The range of heights and colours: from zero unless heights are far above it, if none is wanted.
fn range(chart: &Surface3d) -> ColourRange {
    let values: Vec<f64> = chart.shown().collect();
    let (least, most) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(*v), m.max(*v)));
    let from_zero = !chart.logarithmic && least > 0.0 && least < 0.5 * most;
    let wanted = chart.range.or_else(|| from_zero.then_some((0.0, most)));
    ColourRange::of(&values, chart.logarithmic, wanted).expect("the chart was checked and has a height")
}

/// A height as share of the box.
fn share(axes: &Axes, height: f64) -> f64 {
    axes.z.share(height).clamp(0.0, 1.0)
}

/// The surface of a panel, in shares of the box.
fn surface(chart: &Surface3d, panel: &Surface3dPanel, axes: &Axes) -> Surface {
    let height =
        |height: &Option<f64>| height.filter(|height| chart.has_place(*height)).map(|height| share(axes, height));
    Surface {
        x: chart.x.iter().map(|x| axes.x.share(*x)).collect(),
        y: chart.y.iter().map(|y| axes.y.share(*y)).collect(),
        heights: panel.heights.iter().map(height).collect(),
    }
}

/// The parts of a curve with a place on the axis of heights, in the box.
fn runs(chart: &Surface3d, curve: &Surface3dCurve, axes: &Axes) -> Vec<Vec<Place>> {
    let place = |(x, y, z): &(f64, f64, f64)| (axes.x.share(*x), axes.y.share(*y), share(axes, *z));
    curve.points.split(|point| !chart.has_place(point.2)).map(|run| run.iter().map(place).collect()).collect()
}

/// The names of curves, each once.
fn curve_names(chart: &Surface3d) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in chart.panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.label.as_str()) {
            names.push(&curve.label);
        }
    }
    names
}

/// The colour of curves of a name. The first of the colours, blue, is one of viridis and comes last.
fn colour(names: &[&str], name: &str) -> Ink {
    palette::line_colour(1 + names.iter().position(|other| *other == name).expect("every curve has a name"))
}
