//! Panels of one size side by side, with a colour bar beside them.

use super::{MARGIN, RIGHT, Side, Style, overhang};
use crate::axes::Axis;
use crate::axes::colour_scale::ColourRange;
use crate::axes::ticks::Ticks;
use crate::paint::palette::TEXT;
use crate::paint::scene::{Anchor, Area, Scene, thickness};

/// What decides how large panels are.
pub(crate) struct Demand<'a> {
    pub(crate) style: Style,
    /// Number of panels side by side.
    pub(crate) columns: usize,
    /// The axes of each panel.
    pub(crate) axes: (&'a dyn Axis, &'a dyn Axis),
    /// Name of the vertical axis.
    pub(crate) y_name: &'a str,
    /// The scale of colours and its name, if there is one.
    pub(crate) colours: Option<(ColourRange, &'a str)>,
    /// About how much room labels and colour bar take of the width, over the size of the font.
    pub(crate) label_room: f64,
    /// Height over width of a panel.
    pub(crate) height_over_width: f64,
    /// Least height of a panel over the size of the font.
    pub(crate) least_height: f64,
    /// Length of the colour bar over the height of a panel.
    pub(crate) bar_over_height: f64,
}

/// Where panels and the colour bar lie, and the ticks that all panels share.
pub(crate) struct Panels {
    pub(crate) style: Style,
    columns: usize,
    pub(crate) left: f64,
    pub(crate) width: f64,
    height: f64,
    gap: f64,
    pub(crate) bar_length: f64,
    x_ticks: Ticks,
    y_ticks: Ticks,
}

impl Panels {
    /// The largest panels that leave room for their labels.
    ///
    /// The height follows from the width of a panel, and the labels that fit follow from both, so the width is found in
    /// a few rounds.
    pub(crate) fn fit(demand: &Demand) -> Self {
        let (em, columns) = (demand.style.em, demand.columns as f64);
        let (x, y) = demand.axes;
        let mut panels = Panels {
            style: demand.style,
            columns: demand.columns,
            left: 0.0,
            width: (RIGHT - MARGIN - demand.label_room * em) / columns,
            height: 0.0,
            gap: 0.0,
            bar_length: 0.0,
            x_ticks: Ticks::default(),
            y_ticks: Ticks::default(),
        };
        for _ in 0..4 {
            panels.height = (panels.width * demand.height_over_width).max(demand.least_height * em);
            panels.bar_length = panels.height * demand.bar_over_height;
            let widest = y.ticks(panels.height, em, true).widest(em);
            panels.left = demand.style.plot_left(demand.y_name, panels.height, widest);
            // Half of the last label of a panel, and of the first one of the next, stand out.
            let out = overhang(x, &x.ticks(panels.width, em, false), panels.width, em);
            panels.gap = (out.0 + out.1 + 0.5 * em).max(0.9 * em).max(panels.gap);
            let bar = demand.colours.map_or(0.0, |(scale, name)| scale.width(panels.bar_length, em, name) + 0.8 * em);
            // Where labels leave no room a panel stays a panel, and the picture is cut.
            panels.width = ((RIGHT - bar - out.1 - panels.left - (columns - 1.0) * panels.gap) / columns).max(em);
        }
        panels.x_ticks = x.ticks(panels.width, em, false);
        panels.y_ticks = y.ticks(panels.height, em, true);
        panels
    }

    /// Width of a row of panels.
    pub(crate) fn across(&self) -> f64 {
        self.columns as f64 * self.width + (self.columns as f64 - 1.0) * self.gap
    }

    /// The panel of a column whose upper side is there.
    pub(crate) fn area(&self, column: usize, top: f64) -> Area {
        let left = self.left + column as f64 * (self.width + self.gap);
        Area { left, top, right: left + self.width, bottom: top + self.height }
    }

    /// Draws the labels of panels side by side below `top`, which end at the same height. Returns that height.
    pub(crate) fn draw_labels(&self, scene: &mut Scene, labels: &[&str], top: f64) -> f64 {
        let em = self.style.em;
        let height = |label: &str| thickness(label, em, self.width);
        let bottom = top + labels.iter().map(|label| height(label)).fold(0.0, f64::max);
        for (column, label) in labels.iter().enumerate() {
            let at = (self.area(column, top).centre().0, bottom - height(label));
            scene.paragraph(at, Anchor::Middle, em, TEXT, self.width, label);
        }
        bottom
    }

    /// Draws the ticks of a panel, with labels at the left of the first column and below the lowest panels.
    pub(crate) fn draw_ticks(
        &self,
        scene: &mut Scene,
        (x, y): (&dyn Axis, &dyn Axis),
        area: Area,
        (first, lowest): (bool, bool),
    ) {
        let x_at = |value: f64| area.left + area.width() * x.share(value);
        let y_at = |value: f64| area.bottom - area.height() * y.share(value);
        self.style.ticks_below(scene, area, &Side { ticks: &self.x_ticks, at: &x_at }, lowest);
        self.style.ticks_beside(scene, area, &Side { ticks: &self.y_ticks, at: &y_at }, first);
    }

    /// Draws the colour bar beside all panels. Returns its upper left corner.
    pub(crate) fn draw_bar(&self, scene: &mut Scene, all: Area, scale: &ColourRange, name: &str) -> (f64, f64) {
        let em = self.style.em;
        let left = RIGHT - scale.width(self.bar_length, em, name);
        let corner = (left, all.centre().1 - 0.5 * self.bar_length);
        scale.draw(scene, corner, self.bar_length, em, name);
        corner
    }
}
