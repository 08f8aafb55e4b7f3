//! The surface of a page: its file as the page's reader takes it, with words for its axes and quantities.

use std::collections::BTreeMap;

use serde::Serialize;

use super::encoding::json;
use crate::pictures::{Quantity, symbol_and_words};
use stribeck_surface::Surface;
use stribeck_sweep::Column;

/// The section of the page that shows a surface.
pub(super) const SECTION: &str = include_str!("../../assets/report/live.html");

/// Its style.
pub(super) const STYLE: &str = include_str!("../../assets/report/live.css");

/// What axes and quantities are called.
#[derive(Debug, Serialize)]
struct Words<'a> {
    axes: Vec<AxisWords<'a>>,
    quantities: BTreeMap<&'a str, String>,
}

/// What an axis is called in numbers and beside pictures.
#[derive(Debug, Serialize)]
struct AxisWords<'a> {
    symbol: &'a str,
    label: &'a str,
}

/// The surface as elements that the page's script reads.
pub(super) fn elements(surface: &Surface) -> String {
    let file = surface.file();
    let axes = file.axes.iter().map(|axis| symbol_and_words(&axis.name));
    let quantities = file.quantities.iter().map(|quantity| {
        let words = Column::named(&quantity.name).map(|column| Quantity::from(column).plain());
        (quantity.name.as_str(), words.unwrap_or_else(|| quantity.long_name.clone()))
    });
    let words = Words {
        axes: axes.map(|(symbol, label)| AxisWords { symbol, label }).collect(),
        quantities: quantities.collect(),
    };
    let element = |id: &str, text: String| format!("<script type=\"application/json\" id=\"{id}\">{text}</script>\n");
    element("surface-file", json(file)) + &element("surface-words", json(&words))
}

/// What is to be said of a surface beside the results of a sweep file: it may be made from another one.
pub(super) fn note(surface: &Surface, sweep: &str) -> Option<String> {
    let file = surface.file();
    (file.sweep != sweep).then(|| format!("The surface was made from another sweep file, “{}”.", file.title))
}
