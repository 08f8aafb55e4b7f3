//! A scene as SVG text.

use std::fmt::Write;

use crate::paint::font::{FAMILY, runs};
use crate::paint::palette::{self, Ink, PAPER};
use crate::paint::scene::{Anchor, Point, Scene, Shape, Text};
use crate::paper::{Paper, WIDTH};

/// The scene as SVG: shapes in pixels of the layout, in a picture as wide as the paper.
pub(crate) fn svg(scene: &Scene, paper: &Paper) -> String {
    let height = scene.height.ceil();
    let mut text = format!(
        "<svg data-made=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {height}\" \
         xmlns=\"http://www.w3.org/2000/svg\" font-family=\"{FAMILY}\" stroke-linejoin=\"round\">\n\
         <style>rect {{ shape-rendering: crispEdges }}</style>\n\
         <rect x=\"0\" y=\"0\" width=\"{WIDTH}\" height=\"{height}\" {}/>\n",
        paper.mark(),
        number(paper.width),
        number(paper.width * height / WIDTH),
        filled(PAPER, fixed),
    );
    for shape in &scene.shapes {
        push(&mut text, shape, fixed).expect("memory takes text");
    }
    text + "</svg>\n"
}

/// The scene as an element of a page, which gives it its size, and its colours where it has others.
pub(crate) fn svg_in_page(scene: &Scene) -> String {
    let mut text = format!(
        "<svg viewBox=\"0 0 {WIDTH} {}\" font-family=\"{FAMILY}\" stroke-linejoin=\"round\">\n",
        scene.height.ceil()
    );
    for shape in &scene.shapes {
        push(&mut text, shape, of_page).expect("memory takes text");
    }
    text + "</svg>\n"
}

/// How a colour is written.
type Colours = fn(Ink) -> String;

fn push(text: &mut String, shape: &Shape, colours: Colours) -> std::fmt::Result {
    match shape {
        Shape::Rectangle { area, ink } => {
            // Whole pixels, so that neighbours touch.
            let [left, top, right, bottom] =
                [area.left, area.top, area.right, area.bottom].map(|place| place.round().clamp(-FAR, FAR));
            let (width, height) = (right - left, bottom - top);
            let place = format!("x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\"");
            writeln!(text, "<rect {place} {}/>", filled(*ink, colours))
        }
        Shape::Path { points, width, ink } => {
            let stroke =
                format!("opacity=\"{}\" stroke=\"{}\" stroke-width=\"{}\"", ink.3, colours(*ink), number(*width));
            writeln!(text, "<polyline fill=\"none\" {stroke} points=\"{}\"/>", places(points))
        }
        Shape::Polygon { corners, ink } => {
            writeln!(text, "<polygon {} points=\"{}\"/>", filled(*ink, colours), places(corners))
        }
        Shape::Disc { centre, radius, ink } => {
            let [x, y, radius] = [centre.0, centre.1, *radius].map(number);
            writeln!(text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" {}/>", filled(*ink, colours))
        }
        Shape::Text(words) => push_text(text, words, colours),
    }
}

/// A line of text, its subscripts in spans of their own.
fn push_text(text: &mut String, words: &Text, colours: Colours) -> std::fmt::Result {
    let anchor = match words.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let (x, y) = (number(words.at.0), number(words.at.1));
    let turn = if words.turned { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
    let size = number(words.em);
    write!(
        text,
        "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" font-size=\"{size}\" {}{turn}>",
        filled(words.ink, colours)
    )?;
    let mut drop = 0.0;
    for run in runs(&words.words) {
        let down = run.drop() - drop;
        drop = run.drop();
        let letters = escaped(&run.words);
        if down == 0.0 {
            text.push_str(&letters);
        } else {
            let (down, size) = (number(down * words.em), number(run.size() * words.em));
            write!(text, "<tspan dy=\"{down}\" font-size=\"{size}\">{letters}</tspan>")?;
        }
    }
    writeln!(text, "</text>")
}

/// Nothing reaches farther out of a picture, whose height is that of its texts and panels.
const FAR: f64 = 1e6;

/// A length to a tenth of a pixel.
fn number(length: f64) -> String {
    // −0 is 0
    format!("{}", (10.0 * length.clamp(-FAR, FAR)).round() / 10.0 + 0.0)
}

fn places(points: &[Point]) -> String {
    points.iter().map(|(x, y)| format!("{},{}", number(*x), number(*y))).collect::<Vec<_>>().join(" ")
}

fn fixed(ink: Ink) -> String {
    format!("#{:02X}{:02X}{:02X}", ink.0, ink.1, ink.2)
}

/// The colour that a page gives to the name of this one, or this one.
fn of_page(ink: Ink) -> String {
    palette::name(ink).map_or_else(|| fixed(ink), |name| format!("var(--ink-{name}, {})", fixed(ink)))
}

fn filled(ink: Ink, colours: Colours) -> String {
    format!("opacity=\"{}\" fill=\"{}\"", ink.3, colours(ink))
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
