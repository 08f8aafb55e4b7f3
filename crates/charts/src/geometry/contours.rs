//! Lines of equal value on a grid, by marching squares.

use std::collections::{BTreeMap, BTreeSet};

use crate::axes::place;
use crate::paint::scene::Point;

/// Values at the nodes of a grid, and where the nodes lie.
pub(crate) struct Grid<'a> {
    /// Nodes in a row.
    pub(crate) columns: usize,
    /// Place of each node, row by row.
    pub(crate) places: &'a [Point],
    /// Value of each node; none where it is not known: no line enters the squares around it. −∞ is allowed.
    pub(crate) values: &'a [Option<f64>],
}

/// Two neighbouring nodes, the lower index first. As the border of a square it is passed in either direction.
type Edge = (usize, usize);

impl Grid<'_> {
    /// The lines along which the value, linear along each edge of the grid, is `level`. A line ends where it began, at
    /// the border of the grid, or at a square without a value. Lines of different levels do not cross.
    ///
    /// Higher values lie to the left of a line if columns are counted to the right and rows upwards.
    pub(crate) fn contours(&self, level: f64) -> Vec<Vec<Point>> {
        // Two squares share an edge, and pass it in opposite directions: a line leads to an edge once and away from it
        // once.
        let mut next: BTreeMap<Edge, Edge> = BTreeMap::new();
        let mut reached: BTreeSet<Edge> = BTreeSet::new();
        for square in self.squares() {
            for (from, to) in segments(square, level) {
                next.insert(from, to);
                reached.insert(to);
            }
        }
        let open: Vec<Edge> = next.keys().copied().filter(|edge| !reached.contains(edge)).collect();
        let mut lines = Vec::new();
        let mut starts = open.into_iter();
        while let Some(start) = starts.next().or_else(|| next.first_key_value().map(|(edge, _)| *edge)) {
            let mut line = vec![self.crossing(start, level)];
            let mut edge = start;
            while let Some(to) = next.remove(&edge) {
                line.push(self.crossing(to, level));
                edge = to;
            }
            // A line through a node meets several edges there.
            line.dedup();
            if line.len() > 1 {
                lines.push(line);
            }
        }
        lines
    }

    /// The corners of each square whose values are all known, counter-clockwise.
    fn squares(&self) -> impl Iterator<Item = [(usize, f64); 4]> {
        let rows = self.values.len() / self.columns;
        let lower = (0..rows.saturating_sub(1) * self.columns).filter(move |node| (node + 1) % self.columns != 0);
        lower.filter_map(|node| {
            let corner = |node: usize| Some((node, self.values[node]?));
            let above = node + self.columns;
            Some([corner(node)?, corner(node + 1)?, corner(above + 1)?, corner(above)?])
        })
    }

    /// Where the level lies on an edge.
    fn crossing(&self, (from, to): Edge, level: f64) -> Point {
        let value = |node: usize| self.values[node].expect("a line meets nodes with a value");
        let (start, end) = (value(from), value(to));
        let share = if start.is_infinite() { 1.0 } else { place::linear(level, start, end).clamp(0.0, 1.0) };
        let ((x, y), (to_x, to_y)) = (self.places[from], self.places[to]);
        (x + share * (to_x - x), y + share * (to_y - y))
    }
}

/// The pieces of lines through a square, from edge to edge.
fn segments(square: [(usize, f64); 4], level: f64) -> Vec<(Edge, Edge)> {
    let high = |corner: usize| square[corner % 4].1 >= level;
    let edge = |corner: usize| {
        let (one, other) = (square[corner % 4].0, square[(corner + 1) % 4].0);
        (one.min(other), one.max(other))
    };
    // Around the square, lines leave from edges where the value falls, for edges where it rises.
    let falls: Vec<usize> = (0..4).filter(|corner| high(*corner) && !high(corner + 1)).collect();
    // At a saddle the two higher corners are joined if the middle is as high, else the two lower ones.
    let joined = square.iter().map(|corner| 0.25 * corner.1).sum::<f64>() >= level;
    let rise = |fall: usize| {
        let rises = (1..4).map(|step| fall + step).filter(|corner| !high(*corner) && high(corner + 1));
        let mut found = rises.collect::<Vec<usize>>().into_iter();
        if joined { found.next() } else { found.next_back() }
    };
    falls.into_iter().filter_map(|fall| Some((edge(fall), edge(rise(fall)?)))).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::any_number;

    /// The places of the nodes of a grid whose squares are of size 1.
    fn even(columns: usize, nodes: usize) -> Vec<Point> {
        (0..nodes).map(|node| ((node % columns) as f64, (node / columns) as f64)).collect()
    }

    fn lines(columns: usize, values: &[Option<f64>], level: f64) -> Vec<Vec<Point>> {
        Grid { columns, places: &even(columns, values.len()), values }.contours(level)
    }

    /// Columns, and values of which about one in ten is not known.
    fn field() -> impl Strategy<Value = (usize, Vec<Option<f64>>)> {
        let value = prop::option::weighted(0.9, -1.0..1.0f64);
        (2..9usize, 2..9usize).prop_flat_map(move |(columns, rows)| {
            prop::collection::vec(value.clone(), columns * rows).prop_map(move |values| (columns, values))
        })
    }

    /// Whether two segments cross at an inner point of both.
    fn cross(one: &[Point], other: &[Point]) -> bool {
        let side = |a: Point, b: Point, c: Point| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        let apart = |a: &[Point], b: &[Point]| side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < -1e-14;
        apart(one, other) && apart(other, one)
    }

    laws! {
        seed: 11, cases: 256;

        fn on_a_plane_the_points_of_a_line_have_its_level(
            steps in prop::collection::vec((0.01..3.0f64, 0.01..3.0f64), 2..9),
            a in -2.0..2.0f64,
            b in -2.0..2.0f64,
            share in 0.0..1.0f64,
        ) {
            let along = |of: fn(&(f64, f64)) -> f64| -> Vec<f64> {
                steps.iter().scan(0.0, |end, step| { *end += of(step); Some(*end) }).collect()
            };
            let (xs, ys) = (along(|step| step.0), along(|step| step.1));
            let places: Vec<Point> = ys.iter().flat_map(|y| xs.iter().map(move |x| (*x, *y))).collect();
            let height = |(x, y): Point| a * x + b * y;
            let values: Vec<Option<f64>> = places.iter().map(|place| Some(height(*place))).collect();
            let heights = || places.iter().map(|place| height(*place));
            let (least, most) = (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
            let level = least + share * (most - least);
            let found = Grid { columns: xs.len(), places: &places, values: &values }.contours(level);
            // A plane is cut in one line, from border to border, unless only a corner is met.
            prop_assert!(found.len() <= 1 && (found.len() == 1 || !(1e-9..1.0 - 1e-9).contains(&share)));
            for point in found.iter().flatten() {
                prop_assert!((height(*point) - level).abs() < 1e-12 * (1.0 + level.abs()), "{point:?}");
            }
        }

        fn lines_do_not_cross((columns, values) in field(), one in -0.9..0.9f64, other in -0.9..0.9f64) {
            let segments = |level| -> Vec<Vec<Point>> {
                lines(columns, &values, level).iter().flat_map(|line| line.windows(2)).map(<[Point]>::to_vec).collect()
            };
            let all = [segments(one), segments(other)].concat();
            for (i, segment) in all.iter().enumerate() {
                prop_assert!(!all[..i].iter().any(|earlier| cross(earlier, segment)), "{segment:?}");
            }
        }

        fn a_line_is_closed_or_ends_at_a_border((columns, values) in field(), level in -0.9..0.9f64) {
            let whole = |i: f64, j: f64| {
                let (i, j) = (i as isize, j as isize);
                let known = |i: isize, j: isize| {
                    let inside = i >= 0 && j >= 0 && i < columns as isize && (j as usize) < values.len() / columns;
                    inside && values[j as usize * columns + i as usize].is_some()
                };
                [(0, 0), (1, 0), (0, 1), (1, 1)].iter().all(|(di, dj)| known(i + di, j + dj))
            };
            for line in lines(columns, &values, level) {
                let (first, last) = (line[0], line[line.len() - 1]);
                if first == last {
                    continue;
                }
                for (x, y) in [first, last] {
                    let beside = match y == y.floor() {
                        true => [(x.floor(), y), (x.floor(), y - 1.0)],
                        false => [(x, y.floor()), (x - 1.0, y.floor())],
                    };
                    prop_assert_eq!(beside.iter().filter(|(i, j)| whole(*i, *j)).count(), 1, "({}, {})", x, y);
                }
            }
        }

        /// Every edge between a lower and a higher node is met where it has a square beside it.
        fn nothing_is_left_out((columns, values) in field(), level in -0.9..0.9f64) {
            let found: Vec<Point> = lines(columns, &values, level).concat();
            for (j, row) in values.chunks(columns).enumerate().take(values.len() / columns - 1) {
                for i in 0..columns - 1 {
                    let square = [row[i], row[i + 1], values[(j + 1) * columns + i], values[(j + 1) * columns + i + 1]];
                    let [Some(a), Some(b), Some(_), Some(_)] = square else { continue };
                    if (a < level) != (b < level) {
                        let at = (i as f64 + (level - a) / (b - a), j as f64);
                        prop_assert!(found.iter().any(|point| (point.0 - at.0).hypot(point.1 - at.1) < 1e-9), "{at:?}");
                    }
                }
            }
        }

        fn lines_stay_inside_whatever_the_values_are(
            values in prop::collection::vec(prop::option::weighted(0.9, any_number()), 12), level in any_number(),
        ) {
            for (x, y) in lines(4, &values, level).concat() {
                prop_assert!((0.0..=3.0).contains(&x) && (0.0..=2.0).contains(&y), "({x}, {y})");
            }
        }

        fn a_level_that_no_value_reaches_has_no_line((columns, values) in field()) {
            prop_assert!(lines(columns, &values, 1.0).is_empty() && lines(columns, &values, -1.1).is_empty());
        }
    }

    /// Around a peak the line goes counter-clockwise, around a hollow clockwise.
    #[test]
    fn higher_values_lie_to_the_left() {
        for (peak, sign) in [(1.0, 1.0), (-1.0, -1.0)] {
            let mut values = [Some(0.0); 9];
            values[4] = Some(peak);
            let found = lines(3, &values, 0.5 * peak);
            assert_eq!(found.len(), 1);
            assert_eq!(found[0].first(), found[0].last());
            let area: f64 = found[0].windows(2).map(|pair| 0.5 * (pair[0].0 * pair[1].1 - pair[1].0 * pair[0].1)).sum();
            assert!((area - 0.5 * sign).abs() < 1e-12, "{area}");
        }
    }

    /// A saddle whose middle is above the level joins its high corners, one whose middle is below joins the low ones.
    #[test]
    fn a_saddle_is_resolved_by_its_middle() {
        for (low, joins_high) in [(-0.5, true), (-2.0, false)] {
            let found = lines(2, &[Some(1.0), Some(low), Some(low), Some(1.0)], 0.0);
            assert_eq!(found.len(), 2);
            // Each line cuts off one corner: (1, 0) or (0, 1) are low.
            let cuts_low = found.iter().all(|line| {
                line.iter().all(|(x, y)| (x - y).abs() > 1e-9) && (line[0].0 > line[0].1) == (line[1].0 > line[1].1)
            });
            assert_eq!(cuts_low, joins_high, "{found:?}");
        }
    }
}
