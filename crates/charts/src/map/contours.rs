//! Lines of equal value on a map.

use super::{Cell, Map, Panel};
use crate::axes::Axis;
use crate::axes::cell_axis::CellAxis;
use crate::axes::ticks::Ticks;
use crate::geometry::contours::Grid;
use crate::paint::palette::{PAPER, TEXT, faded};
use crate::paint::scene::{Area, Point, Scene};

/// Fewer levels than this say little.
const FEWEST: usize = 4;
/// More levels than this crowd.
const MOST: usize = 12;

/// The levels to draw: the labelled ticks of the colour bar that lie between these values; where they are few, those
/// without label as well, or if those are many the ones that begin with 1, 2 or 5.
pub(crate) fn levels(ticks: &Ticks, values: &[f64]) -> Vec<f64> {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let inside = |level: &f64| least < *level && *level < most;
    let labelled: Vec<f64> = ticks.major.iter().map(|tick| tick.value).filter(inside).collect();
    if labelled.len() >= FEWEST {
        return labelled;
    }
    let mut between: Vec<f64> = ticks.minor.iter().copied().filter(inside).collect();
    if labelled.len() + between.len() > MOST {
        between.retain(|level| ["1", "2", "5"].iter().any(|digit| format!("{level:e}").starts_with(digit)));
    }
    [labelled, between].concat()
}

/// The lines of one level in a panel drawn in this area.
pub(crate) fn lines(
    map: &Map,
    panel: &Panel,
    axes: (&CellAxis, &CellAxis),
    area: &Area,
    level: f64,
) -> Vec<Vec<Point>> {
    let at_end = |value: f64| value == 0.0 || value == f64::INFINITY;
    let shown = |value: f64| if map.scale.logarithmic { value.log10() } else { value };
    let node = |(k, cell): (usize, &Cell)| {
        let (x, y) = (map.x[k % map.x.len()], map.y[k / map.x.len()]);
        let place = (area.left + area.width() * axes.0.share(x), area.bottom - area.height() * axes.1.share(y));
        let value = match cell {
            Cell::Value(value) if !at_end(x) && !at_end(y) => Some(shown(*value)).filter(|value| value.is_finite()),
            _ => None,
        };
        (place, value)
    };
    let (places, values): (Vec<Point>, Vec<Option<f64>>) = panel.cells.iter().enumerate().map(node).unzip();
    Grid { columns: map.x.len(), places: &places, values: &values }.contours(shown(level))
}

/// Draws a line that is seen on every colour of the scale: white, with a dark rim.
pub(crate) fn stroke(scene: &mut Scene, line: Vec<Point>, em: f64) {
    scene.path(line.clone(), 0.14 * em, faded(TEXT, 0.75));
    scene.path(line, 0.06 * em, PAPER);
}
