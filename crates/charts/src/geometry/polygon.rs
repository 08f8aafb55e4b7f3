//! Polygons: their area, and what lies inside a rectangle.

use crate::paint::scene::{Area, Point};

/// The area of a polygon, above zero if its corners go from the first axis towards the second.
pub(crate) fn area(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(one, other)| 0.5 * (one.0 * other.1 - other.0 * one.1)).sum()
}

/// The part of a polygon inside a rectangle (Sutherland and Hodgman's method). Parts that hang together outside only
/// stay joined by lines along its border. Empty if nothing is inside.
pub(crate) fn clipped(corners: &[Point], within: &Area) -> Vec<Point> {
    // How far a point lies inside each side.
    let sides: [&dyn Fn(Point) -> f64; 4] =
        [&|point| point.0 - within.left, &|point| within.right - point.0, &|point| point.1 - within.top, &|point| {
            within.bottom - point.1
        }];
    let mut kept = corners.to_vec();
    for inside in sides {
        let mut next = Vec::with_capacity(kept.len() + 4);
        for (i, to) in kept.iter().enumerate() {
            let from = kept[(i + kept.len() - 1) % kept.len()];
            let (start, end) = (inside(from), inside(*to));
            if (start < 0.0) != (end < 0.0) {
                let share = start / (start - end);
                next.push((from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1)));
            }
            if end >= 0.0 {
                next.push(*to);
            }
        }
        kept = next;
    }
    kept
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;

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
    }

    #[test]
    fn nothing_is_left_of_what_lies_outside() {
        let within = Area { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 };
        assert!(clipped(&[(2.0, 0.0), (3.0, 0.0), (2.0, 1.0)], &within).is_empty());
        assert_eq!(area(&clipped(&[(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)], &within)), 1.0);
    }
}
