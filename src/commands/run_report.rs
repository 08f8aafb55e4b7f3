//! What `run` tells of itself.

use std::path::Path;

use super::shell;
use crate::format::{bytes, count, duration, filled};
use stribeck_input::shown;
use stribeck_sweep::campaign::{FailedCase, Pending, Refinement, RunReport, field_bytes};
use stribeck_sweep::engine::rate;
use stribeck_sweep::store::{Published, StoreError};
use stribeck_sweep::{FieldPrecision, Note, NoteCounts, Part, Plan, Sweep};

/// What becomes of the cases of a directory that was last run with another sweep file.
pub fn about_other_sweep(directory: &Path, pending: &Pending, refinements: &[Refinement]) -> String {
    let (reused, new) = (pending.reused(), pending.new);
    let stale: String =
        pending.stale.iter().map(|stale| format!(", {} stale ({})", stale.cases, stale.reason)).collect();
    let finer: String = refinements.iter().map(|refinement| format!("\nnote: {refinement} cases of it")).collect();
    format!(
        "note: {} was last run with another sweep file. Of the {} of this one {reused} are there and used again, {new} \
         are new{stale}. Cases that only the other one has stay stored, but are not published.{finer}",
        shown(directory),
        count(reused + pending.to_do(), "case"),
    )
}

/// From so many bytes of fields on a user is told what they take.
const MANY_BYTES: u64 = 100_000_000;

/// What the fields of a sweep take, and how to do without, if it is much.
pub fn about_fields(sweep: &Sweep) -> Option<String> {
    let taken = Some(field_bytes(sweep, &Plan::new(sweep))).filter(|taken| *taken >= MANY_BYTES)?;
    let may_round =
        sweep.field_precision == FieldPrecision::Double && sweep.solver.tolerance >= FieldPrecision::SINGLE_TOLERANCE;
    let rounded = if may_round { ", or field_precision = \"single\" for about half of it" } else { "" };
    Some(format!(
        "note: fields at {} values of x take about {} on the disk; write fields = [] below [output] to leave them out, \
         or x = {{ from = -3.0, to = 3.0, points = 101 }} for fewer values{rounded}",
        sweep.output.x.len(),
        bytes(taken)
    ))
}

/// What is saved, what is left, and the command that resumes.
pub fn how_to_resume(left: &Pending, directory: &Path, stopped_by: Option<&StoreError>) -> String {
    let (saved, place, command) = (count(left.reused(), "case"), shown(directory), shell::own_command());
    let published = match (left.to_do(), directory.join("results.h5").exists()) {
        // That error says so itself.
        _ if matches!(stopped_by, Some(StoreError::Mixed { .. })) => "",
        (0, false) => ", but not published",
        (_, true) => "; what is published there is of an earlier state",
        (_, false) => "",
    };
    format!("{saved} saved in {place}, {} left{published}; resume with\n    {command}", left.to_do())
}

/// A note on places of a sweep.
pub fn note_line(note: Note, count: u64, places: u64) -> String {
    filled(&format!("note: {} at {count} of {places} places: {}", note.name(), note.sentence()), "      ") + "\n"
}

/// What a run did that published.
pub fn about_whole(report: &RunReport, published: &Published, notes: &NoteCounts, seconds: f64) -> String {
    let cases = count(published.converged + published.failed, "case");
    let mut text = format!("{cases}: {} converged, {} failed\n", published.converged, published.failed);
    text += &match report.pending.to_do() {
        0 if published.rewritten => "nothing to solve; published again\n".to_owned(),
        0 => "nothing to do: all of it is solved and published\n".to_owned(),
        _ => about_solving(&report.pending, seconds),
    };
    text += &format!("results in {}: results.h5, summary.csv, timings.csv\n", shown(&report.directory));
    let places = published.converged + published.failed;
    text += &notes.iter().map(|(note, count)| note_line(note, count, places)).collect::<String>();
    if published.failed > 0 {
        text += &list(&report.failures);
        let summary = report.directory.join("summary.csv");
        text += &format!("all of them: {}, columns `status` and `reason`\n", shown(&summary));
    }
    text
}

/// What a run did that solved a part of what is in `directory`; `done` is what is stored of the part.
pub fn about_part(report: &RunReport, part: Part, done: &Pending, directory: &Path, seconds: f64) -> String {
    let cases = count(done.reused(), "case");
    let mut text = format!("part {part}, {cases}: {} converged, {} failed\n", done.converged, done.failed);
    text += &match report.pending.to_do() {
        0 => "nothing to do: all of it is solved\n".to_owned(),
        _ => about_solving(&report.pending, seconds),
    };
    if done.failed > 0 {
        text += &list(&report.failures);
    }
    let directory = shell::quoted(directory.as_os_str());
    text + &format!("once all parts are done: stribeck merge {directory}\n")
}

fn about_solving(pending: &Pending, seconds: f64) -> String {
    let reused = match pending.reused() {
        0 => String::new(),
        reused => format!(" ({reused} more were there already)"),
    };
    let (cases, rate) = (count(pending.to_do(), "case"), rate(pending.to_do() as f64 / seconds));
    format!("solved {cases}{reused} in {}, {rate}\n", duration(seconds))
}

fn list(failures: &[FailedCase]) -> String {
    let lines: String = failures.iter().map(|failure| filled(&format!("  {failure}"), "      ") + "\n").collect();
    format!("failed cases, the first {}:\n{lines}", failures.len())
}
