//! A surface in space and curves beside it, painted from back to front.

use super::curve::Piece;
use super::projection::Space;
use crate::paint::palette::{self, TEXT, faded};
use crate::paint::scene::{Point, Scene, Shape};

/// Heights over a grid of places, all as shares of the box.
pub(crate) struct Surface {
    /// Places to the right, from 0 to 1.
    pub(crate) x: Vec<f64>,
    /// Places to the back, from 0 to 1.
    pub(crate) y: Vec<f64>,
    /// Row by row from the front; none leaves a hole.
    pub(crate) heights: Vec<Option<f64>>,
}

/// Steps of colour: too small to be seen, and large enough to let neighbours share one.
const SHADES: f64 = 110.0;
/// About how many lines of the mesh run to the back, and to the right.
const MESH: (usize, usize) = (15, 10);
/// Neighbours overlap by this many pixels, so that no paper shines through between them where corners are rounded to
/// pixels.
const OVERLAP: f64 = 1.7;

/// Cells of a row from `from` up to `to`, between which none hides another.
struct Run {
    from: usize,
    to: usize,
    /// None for a hole; else whether the upper side is seen.
    upper: Option<bool>,
}

impl Surface {
    fn columns(&self) -> usize {
        self.x.len() - 1
    }

    fn rows(&self) -> usize {
        self.y.len() - 1
    }

    fn height(&self, i: usize, j: usize) -> Option<f64> {
        self.heights[j * self.x.len() + i]
    }

    /// Heights at the corners of a cell, those in front first; none of a hole, or outside.
    fn corners(&self, i: usize, j: usize) -> Option<[f64; 4]> {
        if i >= self.columns() || j >= self.rows() {
            return None;
        }
        Some([self.height(i, j)?, self.height(i + 1, j)?, self.height(i, j + 1)?, self.height(i + 1, j + 1)?])
    }

    /// Height at a place of a cell, linear along its borders.
    pub(crate) fn between(&self, (i, j): (usize, usize), (x, y): Point) -> Option<f64> {
        let [front_left, front_right, back_left, back_right] = self.corners(i, j)?;
        let right = (x - self.x[i]) / (self.x[i + 1] - self.x[i]);
        let back = (y - self.y[j]) / (self.y[j + 1] - self.y[j]);
        let (front, rear) =
            (front_left + right * (front_right - front_left), back_left + right * (back_right - back_left));
        Some(front + back * (rear - front))
    }

    /// Whether the upper side of a cell is seen.
    fn upper(&self, space: &Space, i: usize, j: usize) -> Option<bool> {
        self.corners(i, j)?;
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| self.at(space, i, j));
        // Counter-clockwise from above; the picture counts downwards.
        Some((c.0 - a.0) * (d.1 - b.1) - (c.1 - a.1) * (d.0 - b.0) <= 0.0)
    }

    fn at(&self, space: &Space, i: usize, j: usize) -> Point {
        space.at((self.x[i], self.y[j], self.height(i, j).expect("corners of a cell have heights")))
    }

    /// The cells of a row, from left to right, which is from back to front.
    fn runs(&self, space: &Space, j: usize) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for i in 0..self.columns() {
            let upper = self.upper(space, i, j);
            match runs.last_mut() {
                Some(run) if run.upper == upper => run.to = i + 1,
                _ => runs.push(Run { from: i, to: i + 1, upper }),
            }
        }
        runs
    }

    /// Draws the surface and the pieces of curves. Rows from the back to the front, in each the cells from left to
    /// right: what comes later is never behind what came before.
    pub(crate) fn draw(&self, scene: &mut Scene, space: &Space, pieces: &[Piece]) {
        let (columns, rows) = (self.columns() as isize, self.rows() as isize);
        for row in (-1..=rows).rev() {
            let here: Vec<&Piece> = pieces.iter().filter(|piece| piece.row == row).collect();
            let draw_pieces = |scene: &mut Scene, wanted: &dyn Fn(&Piece) -> bool| {
                here.iter().filter(|piece| wanted(piece)).for_each(|piece| piece.draw(scene));
            };
            if row < 0 || row == rows {
                draw_pieces(scene, &|_| true);
                continue;
            }
            draw_pieces(scene, &|piece| piece.column < 0);
            for run in self.runs(space, row as usize) {
                let inside = |piece: &Piece| (run.from as isize..run.to as isize).contains(&piece.column);
                draw_pieces(scene, &|piece| inside(piece) && !piece.above);
                if run.upper.is_some() {
                    self.fill(scene, space, &run, row as usize);
                    self.mesh(scene, space, &run, row as usize);
                }
                draw_pieces(scene, &|piece| inside(piece) && piece.above);
            }
            draw_pieces(scene, &|piece| piece.column >= columns);
        }
    }

    /// Step of colour of a cell.
    fn shade(&self, i: usize, j: usize) -> f64 {
        let corners = self.corners(i, j).expect("a run of cells has no hole");
        (0.25 * corners.iter().sum::<f64>() * SHADES).floor().min(SHADES - 1.0)
    }

    /// Fills the cells of a run, neighbours of one shade together.
    fn fill(&self, scene: &mut Scene, space: &Space, run: &Run, j: usize) {
        let mut from = run.from;
        while from < run.to {
            let shade = self.shade(from, j);
            let to = (from..run.to).find(|i| self.shade(*i, j) != shade).unwrap_or(run.to);
            let mut corners: Vec<Point> = (from..=to).map(|i| self.at(space, i, j + 1)).collect();
            corners.extend((from..=to).rev().map(|i| self.in_front(space, run, i, j)));
            if to < run.to {
                let (back, front) = (to - from, to - from + 1);
                corners[back] = towards(corners[back], self.at(space, to + 1, j + 1));
                corners[front] = towards(corners[front], self.at(space, to + 1, j));
            }
            scene.shapes.push(Shape::Polygon { corners, ink: palette::viridis((shade + 0.5) / SHADES) });
            from = to;
        }
    }

    /// A corner of a run of cells at the front, moved over what is before it, if there is something.
    fn in_front(&self, space: &Space, run: &Run, i: usize, j: usize) -> Point {
        let here = self.at(space, i, j);
        let cell = |i: usize| j > 0 && self.corners(i, j - 1).is_some();
        if !(cell(i) || (i > 0 && cell(i - 1))) {
            return here;
        }
        let (from, to) = (self.at(space, i.max(run.from + 1) - 1, j), self.at(space, (i + 1).min(run.to), j));
        let by = if run.upper == Some(true) { overlap(from, to) } else { -overlap(from, to) };
        (here.0 - by * (to.1 - from.1), here.1 + by * (to.0 - from.0))
    }

    /// Lines of the mesh at the back and the left of cells, and the border of the surface.
    fn mesh(&self, scene: &mut Scene, space: &Space, run: &Run, j: usize) {
        let on_mesh = |index: usize, count: usize, wanted: usize| index.is_multiple_of(count.div_ceil(wanted));
        let mut draw = |line: Vec<(usize, usize)>, border: bool| {
            let points = line.into_iter().map(|(i, j)| self.at(space, i, j)).collect();
            let (width, ink) = if border { (2.0, faded(TEXT, 0.8)) } else { (1.5, faded(TEXT, 0.4)) };
            scene.path(points, width, ink);
        };
        // Along the row: pieces that are border, and pieces that are not.
        let mut along = |row: usize, beyond: Option<usize>, with_mesh: bool| {
            let border = |i: usize| beyond.is_none_or(|j| self.corners(i, j).is_none());
            let mut from = run.from;
            while from < run.to {
                let to = (from..run.to).find(|i| border(*i) != border(from)).unwrap_or(run.to);
                if border(from) || with_mesh {
                    draw((from..=to).map(|i| (i, row)).collect(), border(from));
                }
                from = to;
            }
        };
        along(j + 1, Some(j + 1), on_mesh(j + 1, self.rows(), MESH.1));
        along(j, j.checked_sub(1), false);
        for i in run.from..=run.to {
            let beside = i == 0 || self.corners(i - 1, j).is_none() || self.corners(i, j).is_none();
            if beside || (i < run.to && on_mesh(i, self.columns(), MESH.0)) {
                draw(vec![(i, j), (i, j + 1)], beside);
            }
        }
    }
}

/// The point moved a little towards another one.
fn towards(from: Point, to: Point) -> Point {
    let share = overlap(from, to);
    (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
}

/// How far neighbours overlap, over the distance of two points; not at all if these are one.
fn overlap(from: Point, to: Point) -> f64 {
    let distance = (to.0 - from.0).hypot(to.1 - from.1);
    if distance < 1e-9 { 0.0 } else { OVERLAP / distance }
}
