//! The legend, under a chart in columns.

use super::font;
use super::marker::{self, Form};
use super::palette::{FAILED_CROSS, FRAME, Ink, TEXT, faded};
use super::scene::{Anchor, Area, Point, Scene, thickness};

/// What stands before an entry.
#[derive(Clone, Copy, Debug)]
pub(super) enum Swatch {
    /// A line with its marker.
    Line { form: Form, ink: Ink },
    /// A small faint marker.
    Small { form: Form, ink: Ink },
    /// A ×.
    Cross { ink: Ink },
    /// A cell of a map.
    Cell { ink: Ink, crossed: bool },
}

/// A swatch with its meaning.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) swatch: Swatch,
    pub(super) label: String,
}

/// Opacity and radius (over the font's size) of the marker of a single case.
pub(super) const SMALL_OPACITY: f64 = 0.35;
pub(super) const SMALL_RADIUS: f64 = 0.16;
/// The same of the marker of a setting.
pub(super) const LARGE_RADIUS: f64 = 0.3;

/// Draws the entries from `left` to `right` under `top`; returns where they end.
pub(super) fn draw(scene: &mut Scene, entries: &[Entry], (left, top): Point, right: f64, em: f64) -> f64 {
    let swatch = 1.7 * em;
    let (gap, between) = (0.4 * em, 1.1 * em);
    let room = right - left;
    let widest = entries.iter().map(|entry| font::width(&entry.label, em)).fold(0.0, f64::max) + swatch + gap;
    let columns = (((room + between) / (widest + between)) as usize).clamp(1, entries.len().max(1));
    let label_room = (widest - swatch - gap).min(room - swatch - gap) + 1.0;

    let mut y = top;
    for row in entries.chunks(columns) {
        let height = row.iter().map(|entry| thickness(&entry.label, em, label_room)).fold(0.0, f64::max);
        for (column, entry) in row.iter().enumerate() {
            let x = left + column as f64 * (widest + between);
            draw_swatch(scene, entry.swatch, (x, y + 0.66 * em), swatch, em);
            scene.paragraph((x + swatch + gap, y), Anchor::Start, em, TEXT, label_room, &entry.label);
        }
        y += height + 0.15 * em;
    }
    y
}

fn draw_swatch(scene: &mut Scene, swatch: Swatch, (left, y): Point, width: f64, em: f64) {
    let middle = (left + 0.5 * width, y);
    match swatch {
        Swatch::Line { form, ink } => {
            scene.line((left, y), (left + width, y), 0.12 * em, ink);
            marker::rimmed(scene, form, middle, LARGE_RADIUS * em, ink);
        }
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
