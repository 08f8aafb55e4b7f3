//! One page of HTML that shows a published data set, without any network.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `contents` | the numbers that the page's script reads |
//! | `failures` | failed places and why |
//! | `fields` | pressure, film and displacement of each case, thinned |
//! | `thinning` | which places and points are shown of a large sweep |
//! | `encoding` | numbers as base64, texts that end no element |
//! | `plotly` | the drawing library |
//!
//! The page itself, its style and its scripts are in `assets/report`; `docs/report.md` says what it shows.

mod contents;
mod encoding;
mod failures;
mod fields;
mod plotly;
mod thinning;

use contents::Contents;
use encoding::{html, json};

use stribeck_lab::Measured;
use stribeck_sweep::store::{DataSet, StoreError};

/// How a page begins. A file that does not is none of ours, and is not replaced.
pub const BEGINNING: &str = "<!DOCTYPE html>\n<!-- made by stribeck report -->\n";

/// The scripts of the page, in the order in which they run.
const SCRIPTS: [&str; 11] = [
    include_str!("../../assets/report/sweep.js"),
    include_str!("../../assets/report/words.js"),
    include_str!("../../assets/report/axes.js"),
    include_str!("../../assets/report/look.js"),
    include_str!("../../assets/report/map.js"),
    include_str!("../../assets/report/surface.js"),
    include_str!("../../assets/report/case.js"),
    include_str!("../../assets/report/curves.js"),
    include_str!("../../assets/report/scatter.js"),
    include_str!("../../assets/report/table.js"),
    include_str!("../../assets/report/page.js"),
];

/// A page, and what it leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The file.
    pub html: String,
    /// What of the data set is thinned or missing, a sentence each.
    pub notes: Vec<String>,
}

/// The page of a data set, with measured points beside it if there are some. The same data give the same bytes.
///
/// # Errors
/// [`StoreError`] if the data set cannot be read.
pub fn page(data: &DataSet, measured: Option<&Measured>) -> Result<Page, StoreError> {
    let contents = Contents::of(data, measured)?;
    let frame = include_str!("../../assets/report/page.html");
    let script = format!("<script>\n\"use strict\";\n(() => {{\n{}}})();\n</script>", SCRIPTS.join("\n"));
    let parts = [
        ("{{title}}", html(&data.title)),
        ("{{style}}", format!("<style>\n{}</style>", include_str!("../../assets/report/page.css"))),
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
