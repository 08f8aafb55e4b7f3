//! Areas between lines of equal value.

use crate::geometry::contours::Grid;
use crate::geometry::polygon;
use crate::paint::scene::Point;

/// An area of one band. Later ones lie on earlier ones.
#[derive(Debug)]
pub(crate) struct Patch {
    pub(crate) corners: Vec<Point>,
    /// Number of boundaries that are not above its values.
    pub(crate) band: usize,
}

/// The areas between increasing boundaries on a grid with `columns` nodes in a row, which has a value at each node. The
/// picture of the grid has its rows in the direction of its second axis.
///
/// Lines of equal value do not cross, so that of two areas with a common part one contains the other: painted from the
/// largest to the smallest, each with the band at the inner side of its border, they need no holes.
pub(crate) fn patches(columns: usize, places: &[Point], values: &[f64], boundaries: &[f64]) -> Vec<Patch> {
    // A frame of no width, lower than everything, closes the lines along the border.
    let rows = values.len() / columns;
    let framed = (0..rows + 2).flat_map(|j| (0..columns + 2).map(move |i| (i, j)));
    let node = |(i, j): (usize, usize)| {
        let (column, row) = (i.clamp(1, columns) - 1, j.clamp(1, rows) - 1);
        let inside = (1..=columns).contains(&i) && (1..=rows).contains(&j);
        let node = row * columns + column;
        (places[node], Some(if inside { values[node] } else { f64::NEG_INFINITY }))
    };
    let (places, values): (Vec<Point>, Vec<Option<f64>>) = framed.map(node).unzip();
    let grid = Grid { columns: columns + 2, places: &places, values: &values };

    let levels = [f64::MIN].into_iter().chain(boundaries.iter().copied());
    let mut found: Vec<(f64, Patch)> = Vec::new();
    for (band, level) in levels.enumerate() {
        for corners in grid.contours(level) {
            let area = polygon::area(&corners);
            // Around a hollow, the lower band is inside.
            let band = if area > 0.0 { band } else { band.saturating_sub(1) };
            found.push((area.abs(), Patch { corners, band }));
        }
    }
    // Of areas of the same size, the higher bands stay above the lower ones.
    found.sort_by(|one, other| other.0.total_cmp(&one.0));
    found.into_iter().map(|(_, patch)| patch).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;

    /// Whether a point lies inside a polygon: a ray to the right meets its border an odd number of times.
    fn holds(corners: &[Point], (x, y): Point) -> bool {
        let next = corners.iter().cycle().skip(1);
        let met = corners
            .iter()
            .zip(next)
            .filter(|(a, b)| (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0));
        met.count() % 2 == 1
    }

    laws! {
        seed: 13, cases: 256;

        /// Beside each node, the band on top is the one of its value.
        fn the_topmost_patch_of_a_node_has_its_band(
            (columns, values) in (2..9usize, 2..9usize).prop_flat_map(|(columns, rows)| {
                (Just(columns), prop::collection::vec(0.0..1.0f64, columns * rows))
            }),
            boundaries in prop::collection::btree_set(1..100u8, 0..6),
        ) {
            let boundaries: Vec<f64> = boundaries.into_iter().map(|b| 0.01 * f64::from(b)).collect();
            let rows = values.len() / columns;
            let places: Vec<Point> = (0..values.len()).map(|k| ((k % columns) as f64, (k / columns) as f64)).collect();
            let found = patches(columns, &places, &values, &boundaries);
            for (k, value) in values.iter().enumerate() {
                // So little to the inside that no boundary lies between, but seldom.
                let inwards = |at: f64, count: usize| if at as usize + 1 == count { at - 1.1e-7 } else { at + 1e-7 };
                let at = (inwards(places[k].0, columns), inwards(places[k].1, rows));
                if boundaries.iter().any(|boundary| (boundary - value).abs() < 1e-6) {
                    continue;
                }
                let top = found.iter().rev().find(|patch| holds(&patch.corners, at)).map(|patch| patch.band);
                prop_assert_eq!(top, Some(boundaries.iter().filter(|boundary| **boundary <= *value).count()));
            }
        }
    }
}
