//! Markers: each line has a form of its own beside its colour.

use std::f64::consts::{PI, TAU};

use crate::paint::palette::{Ink, PAPER};
use crate::paint::scene::{Point, Scene, Shape};

/// The outlines of markers.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outline {
    Disc,
    Square,
    Triangle,
    Diamond,
    Wedge,
}

/// The form of a marker.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Form {
    outline: Outline,
    /// Paper fills it.
    hollow: bool,
}

impl Form {
    pub(crate) const DISC: Self = Self { outline: Outline::Disc, hollow: false };

    /// The form of line `index`. Ten forms and seven colours: the first 70 lines differ.
    pub(crate) fn of(index: usize) -> Self {
        let outlines = [Outline::Disc, Outline::Square, Outline::Triangle, Outline::Diamond, Outline::Wedge];
        Self { outline: outlines[index % 5], hollow: index % 10 >= 5 }
    }

    /// Corners about the origin, for a marker as heavy as a disc of this radius.
    fn corners(self, radius: f64) -> Vec<Point> {
        let (count, first, reach) = match self.outline {
            Outline::Disc => return vec![],
            Outline::Square => (4, 0.25 * PI, 1.25),
            Outline::Triangle => (3, -0.5 * PI, 1.4),
            Outline::Diamond => (4, 0.0, 1.3),
            Outline::Wedge => (3, 0.5 * PI, 1.4),
        };
        let corner = |i: usize| {
            let angle = first + TAU * i as f64 / f64::from(count);
            (reach * radius * angle.cos(), reach * radius * angle.sin())
        };
        (0..count as usize).map(corner).collect()
    }
}

/// One marker.
pub(crate) fn marker(scene: &mut Scene, form: Form, at: Point, radius: f64, ink: Ink) {
    fill(scene, form, at, radius, ink);
    if form.hollow {
        fill(scene, form, at, 0.5 * radius, PAPER);
    }
}

fn fill(scene: &mut Scene, form: Form, (x, y): Point, radius: f64, ink: Ink) {
    scene.shapes.push(match form.outline {
        Outline::Disc => Shape::Disc { centre: (x, y), radius, ink },
        _ => {
            let corners = form.corners(radius).into_iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
            Shape::Polygon { corners, ink }
        }
    });
}

/// A marker with a rim of paper, which stands out from lines and other markers.
pub(crate) fn rimmed(scene: &mut Scene, form: Form, at: Point, radius: f64, ink: Ink) {
    fill(scene, form, at, radius + 3.0, PAPER);
    marker(scene, form, at, radius, ink);
}

/// The × of a case that failed: two strokes.
pub(crate) fn cross(scene: &mut Scene, (x, y): Point, reach: f64, width: f64, ink: Ink) {
    scene.line((x - reach, y - reach), (x + reach, y + reach), width, ink);
    scene.line((x - reach, y + reach), (x + reach, y - reach), width, ink);
}
