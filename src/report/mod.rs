//! One page of HTML that shows a published data set, a surface, or both, without any network.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `contents` | all numbers and words that the page's script reads |
//! | `axis` | names and values of the axes |
//! | `columns` | the columns of `summary.csv`, and what cases cost |
//! | `failures` | failed places and why |
//! | `fields` | the fields of each case, thinned |
//! | `first_picture` | what is seen before the drawing library has started |
//! | `measured` | measured points |
//! | `thinning` | which places and points are shown of a large sweep |
//! | `surface` | the surface, with words for its axes and quantities |
//! | `scaled` | where values lie in the range of their field |
//! | `texts` | texts that come again, each once |
//! | `encoding` | numbers as base64, texts that end no element |
//! | `plotly` | the drawing library |
//!
//! The page itself, its style and its scripts are in `assets/report`; `docs/how-to/report.md` says what it shows. The
//! scripts are ES modules, which `build.rs` joins into one for each kind of page. A page has only the parts that it needs.

mod axis;
mod columns;
mod contents;
mod encoding;
mod failures;
mod fields;
mod first_picture;
mod measured;
#[cfg(test)]
#[path = "../../build/modules.rs"]
mod modules;
mod plotly;
mod scaled;
mod surface;
mod texts;
mod thinning;

use contents::Contents;
use encoding::{html, json};
use first_picture::FirstPicture;
use thinning::Grid;

use crate::pictures::PictureError;

use stribeck_lab::Measured;
use stribeck_surface::Surface;
use stribeck_sweep::store::DataSet;

/// The beginning of every page. A file that begins otherwise is none of ours, and is not replaced.
pub const BEGINNING: &str = "<!DOCTYPE html>\n<!-- made by stribeck report -->\n";

/// A page, and what it leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The file.
    pub html: String,
    /// What of the data set is thinned or missing, a sentence each.
    pub notes: Vec<String>,
}

/// Makes the page of a data set, with measured points beside it and a surface if there are some. The same data give the
/// same bytes.
///
/// # Errors
/// [`PictureError`] if the data set cannot be read, or its first picture not be painted.
pub fn page(data: &DataSet, measured: Option<&Measured>, surface: Option<&Surface>) -> Result<Page, PictureError> {
    let mut contents = Contents::of(data, measured)?;
    contents.notes.extend(surface.and_then(|surface| surface::note(surface, &data.sweep_text)));
    let (shown, hidden) = (|element: String| (String::new(), element), (" hidden".to_owned(), String::new()));
    let (friction, plane) = match FirstPicture::of(data, &Grid::of(data))? {
        FirstPicture::Friction(element) => (shown(element), hidden),
        FirstPicture::Map(element) => (hidden, shown(element)),
        FirstPicture::None => (hidden.clone(), hidden),
    };
    let parts = [
        ("{{friction-hidden}}", friction.0),
        ("{{friction}}", friction.1),
        ("{{plane-hidden}}", plane.0),
        ("{{map}}", plane.1),
        ("{{live}}", surface.map_or(String::new(), |_| surface::SECTION.to_owned())),
        ("{{sweep}}", html(&data.sweep_text)),
    ];
    let body = filled(include_str!("../../assets/report/sweep.html"), parts);
    let script = match surface {
        Some(_) => include_str!(concat!(env!("OUT_DIR"), "/page_with_surface.js")),
        None => include_str!(concat!(env!("OUT_DIR"), "/page.js")),
    };
    let numbers = format!("<script type=\"application/json\" id=\"contents\">{}</script>", json(&contents));
    let skip = "<a class=\"skip\" href=\"#case\">to the selected case</a>";
    let html = Frame { title: &data.title, skip, body, numbers, script }.page(surface);
    Ok(Page { html, notes: contents.notes })
}

/// Makes the page of a surface alone.
pub fn surface_page(surface: &Surface) -> Page {
    let file = surface.file();
    let program =
        format!("Made by {}. Numbers bear their units; copies are in SI units, or over a scale.", file.program);
    let parts =
        [("{{live}}", surface::SECTION.to_owned()), ("{{program}}", html(&program)), ("{{sweep}}", html(&file.sweep))];
    let body = filled(include_str!("../../assets/report/surface.html"), parts);
    let script = include_str!(concat!(env!("OUT_DIR"), "/surface_page.js"));
    let skip = "<a class=\"skip\" href=\"#live\">to the sliders</a>";
    let frame = Frame { title: &file.title, skip, body, numbers: String::new(), script };
    Page { html: frame.page(Some(surface)), notes: Vec::new() }
}

/// What differs between pages.
struct Frame<'a> {
    title: &'a str,
    /// The link that a keyboard meets first.
    skip: &'a str,
    body: String,
    /// The numbers of a sweep, as an element.
    numbers: String,
    script: &'a str,
}

impl Frame<'_> {
    /// The whole page.
    fn page(self, surface: Option<&Surface>) -> String {
        let Self { title, skip, body, numbers, script } = self;
        let style = [include_str!("../../assets/report/page.css"), surface.map_or("", |_| surface::STYLE)].concat();
        let parts = [
            ("{{title}}", html(title)),
            ("{{style}}", format!("<style>\n{style}</style>")),
            ("{{early}}", format!("<script>\n{}</script>", include_str!("../../assets/early.js"))),
            ("{{skip}}", skip.to_owned()),
            ("{{heading}}", html(title)),
            ("{{body}}", body),
            ("{{data}}", numbers + &surface.map_or(String::new(), surface::elements)),
            ("{{plotly}}", plotly::element()),
            ("{{script}}", format!("<script>\n\"use strict\";\n(() => {{\n{script}}})();\n</script>")),
        ];
        BEGINNING.to_owned() + &filled(include_str!("../../assets/report/page.html"), parts)
    }
}

/// A text with its marks replaced: each stands in it once, in this order. It goes piece by piece from the front, so that
/// a title or a sweep file that looks like a mark is left alone.
fn filled(text: &str, parts: impl IntoIterator<Item = (&'static str, String)>) -> String {
    let (mut page, mut rest) = (String::new(), text);
    for (mark, part) in parts {
        let (before, after) = rest.split_once(mark).expect("the text has each mark once, in this order");
        page += before;
        page += &part;
        rest = after;
    }
    page + rest
}
