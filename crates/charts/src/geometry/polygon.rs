//! Polygons: their area, and what lies inside a rectangle.

use crate::paint::scene::{Area, Point};

/// The area of a polygon, above zero if its corners go from the first axis towards the second.
pub(crate) fn area(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(one, other)| 0.5 * (one.0 * other.1 - other.0 * one.1)).sum()
}

/// The part of a polygon inside a rectangle (Sutherland and Hodgman's method). Parts that hang together outside only
/// stay joined by lines along its border. Corners that are no numbers are left out. Empty if nothing is inside.
pub(crate) fn clipped(corners: &[Point], within: &Area) -> Vec<Point> {
    // How far a point lies inside each side, in quarters; and the point of a side beside another one.
    type Side<'a> = (&'a dyn Fn(Point) -> f64, &'a dyn Fn(Point) -> Point);
    let sides: [Side; 4] = [
        (&|(x, _)| 0.25 * x - 0.25 * within.left, &|(_, y)| (within.left, y)),
        (&|(x, _)| 0.25 * within.right - 0.25 * x, &|(_, y)| (within.right, y)),
        (&|(_, y)| 0.25 * y - 0.25 * within.top, &|(x, _)| (x, within.top)),
        (&|(_, y)| 0.25 * within.bottom - 0.25 * y, &|(x, _)| (x, within.bottom)),
    ];
    let mut kept: Vec<Point> = corners.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    for (inside, beside) in sides {
        let mut next = Vec::with_capacity(kept.len() + 4);
        for (i, to) in kept.iter().enumerate() {
            let from = kept[(i + kept.len() - 1) % kept.len()];
            let (start, end) = (inside(from), inside(*to));
            if (start < 0.0) != (end < 0.0) {
                next.push(beside(crossing((from, start), (*to, end))));
            }
            if end >= 0.0 {
                next.push(*to);
            }
        }
        kept = next;
    }
    kept
}

/// Where a segment crosses a side, of which its ends lie so far inside and outside.
fn crossing((from, start): (Point, f64), (to, end): (Point, f64)) -> Point {
    // From the nearer end: what lies far away has no digits for pixels.
    if start.abs() > end.abs() {
        return crossing((to, end), (from, start));
    }
    let share = start / (start - end);
    // In quarters, which are exact: the whole may be longer than the largest number.
    let along =
        |from: f64, to: f64| (4.0 * (0.25 * from + share * (0.25 * to - 0.25 * from))).clamp(f64::MIN, f64::MAX);
    (along(from.0, to.0), along(from.1, to.1))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::any_number;

    laws! {
        seed: 12, cases: 256;

        /// Two halves of a picture show together what the whole shows.
        fn what_a_line_parts_has_the_area_of_the_whole(
            corners in prop::collection::vec((0.0..200.0f64, 0.0..100.0f64), 3..12), at in 0.0..200.0f64,
        ) {
            let whole = Area { left: 0.0, top: 0.0, right: 200.0, bottom: 100.0 };
            let sides = [Area { right: at, ..whole }, Area { left: at, ..whole }];
            let halves = sides.map(|half| clipped(&corners, &half));
            for (half, points) in sides.iter().zip(&halves) {
                prop_assert!(points.iter().all(|point| half.grown(1e-9).contains(&Area::about(*point, 0.0))));
            }
            prop_assert!((area(&halves[0]) + area(&halves[1]) - area(&corners)).abs() < 1e-6);
            prop_assert_eq!(clipped(&corners, &whole), corners);
        }

        fn what_comes_from_anywhere_is_cut_inside(
            corners in prop::collection::vec((any_number(), any_number()), 1..9),
        ) {
            let within = Area { left: 20.3, top: -0.7, right: 200.1, bottom: 150.9 };
            let found = clipped(&corners, &within);
            prop_assert!(found.iter().all(|point| within.grown(1e-9).contains(&Area::about(*point, 0.0))), "{found:?}");
        }
    }

    #[test]
    fn nothing_is_left_of_what_lies_outside() {
        let within = Area { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 };
        assert!(clipped(&[(2.0, 0.0), (3.0, 0.0), (2.0, 1.0)], &within).is_empty());
        assert_eq!(area(&clipped(&[(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)], &within)), 1.0);
    }
}
