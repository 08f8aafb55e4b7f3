//! Polylines: cut at the border of an area, and drawn in dashes.

use crate::paint::scene::{Area, Point};

/// The pieces of a polyline that lie inside an area.
pub(crate) fn clipped(points: &[Point], area: &Area) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut joined = false;
    for pair in points.windows(2) {
        let Some((from, to)) = clipped_segment(pair[0], pair[1], area) else {
            joined = false;
            continue;
        };
        match pieces.last_mut() {
            Some(piece) if joined && from == pair[0] => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
        joined = to == pair[1];
    }
    pieces
}

/// The part of a segment inside an area; none of one whose ends are no numbers.
pub(crate) fn clipped_segment(from: Point, to: Point, area: &Area) -> Option<(Point, Point)> {
    if ![from.0, from.1, to.0, to.1].iter().all(|place| place.is_finite()) {
        return None;
    }
    // Reckoned from the nearer end: what lies far away has no digits for pixels.
    if beyond(from, area) > beyond(to, area) {
        return clipped_from_nearer(to, from, area).map(|(to, from)| (from, to));
    }
    clipped_from_nearer(from, to, area)
}

/// How far a point lies outside an area, along one of the axes.
fn beyond((x, y): Point, area: &Area) -> f64 {
    (area.left - x).max(x - area.right).max(area.top - y).max(y - area.bottom).max(0.0)
}

/// Where a segment is cut: the share of its length, and the side of the area that it meets there.
type Cut = (f64, (Option<f64>, Option<f64>));

/// Liang and Barsky's method.
fn clipped_from_nearer(from: Point, to: Point, area: &Area) -> Option<(Point, Point)> {
    // In quarters, which are exact: the whole may be longer than the largest number.
    let (start, end) = ((0.25 * from.0, 0.25 * from.1), (0.25 * to.0, 0.25 * to.1));
    let (dx, dy) = (end.0 - start.0, end.1 - start.1);
    let (mut enter, mut leave): (Cut, Cut) = ((0.0, (None, None)), (1.0, (None, None)));
    let sides = [
        (-dx, start.0 - 0.25 * area.left, (Some(area.left), None)),
        (dx, 0.25 * area.right - start.0, (Some(area.right), None)),
        (-dy, start.1 - 0.25 * area.top, (None, Some(area.top))),
        (dy, 0.25 * area.bottom - start.1, (None, Some(area.bottom))),
    ];
    for (speed, room, side) in sides {
        let share = room / speed;
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 && share > enter.0 {
            enter = (share, side);
        } else if speed > 0.0 && share < leave.0 {
            leave = (share, side);
        }
    }
    if enter.0 > leave.0 {
        return None;
    }
    // On the side itself, and inside the others, whatever rounding makes of a point far away.
    let at = |(share, (x, y)): Cut| {
        let along = |start: f64, d: f64, (low, high)| (4.0 * (start + share * d)).max(low).min(high);
        let inside = ((area.left, area.right), (area.top, area.bottom));
        (x.unwrap_or_else(|| along(start.0, dx, inside.0)), y.unwrap_or_else(|| along(start.1, dy, inside.1)))
    };
    // The ends themselves, not what rounding makes of them, so that pieces can be joined again.
    Some((if enter.0 == 0.0 { from } else { at(enter) }, if leave.0 == 1.0 { to } else { at(leave) }))
}

/// The length of a polyline.
pub(crate) fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum()
}

/// Dashes of length `dash`, `gap` apart, along a polyline; the polyline itself if it is so long that nobody would see
/// that many dashes.
pub(crate) fn dashes(points: &[Point], dash: f64, gap: f64) -> Vec<Vec<Point>> {
    if !has_room_for_dashes(length(points), dash, gap) {
        return vec![points.to_vec()];
    }
    let mut pieces = Vec::new();
    let mut piece: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, dash);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let mut gone = 0.0;
        while length - gone > left {
            gone += left;
            let at = (from.0 + (to.0 - from.0) * gone / length, from.1 + (to.1 - from.1) * gone / length);
            if drawing {
                piece.push(at);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![at];
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= length - gone;
        if drawing {
            piece.push(to);
        }
    }
    if drawing && piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

/// Whether a line of this length is drawn in dashes.
pub(crate) fn has_room_for_dashes(length: f64, dash: f64, gap: f64) -> bool {
    const MOST_DASHES: f64 = 5000.0;
    length < MOST_DASHES * (dash + gap)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;
    use crate::numbers::any_number;

    fn polyline() -> impl Strategy<Value = Vec<Point>> {
        prop::collection::vec((-100.0..300.0f64, -100.0..300.0f64), 2..20)
    }

    laws! {
        seed: 9, cases: 256;

        fn what_is_cut_lies_inside_and_what_lies_inside_stays(points in polyline()) {
            let area = Area { left: 0.0, top: 0.0, right: 200.0, bottom: 150.0 };
            let pieces = clipped(&points, &area);
            let grown = area.grown(1e-9);
            for point in pieces.iter().flatten() {
                prop_assert!(grown.contains(&Area::about(*point, 0.0)), "{point:?}");
            }
            for point in points.iter().filter(|point| area.grown(-1e-9).contains(&Area::about(**point, 0.0))) {
                prop_assert!(pieces.iter().flatten().any(|other| other == point), "{point:?} is gone");
            }
            let everywhere = Area { left: -1e9, top: -1e9, right: 1e9, bottom: 1e9 };
            prop_assert_eq!(clipped(&points, &everywhere), vec![points]);
        }

        fn what_comes_from_anywhere_is_cut_inside(points in prop::collection::vec((any_number(), any_number()), 2..9)) {
            let area = Area { left: 20.3, top: -0.7, right: 200.1, bottom: 150.9 };
            let grown = area.grown(1e-9);
            for piece in clipped(&points, &area) {
                prop_assert!(piece.iter().all(|point| grown.contains(&Area::about(*point, 0.0))), "{piece:?}");
                let drawn = dashes(&piece, 5.0, 9.0);
                prop_assert!(drawn.len() <= 20 * points.len());
            }
        }

        /// However far away its end is, a line that leaves the area does so where it should.
        fn a_line_keeps_its_direction(
            from in (0.0..200.0f64, 0.0..150.0f64), angle in 0.0..std::f64::consts::TAU, power in 0.0..305.0f64,
            turned: bool,
        ) {
            let area = Area { left: 0.0, top: 0.0, right: 200.0, bottom: 150.0 };
            let (sin, cos) = angle.sin_cos();
            let to = (from.0 + cos * 10f64.powf(power), from.1 + sin * 10f64.powf(power));
            let found = if turned { clipped_segment(to, from, &area) } else { clipped_segment(from, to, &area) };
            let (one, other) = found.unwrap();
            let (start, end) = if turned { (other, one) } else { (one, other) };
            prop_assert_eq!(start, from);
            let off_line = (end.0 - from.0) * sin - (end.1 - from.1) * cos;
            prop_assert!(off_line.abs() < 1e-9, "{end:?} is {off_line} beside the line");
            let at_side = [end.0, 200.0 - end.0, end.1, 150.0 - end.1].contains(&0.0);
            prop_assert!(end == to || at_side, "{end:?} is not at a side");
        }

        fn dashes_take_their_share_of_the_length(points in polyline(), dash in 1.0..30.0f64, gap in 1.0..30.0f64) {
            let pieces = dashes(&points, dash, gap);
            let (whole, drawn) = (length(&points), pieces.iter().map(|piece| length(piece)).sum::<f64>());
            prop_assert!(pieces.iter().all(|piece| length(piece) <= dash * (1.0 + 1e-9)));
            let periods = (whole / (dash + gap)).floor();
            let rest = whole - periods * (dash + gap);
            prop_assert!((drawn - periods * dash - rest.min(dash)).abs() < 1e-6 * whole.max(1.0));
        }
    }

    #[test]
    fn a_line_across_from_far_to_far_stays_one() {
        let area = Area { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        for far in [1e10, 1e45, 1e300, f64::MAX] {
            assert_eq!(clipped_segment((5.0, far), (5.0, -far), &area), Some(((5.0, 10.0), (5.0, 0.0))));
            assert_eq!(clipped_segment((-far, 3.0), (far, 3.0), &area), Some(((0.0, 3.0), (10.0, 3.0))));
        }
        for nowhere in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(
                clipped(&[(1.0, 1.0), (2.0, nowhere), (3.0, 1.0), (4.0, 1.0)], &area),
                [[(3.0, 1.0), (4.0, 1.0)]]
            );
        }
    }

    #[test]
    fn a_line_without_end_has_no_dashes() {
        let line = [(0.0, 0.0), (1e12, 0.0)];
        assert_eq!(dashes(&line, 5.0, 9.0), [line]);
    }

    #[test]
    fn segments_cross_an_area_or_pass_it() {
        let square = Area { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        let crosses = |from, to| clipped_segment(from, to, &square).is_some();
        assert!(crosses((-5.0, 5.0), (15.0, 6.0)));
        assert!(crosses((5.0, 5.0), (6.0, 6.0)));
        assert!(crosses((5.0, -5.0), (5.0, 50.0)));
        assert!(!crosses((-5.0, 6.0), (6.0, 17.0)));
        assert!(!crosses((11.0, -5.0), (11.0, 50.0)));
    }
}
