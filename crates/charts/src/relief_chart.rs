//! A quantity as height over two axes: the layout.

use super::colour_bar::ColourRange;
use super::font;
use super::legend::{self, Entry, Swatch};
use super::log_axis::LogAxis;
use super::paint::WIDTH;
use super::palette::{self, Ink, TEXT};
use super::relief::{Relief, ReliefCurve, ReliefPanel};
use super::relief_box::Axes;
use super::relief_curve::{self, Piece, Style};
use super::relief_surface::Surface;
use super::scene::{Anchor, Scene, thickness};
use super::space::{Place, Space};

const MARGIN: f64 = 30.0;
/// Lengths of dash and gap of a curve over the size of the font.
const PATTERN: (f64, f64) = (0.5, 0.3);

/// The chart, which has been checked and has a height to show.
pub(super) fn draw(chart: &Relief) -> Scene {
    let mut scene = Scene::default();
    let panels = chart.panels.len() as f64;
    let em = font::size(chart.panels.len());
    let right = f64::from(WIDTH) - MARGIN;
    let top = scene.heading(1.15 * em, MARGIN, right - MARGIN, &chart.title, &chart.subtitle) + 0.4 * em;
    let ends = |values: &[f64]| LogAxis::between(values[0], values[values.len() - 1]);
    let axes = Axes { x: ends(&chart.x), y: ends(&chart.y), z: range(chart), em };

    // The height of a box follows from its width, and the room that labels take from both, so they are found in a few rounds.
    let mut width = (right - MARGIN - 8.0 * em) / panels;
    let (mut first, mut gap, mut beside) = (0.0, 0.0, 0.0);
    let (mut upright, mut bar_length) = (0.0, 0.0);
    for _ in 0..4 {
        let height = Space::height(width);
        (upright, bar_length) = (height.max(8.0 * em), (0.9 * height).max(8.0 * em));
        let (of_heights, of_x, of_y) = axes.overhang(&axes.ticks(width));
        first = MARGIN + (axes.height_name_width(upright, &chart.z_label) + 0.3 * em + of_heights).max(of_x);
        (gap, beside) = (of_y + of_x.max(0.4 * em) + 0.4 * em, of_y);
        let bar = axes.z.width(bar_length, em, &chart.z_label) + 0.8 * em;
        width = (right - bar - beside - first - (panels - 1.0) * gap) / panels;
    }
    let ticks = axes.ticks(width);
    let left = |panel: usize| first + panel as f64 * (width + gap);

    let height = |label: &String| thickness(label, em, width);
    let heads = chart.panels.iter().map(|panel| height(&panel.label)).fold(0.0, f64::max);
    let box_top = top + heads + 0.3 * em + 0.5 * (bar_length - Space::height(width)).max(0.0);
    let names = curve_names(chart);
    let mut bottom = box_top;
    for (i, panel) in chart.panels.iter().enumerate() {
        let space = Space::new((left(i), box_top), width);
        let centre = left(i) + 0.5 * width;
        scene.paragraph((centre, top + heads - height(&panel.label)), Anchor::Middle, em, TEXT, width, &panel.label);
        axes.draw_walls(&mut scene, &space, &ticks);
        let surface = surface(chart, panel, &axes);
        let style = |curve: &ReliefCurve| Style {
            width: 0.13 * em,
            pattern: (PATTERN.0 * em, PATTERN.1 * em),
            ink: ink(&names, curve),
        };
        let pieces: Vec<Piece> = panel
            .curves
            .iter()
            .flat_map(|curve| runs(chart, curve, &axes).into_iter().map(move |run| (run, curve)))
            .flat_map(|(run, curve)| relief_curve::pieces(&run, &surface, &space, style(curve)))
            .collect();
        surface.draw(&mut scene, &space, &pieces);
        let labels = axes.draw_labels(&mut scene, &space, &ticks, i == 0);
        let from = if i == 0 { MARGIN } else { left(i - 1) + width + beside + 0.2 * em };
        let sides = (from, left(i) + width + beside);
        bottom = f64::max(
            bottom,
            axes.draw_names(&mut scene, &space, (&ticks, &labels), sides, (&chart.x_label, &chart.y_label)),
        );
        if i == 0 {
            axes.draw_height_name(&mut scene, &space, MARGIN, upright, &chart.z_label);
        }
    }
    let bar =
        (right - axes.z.width(bar_length, em, &chart.z_label), box_top + 0.5 * (Space::height(width) - bar_length));
    axes.z.draw(&mut scene, bar, bar_length, em, &chart.z_label);
    bottom = bottom.max(bar.1 + bar_length + 0.7 * em);
    let entry = |name: &&str| Entry {
        swatch: Swatch::Stroke { pattern: Some((0.4 * em, 0.25 * em)), form: None, ink: colour(&names, name) },
        label: (*name).to_string(),
    };
    let entries: Vec<Entry> = names.iter().map(entry).collect();
    if !entries.is_empty() {
        bottom = legend::draw(&mut scene, &entries, (MARGIN, bottom + 0.4 * em), right, em);
    }
    scene.height = (bottom + 0.5 * em).ceil();
    scene
}

/// The range of heights and colours: from zero unless heights are far above it, if none is wanted.
fn range(chart: &Relief) -> ColourRange {
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

fn surface(chart: &Relief, panel: &ReliefPanel, axes: &Axes) -> Surface {
    let height =
        |height: &Option<f64>| height.filter(|height| chart.has_place(*height)).map(|height| share(axes, height));
    Surface {
        x: chart.x.iter().map(|x| axes.x.share(*x)).collect(),
        y: chart.y.iter().map(|y| axes.y.share(*y)).collect(),
        heights: panel.heights.iter().map(height).collect(),
    }
}

/// The parts of a curve with a place on the axis of heights, in the box.
fn runs(chart: &Relief, curve: &ReliefCurve, axes: &Axes) -> Vec<Vec<Place>> {
    let place = |(x, y, z): &(f64, f64, f64)| (axes.x.share(*x), axes.y.share(*y), share(axes, *z));
    curve.points.split(|point| !chart.has_place(point.2)).map(|run| run.iter().map(place).collect()).collect()
}

/// The names of curves, each once.
fn curve_names(chart: &Relief) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in chart.panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.label.as_str()) {
            names.push(&curve.label);
        }
    }
    names
}

fn ink(names: &[&str], curve: &ReliefCurve) -> Ink {
    colour(names, &curve.label)
}

/// The colour of curves of a name. The first of the colours, blue, is one of viridis and comes last.
fn colour(names: &[&str], name: &str) -> Ink {
    palette::line_colour(1 + names.iter().position(|other| *other == name).expect("every curve has a name"))
}
