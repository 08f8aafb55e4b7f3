//! Colours that colour-blind readers can tell apart: of lines (after Okabe and Ito 2008), of families of lines (the
//! dark part of the map plasma), and of areas (the map viridis).

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

/// The name of a colour that a page may replace by its own, as its letters and lines are light on dark paper.
pub(crate) fn name(ink: Ink) -> Option<String> {
    let is = |other: &Ink| (ink.0, ink.1, ink.2) == (other.0, other.1, other.2);
    const NAMED: [(Ink, &str); 5] =
        [(TEXT, "text"), (QUIET_TEXT, "quiet-text"), (FRAME, "frame"), (GRID, "grid"), (PAPER, "paper")];
    let named = NAMED.iter().find(|(other, _)| is(other)).map(|(_, name)| (*name).to_owned());
    named.or_else(|| (0..7).find(|index| is(&line_colour(*index))).map(|index| format!("line-{index}")))
}

/// The colour of line `index`: four of Okabe and Ito's, and three darker ones in place of those too light for white.
pub(crate) fn line_colour(index: usize) -> Ink {
    const COLOURS: [Ink; 7] = [
        RGBAColor(0, 114, 178, 1.0),
        RGBAColor(213, 94, 0, 1.0),
        RGBAColor(0, 158, 115, 1.0),
        RGBAColor(204, 121, 167, 1.0),
        RGBAColor(48, 16, 208, 1.0),
        RGBAColor(112, 48, 16, 1.0),
        RGBAColor(0, 0, 0, 1.0),
    ];
    COLOURS[index % COLOURS.len()]
}

/// The colour of one of a family of lines, at `share` of the way from the first (dark) to the last: the part of the map
/// plasma that is dark enough for white.
pub(crate) fn family_colour(share: f64) -> Ink {
    const ANCHORS: [[u8; 3]; 11] = [
        [13, 8, 135],
        [65, 4, 157],
        [106, 0, 168],
        [143, 13, 164],
        [177, 42, 144],
        [204, 71, 120],
        [225, 100, 98],
        [242, 132, 75],
        [252, 166, 54],
        [252, 206, 37],
        [240, 249, 33],
    ];
    const DARK: f64 = 0.62;
    between(&ANCHORS, DARK * share.clamp(0.0, 1.0))
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
    between(&ANCHORS, share)
}

/// The colour at `share` of the way along a list of colours.
fn between(colours: &[[u8; 3]], share: f64) -> Ink {
    let place = share.clamp(0.0, 1.0) * (colours.len() - 1) as f64;
    let below = (place as usize).min(colours.len() - 2);
    let rest = place - below as f64;
    let channel = |i: usize| {
        let (a, b) = (f64::from(colours[below][i]), f64::from(colours[below + 1][i]));
        (a + (b - a) * rest).round() as u8
    };
    RGBAColor(channel(0), channel(1), channel(2), 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The channels as amounts of light.
    fn light(ink: Ink) -> [f64; 3] {
        [ink.0, ink.1, ink.2].map(|channel| {
            let share = f64::from(channel) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        })
    }

    fn product(rows: &[[f64; 3]; 3], light: [f64; 3]) -> [f64; 3] {
        rows.map(|row| row.iter().zip(light).map(|(factor, light)| factor * light).sum())
    }

    /// Contrast with white (WCAG 2).
    fn contrast(ink: Ink) -> f64 {
        let [red, green, blue] = light(ink);
        1.05 / (0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05)
    }

    /// Lightness and the two colour axes (CIELAB) of a colour as readers see it.
    fn seen(ink: Ink, reader: &[[f64; 3]; 3]) -> [f64; 3] {
        const XYZ: [[f64; 3]; 3] = [[0.4339, 0.3762, 0.1899], [0.2126, 0.7152, 0.0722], [0.0177, 0.1095, 0.8728]];
        let [x, y, z] = product(&XYZ, product(reader, light(ink)))
            .map(|it| it.max(0.0))
            .map(|it| if it > 0.008856 { it.cbrt() } else { 7.787 * it + 16.0 / 116.0 });
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// Readers with all colours, and without red and green receptors (Machado and others 2009).
    const READERS: [[[f64; 3]; 3]; 3] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    ];

    #[test]
    fn lines_hold_on_white() {
        let family = (0..=20).map(|i| family_colour(f64::from(i) / 20.0));
        for ink in (0..7).map(line_colour).chain(family).chain([TEXT, QUIET_TEXT]) {
            assert!(contrast(ink) >= 3.0, "{ink:?}: {}", contrast(ink));
        }
    }

    #[test]
    fn colour_blind_readers_tell_lines_apart() {
        for reader in &READERS {
            for (i, j) in (0..7).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let (one, other) = (seen(line_colour(i), reader), seen(line_colour(j), reader));
                let distance: f64 = one.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                assert!(distance > 15.0, "{i} and {j}: {distance}");
            }
            // A family grows lighter from member to member.
            let lightness: Vec<f64> = (0..=6).map(|i| seen(family_colour(f64::from(i) / 6.0), reader)[0]).collect();
            assert!(lightness.windows(2).all(|pair| pair[0] + 3.0 < pair[1]), "{lightness:?}");
        }
    }
}
