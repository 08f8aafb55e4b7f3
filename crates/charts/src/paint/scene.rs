//! A chart as a list of shapes, in pixels of a layout [`WIDTH`](crate::paper::WIDTH) wide, y downwards.

use crate::paint::font::{self, DESCENT};
use crate::paint::palette::Ink;

/// A point, x and y in pixels.
pub(crate) type Point = (f64, f64);

/// A rectangle in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Area {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Area {
    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub(crate) fn centre(&self) -> Point {
        (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom))
    }

    /// The square of half-width `reach` about a point.
    pub(crate) fn about((x, y): Point, reach: f64) -> Self {
        Area { left: x - reach, top: y - reach, right: x + reach, bottom: y + reach }
    }

    /// Wider by `by` on each side.
    pub(crate) fn grown(&self, by: f64) -> Self {
        Area { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    pub(crate) fn overlaps(&self, other: &Area) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    pub(crate) fn contains(&self, other: &Area) -> bool {
        self.left <= other.left && self.top <= other.top && self.right >= other.right && self.bottom >= other.bottom
    }
}

/// Which part of a text stands at its point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// One line of text.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// A point of the baseline.
    pub(crate) at: Point,
    pub(crate) anchor: Anchor,
    /// Size of the font in pixels.
    pub(crate) em: f64,
    pub(crate) ink: Ink,
    /// Reads upwards instead of to the right.
    pub(crate) turned: bool,
    pub(crate) words: String,
}

impl Text {
    /// How much of the text stands before its point.
    pub(crate) fn before(&self) -> f64 {
        match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * font::width(&self.words, self.em),
            Anchor::End => font::width(&self.words, self.em),
        }
    }

    /// The rectangle of the text, from the top of its capitals to the descenders.
    pub(crate) fn area(&self) -> Area {
        const CAPITALS: f64 = 0.73;
        let (width, before) = (font::width(&self.words, self.em), self.before());
        let (x, y) = self.at;
        if self.turned {
            let bottom = y + before;
            Area { left: x - CAPITALS * self.em, top: bottom - width, right: x + DESCENT * self.em, bottom }
        } else {
            let left = x - before;
            Area { left, top: y - CAPITALS * self.em, right: left + width, bottom: y + DESCENT * self.em }
        }
    }
}

/// One shape. Later shapes cover earlier ones.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Rectangle { area: Area, ink: Ink },
    Path { points: Vec<Point>, width: f64, ink: Ink },
    Polygon { corners: Vec<Point>, ink: Ink },
    Disc { centre: Point, radius: f64, ink: Ink },
    Text(Text),
}

impl Shape {
    /// A text. Characters that XML forbids, which no picture can hold, become U+FFFD.
    pub(crate) fn text(text: Text) -> Self {
        let is_allowed = |c: char| matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..);
        let words = text.words.chars().map(|c| if is_allowed(c) { c } else { char::REPLACEMENT_CHARACTER }).collect();
        Shape::Text(Text { words, ..text })
    }
}

/// A picture: its height and its shapes in the order of painting.
#[derive(Debug, Default)]
pub struct Scene {
    pub(crate) height: f64,
    pub(crate) shapes: Vec<Shape>,
}

/// Distance of the baselines of two lines of text over the size of the font.
const LEADING: f64 = 1.22;

impl Scene {
    pub(crate) fn rectangle(&mut self, area: Area, ink: Ink) {
        self.shapes.push(Shape::Rectangle { area, ink });
    }

    pub(crate) fn path(&mut self, points: Vec<Point>, width: f64, ink: Ink) {
        self.shapes.push(Shape::Path { points, width, ink });
    }

    pub(crate) fn line(&mut self, from: Point, to: Point, width: f64, ink: Ink) {
        self.path(vec![from, to], width, ink);
    }

    /// The outline of an area. Four lines, whose ends fill the corners.
    pub(crate) fn frame(&mut self, area: Area, width: f64, ink: Ink) {
        let half = 0.5 * width;
        let Area { left, top, right, bottom } = area;
        for y in [top, bottom] {
            self.line((left - half, y), (right + half, y), width, ink);
        }
        for x in [left, right] {
            self.line((x, top - half), (x, bottom + half), width, ink);
        }
    }

    pub(crate) fn text(&mut self, at: Point, anchor: Anchor, em: f64, ink: Ink, words: impl Into<String>) {
        let words = words.into();
        if !words.is_empty() {
            self.shapes.push(Shape::text(Text { at, anchor, em, ink, turned: false, words }));
        }
    }

    /// Text of several lines under `top`, at most `room` wide. Returns where it ends.
    ///
    /// The arguments are those of [`Scene::text`] and the room: a struct for them would be filled in at each call.
    pub(crate) fn paragraph(
        &mut self,
        (x, top): Point,
        anchor: Anchor,
        em: f64,
        ink: Ink,
        room: f64,
        words: &str,
    ) -> f64 {
        let mut bottom = top;
        for line in font::wrap(words, em, room) {
            self.text((x, bottom + LEADING * em - DESCENT * em), anchor, em, ink, line);
            bottom += LEADING * em;
        }
        bottom
    }

    /// Text of several lines that reads upwards, centred at `centre` and at most `room` long. Its lines go from `left`
    /// to the right. Returns where it ends.
    pub(crate) fn upright(&mut self, (left, centre): Point, em: f64, ink: Ink, room: f64, words: &str) -> f64 {
        let mut right = left;
        for words in font::wrap(words, em, room) {
            let at = (right + LEADING * em - DESCENT * em, centre);
            self.shapes.push(Shape::text(Text { at, anchor: Anchor::Middle, em, ink, turned: true, words }));
            right += LEADING * em;
        }
        right
    }
}

/// How much room wrapped text takes across its lines.
pub(crate) fn thickness(words: &str, em: f64, room: f64) -> f64 {
    font::wrap(words, em, room).len() as f64 * LEADING * em
}
