//! The one font of all charts, shipped with the program so that pictures do not depend on the machine.

use std::sync::OnceLock;

use plotters::style::{FontFamily, FontStyle, IntoFont, register_font};

/// The family under which the font is registered. SVG files name it as it stands, so that a viewer without DejaVu Sans
/// takes Verdana, which has the same widths.
const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Depth of descenders under the baseline, over the size of the font.
pub(crate) const DESCENT: f64 = 0.24;

/// Height of the line (ascender to descender) over the size of the font: ab_glyph counts sizes in lines.
pub(crate) const LINE_PER_EM: f64 = (1901.0 + 483.0) / 2048.0;

/// Size of the font of a chart with this many panels side by side: 6 points or more when one panel is printed 8.5 cm
/// wide, and several as wide as a page (17 cm).
pub(crate) fn size(side_by_side: usize) -> f64 {
    match side_by_side {
        1 => 40.0,
        2 => 32.0,
        _ => 26.0,
    }
}

static REGISTERED: OnceLock<()> = OnceLock::new();

/// The font, registered with the drawing library by the first who asks.
pub(crate) fn family() -> FontFamily<'static> {
    REGISTERED.get_or_init(|| {
        let font = include_bytes!("../../fonts/DejaVuSans-subset.ttf");
        assert!(
            register_font(FAMILY, FontStyle::Normal, font).is_ok(),
            "the font in crates/charts/fonts is a TrueType font"
        );
    });
    FontFamily::Name(FAMILY)
}

/// Width of one line of text in pixels, for a font of `em` pixels.
pub(crate) fn width(text: &str, em: f64) -> f64 {
    // The library rounds to pixels: measured large, the width is exact to a thousandth of the font's size.
    const MEASURED: f64 = 1000.0;
    let font = (family(), MEASURED * LINE_PER_EM).into_font();
    let ((left, _), (right, _)) = font.layout_box(text).expect("the font was registered just before");
    f64::from(right - left) * em / MEASURED
}

/// No text of a picture has more letters or lines than these.
const MOST_LETTERS: usize = 1000;
const MOST_LINES: usize = 24;

/// The text in lines of at most `room` pixels, broken at spaces, and inside a word only if the word alone is longer. A
/// text that is too long ends in "…".
pub(crate) fn wrap(text: &str, em: f64, room: f64) -> Vec<String> {
    const REST: &str = "…";
    let shown = text.char_indices().nth(MOST_LETTERS).map_or(text, |(end, _)| &text[..end]);
    let rest = (shown.len() < text.len()).then_some(REST);
    let mut lines: Vec<String> = Vec::new();
    for word in shown.split_whitespace().chain(rest) {
        if let Some(line) = lines.last_mut() {
            let longer = format!("{line} {word}");
            if width(&longer, em) <= room {
                *line = longer;
                continue;
            }
        }
        let mut piece = String::new();
        for letter in word.chars() {
            if !piece.is_empty() && width(&format!("{piece}{letter}"), em) > room {
                lines.push(std::mem::take(&mut piece));
            }
            piece.push(letter);
        }
        lines.push(piece);
    }
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1] = REST.to_owned();
    }
    lines
}
