//! The label of a setting beside its median marker.

use super::placement::{self, Effort, Obstacles};
use crate::paint::font;
use crate::paint::palette::{Ink, PAPER, faded};
use crate::paint::scene::{Anchor, Point, Scene, Shape, Text};

/// Distance of baselines over the size of the font.
const LEADING: f64 = 1.12;
/// A label without room is tried once more at this size.
const SMALLER: f64 = 0.85;

/// A label and the point that it belongs to.
pub(crate) struct SettingLabel {
    pub(crate) at: Point,
    pub(crate) ink: Ink,
    /// One line of text each.
    pub(crate) words: Vec<String>,
    pub(crate) effort: Effort,
}

impl SettingLabel {
    /// Finds room at `reach` from the point or further away, and draws what lies behind the text. Returns the text, to
    /// be drawn when all labels have their place; none if there is no room.
    pub(crate) fn place(&self, obstacles: &mut Obstacles, reach: f64, em: f64, scene: &mut Scene) -> Vec<Shape> {
        let attempts: &[(f64, Effort)] = match self.effort {
            Effort::Near => &[(1.0, Effort::Near)],
            Effort::Far => &[(1.0, Effort::Far), (SMALLER, Effort::Far)],
            Effort::Always => &[(1.0, Effort::Far), (SMALLER, Effort::Far), (SMALLER, Effort::Always)],
        };
        let found = attempts.iter().find_map(|(size, effort)| {
            let em = size * em;
            let width = self.words.iter().map(|line| font::width(line, em)).fold(0.0, f64::max) + 8.0;
            let height = LEADING * em * self.words.len() as f64 + 4.0;
            obstacles.place(self.at, (width, height), reach, *effort).map(|area| (em, area))
        });
        let Some((em, area)) = found else { return vec![] };
        if let Some((from, to)) = placement::leader(self.at, &area, reach) {
            scene.line(from, to, 2.0, self.ink);
        }
        scene.rectangle(area, faded(PAPER, 0.5));
        let (anchor, x) = if area.left >= self.at.0 {
            (Anchor::Start, area.left + 4.0)
        } else if area.right <= self.at.0 {
            (Anchor::End, area.right - 4.0)
        } else {
            (Anchor::Middle, area.centre().0)
        };
        let text = |(i, words): (usize, &String)| {
            let baseline = area.top + 2.0 + LEADING * em * (i as f64 + 1.0) - 0.28 * em;
            Shape::text(Text { at: (x, baseline), anchor, em, ink: self.ink, turned: false, words: words.clone() })
        };
        self.words.iter().enumerate().map(text).collect()
    }
}
