//! A field below a deformed surface: where everything lies, and how it is drawn.

use super::{CrossSection, CrossSectionPanel};
use crate::axes::Axis;
use crate::axes::colour_scale::ColourRange;
use crate::axes::scaled_axis::ScaledAxis;
use crate::frame::Style;
use crate::frame::legend::{Entry, Swatch};
use crate::frame::panels::{Demand, Panels};
use crate::geometry::bands::patches;
use crate::geometry::contours::Grid;
use crate::geometry::{polygon, polyline};
use crate::paint::palette::{FRAME, PAPER, TEXT, UNKNOWN, faded};
use crate::paint::scene::{Area, Point, Scene, Shape};
use crate::paper::Paper;

/// Most panels side by side.
pub(crate) const MOST_COLUMNS: usize = 2;
/// Least height of a panel over the size of the font.
const LEAST_HEIGHT: f64 = 8.0;

/// What all panels share.
struct Layout {
    panels: Panels,
    columns: usize,
    x: ScaledAxis,
    y: ScaledAxis,
    colours: ColourRange,
    logarithmic: bool,
}

impl Layout {
    fn new(chart: &CrossSection, paper: &Paper, stretch: f64) -> Self {
        let columns = chart.panels.len().min(MOST_COLUMNS);
        let values: Vec<f64> = chart.panels.iter().flat_map(|panel| &panel.values).copied().collect();
        let colours = ColourRange::of(&values, chart.scale.logarithmic, chart.scale.range)
            .expect("the chart was checked and has values")
            .in_bands(chart.levels);
        let axis = |range| ScaledAxis::new(std::iter::empty(), false, Some(range), 0.0);
        let (x, y) = (axis(chart.x_range), axis(chart.y_range));
        let panels = Panels::fit(&Demand {
            style: Style { baseline: 1.3, name_below: 1.7, above_legend: 0.3, ..Style::panels(columns, paper) },
            columns,
            axes: (&x, &y),
            y_name: &chart.y_label,
            colours: Some((colours, &chart.scale.label)),
            label_room: 8.0,
            height_over_width: stretch * if columns == 1 { 0.72 } else { 0.66 },
            least_height: LEAST_HEIGHT,
            bar_over_height: if chart.panels.len() <= columns { 1.0 } else { 1.6 },
        });
        Layout { panels, columns, x, y, colours, logarithmic: chart.scale.logarithmic }
    }

    /// Where a point lies in a panel.
    fn at(&self, area: Area, (x, y): Point) -> Point {
        (area.left + area.width() * self.x.share(x), area.bottom - area.height() * self.y.share(y))
    }
}

/// Draws the chart, which has been checked.
pub(crate) fn draw(chart: &CrossSection, paper: &Paper, stretch: f64) -> Scene {
    let mut scene = Scene::default();
    let layout = Layout::new(chart, paper, stretch);
    let panels = &layout.panels;
    let style = panels.style;
    let top = style.heading(&mut scene, &chart.title, &chart.subtitle);
    let all = draw_panels(&mut scene, chart, &layout, top);
    let below = style.names(&mut scene, all, &chart.x_label, &chart.y_label);
    panels.draw_bar(&mut scene, all, &layout.colours, &chart.scale.label);
    let cylinder = Entry { swatch: Swatch::Cell { ink: UNKNOWN, crossed: false }, label: "cylinder".to_string() };
    style.finish(&mut scene, &[cylinder], (panels.left, below));
    scene
}

/// Draws all panels below `top`, each under its label. Returns their area.
fn draw_panels(scene: &mut Scene, chart: &CrossSection, layout: &Layout, top: f64) -> Area {
    let (panels, columns) = (&layout.panels, layout.columns);
    let em = panels.style.em;
    let mut bottom = top;
    let mut all: Option<Area> = None;
    for (row, held) in chart.panels.chunks(columns).enumerate() {
        let labels: Vec<&str> = held.iter().map(|panel| panel.label.as_str()).collect();
        let top = panels.draw_labels(scene, &labels, bottom) + 0.3 * em;
        for (column, panel) in held.iter().enumerate() {
            let area = panels.area(column, top);
            let all = all.get_or_insert(Area { right: panels.left + panels.across(), ..area });
            all.bottom = area.bottom;
            draw_field(scene, layout, panel, area);
            draw_contact(scene, layout, panel, area);
            scene.frame(area, 2.0, FRAME);
            let lowest = (row + 1) * columns + column >= chart.panels.len();
            panels.draw_ticks(scene, (&layout.x, &layout.y), area, (column == 0, lowest));
        }
        bottom = panels.area(0, top).bottom + 0.6 * em;
    }
    all.expect("the chart was checked and has a panel")
}

/// Draws the field below the surface: bands of colour with lines between them.
fn draw_field(scene: &mut Scene, layout: &Layout, panel: &CrossSectionPanel, area: Area) {
    let shown = |value: f64| if layout.logarithmic { value.log10() } else { value };
    let columns = panel.x.len();
    let place =
        |k: usize| layout.at(area, (panel.x[k % columns], panel.surface[k % columns] - panel.depth[k / columns]));
    let places: Vec<Point> = (0..panel.values.len()).map(|k| within_reach(place(k))).collect();
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
}

/// A point not so far away that areas reckoned with it lose all digits; values change little from there to the panel.
fn within_reach((x, y): Point) -> Point {
    const REACH: f64 = 1e12;
    (x.clamp(-REACH, REACH), y.clamp(-REACH, REACH))
}

/// Draws the cylinder above its lower side, and the surface.
fn draw_contact(scene: &mut Scene, layout: &Layout, panel: &CrossSectionPanel, area: Area) {
    let line = |heights: &[f64]| -> Vec<Point> {
        panel.x.iter().zip(heights).map(|(x, y)| layout.at(area, (*x, *y))).collect()
    };
    let (surface, cylinder) = (line(&panel.surface), line(&panel.cylinder));
    let mut above = cylinder.clone();
    let highest = above.iter().map(|point| point.1).fold(area.top, f64::min);
    above.extend([(above[panel.x.len() - 1].0, highest), (above[0].0, highest)]);
    let above = polygon::clipped(&above, &area);
    if !above.is_empty() {
        scene.shapes.push(Shape::Polygon { corners: above, ink: UNKNOWN });
    }
    polyline::clipped(&cylinder, &area).into_iter().for_each(|piece| scene.path(piece, 2.5, FRAME));
    polyline::clipped(&surface, &area).into_iter().for_each(|piece| scene.path(piece, 4.0, TEXT));
}
