//! One page of HTML that shows a published data set, without any network.
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
//! | `scaled` | where values lie in the range of their field |
//! | `texts` | texts that come again, each once |
//! | `encoding` | numbers as base64, texts that end no element |
//! | `plotly` | the drawing library |
//!
//! The page itself, its style and its scripts are in `assets/report`; `docs/how-to/report.md` says what it shows. The
//! scripts are ES modules, which `build.rs` joins into one.

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
mod texts;
mod thinning;

use contents::Contents;
use encoding::{html, json};
use first_picture::FirstPicture;
use thinning::Grid;

use crate::pictures::PictureError;

use stribeck_lab::Measured;
use stribeck_sweep::store::DataSet;

/// The beginning of every page. A file that begins otherwise is none of ours, and is not replaced.
pub const BEGINNING: &str = "<!DOCTYPE html>\n<!-- made by stribeck report -->\n";

/// The scripts of the page, which build.rs has joined.
const SCRIPT: &str = include_str!(concat!(env!("OUT_DIR"), "/page.js"));

/// A page, and what it leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The file.
    pub html: String,
    /// What of the data set is thinned or missing, a sentence each.
    pub notes: Vec<String>,
}

/// Makes the page of a data set, with measured points beside it if there are some. The same data give the same bytes.
///
/// # Errors
/// [`PictureError`] if the data set cannot be read, or its first picture not be painted.
pub fn page(data: &DataSet, measured: Option<&Measured>) -> Result<Page, PictureError> {
    let contents = Contents::of(data, measured)?;
    let (shown, hidden) = (|element: String| (String::new(), element), (" hidden".to_owned(), String::new()));
    let (friction, plane) = match FirstPicture::of(data, &Grid::of(data))? {
        FirstPicture::Friction(element) => (shown(element), hidden),
        FirstPicture::Map(element) => (hidden, shown(element)),
        FirstPicture::None => (hidden.clone(), hidden),
    };
    let frame = include_str!("../../assets/report/page.html");
    let script = format!("<script>\n\"use strict\";\n(() => {{\n{SCRIPT}}})();\n</script>");
    let parts = [
        ("{{title}}", html(&data.title)),
        ("{{style}}", format!("<style>\n{}</style>", include_str!("../../assets/report/page.css"))),
        ("{{early}}", format!("<script>\n{}</script>", include_str!("../../assets/early.js"))),
        ("{{heading}}", html(&data.title)),
        ("{{friction-hidden}}", friction.0),
        ("{{friction}}", friction.1),
        ("{{plane-hidden}}", plane.0),
        ("{{map}}", plane.1),
        ("{{sweep}}", html(&data.sweep_text)),
        ("{{contents}}", format!("<script type=\"application/json\" id=\"contents\">{}</script>", json(&contents))),
        ("{{plotly}}", plotly::element()),
        ("{{script}}", script),
    ];
    // Piece by piece from the front, so that a title or a sweep file that looks like a mark is left alone.
    let (mut page, mut rest) = (BEGINNING.to_owned(), frame);
    for (mark, part) in parts {
        let (before, after) = rest.split_once(mark).expect("page.html has each mark once, in this order");
        page += before;
        page += &part;
        rest = after;
    }
    page += rest;
    Ok(Page { html: page, notes: contents.notes })
}
