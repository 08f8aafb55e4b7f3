//! What charts share around the numbers that they show: heading, ticks, names of axes, panels, legend.

pub(crate) mod legend;
pub(crate) mod panels;

use crate::axes::Axis;
use crate::axes::ticks::{Tick, Ticks};
use crate::paint::font;
use crate::paint::palette::{FRAME, GRID, QUIET_TEXT, TEXT};
use crate::paint::scene::{Anchor, Area, Scene, thickness};
use crate::paper::{Paper, WIDTH};
use legend::Entry;

/// What stays free at the left and at the right of a picture, in pixels.
pub(crate) const MARGIN: f64 = 30.0;
/// Where everything ends at the right.
pub(crate) const RIGHT: f64 = WIDTH - MARGIN;
/// Size of the names of axes over the size of labels.
const NAME: f64 = 1.1;

/// The lengths of a frame. Those without a unit are multiples of the size of the font.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    /// Size of the font of labels, in pixels.
    pub(crate) em: f64,
    /// Size of the title.
    pub(crate) title: f64,
    /// Whether there is a heading.
    pub(crate) heading: bool,
    /// What stays free below the heading.
    pub(crate) below_heading: f64,
    /// Length of a tick with a label.
    pub(crate) tick: f64,
    /// Length of a tick without one.
    pub(crate) minor_tick: f64,
    /// Width of a tick with a label, in pixels.
    pub(crate) tick_width: f64,
    /// From the lower side of a plot to the baseline of the labels.
    pub(crate) baseline: f64,
    /// From the lower side of a plot to the name of its horizontal axis.
    pub(crate) name_below: f64,
    /// From the name of the vertical axis to the labels.
    pub(crate) beside_name: f64,
    /// What stays free above the legend.
    pub(crate) above_legend: f64,
    /// What stays free at the lower edge of the picture.
    pub(crate) below_all: f64,
}

/// One side of a plot: its ticks, and from a value to a pixel.
pub(crate) struct Side<'a> {
    pub(crate) ticks: &'a Ticks,
    pub(crate) at: &'a dyn Fn(f64) -> f64,
}

impl Style {
    /// A chart of one plot.
    pub(crate) fn plot(paper: &Paper) -> Self {
        Style {
            em: paper.em(1),
            title: 1.12,
            heading: paper.heading,
            below_heading: 0.5,
            tick: 0.3,
            minor_tick: 0.15,
            tick_width: 3.0,
            baseline: 1.4,
            name_below: 1.5 + font::DESCENT,
            beside_name: 0.3,
            above_legend: 0.5,
            below_all: 0.6,
        }
    }

    /// A chart of several panels, with this many side by side.
    pub(crate) fn panels(side_by_side: usize, paper: &Paper) -> Self {
        Style {
            em: paper.em(side_by_side),
            title: 1.15,
            below_heading: 0.4,
            tick: 0.25,
            minor_tick: 0.13,
            tick_width: 2.0,
            name_below: 1.8,
            above_legend: 0.4,
            ..Style::plot(paper)
        }
    }

    /// Draws title and subtitle at the upper edge. Returns where the chart begins.
    pub(crate) fn heading(&self, scene: &mut Scene, title: &str, subtitle: &str) -> f64 {
        let (em, room) = (self.title * self.em, RIGHT - MARGIN);
        if !self.heading {
            return 0.8 * self.em;
        }
        let top = scene.paragraph((MARGIN, 0.5 * em), Anchor::Start, em, TEXT, room, title);
        let bottom = scene.paragraph((MARGIN, top), Anchor::Start, 0.85 * em, QUIET_TEXT, room, subtitle);
        bottom + self.below_heading * self.em
    }

    /// Where a plot of this height begins at the left: beside the name of its vertical axis and its labels.
    pub(crate) fn plot_left(&self, y_name: &str, height: f64, widest_label: f64) -> f64 {
        let name = thickness(y_name, NAME * self.em, height);
        MARGIN + name + self.beside_name * self.em + widest_label + 0.4 * self.em
    }

    /// Draws grid lines across an area.
    pub(crate) fn grid(&self, scene: &mut Scene, area: Area, x: &Side, y: &Side) {
        for tick in &x.ticks.major {
            let x = (x.at)(tick.value);
            scene.line((x, area.top), (x, area.bottom), 2.0, GRID);
        }
        for tick in &y.ticks.major {
            let y = (y.at)(tick.value);
            scene.line((area.left, y), (area.right, y), 2.0, GRID);
        }
    }

    /// Draws the ticks of the horizontal axis below an area, with their labels if these are wanted.
    pub(crate) fn ticks_below(&self, scene: &mut Scene, area: Area, x: &Side, labelled: bool) {
        let em = self.em;
        for value in &x.ticks.minor {
            let x = (x.at)(*value);
            scene.line((x, area.bottom), (x, area.bottom + self.minor_tick * em), 2.0, FRAME);
        }
        for tick in &x.ticks.major {
            let x = (x.at)(tick.value);
            scene.line((x, area.bottom), (x, area.bottom + self.tick * em), self.tick_width, FRAME);
            if labelled {
                let baseline = area.bottom + self.baseline * em;
                scene.text((x, baseline), Anchor::Middle, em, TEXT, tick.label.as_str());
            }
        }
    }

    /// Draws the ticks of the vertical axis at the left of an area, with their labels if these are wanted.
    pub(crate) fn ticks_beside(&self, scene: &mut Scene, area: Area, y: &Side, labelled: bool) {
        for value in &y.ticks.minor {
            let y = (y.at)(*value);
            scene.line((area.left - self.minor_tick * self.em, y), (area.left, y), 2.0, FRAME);
        }
        for tick in &y.ticks.major {
            let y = (y.at)(tick.value);
            scene.line((area.left - self.tick * self.em, y), (area.left, y), self.tick_width, FRAME);
            if labelled {
                self.label_beside(scene, (area.left, y), &tick.label);
            }
        }
    }

    /// Draws a label at the left of a point on the left side of a plot.
    pub(crate) fn label_beside(&self, scene: &mut Scene, (left, y): (f64, f64), label: &str) {
        scene.text((left - 0.4 * self.em, y + 0.36 * self.em), Anchor::End, self.em, TEXT, label);
    }

    /// Draws the names of both axes of an area. Returns where that of the horizontal axis ends.
    pub(crate) fn names(&self, scene: &mut Scene, area: Area, x_name: &str, y_name: &str) -> f64 {
        let em = NAME * self.em;
        scene.upright((MARGIN, area.centre().1), em, TEXT, area.height(), y_name);
        let top = area.bottom + self.name_below * self.em;
        scene.paragraph((area.centre().0, top), Anchor::Middle, em, TEXT, area.width(), x_name)
    }

    /// Draws the legend, if it has entries, and ends the picture below it.
    pub(crate) fn finish(&self, scene: &mut Scene, entries: &[Entry], (left, below): (f64, f64)) {
        let mut bottom = below;
        if !entries.is_empty() {
            bottom = legend::draw(scene, entries, (left, below + self.above_legend * self.em), RIGHT, self.em);
        }
        scene.height = (bottom + self.below_all * self.em).ceil();
    }
}

/// How far the labels of a horizontal axis stand out at its left and right ends, in pixels; 0 if they do not.
pub(crate) fn overhang(axis: &dyn Axis, ticks: &Ticks, length: f64, em: f64) -> (f64, f64) {
    let ends = |tick: &Tick| {
        let (middle, half) = (length * axis.share(tick.value), 0.5 * font::width(&tick.label, em));
        (half - middle, middle + half - length)
    };
    ticks.major.iter().map(ends).fold((0.0, 0.0), |out: (f64, f64), end| (out.0.max(end.0), out.1.max(end.1)))
}
