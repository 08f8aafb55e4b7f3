//! A curve in space, cut where it passes from cell to cell of a surface.

use super::mesh::Surface;
use super::projection::{Place, Space};
use crate::paint::palette::{Ink, PAPER, faded};
use crate::paint::scene::{Point, Scene};

/// A dash, or a part of one, over one cell of a surface or beside it.
#[derive(Debug)]
pub(crate) struct Piece {
    /// Row of cells: −1 along the front edge, as many as there are rows along the back edge.
    pub(crate) row: isize,
    /// Column of cells: −1 along the left edge, as many as there are columns along the right edge.
    pub(crate) column: isize,
    /// Not below the surface.
    pub(crate) above: bool,
    line: Vec<Point>,
    width: f64,
    ink: Ink,
}

impl Piece {
    /// Draws the line, with a rim that sets it off any colour.
    pub(crate) fn draw(&self, scene: &mut Scene) {
        scene.path(self.line.clone(), self.width + 4.0, faded(PAPER, 0.85));
        scene.path(self.line.clone(), self.width, self.ink);
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    pub(crate) width: f64,
    /// Lengths of dash and gap.
    pub(crate) pattern: (f64, f64),
    pub(crate) ink: Ink,
}

/// A curve that lies this little below a surface counts as lying on it.
const ON: f64 = 4e-3;

/// The dashes of a curve.
pub(crate) fn pieces(points: &[Place], surface: &Surface, space: &Space, style: Style) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let (dash, gap) = style.pattern;
    let mut length = 0.0;
    for ends in points.windows(2) {
        let at = |share: f64| {
            let along = |from: f64, to: f64| from + share * (to - from);
            (along(ends[0].0, ends[1].0), along(ends[0].1, ends[1].1), along(ends[0].2, ends[1].2))
        };
        for (from, to) in cuts(ends, surface) {
            let middle = at(0.5 * (from + to));
            let (row, column) = cell(middle, surface);
            let above = usize::try_from(column)
                .ok()
                .zip(usize::try_from(row).ok())
                .and_then(|cell| surface.between(cell, (middle.0, middle.1)))
                .is_none_or(|height| middle.2 >= height - ON);
            let (start, end) = (space.at(at(from)), space.at(at(to)));
            let long = (end.0 - start.0).hypot(end.1 - start.1);
            let place = |gone: f64| {
                let share = gone / long;
                (start.0 + share * (end.0 - start.0), start.1 + share * (end.1 - start.1))
            };
            // The dashes that begin before the end of this part of the curve, and end after its start.
            let mut dash_from = (length / (dash + gap)).floor() * (dash + gap);
            while long > 0.0 && dash_from < length + long {
                let (first, last) = ((dash_from - length).max(0.0), (dash_from + dash - length).min(long));
                if first < last {
                    let (first, last) = (place(first), place(last));
                    match pieces.last_mut() {
                        Some(piece)
                            if (piece.row, piece.column, piece.above) == (row, column, above)
                                && piece.line.last() == Some(&first) =>
                        {
                            piece.line.push(last)
                        }
                        _ => pieces.push(Piece {
                            row,
                            column,
                            above,
                            line: vec![first, last],
                            width: style.width,
                            ink: style.ink,
                        }),
                    }
                }
                dash_from += dash + gap;
            }
            length += long;
        }
    }
    pieces
}

/// The parts of a straight line between the lines of the grid, as shares of its length.
fn cuts(ends: &[Place], surface: &Surface) -> Vec<(f64, f64)> {
    let crossings = |lines: &[f64], from: f64, to: f64| -> Vec<f64> {
        let inside = lines.iter().filter(|line| (**line - from) * (**line - to) < 0.0);
        inside.map(|line| (line - from) / (to - from)).collect()
    };
    let mut shares = vec![0.0, 1.0];
    shares.extend(crossings(&surface.x, ends[0].0, ends[1].0));
    shares.extend(crossings(&surface.y, ends[0].1, ends[1].1));
    shares.sort_by(f64::total_cmp);
    shares.windows(2).map(|pair| (pair[0], pair[1])).filter(|(from, to)| from < to).collect()
}

/// Row and column of the cell below a place; of two beside it the one in front.
fn cell((x, y, _): Place, surface: &Surface) -> (isize, isize) {
    let row = surface.y.partition_point(|line| *line < y) as isize - 1;
    let column = surface.x.partition_point(|line| *line <= x) as isize - 1;
    let row = if y >= 1.0 { surface.y.len() as isize - 1 } else { row };
    let column = if x <= 0.0 { -1 } else { column };
    (row, column)
}
