//! A quantity as colour over two axes: where everything lies, and how it is drawn.

use super::{Cell, Map, Panel, contours};
use crate::axes::cell_axis::CellAxis;
use crate::axes::colour_scale::ColourRange;
use crate::frame::Style;
use crate::frame::legend::{Entry, Swatch};
use crate::frame::panels::{Demand, Panels};
use crate::paint::marker;
use crate::paint::palette::{EXACT, FAILED, FAILED_CROSS, FRAME, PAPER, SOLVED, TEXT, UNKNOWN};
use crate::paint::scene::{Anchor, Area, Scene};
use crate::paper::Paper;

/// More columns than this are folded into several lines of panels.
const MOST_COLUMNS: usize = 4;
/// Least height of a panel over the size of the font.
const LEAST_HEIGHT: f64 = 9.0;

/// What all panels share.
struct Layout {
    panels: Panels,
    /// Lines of panels for each row, and panels in each line.
    folds: usize,
    columns: usize,
    x: CellAxis,
    y: CellAxis,
    colours: Option<ColourRange>,
    /// Where lines of equal value are drawn.
    levels: Vec<f64>,
}

impl Layout {
    fn new(map: &Map, paper: &Paper, stretch: f64) -> Self {
        let folds = map.columns.len().div_ceil(MOST_COLUMNS);
        let columns = columns(map);
        let values: Vec<f64> = map.values().collect();
        let colours = ColourRange::of(&values, map.scale.logarithmic, map.scale.range);
        let (x, y) = (CellAxis::new(&map.x), CellAxis::new(&map.y));
        let panels = Panels::fit(&Demand {
            style: Style { beside_name: 0.5, ..Style::panels(columns, paper) },
            columns,
            axes: (&x, &y),
            y_name: &map.y_label,
            colours: colours.map(|scale| (scale, map.scale.label.as_str())),
            label_room: 6.0,
            height_over_width: stretch * if columns == 1 { 0.75 } else { 0.9 },
            least_height: LEAST_HEIGHT,
            bar_over_height: if map.rows.len() * folds == 1 { 1.0 } else { 1.6 },
        });
        let levels = match colours {
            Some(scale) if map.contours => contours::levels(&scale.ticks(panels.bar_length, panels.style.em), &values),
            _ => vec![],
        };
        Layout { panels, folds, columns, x, y, colours, levels }
    }
}

/// Panels in each line of panels.
pub(crate) fn columns(map: &Map) -> usize {
    let folds = map.columns.len().div_ceil(MOST_COLUMNS).max(1);
    map.columns.len().div_ceil(folds)
}

/// Draws the chart, which has been checked.
pub(crate) fn draw(map: &Map, paper: &Paper, stretch: f64) -> Scene {
    let mut scene = Scene::default();
    let layout = Layout::new(map, paper, stretch);
    let panels = &layout.panels;
    let style = panels.style;
    let top = style.heading(&mut scene, &map.title, &map.subtitle);
    let all = draw_panels(&mut scene, map, &layout, top);
    let below = style.names(&mut scene, all, &map.x_label, &map.y_label);
    if let Some(scale) = layout.colours {
        let corner = panels.draw_bar(&mut scene, all, &scale, &map.scale.label);
        for across in scale.across(corner, panels.bar_length, style.em, &layout.levels) {
            contours::stroke(&mut scene, across, style.em);
        }
    }
    style.finish(&mut scene, &entries(map), (panels.left, below));
    scene
}

/// Draws all panels below `top`, each row under its label, folded if it has many columns. Labels of columns stand once
/// above all rows, or above each fold. Returns the area of the panels.
fn draw_panels(scene: &mut Scene, map: &Map, layout: &Layout, top: f64) -> Area {
    let (panels, folds, columns) = (&layout.panels, layout.folds, layout.columns);
    let em = panels.style.em;
    let labels: Vec<&str> = map.columns.iter().map(String::as_str).collect();
    let mut bottom = if folds == 1 { panels.draw_labels(scene, &labels, top) } else { top };
    let mut all: Option<Area> = None;
    for (row, label) in map.rows.iter().enumerate() {
        let at = (panels.left, bottom + 0.1 * em);
        bottom = scene.paragraph(at, Anchor::Start, em, TEXT, panels.across(), label);
        for fold in 0..folds {
            let held = fold * columns..((fold + 1) * columns).min(labels.len());
            if folds > 1 {
                bottom = panels.draw_labels(scene, &labels[held.clone()], bottom);
            }
            for column in held {
                let area = panels.area(column % columns, bottom + 0.35 * em);
                let all = all.get_or_insert(Area { right: panels.left + panels.across(), ..area });
                all.bottom = area.bottom;
                draw_cells(scene, map, layout, &map.panels[row * labels.len() + column], area);
                let lowest = row + 1 == map.rows.len() && column + columns >= labels.len();
                panels.draw_ticks(scene, (&layout.x, &layout.y), area, (column % columns == 0, lowest));
            }
            bottom = panels.area(0, bottom + 0.35 * em).bottom + 0.7 * em;
        }
    }
    all.expect("the map was checked and has a panel")
}

/// Draws the cells of a panel, with lines of equal value and frames.
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
            let reach = (0.3 * place.width().min(place.height())).min(0.4 * layout.panels.style.em);
            marker::cross(scene, place.centre(), reach, 0.09 * layout.panels.style.em, FAILED_CROSS);
        }
    }
    let axes = (&layout.x, &layout.y);
    for line in layout.levels.iter().flat_map(|level| contours::lines(map, panel, axes, &area, *level)) {
        contours::stroke(scene, line, layout.panels.style.em);
    }
    for across in layout.x.blocks() {
        for up in layout.y.blocks() {
            scene.frame(inside(*across, *up), 2.0, FRAME);
        }
    }
}

/// The legend: what the map shows beside values.
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
