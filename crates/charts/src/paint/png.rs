//! A scene as the bytes of a PNG.

use std::sync::OnceLock;

use plotters::prelude::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    FontFamily, FontStyle, FontTransform, IntoFont, RGBAColor, ShapeStyle, TextStyle, register_font,
};

use crate::ChartError;
use crate::paint::font::{self, Run, runs};
use crate::paint::indexed::{Indexed, indexed};
use crate::paint::palette::PAPER;
use crate::paint::scene::{Point, Scene, Shape, Text};
use crate::paper::{Paper, WIDTH};

/// Painted at this many times the size and averaged: smooth edges, and letters at parts of pixels.
const FINER: usize = 2;

/// Height of the line (ascender to descender) over the size of the font: ab_glyph counts sizes in lines.
const LINE_PER_EM: f64 = (1901.0 + 483.0) / 2048.0;

/// The scene as PNG.
pub(crate) fn png(scene: &Scene, paper: &Paper) -> Result<Vec<u8>, ChartError> {
    let scale = f64::from(paper.pixels) / WIDTH;
    let (width, height) = (paper.pixels as usize, (scene.height * scale).ceil() as usize);
    let mut fine = vec![255; 3 * width * height * FINER * FINER];
    let size = ((width * FINER) as u32, (height * FINER) as u32);
    paint(scene, BitMapBackend::with_buffer(&mut fine, size), scale * FINER as f64)?;

    let row = 3 * width * FINER;
    let mut pixels = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            pixels.push([0, 1, 2].map(|channel| {
                let at = |i: usize, j: usize| u32::from(fine[(FINER * y + i) * row + 3 * (FINER * x + j) + channel]);
                ((at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1) + 2) / 4) as u8
            }));
        }
    }

    let Indexed { palette, pixels } = indexed(&pixels);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, paper.pixels, height as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.concat());
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.add_text_chunk("Software".to_owned(), paper.mark())?;
    // Printed as wide as the SVG.
    let per_metre = (f64::from(paper.pixels) / (paper.width / 96.0 * 0.0254)).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// Paints the shapes with `scale` pixels for one of the scene.
fn paint(scene: &Scene, mut backend: BitMapBackend, scale: f64) -> Result<(), ChartError> {
    // Nothing reaches far out of a picture, whose height is that of its texts and panels.
    let pixel = |place: f64| (place * scale).round().clamp(-1e6, 1e6) as i32;
    let place = |(x, y): Point| (pixel(x), pixel(y));
    let whole = backend.get_size();
    let filled = |ink: RGBAColor| ShapeStyle { color: ink, filled: true, stroke_width: 0 };
    backend.draw_rect((0, 0), (whole.0 as i32, whole.1 as i32), &filled(PAPER), true).map_err(refused)?;
    for shape in &scene.shapes {
        match shape {
            Shape::Rectangle { area, ink } => {
                let (from, to) = (place((area.left, area.top)), place((area.right, area.bottom)));
                backend.draw_rect(from, to, &filled(*ink), true)
            }
            Shape::Path { points, width, ink } => {
                let stroke_width = (width * scale).round().max(1.0) as u32;
                let style = ShapeStyle { color: *ink, filled: false, stroke_width };
                backend.draw_path(points.iter().map(|point| place(*point)), &style)
            }
            Shape::Polygon { corners, ink } => {
                backend.fill_polygon(corners.iter().map(|point| place(*point)), &filled(*ink))
            }
            Shape::Disc { centre, radius, ink } => {
                backend.draw_circle(place(*centre), (radius * scale).round() as u32, &filled(*ink), true)
            }
            Shape::Text(text) => {
                let mut gone = -text.before();
                runs(&text.words).iter().try_for_each(|run| {
                    let begun = gone;
                    gone += run.width() * text.em;
                    let at = begin(text, run, begun);
                    backend.draw_text(&run.words, &style(text, run, scale), place(at))
                })
            }
        }
        .map_err(refused)?;
    }
    backend.present().map_err(refused)
}

/// The point of a run that the library counts as its top at the left, `along` behind the point of its text.
fn begin(text: &Text, run: &Run, along: f64) -> Point {
    // It puts the baseline half the size (in lines) below.
    let down = (run.drop() - 0.5 * LINE_PER_EM * run.size()) * text.em;
    let (x, y) = text.at;
    if text.turned { (x + down, y - along) } else { (x + along, y + down) }
}

fn style<'a>(text: &'a Text, run: &Run, scale: f64) -> TextStyle<'a> {
    let size = text.em * run.size() * scale * LINE_PER_EM;
    let turn = if text.turned { FontTransform::Rotate270 } else { FontTransform::None };
    TextStyle::from((family(), size).into_font().transform(turn)).color(&text.ink).pos(Pos::new(HPos::Left, VPos::Top))
}

/// The font, registered with the drawing library by the first who asks.
fn family() -> FontFamily<'static> {
    static REGISTERED: OnceLock<()> = OnceLock::new();
    REGISTERED.get_or_init(|| {
        let is_font = register_font(font::FAMILY, FontStyle::Normal, font::FILE).is_ok();
        assert!(is_font, "the font in crates/charts/fonts is a TrueType font");
    });
    FontFamily::Name(font::FAMILY)
}

fn refused(error: impl std::error::Error) -> ChartError {
    ChartError::Painting(error.to_string())
}
