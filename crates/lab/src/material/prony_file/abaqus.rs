//! Input files of Abaqus: `*VISCOELASTIC, TIME=PRONY` with rows of g_i, k_i, τ_i; `*ELASTIC` beside it.

use super::lines::{Cell, Line, lines, term};
use super::{BULK, PronyFile};
use crate::Modulus;
use stribeck_input::Fault;

/// A keyword with its parameters and the rows below it.
struct Block<'t> {
    keyword: Line<'t>,
    rows: Vec<Line<'t>>,
}

impl<'t> Block<'t> {
    fn is(&self, word: &str) -> bool {
        self.keyword.cells[0].text.strip_prefix('*').is_some_and(|name| name.trim().eq_ignore_ascii_case(word))
    }

    /// The value of a parameter, in capitals.
    fn parameter(&self, name: &str) -> Option<String> {
        let parameters = self.keyword.cells[1..].iter().filter_map(|cell| cell.text.split_once('='));
        let mut found = parameters.filter(|(key, _)| key.trim().eq_ignore_ascii_case(name));
        found.next().map(|(_, value)| value.trim().to_ascii_uppercase())
    }
}

/// True for a text with the keyword.
pub(super) fn is_one(text: &str) -> bool {
    blocks(text).iter().any(|block| block.is("VISCOELASTIC"))
}

pub(super) fn interpret(text: &str) -> Result<PronyFile, Fault> {
    let blocks = blocks(text);
    let block = only(&blocks, "VISCOELASTIC")?.expect("it was seen");
    let is_prony = |name| block.parameter(name).is_some_and(|value| value == "PRONY");
    if !is_prony("TIME") && !is_prony("FREQUENCY") {
        let help =
            "rows of g_i, k_i and times stand below *VISCOELASTIC, TIME=PRONY; measured data are read from a table";
        return Err(block.keyword.fault("*VISCOELASTIC is read with TIME=PRONY", "another kind", help));
    }
    let mut terms = Vec::new();
    let mut notes = Vec::new();
    for row in &block.rows {
        let [shear, bulk, time, ..] = row.cells.as_slice() else {
            let help = "a row is g_i, k_i, time: of shear, of compression, in s";
            return Err(row.fault("a row below *VISCOELASTIC has three numbers", "this row", help));
        };
        terms.push(term(shear, time)?);
        if bulk.number()? != 0.0 && notes.is_empty() {
            notes.push(BULK.to_owned());
        }
    }
    if terms.is_empty() {
        return Err(block.keyword.fault("*VISCOELASTIC has no terms", "nothing below", "add rows of g_i, k_i, time"));
    }
    Ok(PronyFile::new("Abaqus", terms.into_iter(), modulus(&blocks)?, notes))
}

/// The modulus of `*ELASTIC`: that after a long time unless MODULI says otherwise.
fn modulus(blocks: &[Block<'_>]) -> Result<Option<Modulus>, Fault> {
    let Some(block) = only(blocks, "ELASTIC")? else { return Ok(None) };
    if block.parameter("TYPE").is_some_and(|kind| kind != "ISOTROPIC" && kind != "ISO") {
        return Err(block.keyword.fault("*ELASTIC is read with TYPE=ISOTROPIC", "another kind", "remove the block"));
    }
    let Some(value) = block.rows.first().map(|row| &row.cells[0]) else { return Ok(None) };
    let number = value.number()?;
    if number <= 0.0 {
        return Err(value.fault("a modulus must be above 0", "not a modulus", "a row is E, Poisson's ratio"));
    }
    let is_instantaneous = block.parameter("MODULI").is_some_and(|moduli| moduli == "INSTANTANEOUS");
    Ok(Some(if is_instantaneous { Modulus::Instantaneous(number) } else { Modulus::Relaxed(number) }))
}

/// The one block of a keyword, if there is one.
fn only<'b, 't>(blocks: &'b [Block<'t>], word: &str) -> Result<Option<&'b Block<'t>>, Fault> {
    let mut found = blocks.iter().filter(|block| block.is(word));
    let (first, second) = (found.next(), found.next());
    match second {
        None => Ok(first),
        Some(second) => {
            let what = format!("the file has a second *{word}");
            Err(second.keyword.fault(what, "again", "keep the material that is meant, and remove the other ones"))
        }
    }
}

/// Keywords with what stands below them; comments begin with two stars, and a keyword goes on after a comma at its end.
fn blocks(text: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let is_comment = |line: &Line<'_>| line.cells[0].text.starts_with("**");
    for line in lines(text, None).filter(|line| !is_comment(line)) {
        if line.cells[0].text.starts_with('*') {
            blocks.push(Block { keyword: line, rows: Vec::new() });
        } else if let Some(block) = blocks.last_mut() {
            let goes_on = block.rows.is_empty() && block.keyword.cells.last().is_some_and(|cell| cell.text.is_empty());
            if goes_on {
                block.keyword.cells.pop();
                block.keyword.cells.extend(line.cells);
            } else {
                block.rows.push(without_last_comma(line));
            }
        }
    }
    blocks
}

/// A row without the empty cell behind a comma at its end.
fn without_last_comma(mut line: Line<'_>) -> Line<'_> {
    if line.cells.len() > 3 && line.cells.last().is_some_and(|cell: &Cell<'_>| cell.text.is_empty()) {
        line.cells.pop();
    }
    line
}
