//! Colours: eight that colour-blind readers can tell apart (Okabe and Ito 2008), and the map viridis.

use plotters::style::RGBAColor;

/// A colour with its opacity.
pub(crate) type Ink = RGBAColor;

/// Text.
pub(crate) const TEXT: Ink = RGBAColor(34, 34, 34, 1.0);
/// Text of second rank.
pub(crate) const QUIET_TEXT: Ink = RGBAColor(85, 85, 85, 1.0);
/// Frames and ticks.
pub(crate) const FRAME: Ink = RGBAColor(68, 68, 68, 1.0);
/// Lines of the grid.
pub(crate) const GRID: Ink = RGBAColor(228, 228, 228, 1.0);
/// Walls behind a surface in space.
pub(crate) const WALL: Ink = RGBAColor(247, 247, 247, 1.0);
/// The paper.
pub(crate) const PAPER: Ink = RGBAColor(255, 255, 255, 1.0);
/// Behind cases that failed.
pub(crate) const FAILED: Ink = RGBAColor(250, 214, 208, 1.0);
/// The cross on a cell that failed.
pub(crate) const FAILED_CROSS: Ink = RGBAColor(170, 34, 34, 1.0);
/// Behind errors of exactly zero.
pub(crate) const EXACT: Ink = RGBAColor(222, 235, 247, 1.0);
/// Cells of cases that were solved, in a map that shows no more.
pub(crate) const SOLVED: Ink = RGBAColor(120, 190, 220, 1.0);
/// Cells whose quantity does not exist.
pub(crate) const UNKNOWN: Ink = RGBAColor(208, 208, 208, 1.0);

/// The colour and number of the marker of line `index`. Yellow is left out (too light on white).
pub(crate) fn line_colour(index: usize) -> Ink {
    const COLOURS: [Ink; 7] = [
        RGBAColor(0, 114, 178, 1.0),
        RGBAColor(213, 94, 0, 1.0),
        RGBAColor(0, 158, 115, 1.0),
        RGBAColor(204, 121, 167, 1.0),
        RGBAColor(230, 159, 0, 1.0),
        RGBAColor(86, 180, 233, 1.0),
        RGBAColor(0, 0, 0, 1.0),
    ];
    COLOURS[index % COLOURS.len()]
}

/// The same colour with another opacity.
pub(crate) fn faded(ink: Ink, opacity: f64) -> Ink {
    RGBAColor(ink.0, ink.1, ink.2, opacity)
}

/// The colour mixed with black, so that text in it is legible on white.
pub(crate) fn darkened(ink: Ink) -> Ink {
    let part = |channel: u8| (f64::from(channel) * 0.68) as u8;
    RGBAColor(part(ink.0), part(ink.1), part(ink.2), ink.3)
}

/// Viridis at `share` of its length, 0 (dark) to 1 (light), interpolated between eleven of its colours.
pub(crate) fn viridis(share: f64) -> Ink {
    const ANCHORS: [[u8; 3]; 11] = [
        [68, 1, 84],
        [72, 36, 117],
        [65, 68, 135],
        [53, 95, 141],
        [42, 120, 142],
        [33, 145, 140],
        [34, 168, 132],
        [68, 191, 112],
        [122, 209, 81],
        [189, 223, 38],
        [253, 231, 37],
    ];
    let place = share.clamp(0.0, 1.0) * (ANCHORS.len() - 1) as f64;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let rest = place - below as f64;
    let channel = |i: usize| {
        let (a, b) = (f64::from(ANCHORS[below][i]), f64::from(ANCHORS[below + 1][i]));
        (a + (b - a) * rest).round() as u8
    };
    RGBAColor(channel(0), channel(1), channel(2), 1.0)
}
