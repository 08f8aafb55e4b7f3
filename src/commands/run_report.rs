//! What `run` tells of itself.

use std::fmt::Write;
use std::path::Path;

use super::wording::{count, duration};
use super::workload::Workload;
use super::{CliError, failures, shell};
use stribeck_input::shown;
use stribeck_sweep::engine::rate;
use stribeck_sweep::store::{Published, Store};
use stribeck_sweep::{Part, Plan};

/// Failed cases that are listed at the end of a run.
const LISTED_FAILURES: usize = 5;

/// What becomes of the cases of a directory that was last run with another sweep file.
pub fn about_other_sweep(directory: &Path, workload: &Workload) -> String {
    let (reused, new) = (workload.reused(), workload.new);
    let stale: String = workload.stale.iter().map(|(why, cases)| format!(", {cases} stale ({why})")).collect();
    format!(
        "note: {} was last run with another sweep file. Of the {} of this one {reused} are there and used again, {new} \
         are new{stale}. Cases that only the other one has stay stored, but are not published.",
        shown(directory),
        count(reused + workload.to_do(), "case"),
    )
}

/// What is saved, what is left, and the command that resumes.
pub fn how_to_resume(left: &Workload, directory: &Path) -> String {
    let (saved, place, command) = (count(left.reused(), "case"), shown(directory), shell::own_command());
    let published = match (left.to_do(), directory.join("results.h5").exists()) {
        (0, false) => ", but not published",
        (_, true) => "; what is published there is of an earlier state",
        (_, false) => "",
    };
    format!("{saved} saved in {place}, {} left{published}; resume with\n    {command}", left.to_do())
}

/// What a run did that published.
pub fn of_whole(
    plan: &Plan,
    store: &Store,
    workload: &Workload,
    published: &Published,
    directory: &Path,
    seconds: f64,
) -> Result<String, CliError> {
    let cases = count(published.converged + published.failed, "case");
    let mut text = format!("{cases}: {} converged, {} failed\n", published.converged, published.failed);
    text += &match workload.to_do() {
        0 if published.rewritten => "nothing to solve; published again\n".to_owned(),
        0 => "nothing to do: all of it is solved and published\n".to_owned(),
        _ => solved(workload, seconds),
    };
    text += &format!("results in {}: results.h5, summary.csv, timings.csv\n", shown(directory));
    if published.failed > 0 {
        text += &first_failures(plan, None, store)?;
        let summary = directory.join("summary.csv");
        text += &format!("all of them: {}, columns `status` and `reason`\n", shown(&summary));
    }
    Ok(text)
}

/// What a run did that solved a part; `done` is the state after it.
pub fn of_part(
    plan: &Plan,
    part: Part,
    store: &Store,
    workload: &Workload,
    done: &Workload,
    directory: &Path,
    seconds: f64,
) -> Result<String, CliError> {
    let cases = count(done.reused(), "case");
    let mut text = format!("part {part}, {cases}: {} converged, {} failed\n", done.converged, done.failed);
    text += &match workload.to_do() {
        0 => "nothing to do: all of it is solved\n".to_owned(),
        _ => solved(workload, seconds),
    };
    if done.failed > 0 {
        text += &first_failures(plan, Some(part), store)?;
    }
    let directory = shell::quoted(directory.as_os_str());
    Ok(text + &format!("once all parts are done: stribeck merge {directory}\n"))
}

fn solved(workload: &Workload, seconds: f64) -> String {
    let reused = match workload.reused() {
        0 => String::new(),
        reused => format!(" ({reused} more were there already)"),
    };
    let (cases, rate) = (count(workload.to_do(), "case"), rate(workload.to_do() as f64 / seconds));
    format!("solved {cases}{reused} in {}, {rate}\n", duration(seconds))
}

fn first_failures(plan: &Plan, part: Option<Part>, store: &Store) -> Result<String, CliError> {
    let list = failures::first(plan, part, store, LISTED_FAILURES)?;
    let mut text = format!("failed cases, the first {}:\n", list.len());
    for (parameters, reason) in list {
        writeln!(text, "  {}: {reason}", failures::place(&parameters)).expect("writing to memory does not fail");
    }
    Ok(text)
}
