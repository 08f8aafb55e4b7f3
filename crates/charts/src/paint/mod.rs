//! Paints a scene, which is a list of shapes, as SVG text or as the bytes of a PNG.

pub(crate) mod font;
mod indexed;
pub(crate) mod marker;
pub(crate) mod palette;
pub(crate) mod scene;

use plotters::prelude::{BitMapBackend, DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, IntoFont, RGBAColor, ShapeStyle, TextStyle};

use crate::ChartError;
use font::LINE_PER_EM;
use indexed::{Indexed, indexed};
use palette::PAPER;
use scene::{Anchor, Point, Scene, Shape, Text};

/// Width of every picture in pixels. Font sizes are chosen for a picture printed 8.5 cm wide (one panel) or as wide as
/// a page (several).
pub const WIDTH: u32 = 1600;

/// How a backend counts: pixels for one of the scene, and what it takes for the size of a font and the place of a text.
struct Units {
    /// Pixels of the backend for one pixel of the scene.
    scale: f64,
    /// Size to ask for over the size wanted.
    size_per_em: f64,
    /// How far the baseline lies below the point of a text anchored at its top, over the size wanted.
    baseline_per_em: f64,
}

/// The scene as SVG.
pub(crate) fn svg(scene: &Scene) -> Result<String, ChartError> {
    // plotters-svg divides sizes by 1.24 and lowers text by 0.76 em.
    let units = Units { scale: 1.0, size_per_em: 1.24, baseline_per_em: 0.76 };
    let mut text = String::new();
    paint(scene, SVGBackend::with_string(&mut text, (WIDTH, scene.height.ceil() as u32)), &units)?;
    Ok(text)
}

/// The scene as PNG, painted at twice the size and averaged: smooth edges, and letters at half pixels.
pub(crate) fn png(scene: &Scene) -> Result<Vec<u8>, ChartError> {
    const FINER: usize = 2;
    // plotters puts the baseline of an ab_glyph font half its size (in lines) below the point.
    let units = Units { scale: FINER as f64, size_per_em: LINE_PER_EM, baseline_per_em: 0.5 * LINE_PER_EM };
    let (width, height) = (WIDTH as usize, scene.height.ceil() as usize);
    let mut fine = vec![255; 3 * width * height * FINER * FINER];
    paint(scene, BitMapBackend::with_buffer(&mut fine, ((width * FINER) as u32, (height * FINER) as u32)), &units)?;

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
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH, height as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.concat());
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(bytes)
}

fn paint<B: DrawingBackend>(scene: &Scene, mut backend: B, units: &Units) -> Result<(), ChartError> {
    // Nothing reaches far out of a picture, whose height is that of its texts and panels.
    let pixel = |place: f64| (place * units.scale).round().clamp(-1e6, 1e6) as i32;
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
                let stroke_width = (width * units.scale).round().max(1.0) as u32;
                let style = ShapeStyle { color: *ink, filled: false, stroke_width };
                backend.draw_path(points.iter().map(|point| place(*point)), &style)
            }
            Shape::Polygon { corners, ink } => {
                backend.fill_polygon(corners.iter().map(|point| place(*point)), &filled(*ink))
            }
            Shape::Disc { centre, radius, ink } => {
                backend.draw_circle(place(*centre), (radius * units.scale).round() as u32, &filled(*ink), true)
            }
            Shape::Text(text) => {
                let style = text_style(text, units);
                let drop = units.baseline_per_em * text.em;
                let (x, y) = text.at;
                let at = if text.turned { (x - drop, y) } else { (x, y - drop) };
                backend.draw_text(&text.words, &style, place(at))
            }
        }
        .map_err(refused)?;
    }
    backend.present().map_err(refused)
}

fn text_style<'a>(text: &'a Text, units: &Units) -> TextStyle<'a> {
    let size = text.em * units.scale * units.size_per_em;
    let turn = if text.turned { FontTransform::Rotate270 } else { FontTransform::None };
    let side = match text.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    TextStyle::from((font::family(), size).into_font().transform(turn)).color(&text.ink).pos(Pos::new(side, VPos::Top))
}

fn refused(error: impl std::error::Error) -> ChartError {
    ChartError::Painting(error.to_string())
}
