//! Prony series in files that a sweep file names: `relaxation = { file = "prony.csv" }`.
//!
//! The text that a sweep keeps has the terms in place of the name. So results say what they were computed with, and a
//! file that changes is another sweep.

use std::ops::Range;
use std::path::Path;

use super::modulus;
use super::sections::section;
use stribeck_input::{Entry, Fault, Section, printable};
use stribeck_lab::{Dimension, MaterialData, MaterialFile, MaterialFileError, MaterialOptions, PronySeries};

const HELP: &str =
    "write relaxation = { file = \"prony.csv\" }, with modulus_unit = \"MPa\" where the file names no unit";

/// The keys of a table that names a file.
pub(super) const FILE_KEYS: [&str; 2] = ["file", "modulus_unit"];

/// The series that a sweep file names files for.
#[derive(Default)]
pub(super) struct NamedSeries(Vec<One>);

/// A series that was read from a file, and where the sweep file names that.
struct One {
    series: PronySeries,
    file: String,
    place: Range<usize>,
    /// Where the section stands, if it needs the modulus of the file.
    in_want: Option<usize>,
}

impl NamedSeries {
    /// Reads the files that the sections of bodies name, relative to a folder; without one there are none.
    pub(super) fn read(root: &Section<'_>, folder: Option<&Path>) -> Result<Self, Fault> {
        let Some(folder) = folder else { return Ok(Self::default()) };
        let mut all = Vec::new();
        for body in ["substrate", "flat", "roller"].into_iter().filter_map(|name| root.get(name)) {
            let keys = section(&body)?;
            if let Some(entry) = keys.get("relaxation").filter(Entry::is_section) {
                let needs_modulus = modulus::find(&keys, body.path())?.is_none();
                all.push(One::read(&entry, folder, needs_modulus.then(|| body.span().start))?);
            }
        }
        Ok(Self(all))
    }

    /// The series of an entry that names a file.
    pub(super) fn series(&self, entry: &Entry<'_>) -> Result<&PronySeries, Fault> {
        let found = self.0.iter().find(|one| one.place == entry.span());
        found.map(|one| &one.series).ok_or_else(|| {
            let help = "write the terms themselves; `stribeck material FILE` prints them";
            entry.fault("a file can be named in a sweep file only, which has a folder", "no folder", help).unquoted()
        })
    }

    /// The text with the terms in place of the names, and behind them the moduli of files whose sections have none.
    pub(super) fn written_into(&self, text: &str) -> Result<String, Fault> {
        let mut places: Vec<&One> = self.0.iter().collect();
        places.sort_by_key(|one| one.place.start);
        let mut written = text.to_owned();
        for one in places.into_iter().rev() {
            written.replace_range(one.place.clone(), &one.terms(text)?);
        }
        Ok(written)
    }
}

impl One {
    /// Reads the series of a table `{ file, modulus_unit }`.
    fn read(entry: &Entry<'_>, folder: &Path, in_want: Option<usize>) -> Result<Self, Fault> {
        let keys = entry.section(&FILE_KEYS, |_| None)?;
        let name = keys.require("file", HELP)?;
        let modulus_unit = keys.get("modulus_unit").map(|unit| read_unit(&unit)).transpose()?;
        let file = name.text()?;
        let options = MaterialOptions { modulus_unit, ..MaterialOptions::default() };
        let content = MaterialFile::read(&folder.join(file), &options).map_err(|error| {
            let help = match &error {
                MaterialFileError::Series(error) => error.remedy(),
                MaterialFileError::Table(_) => HELP,
            };
            name.fault(format!("`{}`: {error}", entry.path()), "in this file", help).unquoted()
        })?;
        let MaterialData::Series(series) = content.data else {
            let what =
                format!("`{}` needs a file with a Prony series, and this one holds measured moduli", entry.path());
            let help = "fit a series to them with `stribeck material FILE`, and paste what it prints";
            return Err(name.fault(what, "measured moduli", help));
        };
        Ok(Self { series, file: printable(file).into_owned(), place: entry.span(), in_want })
    }

    /// What stands in place of the name.
    fn terms(&self, text: &str) -> Result<String, Fault> {
        let terms = self.series.toml_terms(Some(&self.file));
        let Some((start, modulus)) = self.in_want.and_then(|start| Some((start, self.series.toml_modulus()?))) else {
            return Ok(terms);
        };
        if !text[start..].starts_with('[') {
            let what = "the modulus of this file has no place in a section that is written in one line";
            let help = "begin the section with a line [substrate], or give the modulus there";
            return Err(Fault::new(self.place.clone(), what, "has a modulus", help).unquoted());
        }
        Ok(format!("{terms}\n{modulus}"))
    }
}

fn read_unit(entry: &Entry<'_>) -> Result<f64, Fault> {
    let unit = Dimension::Modulus.conversion(entry.text()?).map(|unit| unit.in_si(1.0));
    unit.ok_or_else(|| {
        entry.fault(format!("`{}` must be a unit of a modulus", entry.path()), "not one of them", "write \"MPa\", say")
    })
}
