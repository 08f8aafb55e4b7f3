//! A scene as a page of PDF, whose letters are text in the font that comes with it.

use std::collections::{BTreeMap, BTreeSet};

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{CidFontType, FontFlags, LineJoinStyle, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use crate::paint::font::{self, runs};
use crate::paint::palette::{Ink, PAPER};
use crate::paint::scene::{Area, Point, Scene, Shape, Text};
use crate::paper::{Paper, WIDTH};

/// The objects of the file.
const INFO: Ref = Ref::new(1);
const CATALOG: Ref = Ref::new(2);
const PAGES: Ref = Ref::new(3);
const PAGE: Ref = Ref::new(4);
const CONTENT: Ref = Ref::new(5);
const FONT: Ref = Ref::new(6);
const CID_FONT: Ref = Ref::new(7);
const DESCRIPTOR: Ref = Ref::new(8);
const FONT_FILE: Ref = Ref::new(9);
const TO_UNICODE: Ref = Ref::new(10);
const FIRST_STATE: i32 = 11;

const FONT_NAME: Name = Name(b"DejaVuSans");
const SYSTEM: SystemInfo = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };
/// What is best packed takes little time here.
const SMALLEST: u8 = 9;

/// What the page needs beside its shapes.
#[derive(Default)]
struct Needed {
    /// The character of each glyph.
    glyphs: BTreeMap<u16, char>,
    /// Opacities in thousandths.
    opacities: BTreeSet<u16>,
}

/// The scene as PDF.
pub(crate) fn pdf(scene: &Scene, paper: &Paper) -> Vec<u8> {
    let (width, mut needed) = (0.75 * paper.width, Needed::default());
    let scale = width / WIDTH;
    let height = scene.height.ceil() * scale;
    let mut content = Content::new();
    content.transform([scale, 0.0, 0.0, -scale, 0.0, height].map(|number| number as f32));
    content.set_line_join(LineJoinStyle::RoundJoin);
    let whole = Area { left: 0.0, top: 0.0, right: WIDTH, bottom: scene.height.ceil() };
    push(&mut content, &Shape::Rectangle { area: whole, ink: PAPER }, &mut needed);
    for shape in &scene.shapes {
        push(&mut content, shape, &mut needed);
    }

    let mut pdf = Pdf::new();
    // First, where a file is known by its beginning.
    pdf.document_info(INFO).creator(TextStr(&paper.mark()));
    pdf.catalog(CATALOG).pages(PAGES);
    pdf.pages(PAGES).kids([PAGE]).count(1);
    let mut page = pdf.page(PAGE);
    page.media_box(Rect::new(0.0, 0.0, width as f32, height as f32)).parent(PAGES).contents(CONTENT);
    let mut resources = page.resources();
    resources.fonts().pair(Name(b"F"), FONT);
    let mut states = resources.ext_g_states();
    for (opacity, id) in needed.opacities.iter().zip(FIRST_STATE..) {
        states.pair(Name(state_name(*opacity).as_bytes()), Ref::new(id));
    }
    states.finish();
    resources.finish();
    page.finish();
    for (opacity, id) in needed.opacities.iter().zip(FIRST_STATE..) {
        let share = f32::from(*opacity) / 1000.0;
        pdf.ext_graphics(Ref::new(id)).stroking_alpha(share).non_stroking_alpha(share);
    }
    pdf.stream(CONTENT, &compress_to_vec_zlib(&content.finish(), SMALLEST)).filter(Filter::FlateDecode);
    write_font(&mut pdf, &needed.glyphs);
    pdf.finish()
}

/// Writes the font with the widths and characters of these glyphs.
fn write_font(pdf: &mut Pdf, glyphs: &BTreeMap<u16, char>) {
    let face = font::face();
    let thousandths = |units: i16| 1000.0 * f32::from(units) / f32::from(face.units_per_em());
    pdf.type0_font(FONT)
        .base_font(FONT_NAME)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(CID_FONT)
        .to_unicode(TO_UNICODE);
    let mut cid_font = pdf.cid_font(CID_FONT);
    cid_font.subtype(CidFontType::Type2).base_font(FONT_NAME).system_info(SYSTEM).font_descriptor(DESCRIPTOR);
    cid_font.cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = cid_font.widths();
    for glyph in glyphs.keys() {
        widths.consecutive(*glyph, [1000.0 * font::advance(ttf_parser::GlyphId(*glyph)) as f32]);
    }
    widths.finish();
    cid_font.finish();
    let bounds = face.global_bounding_box();
    pdf.font_descriptor(DESCRIPTOR)
        .name(FONT_NAME)
        .flags(FontFlags::NON_SYMBOLIC)
        .bbox(Rect::new(
            thousandths(bounds.x_min),
            thousandths(bounds.y_min),
            thousandths(bounds.x_max),
            thousandths(bounds.y_max),
        ))
        .italic_angle(0.0)
        .ascent(thousandths(face.ascender()))
        .descent(thousandths(face.descender()))
        .cap_height(729.0)
        .stem_v(80.0)
        .font_file2(FONT_FILE);
    let packed = compress_to_vec_zlib(font::FILE, SMALLEST);
    pdf.stream(FONT_FILE, &packed)
        .filter(Filter::FlateDecode)
        .pair(Name(b"Length1"), i32::try_from(font::FILE.len()).expect("a font is no gigabyte"));
    let mut characters = UnicodeCmap::new(Name(b"Characters"), SYSTEM);
    glyphs.iter().for_each(|(glyph, letter)| characters.pair(*glyph, *letter));
    pdf.cmap(TO_UNICODE, &characters.finish());
}

fn push(content: &mut Content, shape: &Shape, needed: &mut Needed) {
    match shape {
        Shape::Rectangle { area, ink } => {
            set_ink(content, *ink, needed);
            // Neighbours overlap a little, so that no paper shines through between them.
            let area = if ink.3 == 1.0 { area.grown(0.3) } else { *area };
            let [left, top, width, height] = [area.left, area.top, area.width(), area.height()].map(|it| it as f32);
            content.rect(left, top, width, height).fill_nonzero();
        }
        Shape::Path { points, width, ink } => {
            set_ink(content, *ink, needed);
            content.set_line_width(*width as f32);
            push_path(content, points);
            content.stroke();
        }
        Shape::Polygon { corners, ink } => {
            set_ink(content, *ink, needed);
            push_path(content, corners);
            content.close_path().fill_nonzero();
        }
        Shape::Disc { centre, radius, ink } => {
            set_ink(content, *ink, needed);
            push_circle(content, *centre, *radius);
            content.fill_nonzero();
        }
        Shape::Text(text) => push_text(content, text, needed),
    }
}

fn push_path(content: &mut Content, points: &[Point]) {
    for (i, (x, y)) in points.iter().enumerate() {
        let (x, y) = (*x as f32, *y as f32);
        if i == 0 {
            content.move_to(x, y)
        } else {
            content.line_to(x, y)
        };
    }
}

/// A circle of four curves, round to a part in four thousand.
fn push_circle(content: &mut Content, (x, y): Point, radius: f64) {
    const HANDLE: f64 = 0.5523;
    let at = |across: f64, down: f64| ((x + radius * across) as f32, (y + radius * down) as f32);
    let (start_x, start_y) = at(1.0, 0.0);
    content.move_to(start_x, start_y);
    for (from, to) in
        [((1.0, 0.0), (0.0, 1.0)), ((0.0, 1.0), (-1.0, 0.0)), ((-1.0, 0.0), (0.0, -1.0)), ((0.0, -1.0), (1.0, 0.0))]
    {
        let (from, to): (Point, Point) = (from, to);
        let (first, second) =
            (at(from.0 + HANDLE * to.0, from.1 + HANDLE * to.1), at(to.0 + HANDLE * from.0, to.1 + HANDLE * from.1));
        let end = at(to.0, to.1);
        content.cubic_to(first.0, first.1, second.0, second.1, end.0, end.1);
    }
}

fn push_text(content: &mut Content, text: &Text, needed: &mut Needed) {
    set_ink(content, text.ink, needed);
    content.begin_text();
    let mut gone = -text.before();
    for run in runs(&text.words) {
        let (along, down) = (gone, run.drop() * text.em);
        gone += run.width() * text.em;
        let (x, y) = text.at;
        // The page counts downwards, letters upwards.
        let matrix = match text.turned {
            true => [0.0, -1.0, -1.0, 0.0, x + down, y - along],
            false => [1.0, 0.0, 0.0, -1.0, x + along, y + down],
        };
        content.set_font(Name(b"F"), (run.size() * text.em) as f32);
        content.set_text_matrix(matrix.map(|number: f64| number as f32));
        let mut glyphs = Vec::new();
        for letter in run.words.chars() {
            let glyph = font::glyph(letter).0;
            needed.glyphs.entry(glyph).or_insert(letter);
            glyphs.extend(glyph.to_be_bytes());
        }
        content.show(Str(&glyphs));
    }
    content.end_text();
}

/// Sets colour and opacity of what follows.
fn set_ink(content: &mut Content, ink: Ink, needed: &mut Needed) {
    let [red, green, blue] = [ink.0, ink.1, ink.2].map(|channel| f32::from(channel) / 255.0);
    let opacity = (1000.0 * ink.3).round() as u16;
    needed.opacities.insert(opacity);
    content.set_parameters(Name(state_name(opacity).as_bytes()));
    content.set_fill_rgb(red, green, blue).set_stroke_rgb(red, green, blue);
}

fn state_name(opacity: u16) -> String {
    format!("O{opacity}")
}
