//! A Prony series in a file that a sweep file names: `relaxation = { file = "prony.csv" }`.
//!
//! The text that a sweep keeps has the terms in place of the name. So results say what they were computed with, and a
//! file that changes is another sweep.

use std::ops::Range;
use std::path::Path;

use stribeck_input::{Entry, Fault, printable};
use stribeck_lab::{Dimension, MaterialData, MaterialFile, MaterialOptions, PronySeries};

const HELP: &str =
    "write relaxation = { file = \"prony.csv\" }, with modulus_unit = \"MPa\" where the file names no unit";

/// A series that was read from a file, and how the sweep file says the same without it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NamedSeries {
    pub(super) series: PronySeries,
    /// The file as it was named.
    file: String,
    /// Where the name stands, and where the section begins that it stands in.
    place: Range<usize>,
    section: usize,
}

/// Reads the series of a table `{ file, modulus_unit }`; names are relative to a folder, where there is one.
pub(super) fn read(entry: &Entry<'_>, section: &Entry<'_>, folder: Option<&Path>) -> Result<NamedSeries, Fault> {
    let keys = entry.section(&["file", "modulus_unit"], |_| None)?;
    let name = keys.require("file", HELP)?;
    let Some(folder) = folder else {
        let help = "write the terms themselves; `stribeck material FILE` prints them";
        return Err(name.fault("a file can be named in a sweep file only, which has a folder", "no folder", help));
    };
    let unit = keys.get("modulus_unit").map(|unit| read_unit(&unit)).transpose()?;
    let file = name.text()?;
    let options = MaterialOptions { modulus_unit: unit, ..MaterialOptions::default() };
    let content = MaterialFile::read(&folder.join(file), &options).map_err(|error| {
        name.fault(format!("`{}`: {error}", entry.path()), "in this file", error.remedy()).unquoted()
    })?;
    let MaterialData::Series(series) = content.data else {
        let what = format!("`{}` needs a file with a Prony series, and this one holds measured moduli", entry.path());
        let help = "fit a series to them with `stribeck material FILE`, and paste what it prints";
        return Err(name.fault(what, "measured moduli", help));
    };
    Ok(NamedSeries { series, file: printable(file).into_owned(), place: entry.span(), section: section.span().start })
}

fn read_unit(entry: &Entry<'_>) -> Result<f64, Fault> {
    Dimension::Modulus.factor_of(entry.text()?).ok_or_else(|| {
        entry.fault(format!("`{}` must be a unit of a modulus", entry.path()), "not one of them", "write \"MPa\", say")
    })
}

impl NamedSeries {
    /// The text with the terms in place of the name, and behind them the modulus of the series.
    pub(super) fn written_into(&self, text: &str) -> Result<String, Fault> {
        let modulus = self.series.toml_modulus();
        if modulus.is_some() && !text[self.section..].starts_with('[') {
            let what = "the modulus of this file has no place in a section that is written in one line";
            let help = "begin the section with a line [substrate], or give the modulus there";
            return Err(Fault::new(self.place.clone(), what, "has a modulus", help).unquoted());
        }
        let modulus = modulus.map(|modulus| format!("\n{modulus}")).unwrap_or_default();
        let terms = self.series.toml_terms(Some(&self.file));
        Ok(format!("{}{terms}{modulus}{}", &text[..self.place.start], &text[self.place.end..]))
    }
}
