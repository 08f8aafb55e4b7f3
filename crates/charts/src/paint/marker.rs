//! Markers: each line has a form of its own beside its colour.

use std::f64::consts::{PI, TAU};

use crate::paint::palette::{Ink, PAPER};
use crate::paint::scene::{Point, Scene};

/// The forms of markers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Form {
    Disc,
    Square,
    Triangle,
    Diamond,
    Wedge,
}

impl Form {
    /// The form of line `index`. Five forms and seven colours: the first 35 lines differ.
    pub(crate) fn of(index: usize) -> Self {
        [Form::Disc, Form::Square, Form::Triangle, Form::Diamond, Form::Wedge][index % 5]
    }

    /// Corners about the origin, for a marker as heavy as a disc of this radius.
    fn corners(self, radius: f64) -> Vec<Point> {
        let (count, first, reach) = match self {
            Form::Disc => return vec![],
            Form::Square => (4, 0.25 * PI, 1.25),
            Form::Triangle => (3, -0.5 * PI, 1.4),
            Form::Diamond => (4, 0.0, 1.3),
            Form::Wedge => (3, 0.5 * PI, 1.4),
        };
        let corner = |i: usize| {
            let angle = first + TAU * i as f64 / f64::from(count);
            (reach * radius * angle.cos(), reach * radius * angle.sin())
        };
        (0..count as usize).map(corner).collect()
    }
}

/// One marker.
pub(crate) fn marker(scene: &mut Scene, form: Form, (x, y): Point, radius: f64, ink: Ink) {
    if form == Form::Disc {
        scene.shapes.push(crate::paint::scene::Shape::Disc { centre: (x, y), radius, ink });
    } else {
        let corners = form.corners(radius).into_iter().map(|(dx, dy)| (x + dx, y + dy)).collect();
        scene.shapes.push(crate::paint::scene::Shape::Polygon { corners, ink });
    }
}

/// A marker with a rim of paper, which stands out from lines and other markers.
pub(crate) fn rimmed(scene: &mut Scene, form: Form, at: Point, radius: f64, ink: Ink) {
    marker(scene, form, at, radius + 3.0, PAPER);
    marker(scene, form, at, radius, ink);
}

/// The × of a case that failed: two strokes.
pub(crate) fn cross(scene: &mut Scene, (x, y): Point, reach: f64, width: f64, ink: Ink) {
    scene.line((x - reach, y - reach), (x + reach, y + reach), width, ink);
    scene.line((x - reach, y + reach), (x + reach, y - reach), width, ink);
}
