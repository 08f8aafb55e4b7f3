//! Labels beside points: each goes where it covers least.

use crate::geometry::polyline::clipped_segment;
use crate::paint::scene::{Area, Point};

/// What labels must not cover.
#[derive(Debug)]
pub(crate) struct Obstacles {
    /// Labels stay inside.
    pub(crate) bounds: Area,
    /// Markers and labels: never covered if there is any other place.
    pub(crate) solid: Vec<Area>,
    /// Lines: crossed only if there is no better place.
    pub(crate) lines: Vec<(Point, Point)>,
    /// Small marks: the fewer covered the better.
    pub(crate) faint: Vec<Point>,
    /// Whether some label had to cover a marker or another label, or be led through one.
    pub(crate) crowded: bool,
}

/// How far a label goes to be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Effort {
    /// Beside its point, or left out if it would cover a marker or another label there.
    Near,
    /// Further away as well, or left out.
    Far,
    /// Where it covers least, if it covers something everywhere.
    Always,
}

/// What it costs to cover a marker or a label, to lead a line through one, to cover a line or a small mark, and to step
/// away from the point. The first step away is worth two small marks: labels leave a cloud of cases that is dense, not
/// one that is thin.
const SOLID: u64 = 1_000_000;
const CROSSED: u64 = 10_000;
const LINE: u64 = 60;
const FAINT: u64 = 4;
const FAR: f64 = 12.0;

impl Obstacles {
    /// The best place for a label of this size near a point, which it takes from then on.
    pub(crate) fn place(&mut self, (x, y): Point, (width, height): Point, reach: f64, effort: Effort) -> Option<Area> {
        // Beside, above, below, then at the corners; then the same further away.
        let corner = std::f64::consts::FRAC_1_SQRT_2;
        let directions = [
            (1.0, 0.0),
            (-1.0, 0.0),
            (0.0, -1.0),
            (0.0, 1.0),
            (corner, -corner),
            (-corner, -corner),
            (corner, corner),
            (-corner, corner),
        ];
        let distances =
            if effort == Effort::Near { &[1.0, 1.6][..] } else { &[1.0, 1.6, 2.4, 3.5, 5.0, 7.0, 10.0, 14.0][..] };
        let mut best: Option<(u64, Area)> = None;
        for distance in distances {
            for (dx, dy) in directions {
                let (nx, ny) = (x + dx * reach * distance, y + dy * reach * distance);
                // The label touches the circle with the side or corner that faces the point.
                let left = nx - width * 0.5 * (1.0 - side(dx));
                let top = ny - height * 0.5 * (1.0 - side(dy));
                let area = Area { left, top, right: left + width, bottom: top + height };
                if !self.bounds.contains(&area) {
                    continue;
                }
                let behind = leader((x, y), &area, reach).map_or(0, |(from, to)| self.covered(from, to));
                let cost = self.cost(&area) + CROSSED * behind + (FAR * distance) as u64;
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, area));
                }
            }
        }
        let (cost, area) = best?;
        if cost >= SOLID && effort != Effort::Always {
            return None;
        }
        self.crowded |= cost >= CROSSED;
        self.solid.push(area);
        self.lines.extend(leader((x, y), &area, reach));
        Some(area)
    }

    /// How many markers and labels a line runs through, that at its beginning not counted.
    fn covered(&self, from: Point, to: Point) -> u64 {
        let apart = |area: &&Area| !area.overlaps(&Area::about(from, 1.0));
        self.solid.iter().filter(apart).filter(|area| crosses(area, (from, to))).count() as u64
    }

    fn cost(&self, area: &Area) -> u64 {
        let solid = self.solid.iter().filter(|other| other.overlaps(area)).count() as u64;
        let lines = self.lines.iter().filter(|line| crosses(area, **line)).count() as u64;
        let faint =
            self.faint.iter().filter(|point| area.grown(4.0).overlaps(&Area::about(**point, 1.0))).count() as u64;
        SOLID * solid + LINE * lines + FAINT * faint
    }
}

/// The line that leads from a point to its label, if the label is so far away that it needs one.
pub(crate) fn leader((x, y): Point, label: &Area, reach: f64) -> Option<(Point, Point)> {
    let nearest = (x.clamp(label.left, label.right), y.clamp(label.top, label.bottom));
    ((nearest.0 - x).hypot(nearest.1 - y) > 1.4 * reach).then_some(((x, y), nearest))
}

fn side(direction: f64) -> f64 {
    if direction.abs() < 1e-9 { 0.0 } else { direction.signum() }
}

/// Whether a segment passes through an area.
fn crosses(area: &Area, (from, to): (Point, Point)) -> bool {
    clipped_segment(from, to, area).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_point_do_not_cover_each_other_while_there_is_room() {
        let bounds = Area { left: 0.0, top: 0.0, right: 1000.0, bottom: 1000.0 };
        let mut obstacles = Obstacles { bounds, solid: vec![], lines: vec![], faint: vec![], crowded: false };
        let placed: Vec<Area> =
            (0..4).map(|_| obstacles.place((500.0, 500.0), (100.0, 40.0), 20.0, Effort::Far).unwrap()).collect();
        for (i, one) in placed.iter().enumerate() {
            assert!(bounds.contains(one));
            assert!(placed[..i].iter().all(|other| !one.overlaps(other)), "{placed:?}");
        }
    }

    #[test]
    fn a_label_leaves_a_cloud_of_small_marks() {
        let bounds = Area { left: 0.0, top: 0.0, right: 1000.0, bottom: 1000.0 };
        let cloud: Vec<Point> =
            (0..400).map(|i| (440.0 + 6.0 * f64::from(i % 20), 440.0 + 6.0 * f64::from(i / 20))).collect();
        let mut obstacles = Obstacles { bounds, solid: vec![], lines: vec![], faint: cloud.clone(), crowded: false };
        let at = (500.0, 500.0);
        let label = obstacles.place(at, (100.0, 40.0), 20.0, Effort::Far).unwrap();
        assert!(!cloud.iter().any(|point| label.overlaps(&Area::about(*point, 1.0))), "{label:?}");
        // From out there a line leads back to its point.
        assert!(leader(at, &label, 20.0).is_some());
    }

    #[test]
    fn a_label_without_room_is_left_out_unless_it_must_be_shown() {
        let bounds = Area { left: 0.0, top: 0.0, right: 300.0, bottom: 300.0 };
        let mut obstacles = Obstacles { bounds, solid: vec![bounds], lines: vec![], faint: vec![], crowded: false };
        assert_eq!(obstacles.place((150.0, 150.0), (60.0, 20.0), 10.0, Effort::Far), None);
        assert!(obstacles.place((150.0, 150.0), (60.0, 20.0), 10.0, Effort::Always).is_some());
    }
}
