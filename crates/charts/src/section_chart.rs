//! A field below a deformed surface: the layout.

use super::bands::patches;
use super::colour_bar::ColourRange;
use super::contours::Grid;
use super::legend::{self, Entry, Swatch};
use super::paint::WIDTH;
use super::palette::{FRAME, PAPER, TEXT, UNKNOWN, faded};
use super::plane_axis::PlaneAxis;
use super::polyline;
use super::scene::{Anchor, Area, Point, Scene, Shape, thickness};
use super::section::{Section, SectionPanel};
use super::ticks::Ticks;
use super::{font, polygon};

const MARGIN: f64 = 30.0;
/// Most panels side by side.
const MOST_COLUMNS: usize = 2;

/// What all panels share.
struct Layout {
    em: f64,
    x: PlaneAxis,
    y: PlaneAxis,
    x_ticks: Ticks,
    y_ticks: Ticks,
    colours: ColourRange,
    logarithmic: bool,
}

/// The chart, which has been checked.
pub(super) fn draw(chart: &Section) -> Scene {
    let mut scene = Scene::default();
    let columns = chart.panels.len().min(MOST_COLUMNS);
    let rows = chart.panels.len().div_ceil(columns);
    let em = font::size(columns);
    let right = f64::from(WIDTH) - MARGIN;
    let top = scene.heading(1.15 * em, MARGIN, right - MARGIN, &chart.title, &chart.subtitle) + 0.4 * em;

    let values: Vec<f64> = chart.panels.iter().flat_map(|panel| &panel.values).copied().collect();
    let colours = ColourRange::of(&values, chart.scale.logarithmic, chart.scale.range)
        .expect("the chart was checked and has values")
        .in_bands(chart.levels);
    let axis = |range| PlaneAxis::new(std::iter::empty(), false, Some(range), 0.0);
    let (x, y) = (axis(chart.x_range), axis(chart.y_range));

    // The height follows from the width of a panel, and the labels that fit from both, so they are found in a few rounds.
    let mut width = (right - MARGIN - 8.0 * em) / columns as f64;
    let (mut height, mut gap, mut left, mut bar_length) = (0.0, 0.0, 0.0, 0.0);
    for _ in 0..4 {
        height = (width * if columns == 1 { 0.72 } else { 0.66 }).max(8.0 * em);
        bar_length = height * if rows == 1 { 1.0 } else { 1.6 };
        let y_ticks = y.ticks(height, em, true);
        let widest = y_ticks.major.iter().map(|tick| font::width(&tick.label, em)).fold(0.0, f64::max);
        left = MARGIN + thickness(&chart.y_label, 1.1 * em, height) + 0.3 * em + widest + 0.4 * em;
        // Half of the last label of a panel, and of the first one of the next, stand out.
        let out = x.ticks(width, em, false).major.iter().fold((0.0, 0.0), |out: (f64, f64), tick| {
            let (middle, half) = (width * x.share(tick.value), 0.5 * font::width(&tick.label, em));
            (out.0.max(half - middle), out.1.max(middle + half - width))
        });
        gap = (out.0 + out.1 + 0.5 * em).max(0.9 * em);
        let bar = colours.width(bar_length, em, &chart.scale.label) + 0.8 * em + out.1;
        width = (right - bar - left - (columns as f64 - 1.0) * gap) / columns as f64;
    }
    let (x_ticks, y_ticks) = (x.ticks(width, em, false), y.ticks(height, em, true));
    let layout = Layout { em, x, y, x_ticks, y_ticks, colours, logarithmic: chart.scale.logarithmic };

    let mut bottom = top;
    let mut first_top = None;
    for (row, panels) in chart.panels.chunks(columns).enumerate() {
        let head = |panel: &SectionPanel| thickness(&panel.label, em, width);
        let heads = panels.iter().map(head).fold(0.0, f64::max);
        let top = bottom + heads + 0.3 * em;
        first_top.get_or_insert(top);
        for (column, panel) in panels.iter().enumerate() {
            let from = left + column as f64 * (width + gap);
            let area = Area { left: from, top, right: from + width, bottom: top + height };
            let at = (area.centre().0, top - 0.3 * em - head(panel));
            scene.paragraph(at, Anchor::Middle, em, TEXT, width, &panel.label);
            draw_panel(&mut scene, &layout, panel, area);
            let lowest = (row + 1) * columns + column >= chart.panels.len();
            draw_ticks(&mut scene, &layout, area, column == 0, lowest);
        }
        bottom = top + height + 0.6 * em;
    }
    let panels = Area {
        left,
        top: first_top.expect("the chart was checked and has a panel"),
        right: left + columns as f64 * width + (columns as f64 - 1.0) * gap,
        bottom: bottom - 0.6 * em,
    };
    scene.upright((MARGIN, panels.centre().1), 1.1 * em, TEXT, panels.height(), &chart.y_label);
    let names_top = panels.bottom + 1.7 * em;
    let names =
        scene.paragraph((panels.centre().0, names_top), Anchor::Middle, 1.1 * em, TEXT, panels.width(), &chart.x_label);
    let bar_left = right - colours.width(bar_length, em, &chart.scale.label);
    layout.colours.draw(
        &mut scene,
        (bar_left, panels.centre().1 - 0.5 * bar_length),
        bar_length,
        em,
        &chart.scale.label,
    );
    let cylinder = Entry { swatch: Swatch::Cell { ink: UNKNOWN, crossed: false }, label: "cylinder".to_string() };
    let bottom = legend::draw(&mut scene, &[cylinder], (left, names + 0.3 * em), right, em);
    scene.height = (bottom + 0.6 * em).ceil();
    scene
}

fn draw_panel(scene: &mut Scene, layout: &Layout, panel: &SectionPanel, area: Area) {
    let at =
        |(x, y): Point| (area.left + area.width() * layout.x.share(x), area.bottom - area.height() * layout.y.share(y));
    let shown = |value: f64| if layout.logarithmic { value.log10() } else { value };
    let columns = panel.x.len();
    let place = |k: usize| at((panel.x[k % columns], panel.surface[k % columns] - panel.depth[k / columns]));
    let places: Vec<Point> = (0..panel.values.len()).map(place).collect();
    let values: Vec<f64> = panel.values.iter().map(|value| shown(*value)).collect();
    let boundaries: Vec<f64> = layout.colours.boundaries().into_iter().map(shown).collect();
    let inks = layout.colours.band_inks();
    for patch in patches(columns, &places, &values, &boundaries) {
        let corners = polygon::clipped(&patch.corners, &area);
        if !corners.is_empty() {
            scene.shapes.push(Shape::Polygon { corners, ink: inks[patch.band] });
        }
    }
    let known: Vec<Option<f64>> = values.into_iter().map(Some).collect();
    let grid = Grid { columns, places: &places, values: &known };
    for line in boundaries.iter().flat_map(|level| grid.contours(*level)) {
        polyline::clipped(&line, &area).into_iter().for_each(|piece| scene.path(piece, 1.5, faded(PAPER, 0.6)));
    }

    let line = |heights: &[f64]| -> Vec<Point> { panel.x.iter().zip(heights).map(|(x, y)| at((*x, *y))).collect() };
    let (surface, cylinder) = (line(&panel.surface), line(&panel.cylinder));
    let mut above = cylinder.clone();
    let highest = above.iter().map(|point| point.1).fold(area.top, f64::min);
    above.extend([(above[columns - 1].0, highest), (above[0].0, highest)]);
    let above = polygon::clipped(&above, &area);
    if !above.is_empty() {
        scene.shapes.push(Shape::Polygon { corners: above, ink: UNKNOWN });
    }
    polyline::clipped(&cylinder, &area).into_iter().for_each(|piece| scene.path(piece, 2.5, FRAME));
    polyline::clipped(&surface, &area).into_iter().for_each(|piece| scene.path(piece, 4.0, TEXT));
    scene.frame(area, 2.0, FRAME);
}

fn draw_ticks(scene: &mut Scene, layout: &Layout, area: Area, with_y_labels: bool, with_x_labels: bool) {
    let em = layout.em;
    for tick in &layout.x_ticks.major {
        let x = area.left + area.width() * layout.x.share(tick.value);
        scene.line((x, area.bottom), (x, area.bottom + 0.25 * em), 2.0, FRAME);
        if with_x_labels {
            scene.text((x, area.bottom + 1.3 * em), Anchor::Middle, em, TEXT, tick.label.as_str());
        }
    }
    for tick in &layout.y_ticks.major {
        let y = area.bottom - area.height() * layout.y.share(tick.value);
        scene.line((area.left - 0.25 * em, y), (area.left, y), 2.0, FRAME);
        if with_y_labels {
            scene.text((area.left - 0.4 * em, y + 0.36 * em), Anchor::End, em, TEXT, tick.label.as_str());
        }
    }
}
