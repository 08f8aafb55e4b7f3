//! One quantity over two axes: the layout.

use super::cell_axis::CellAxis;
use super::colour_bar::ColourRange;
use super::legend::{self, Entry, Swatch};
use super::map::{Cell, Map, Panel};
use super::paint::WIDTH;
use super::palette::{EXACT, FAILED, FAILED_CROSS, FRAME, PAPER, SOLVED, TEXT, UNKNOWN};
use super::scene::{Anchor, Area, Point, Scene, thickness};
use super::ticks::{Tick, Ticks};
use super::{font, map_contours, marker};

const MARGIN: f64 = 30.0;
/// More columns than this are folded into several lines of panels.
const MOST_COLUMNS: usize = 4;

/// What all panels share.
struct Layout {
    em: f64,
    x: CellAxis,
    y: CellAxis,
    x_ticks: Ticks,
    y_ticks: Ticks,
    colours: Option<ColourRange>,
    /// Where lines of equal value are drawn.
    levels: Vec<f64>,
}

/// The chart, which has been checked.
pub(super) fn draw(map: &Map) -> Scene {
    let mut scene = Scene::default();
    let rows = map.rows.len();
    let folds = map.columns.len().div_ceil(MOST_COLUMNS);
    let columns = map.columns.len().div_ceil(folds);
    let em = font::size(columns);
    let right = f64::from(WIDTH) - MARGIN;
    let top = scene.heading(1.15 * em, MARGIN, right - MARGIN, &map.title, &map.subtitle) + 0.4 * em;

    let values: Vec<f64> = map.values().collect();
    let colours = ColourRange::of(&values, map.scale.logarithmic, map.scale.range);
    let (x, y) = (CellAxis::new(&map.x), CellAxis::new(&map.y));

    // Widths. The height follows from the width of a panel, and the labels that fit from both, so they are found in a few
    // rounds: first with a panel of the width it would have without labels.
    let across = |panel: f64, gap: f64| columns as f64 * panel + (columns as f64 - 1.0) * gap;
    let mut panel_width = (right - MARGIN - 6.0 * em) / columns as f64;
    let (mut gap, mut left, mut bar_left) = (0.0, 0.0, 0.0);
    let (mut panel_height, mut bar_length) = (0.0, 0.0);
    for _ in 0..4 {
        panel_height = (panel_width * if columns == 1 { 0.75 } else { 0.9 }).max(9.0 * em);
        bar_length = panel_height * if rows * folds == 1 { 1.0 } else { 1.6 };
        let y_ticks = y.ticks(panel_height, em, true);
        let widest = y_ticks.major.iter().map(|tick| font::width(&tick.label, em)).fold(0.0, f64::max);
        left = MARGIN + thickness(&map.y_label, 1.1 * em, panel_height) + 0.5 * em + widest + 0.4 * em;
        let x_ticks = x.ticks(panel_width, em, false);
        let overhang = overhang(&x, &x_ticks, panel_width, em);
        gap = (overhang.0 + overhang.1 + 0.5 * em).max(0.9 * em).max(gap);
        let bar = colours.map_or(0.0, |range| range.width(bar_length, em, &map.scale.label) + 0.8 * em);
        let panels_right = right - bar - overhang.1;
        panel_width = (panels_right - left - (columns as f64 - 1.0) * gap) / columns as f64;
        bar_left = left + across(panel_width, gap) + overhang.1.max(0.0) + 0.8 * em;
    }
    let x_ticks = x.ticks(panel_width, em, false);
    let y_ticks = y.ticks(panel_height, em, true);
    let levels = match colours {
        Some(range) if map.contours => map_contours::levels(&range.ticks(bar_length, em), &values),
        _ => vec![],
    };
    let layout = Layout { em, x, y, x_ticks, y_ticks, colours, levels };

    // Downwards: each row under its label, folded if it has many columns. The labels of columns stand once above all rows,
    // or above each fold.
    let mut bottom = top;
    if folds == 1 {
        bottom = draw_heads(&mut scene, &map.columns, (left, bottom), (panel_width, gap), em);
    }
    let mut first_top = None;
    for (row, label) in map.rows.iter().enumerate() {
        bottom = scene.paragraph((left, bottom + 0.1 * em), Anchor::Start, em, TEXT, across(panel_width, gap), label);
        for fold in 0..folds {
            let held = fold * columns..((fold + 1) * columns).min(map.columns.len());
            if folds > 1 {
                bottom = draw_heads(&mut scene, &map.columns[held.clone()], (left, bottom), (panel_width, gap), em);
            }
            let top = bottom + 0.35 * em;
            first_top.get_or_insert(top);
            for column in held {
                let from = left + (column % columns) as f64 * (panel_width + gap);
                let area = Area { left: from, top, right: from + panel_width, bottom: top + panel_height };
                draw_cells(&mut scene, map, &layout, &map.panels[row * map.columns.len() + column], area);
                let lowest = row + 1 == rows && column + columns >= map.columns.len();
                draw_ticks(&mut scene, &layout, area, column % columns == 0, lowest);
            }
            bottom = top + panel_height + 0.7 * em;
        }
    }
    let panels = Area {
        left,
        top: first_top.expect("the map was checked and has a row"),
        right: left + across(panel_width, gap),
        bottom: bottom - 0.7 * em,
    };
    scene.upright((MARGIN, panels.centre().1), 1.1 * em, TEXT, panels.height(), &map.y_label);
    let names_top = panels.bottom + 1.8 * em;
    let names =
        scene.paragraph((panels.centre().0, names_top), Anchor::Middle, 1.1 * em, TEXT, panels.width(), &map.x_label);
    if let Some(range) = layout.colours {
        let bar_top = panels.centre().1 - 0.5 * bar_length;
        range.draw(&mut scene, (bar_left, bar_top), bar_length, em, &map.scale.label);
        for across in range.across((bar_left, bar_top), bar_length, em, &layout.levels) {
            map_contours::stroke(&mut scene, across, em);
        }
    }
    let entries = entries(map);
    let below = names + 0.4 * em;
    let end = if entries.is_empty() {
        below
    } else {
        legend::draw(&mut scene, &entries, (left, below), right, em) + 0.6 * em
    };
    scene.height = end.ceil();
    scene
}

/// Draws the labels of columns of this width and gap side by side; returns where they end.
fn draw_heads(scene: &mut Scene, labels: &[String], (left, top): Point, (width, gap): (f64, f64), em: f64) -> f64 {
    let height = |label: &String| thickness(label, em, width);
    let bottom = top + labels.iter().map(height).fold(0.0, f64::max);
    for (column, label) in labels.iter().enumerate() {
        let centre = left + column as f64 * (width + gap) + 0.5 * width;
        scene.paragraph((centre, bottom - height(label)), Anchor::Middle, em, TEXT, width, label);
    }
    bottom
}

/// How far labels of the horizontal axis stand out of their panel, to the left and to the right.
fn overhang(axis: &CellAxis, ticks: &Ticks, length: f64, em: f64) -> (f64, f64) {
    let ends = |tick: &Tick| {
        let (middle, half) = (length * axis.share(tick.value), 0.5 * font::width(&tick.label, em));
        (half - middle, middle + half - length)
    };
    ticks.major.iter().map(ends).fold((0.0, 0.0), |out: (f64, f64), end| (out.0.max(end.0), out.1.max(end.1)))
}

fn draw_cells(scene: &mut Scene, map: &Map, layout: &Layout, panel: &Panel, area: Area) {
    let inside = |(from_x, to_x): (f64, f64), (from_y, to_y): (f64, f64)| Area {
        left: area.left + area.width() * from_x,
        right: area.left + area.width() * to_x,
        top: area.bottom - area.height() * to_y,
        bottom: area.bottom - area.height() * from_y,
    };
    for (k, cell) in panel.cells.iter().enumerate() {
        let place = inside(layout.x.cell(k % map.x.len()), layout.y.cell(k / map.x.len()));
        let ink = match cell {
            Cell::Value(value) => match layout.colours {
                Some(range) if !(map.scale.logarithmic && *value == 0.0) => range.ink(*value),
                _ => EXACT,
            },
            Cell::Failed => FAILED,
            Cell::Unknown => UNKNOWN,
            Cell::Solved => SOLVED,
            Cell::Absent => continue,
        };
        scene.rectangle(place, ink);
        if *cell == Cell::Failed {
            let reach = (0.3 * place.width().min(place.height())).min(0.4 * layout.em);
            marker::cross(scene, place.centre(), reach, 0.09 * layout.em, FAILED_CROSS);
        }
    }
    let axes = (&layout.x, &layout.y);
    for line in layout.levels.iter().flat_map(|level| map_contours::lines(map, panel, axes, &area, *level)) {
        map_contours::stroke(scene, line, layout.em);
    }
    for across in layout.x.blocks() {
        for up in layout.y.blocks() {
            scene.frame(inside(*across, *up), 2.0, FRAME);
        }
    }
}

fn draw_ticks(scene: &mut Scene, layout: &Layout, area: Area, with_y_labels: bool, with_x_labels: bool) {
    let em = layout.em;
    let x = |value: f64| area.left + area.width() * layout.x.share(value);
    let y = |value: f64| area.bottom - area.height() * layout.y.share(value);
    for tick in &layout.x_ticks.major {
        let at = x(tick.value);
        scene.line((at, area.bottom), (at, area.bottom + 0.25 * em), 2.0, FRAME);
        if with_x_labels {
            scene.text((at, area.bottom + 1.4 * em), Anchor::Middle, em, TEXT, tick.label.as_str());
        }
    }
    for value in &layout.x_ticks.minor {
        scene.line((x(*value), area.bottom), (x(*value), area.bottom + 0.13 * em), 2.0, FRAME);
    }
    for tick in &layout.y_ticks.major {
        let at = y(tick.value);
        scene.line((area.left - 0.25 * em, at), (area.left, at), 2.0, FRAME);
        if with_y_labels {
            scene.text((area.left - 0.4 * em, at + 0.36 * em), Anchor::End, em, TEXT, tick.label.as_str());
        }
    }
    for value in &layout.y_ticks.minor {
        scene.line((area.left - 0.13 * em, y(*value)), (area.left, y(*value)), 2.0, FRAME);
    }
}

/// Entries for what the map shows beside values.
fn entries(map: &Map) -> Vec<Entry> {
    let shown = |is: &dyn Fn(&Cell) -> bool| map.cells().any(is);
    let zero = |cell: &Cell| map.scale.logarithmic && *cell == Cell::Value(0.0);
    let kinds = [
        (shown(&|cell| *cell == Cell::Failed), FAILED, true, "failed"),
        (shown(&zero), EXACT, false, "0 (exact)"),
        (shown(&|cell| *cell == Cell::Unknown), UNKNOWN, false, "solved, quantity not known"),
        (shown(&|cell| *cell == Cell::Solved), SOLVED, false, "converged"),
        (shown(&|cell| *cell == Cell::Absent), PAPER, false, "no case"),
    ];
    let entry = |(_, ink, crossed, label): (bool, _, _, &str)| Entry {
        swatch: Swatch::Cell { ink, crossed },
        label: label.to_string(),
    };
    kinds.into_iter().filter(|kind| kind.0).map(entry).collect()
}
