//! Prony series in files that a sweep file names: `relaxation = { file = "prony.csv" }`.
//!
//! The text that a sweep keeps has the terms in place of the name. So results say what they were computed with, and a
//! file that changes is another sweep.

use std::ops::Range;
use std::path::Path;

use super::modulus;
use stribeck_input::{Entry, Fault, Section, printable};
use stribeck_lab::{Dimension, MaterialData, MaterialFile, MaterialFileError, MaterialOptions, PronySeries};

const HELP: &str =
    "write relaxation = { file = \"prony.csv\" }, with modulus_unit = \"MPa\" where the file names no unit";

/// The keys of a table that names a file.
pub(super) const FILE_KEYS: [&str; 2] = ["file", "modulus_unit"];

/// The series that a sweep file names files for: where each is named, and what was read.
#[derive(Default)]
pub(super) struct NamedSeries(Vec<(Range<usize>, Result<One, Fault>)>);

/// A series that was read from a file.
struct One {
    series: PronySeries,
    file: String,
    /// Where the section stands, if it needs the modulus of the file.
    in_want: Option<usize>,
}

impl NamedSeries {
    /// Reads the files that the sections of bodies name, relative to a folder; without one there are none.
    pub(super) fn read(root: &Section<'_>, folder: Option<&Path>) -> Self {
        let Some(folder) = folder else { return Self::default() };
        let bodies = ["substrate", "flat", "roller"].into_iter().filter_map(|name| root.get(name));
        let named = bodies.filter_map(|body| {
            let relaxation = body.member("relaxation").filter(Entry::is_section)?;
            let has_modulus = modulus::KEYS.iter().any(|(key, ..)| body.member(key).is_some());
            let in_want = (!has_modulus).then(|| body.span().start);
            Some((relaxation.span(), One::read(&relaxation, folder, in_want)))
        });
        Self(named.collect())
    }

    /// The series of an entry that names a file.
    pub(super) fn series(&self, entry: &Entry<'_>) -> Result<PronySeries, Fault> {
        match self.0.iter().find(|(place, _)| *place == entry.span()) {
            Some((_, read)) => read.as_ref().map(|one| one.series.clone()).map_err(Clone::clone),
            None => {
                let help = "write the terms themselves; `stribeck material FILE` prints them";
                let what = "a file can be named in a sweep file only, which has a folder";
                Err(entry.fault(what, "no folder", help).unquoted())
            }
        }
    }

    /// The text with the terms in place of the names, and behind them the moduli of files whose sections have none.
    pub(super) fn written_into(&self, text: &str) -> Result<String, Fault> {
        let mut named: Vec<_> = self.0.iter().collect();
        named.sort_by_key(|(place, _)| place.start);
        let mut written = text.to_owned();
        for (place, one) in named.into_iter().rev() {
            written.replace_range(place.clone(), &one.as_ref().map_err(Clone::clone)?.terms(place, text)?);
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
        Ok(Self { series, file: printable(file).into_owned(), in_want })
    }

    /// What stands in place of the name.
    fn terms(&self, place: &Range<usize>, text: &str) -> Result<String, Fault> {
        let terms = self.series.toml_terms(Some(&self.file));
        let Some((start, modulus)) = self.in_want.and_then(|start| Some((start, self.series.toml_modulus()?))) else {
            return Ok(terms);
        };
        if !text[start..].starts_with('[') {
            let what = "the modulus of this file has no place in a section that is written in one line";
            let help = "begin the section with a line [substrate], or give the modulus there";
            return Err(Fault::new(place.clone(), what, "has a modulus", help).unquoted());
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
