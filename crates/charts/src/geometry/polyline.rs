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

/// The part of a segment inside an area (Liang and Barsky's method).
pub(crate) fn clipped_segment(from: Point, to: Point, area: &Area) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0, 1.0);
    let sides =
        [(-dx, from.0 - area.left), (dx, area.right - from.0), (-dy, from.1 - area.top), (dy, area.bottom - from.1)];
    for (speed, room) in sides {
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            enter = f64::max(enter, room / speed);
        } else {
            leave = f64::min(leave, room / speed);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    // The ends themselves, not what rounding makes of them, so that pieces can be joined again.
    Some((if enter == 0.0 { from } else { at(enter) }, if leave == 1.0 { to } else { at(leave) }))
}

/// Dashes of length `dash`, `gap` apart, along a polyline.
pub(crate) fn dashes(points: &[Point], dash: f64, gap: f64) -> Vec<Vec<Point>> {
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::laws::laws;

    fn length(points: &[Point]) -> f64 {
        points.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum()
    }

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
