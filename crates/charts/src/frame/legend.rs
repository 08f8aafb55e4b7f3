//! The legend, under a chart in columns.

use crate::geometry::polyline::dashes;
use crate::paint::font;
use crate::paint::marker::{self, Form};
use crate::paint::palette::{FAILED_CROSS, FRAME, Ink, TEXT, faded};
use crate::paint::scene::{Anchor, Area, Point, Scene};

/// What stands before an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Swatch {
    /// A line with its marker.
    Line { form: Form, ink: Ink },
    /// A line, with lengths of dash and gap if it has some, and its marker if it has one.
    Stroke { pattern: Option<(f64, f64)>, form: Option<Form>, ink: Ink },
    /// A marker as curves have them.
    Marker { form: Form, ink: Ink },
    /// A small faint marker.
    Small { form: Form, ink: Ink },
    /// A ×.
    Cross { ink: Ink },
    /// A cell of a map.
    Cell { ink: Ink, crossed: bool },
}

/// A swatch with its meaning.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) swatch: Swatch,
    pub(crate) label: String,
}

/// Opacity and radius (over the font's size) of the marker of a single case.
pub(crate) const SMALL_OPACITY: f64 = 0.35;
pub(crate) const SMALL_RADIUS: f64 = 0.16;
/// The same of the marker of a setting.
pub(crate) const LARGE_RADIUS: f64 = 0.3;

/// Draws the entries from `left` to `right` under `top`, in as many columns as fit; returns where they end.
pub(crate) fn draw(scene: &mut Scene, entries: &[Entry], (left, top): Point, right: f64, em: f64) -> f64 {
    let swatch = 1.7 * em;
    let (gap, between) = (0.4 * em, 1.2 * em);
    let room = right - left;
    let wanted = |column: &[Entry]| {
        column.iter().map(|entry| font::width(&entry.label, em)).fold(0.0, f64::max) + swatch + gap + 1.0
    };
    let across = |rows: usize| entries.chunks(rows).map(|column| wanted(column) + between).sum::<f64>() - between;
    let rows = (1..entries.len()).find(|rows| across(*rows) <= room).unwrap_or(entries.len().max(1));

    let (mut x, mut bottom) = (left, top);
    for column in entries.chunks(rows) {
        let width = wanted(column).min(room);
        let mut y = top;
        for entry in column {
            draw_swatch(scene, entry.swatch, (x, y + 0.66 * em), swatch, em);
            let start = (x + swatch + gap, y);
            y = scene.paragraph(start, Anchor::Start, em, TEXT, width - swatch - gap, &entry.label) + 0.1 * em;
        }
        bottom = f64::max(bottom, y);
        x += width + between;
    }
    bottom
}

fn draw_swatch(scene: &mut Scene, swatch: Swatch, (left, y): Point, width: f64, em: f64) {
    let middle = (left + 0.5 * width, y);
    match swatch {
        Swatch::Line { form, ink } => {
            scene.line((left, y), (left + width, y), 0.12 * em, ink);
            marker::rimmed(scene, form, middle, LARGE_RADIUS * em, ink);
        }
        Swatch::Stroke { pattern, form, ink } => {
            let line = vec![(left, y), (left + width, y)];
            let pieces = match pattern {
                None => vec![line],
                Some((dash, gap)) => dashes(&line, dash, gap),
            };
            pieces.into_iter().for_each(|piece| scene.path(piece, 0.12 * em, ink));
            if let Some(form) = form {
                marker::rimmed(scene, form, middle, 0.22 * em, ink);
            }
        }
        Swatch::Marker { form, ink } => marker::rimmed(scene, form, middle, 0.22 * em, ink),
        Swatch::Small { form, ink } => {
            marker::marker(scene, form, middle, SMALL_RADIUS * em, faded(ink, SMALL_OPACITY))
        }
        Swatch::Cross { ink } => marker::cross(scene, middle, 0.22 * em, 0.09 * em, ink),
        Swatch::Cell { ink, crossed } => {
            let area = Area { left: left + 0.2 * em, top: y - 0.42 * em, right: left + width, bottom: y + 0.42 * em };
            scene.rectangle(area, ink);
            if crossed {
                marker::cross(scene, area.centre(), 0.26 * em, 0.08 * em, FAILED_CROSS);
            }
            scene.frame(area, 1.5, FRAME);
        }
    }
}
