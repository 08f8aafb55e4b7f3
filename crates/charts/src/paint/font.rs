//! The one font of all charts, shipped with the program so that pictures do not depend on the machine; and texts in it.

use std::sync::OnceLock;

use ttf_parser::{Face, GlyphId};

/// The font.
pub(crate) const FILE: &[u8] = include_bytes!("../../fonts/DejaVuSans-subset.ttf");

/// What SVG files name, so that a viewer without DejaVu Sans takes Verdana, which has the same widths.
pub(crate) const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Depth of descenders under the baseline, over the size of the font.
pub(crate) const DESCENT: f64 = 0.24;

/// Size of subscripts over that of the text, and how far they stand lower.
const SUBSCRIPT: f64 = 0.74;
const DROP: f64 = 0.17;

/// Size of the font of a chart with this many panels side by side: 6 points or more when one panel is printed 8.5 cm
/// wide, and several as wide as a page (17 cm).
pub(crate) fn size(side_by_side: usize) -> f64 {
    match side_by_side {
        1 => 40.0,
        2 => 32.0,
        _ => 26.0,
    }
}

/// The font, read by the first who asks.
pub(crate) fn face() -> &'static Face<'static> {
    static FACE: OnceLock<Face<'static>> = OnceLock::new();
    FACE.get_or_init(|| Face::parse(FILE, 0).expect("the font in crates/charts/fonts is a TrueType font"))
}

/// The glyph of a character; that of missing ones where there is none.
pub(crate) fn glyph(letter: char) -> GlyphId {
    face().glyph_index(letter).unwrap_or_default()
}

/// How far a glyph moves on, over the size of the font.
pub(crate) fn advance(glyph: GlyphId) -> f64 {
    f64::from(face().glyph_hor_advance(glyph).unwrap_or_default()) / f64::from(face().units_per_em())
}

/// A part of a text whose letters have one size.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    pub(crate) words: String,
    pub(crate) is_subscript: bool,
}

impl Run {
    /// Size of the font over that of the text.
    pub(crate) fn size(&self) -> f64 {
        if self.is_subscript { SUBSCRIPT } else { 1.0 }
    }

    /// How far the baseline lies below that of the text, over the size of the text's font.
    pub(crate) fn drop(&self) -> f64 {
        if self.is_subscript { DROP } else { 0.0 }
    }

    /// Width over the size of the text's font.
    pub(crate) fn width(&self) -> f64 {
        self.size() * self.words.chars().map(|letter| advance(glyph(letter))).sum::<f64>()
    }
}

/// The parts of a text. Subscripts are the letters that Unicode has for them (μᵥ) and what stands in `_{…}`.
pub(crate) fn runs(text: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for letter in letters(text) {
        let (words, is_subscript) = subscript(letter).map_or((letter, false), |base| (base, true));
        match runs.last_mut() {
            Some(run) if run.is_subscript == is_subscript => run.words.push_str(words),
            _ => runs.push(Run { words: words.to_owned(), is_subscript }),
        }
    }
    runs
}

/// What is not to be torn apart: characters, and groups `_{…}`.
fn letters(text: &str) -> Vec<&str> {
    let mut letters = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let group = rest.strip_prefix("_{").and_then(|group| group.find('}'));
        let (letter, after) = rest.split_at(group.map_or(first.len_utf8(), |length| length + "_{}".len()));
        letters.push(letter);
        rest = after;
    }
    letters
}

/// What a letter is a subscript of; none if it is no subscript.
fn subscript(letter: &str) -> Option<&str> {
    const SMALL: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₒₓₕₖₗₘₙₚₛₜᵢᵣᵤᵥ";
    const BASE: &str = "0123456789+−=()aeoxhklmnpstiruv";
    if let Some(group) = letter.strip_prefix("_{") {
        return group.strip_suffix('}');
    }
    let place = SMALL.chars().position(|small| letter.starts_with(small))?;
    let (from, base) = BASE.char_indices().nth(place)?;
    Some(&BASE[from..from + base.len_utf8()])
}

/// Width of one line of text in pixels, for a font of `em` pixels.
pub(crate) fn width(text: &str, em: f64) -> f64 {
    em * runs(text).iter().map(Run::width).sum::<f64>()
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
        for letter in letters(word) {
            if !piece.is_empty() && width(&format!("{piece}{letter}"), em) > room {
                lines.push(std::mem::take(&mut piece));
            }
            piece.push_str(letter);
        }
        lines.push(piece);
    }
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1] = REST.to_owned();
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<(String, bool)> {
        runs(text).into_iter().map(|run| (run.words, run.is_subscript)).collect()
    }

    #[test]
    fn subscripts_are_letters_that_stand_lower() {
        let run = |words: &str, is_subscript| (words.to_owned(), is_subscript);
        assert_eq!(shown("μₜₒₜ, σ_{yy}"), [run("μ", false), run("tot", true), run(", σ", false), run("yy", true)]);
        assert_eq!(shown("film_min a_{b"), [run("film_min a_{b", false)]);
        assert_eq!(shown("a₀²/R"), [run("a", false), run("0", true), run("²/R", false)]);
    }

    #[test]
    fn groups_are_not_torn_apart() {
        for line in wrap("σ_{yy}σ_{yy}σ_{yy}σ_{yy}", 40.0, 90.0) {
            assert_eq!(line.matches("_{").count(), line.matches('}').count(), "{line}");
            assert!(width(&line, 40.0) <= 90.0);
        }
    }
}
