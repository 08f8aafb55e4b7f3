//! The box around a surface: walls with a grid behind it, axes in front.

use super::projection::{Place, Space};
use crate::axes::colour_scale::ColourRange;
use crate::axes::log_axis::LogAxis;
use crate::axes::ticks::{self, Tick, Ticks};
use crate::frame::MARGIN;
use crate::paint::font;
use crate::paint::palette::{FRAME, GRID, TEXT, WALL};
use crate::paint::scene::{Anchor, Area, Point, Scene, Shape, Text, thickness};

/// The axes of all panels.
pub(crate) struct Axes {
    pub(crate) x: LogAxis,
    pub(crate) y: LogAxis,
    /// Of heights and colours.
    pub(crate) z: ColourRange,
    /// Size of the font.
    pub(crate) em: f64,
    /// How much higher boxes are than they are seen.
    pub(crate) stretch: f64,
}

/// The ticks that fit a box.
pub(crate) struct BoxTicks {
    x: Ticks,
    y: Ticks,
    z: Ticks,
}

/// From an axis to the baseline of its labels below, and to the labels beside.
const BELOW: f64 = 1.5;
const BESIDE: f64 = 0.5;
/// Size of titles over that of labels.
const TITLE: f64 = 1.1;

impl Axes {
    /// The ticks in a box of this width.
    pub(crate) fn ticks(&self, width: f64) -> BoxTicks {
        let (em, space) = (self.em, Space::new((0.0, 0.0), width, self.stretch));
        let x_extent = |tick: &Tick| {
            let (middle, half) = (space.at((self.x.share(tick.value), 0.0, 0.0)).0, 0.5 * font::width(&tick.label, em));
            (middle - half, middle + half)
        };
        let y_extent = |tick: &Tick| {
            let middle = -space.at((1.0, self.y.share(tick.value), 0.0)).1;
            (middle - 0.6 * em, middle + 0.6 * em)
        };
        let high = space.at((0.0, 0.0, 0.0)).1 - space.at((0.0, 0.0, 1.0)).1;
        BoxTicks {
            x: ticks::fitting_or_fewer(|most| self.x.ticks(most), x_extent, 0.4 * em),
            y: ticks::fitting_or_fewer(|most| self.y.ticks(most), y_extent, 0.2 * em),
            z: self.z.ticks(high, em),
        }
    }

    /// How far labels stand out of the box: heights to the left, the labels of x to the left, those of y to the right.
    pub(crate) fn overhang(&self, ticks: &BoxTicks) -> (f64, f64, f64) {
        let widest = |ticks: &Ticks| ticks.widest(self.em) + 1.0;
        (
            BESIDE * self.em + widest(&ticks.z),
            0.2 * self.em + 0.5 * widest(&ticks.x),
            BESIDE * self.em + widest(&ticks.y),
        )
    }

    /// The walls at the back and the floor.
    pub(crate) fn draw_walls(&self, scene: &mut Scene, space: &Space, ticks: &BoxTicks) {
        let path = |places: &[Place]| -> Vec<Point> { places.iter().map(|place| space.at(*place)).collect() };
        let floor = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)];
        let left = [(0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 1.0, 1.0), (0.0, 0.0, 1.0)];
        let back = [(0.0, 1.0, 0.0), (1.0, 1.0, 0.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)];
        for face in [&floor, &left, &back] {
            scene.shapes.push(Shape::Polygon { corners: path(face), ink: WALL });
        }
        for tick in &ticks.x.major {
            let x = self.x.share(tick.value);
            scene.path(path(&[(x, 0.0, 0.0), (x, 1.0, 0.0), (x, 1.0, 1.0)]), 2.0, GRID);
        }
        for tick in &ticks.y.major {
            let y = self.y.share(tick.value);
            scene.path(path(&[(1.0, y, 0.0), (0.0, y, 0.0), (0.0, y, 1.0)]), 2.0, GRID);
        }
        for tick in &ticks.z.major {
            let z = self.z.share(tick.value);
            scene.path(path(&[(0.0, 0.0, z), (0.0, 1.0, z), (1.0, 1.0, z)]), 2.0, GRID);
        }
        for face in [&floor, &left, &back] {
            let mut outline = path(face);
            outline.push(outline[0]);
            scene.path(outline, 2.0, FRAME);
        }
    }

    /// Ticks and their labels; those of the height if wanted. Returns the areas of the labels.
    pub(crate) fn draw_labels(&self, scene: &mut Scene, space: &Space, ticks: &BoxTicks, with_z: bool) -> Vec<Area> {
        let em = self.em;
        let outwards = |scene: &mut Scene, place: Place, to: Place, length: f64| {
            let ((x, y), (far_x, far_y)) = (space.at(place), space.at(to));
            let share = length / (far_x - x).hypot(far_y - y);
            scene.line((x, y), (x + share * (far_x - x), y + share * (far_y - y)), 2.0, FRAME);
        };
        let first = scene.shapes.len();
        for (ticks, length) in [(minor(&ticks.x), 0.14), (major(&ticks.x), 0.3)] {
            for value in ticks {
                let x = self.x.share(value);
                outwards(scene, (x, 0.0, 0.0), (x, -1.0, 0.0), length * em);
            }
        }
        for (ticks, length) in [(minor(&ticks.y), 0.14), (major(&ticks.y), 0.3)] {
            for value in ticks {
                let y = self.y.share(value);
                outwards(scene, (1.0, y, 0.0), (2.0, y, 0.0), length * em);
            }
        }
        for tick in &ticks.x.major {
            let (x, y) = space.at((self.x.share(tick.value), 0.0, 0.0));
            scene.text((x - 0.15 * em, y + BELOW * em), Anchor::Middle, em, TEXT, tick.label.as_str());
        }
        for tick in &ticks.y.major {
            let (x, y) = space.at((1.0, self.y.share(tick.value), 0.0));
            scene.text((x + BESIDE * em, y + 0.36 * em), Anchor::Start, em, TEXT, tick.label.as_str());
        }
        for tick in ticks.z.major.iter().filter(|_| with_z) {
            let (x, y) = space.at((0.0, 0.0, self.z.share(tick.value)));
            scene.line((x - 0.3 * em, y), (x, y), 2.0, FRAME);
            scene.text((x - BESIDE * em, y + 0.36 * em), Anchor::End, em, TEXT, tick.label.as_str());
        }
        text_areas(&scene.shapes[first..])
    }

    /// Draws the names of the horizontal axes, clear of their labels, between `left` and `right`. Returns where they
    /// end.
    pub(crate) fn draw_names(
        &self,
        scene: &mut Scene,
        space: &Space,
        (ticks, labels): (&BoxTicks, &[Area]),
        (left, right): (f64, f64),
        (x_name, y_name): (&str, &str),
    ) -> f64 {
        let mut texts = ClearTexts::beside(labels, self.em);
        self.draw_x_name(scene, space, &mut texts, left, x_name);
        self.draw_y_name(scene, space, &mut texts, (ticks, labels), (right, y_name));
        f64::max(texts.bottom, space.at((1.0, 0.0, 0.0)).1)
    }

    /// Draws the name of x below the middle of its axis.
    fn draw_x_name(&self, scene: &mut Scene, space: &Space, texts: &mut ClearTexts, left: f64, name: &str) {
        let (origin, corner) = (space.at((0.0, 0.0, 0.0)), space.at((1.0, 0.0, 0.0)));
        let room = corner.0 - left;
        let half = 0.5 * texts.size(name, room).0;
        let middle = space.at((0.5, 0.0, 0.0)).0.min(corner.0 - half).max(left + half);
        // Below the lowest label above it, which is at its right.
        let across = (middle + half - origin.0) / (corner.0 - origin.0);
        let top = space.at((across.min(1.0), 0.0, 0.0)).1 + (BELOW + 0.2) * self.em;
        texts.draw(scene, (middle, top), room, name);
    }

    /// Draws the name of y beside its labels, between two of them, if there is room; else below them.
    fn draw_y_name(
        &self,
        scene: &mut Scene,
        space: &Space,
        texts: &mut ClearTexts,
        (ticks, labels): (&BoxTicks, &[Area]),
        (right, name): (f64, &str),
    ) {
        let em = self.em;
        let shares: Vec<f64> = ticks.y.major.iter().map(|tick| self.y.share(tick.value)).collect();
        let between = shares.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let off_middle = |share: &f64| (share - 0.5).abs();
        let share = between.min_by(|one, other| off_middle(one).total_cmp(&off_middle(other))).unwrap_or(0.5);
        let side = space.at((1.0, share, 0.0));
        let (width, height) = texts.size(name, f64::INFINITY);
        let top = side.1 - 0.5 * height;
        let area = |left: f64| Area { left, top, right: left + width, bottom: top + height };
        let free = |left: f64| !labels.iter().any(|label| label.grown(0.3 * em).overlaps(&area(left)));
        let beside = (0..).map(|step| side.0 + (1.0 + 0.1 * f64::from(step)) * em).find(|left| free(*left));
        if let Some(left) = beside.filter(|left| left + width <= right) {
            texts.draw(scene, (left + 0.5 * width, top), width + 1.0, name);
        } else {
            let room = right - space.at((1.0, 0.0, 0.0)).0 - 0.5 * em;
            let (width, _) = texts.size(name, room);
            texts.draw(scene, (right - 0.5 * width, side.1), room, name);
        }
    }

    /// Draws the name of the height, left of everything. Returns the areas of its lines.
    pub(crate) fn draw_height_name(&self, scene: &mut Scene, space: &Space, room: f64, name: &str) -> Vec<Area> {
        let middle = 0.5 * (space.at((0.0, 0.0, 0.0)).1 + space.at((0.0, 0.0, 1.0)).1);
        let first = scene.shapes.len();
        scene.upright((MARGIN, middle), TITLE * self.em, TEXT, room, name);
        text_areas(&scene.shapes[first..])
    }

    /// How much room the name of the height takes across, beside a box of this width.
    pub(crate) fn height_name_width(&self, room: f64, name: &str) -> f64 {
        thickness(name, TITLE * self.em, room)
    }
}

/// The areas of the texts among shapes.
fn text_areas(shapes: &[Shape]) -> Vec<Area> {
    let area = |shape: &Shape| if let Shape::Text(text) = shape { Some(Text::area(text)) } else { None };
    shapes.iter().filter_map(area).collect()
}

/// Texts that cover neither each other nor labels drawn before.
struct ClearTexts {
    em: f64,
    taken: Vec<Area>,
    /// Where the lowest text ends.
    bottom: f64,
}

impl ClearTexts {
    fn beside(labels: &[Area], em: f64) -> Self {
        let taken = labels.iter().map(|area| area.grown(0.3 * em)).collect();
        ClearTexts { em, taken, bottom: labels.iter().map(|area| area.bottom).fold(f64::NEG_INFINITY, f64::max) }
    }

    /// Width and height of a text in lines of at most `room` pixels.
    fn size(&self, words: &str, room: f64) -> (f64, f64) {
        let em = TITLE * self.em;
        let width = font::wrap(words, em, room).iter().map(|line| font::width(line, em)).fold(0.0, f64::max);
        (width, thickness(words, em, room))
    }

    /// Draws a text centred below a point, so far below that it covers nothing.
    fn draw(&mut self, scene: &mut Scene, (centre, mut top): Point, room: f64, words: &str) {
        let (width, height) = self.size(words, room);
        let area =
            |top: f64| Area { left: centre - 0.5 * width, top, right: centre + 0.5 * width, bottom: top + height };
        while self.taken.iter().any(|other| other.overlaps(&area(top))) {
            top += 0.1 * self.em;
        }
        scene.paragraph((centre, top), Anchor::Middle, TITLE * self.em, TEXT, room, words);
        self.taken.push(area(top).grown(0.3 * self.em));
        self.bottom = self.bottom.max(area(top).bottom);
    }
}

fn major(ticks: &Ticks) -> Vec<f64> {
    ticks.major.iter().map(|tick| tick.value).collect()
}

fn minor(ticks: &Ticks) -> Vec<f64> {
    ticks.minor.clone()
}
