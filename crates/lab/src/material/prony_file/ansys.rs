//! Input files of Ansys: `TB,PRONY` with `TBDATA` of pairs of fraction and time; `MP,EX` beside it.

use super::lines::{Cell, Line, lines, term};
use super::{BULK, PronyFile};
use crate::Modulus;
use crate::PronySeries;
use stribeck_input::Fault;

/// What begins a comment.
const COMMENT: Option<char> = Some('!');

/// A table `TB,PRONY` and its data, by their places from 0.
struct Table<'t> {
    line: Line<'t>,
    data: Vec<Option<Cell<'t>>>,
    next: usize,
}

/// True for a text with such a table.
pub(super) fn is_one(text: &str) -> bool {
    lines(text, COMMENT).any(|line| is_prony(&line))
}

fn is_prony(line: &Line<'_>) -> bool {
    line.cells[0].is("TB") && line.cells.get(1).is_some_and(|cell| cell.begins("PRON"))
}

pub(super) fn interpret(text: &str) -> Result<PronyFile, Fault> {
    let mut table: Option<Table<'_>> = None;
    let (mut modulus, mut notes, mut bulk) = (None, Vec::new(), None);
    // the data of other tables, bulk terms for instance, are not wanted
    let mut is_open = false;
    for line in lines(text, COMMENT) {
        let command = &line.cells[0];
        if is_prony(&line) && line.cells.get(5).is_some_and(|cell| cell.begins("BULK")) {
            is_open = false;
            bulk.get_or_insert(line);
        } else if is_prony(&line) {
            if table.is_some() {
                let help = "keep the material that is meant, and remove the other ones";
                return Err(line.fault("the file has a second TB,PRONY of shear", "again", help));
            }
            table = Some(Table::new(line)?);
            is_open = true;
        } else if command.is("TB") {
            is_open = false;
        } else if command.is("TBDATA") && is_open {
            table.as_mut().expect("it is open").take(&line)?;
        } else if command.is("MP") && line.cells.get(1).is_some_and(|cell| cell.is("EX")) {
            modulus = line.cells.get(3).map(read_modulus).transpose()?;
        }
    }
    if let Some(bulk) = bulk {
        if table.is_none() {
            let help = "add TB,PRONY,…,SHEAR: the shear terms are those that a soft solid relaxes by";
            return Err(bulk.fault("the file has no shear terms", "bulk terms", help));
        }
        notes.push(BULK.to_owned());
    }
    let terms = table.expect("it was seen").terms()?;
    Ok(PronyFile::new("Ansys", terms.into_iter(), modulus, notes))
}

/// What Ansys relaxes from.
fn read_modulus(cell: &Cell<'_>) -> Result<Modulus, Fault> {
    let value = cell.number()?;
    if value > 0.0 {
        Ok(Modulus::Instantaneous(value))
    } else {
        Err(cell.fault("a modulus must be above 0", "not a modulus", "it is MP,EX,material,modulus"))
    }
}

impl<'t> Table<'t> {
    /// `TB,PRONY,material,temperatures,terms,SHEAR`
    fn new(line: Line<'t>) -> Result<Self, Fault> {
        let cell = |place: usize| line.cells.get(place);
        if let Some(temperatures) = cell(3).filter(|cell| !matches!(cell.text, "" | "1")) {
            let help = "a material has one series, at one temperature; remove the other ones";
            return Err(temperatures.fault("a series is read at one temperature", "several", help));
        }
        let allowed = 1..=PronySeries::MOST_TERMS;
        let terms = cell(4).map_or(Some(1), |cell| cell.text.parse().ok());
        let Some(terms) = terms.filter(|terms| allowed.contains(terms)) else {
            let cell = cell(4).expect("one term is meant where none is given");
            let what = format!("the number of terms must be a whole number from 1 to {}", allowed.end());
            return Err(cell.fault(what, "not such a number", "it is TB,PRONY,material,temperatures,terms,SHEAR"));
        };
        Ok(Self { line, data: vec![None; 2 * terms], next: 0 })
    }

    /// `TBDATA,place,value,…`: the place from 1, or that behind the last one.
    fn take(&mut self, line: &Line<'t>) -> Result<(), Fault> {
        if let Some(place) = line.cells.get(1).filter(|cell| !cell.text.is_empty()) {
            let at = place.text.parse().ok().filter(|at: &usize| (1..=self.data.len()).contains(at));
            self.next = at.ok_or_else(|| {
                let what = format!("the first value of TBDATA is a place from 1 to {}", self.data.len());
                place.fault(what, "no such place", "the places are those of fraction, time, fraction, time …")
            })? - 1;
        }
        for cell in line.cells.iter().skip(2) {
            if let Some(place) = self.data.get_mut(self.next) {
                *place = Some(cell.clone());
            }
            self.next += 1;
        }
        Ok(())
    }

    fn terms(self) -> Result<Vec<(f64, f64)>, Fault> {
        let given: Vec<&Cell<'_>> = self.data.iter().flatten().collect();
        if given.len() < self.data.len() {
            let what = format!("TB,PRONY has {} of {} values", given.len(), self.data.len());
            return Err(self.line.fault(what, "of this table", "add TBDATA with a fraction and a time for each term"));
        }
        given.chunks(2).map(|pair| term(pair[0], pair[1])).collect()
    }
}
