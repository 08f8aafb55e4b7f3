//! `stribeck merge`: joins what parts and other runs of a sweep have solved, and publishes.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use super::collection::{Collection, Held, part_directory, parts, sweep_file};
use super::job::publish;
use super::parts::{PartState, states};
use super::run::recipe;
use super::shell::quoted;
use super::wording::count;
use super::workload::{Workload, inspection};
use super::{CliError, Exit, console};
use stribeck_input::shown;
use stribeck_solver::{COLUMNS, viscoelastic_error_scale};
use stribeck_sweep::store::{Ending, Holdings, Joined, Store};
use stribeck_sweep::{Method, Part, Plan, Sweep};

/// Missing parts that are named with the command that finishes them.
const LISTED: usize = 10;

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck merge /scratch/surface                       the parts that `run --shard` left there
  stribeck merge here/surface there/surface -o surface  runs of one sweep on several machines

Shards are linked, or copied from another file system, so that the result is a directory like any other: it can be
resumed, extended and verified, and those it was made of may be deleted. Start again after an interruption. A case that
is there twice has to agree within the tolerance. If cases are missing nothing is published, and the message names the
parts they are in with the commands that finish them; exit code 4.")]
pub struct Arguments {
    /// Results directories of one sweep; their parts are joined with them
    #[arg(value_name = "DIR", required = true)]
    sources: Vec<PathBuf>,
    /// Results directory to join them in [default: DIR, if there is one]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let target = match (&arguments.output, arguments.sources.as_slice()) {
        (Some(target), _) => target,
        (None, [only]) => only,
        (None, _) => return Err(CliError::NoTarget),
    };
    let (sweep, sources) = one_sweep(&arguments.sources)?;
    let plan = Plan::new(&sweep);
    let mut store = Store::open(target, &sweep.text, &sweep.output)?.solving_with(recipe(&plan));
    for warning in store.warnings() {
        console::tell(&format!("warning: {warning}"));
    }
    store.begin(&sweep.name, 0, 0)?;
    let others = sources.iter().filter(|source| !same_place(source, target));
    let Joined { shards, cases, twice } = join_all(others, &sweep, &mut store)?;
    store.end(Ending::Completed)?;
    let workload = Workload::survey(&sweep, &plan, None, &Held::new(vec![&store]));
    if workload.to_do() > 0 {
        return Err(CliError::Incomplete { missing: what_is_missing(arguments, target, &sweep, &plan, &workload)? });
    }
    let published = publish(&sweep, &plan, &mut store)?;
    let (converged, failed) = (published.converged, published.failed);
    let mut text = format!("{}: {converged} converged, {failed} failed\n", count(converged + failed, "case"));
    let written = "writing to memory does not fail";
    writeln!(text, "joined {} in {}; {twice} were there already", count(cases, "case"), count(shards, "shard"))
        .expect(written);
    writeln!(text, "results in {}: results.h5, summary.csv, timings.csv", shown(target)).expect(written);
    console::print(&text)?;
    Ok(if failed == 0 { Exit::Success } else { Exit::CasesFailed })
}

/// Takes over what directories hold, one after the other, so that memory has the cases of one at a time beside those that are
/// joined.
pub fn join_all<'s>(
    sources: impl IntoIterator<Item = &'s PathBuf>,
    sweep: &Sweep,
    store: &mut Store,
) -> Result<Joined, CliError> {
    let mut all = Joined::default();
    for source in sources {
        let held = Holdings::read(source, &sweep.output, inspection(false))?;
        for warning in held.warnings() {
            console::tell(&format!("warning: {warning}"));
        }
        let Joined { shards, cases, twice } = store.join(&held, &|here, there| agree(sweep, here, there))?;
        all = Joined { shards: all.shards + shards, cases: all.cases + cases, twice: all.twice + twice };
    }
    Ok(all)
}

/// The sweep that all directories are of, and all that hold results of it: the directories and their parts.
///
/// A directory that has parts may hold an earlier state of the sweep beside them: the parts say what it has become.
fn one_sweep(directories: &[PathBuf]) -> Result<(Sweep, Vec<PathBuf>), CliError> {
    let (mut sources, mut files) = (Vec::new(), Vec::new());
    for directory in directories {
        let parts = parts(directory)?.into_iter().map(|part| part_directory(directory, part));
        // A part that has only just begun has no sweep file yet, and nothing to be joined.
        let parts: Vec<PathBuf> = parts.filter(|part| part.join("sweep.toml").exists()).collect();
        if parts.is_empty() {
            files.push(directory.join("sweep.toml"));
        }
        if parts.is_empty() || directory.join("sweep.toml").exists() {
            sources.push(directory.clone());
        }
        files.extend(parts.iter().map(|part| part.join("sweep.toml")));
        sources.extend(parts);
    }
    let first = &files[0];
    let sweep = Sweep::read(first)?;
    for other in &files[1..] {
        if Sweep::read(other)?.text != sweep.text {
            return Err(CliError::OtherSweep { first: first.clone(), other: other.clone() });
        }
    }
    // The title of a sweep without one is the name of its file, which is not that of the copies in results directories.
    for home in files.iter().filter_map(|file| file.parent()) {
        if let Some(name) = Holdings::name_of_sweep(home)? {
            return Ok((Sweep::parse(&name, &sweep.text)?, sources));
        }
    }
    Ok((sweep, sources))
}

fn same_place(a: &Path, b: &Path) -> bool {
    a == b || matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// Whether two solutions of one case agree within what the solver was asked for. The last bits depend on the processor.
fn agree(sweep: &Sweep, here: &[f64; COLUMNS.len()], there: &[f64; COLUMNS.len()]) -> bool {
    let tolerance = match sweep.solver.method {
        Method::Collocation => sweep.solver.tolerance,
        // A residual, not an error: friction and film follow it with a factor of some hundreds.
        Method::Relaxation => 1e3 * sweep.solver.relaxation.tolerance,
    };
    let place = |name| COLUMNS.iter().position(|column| column.name == name).expect("a column");
    ["mu_v", "mu_h", "c"].into_iter().all(|name| {
        let (a, b) = (here[place(name)], there[place(name)]);
        let scale = if name == "mu_v" { viscoelastic_error_scale(a, here[place("mu_tot")]) } else { a.abs() };
        (a - b).abs() <= tolerance * scale
    })
}

/// What is missing, by parts if there are any, with the commands that finish it.
fn what_is_missing(
    arguments: &Arguments,
    target: &Path,
    sweep: &Sweep,
    plan: &Plan,
    workload: &Workload,
) -> Result<String, CliError> {
    let mut text = format!("{} of the sweep missing", count(workload.to_do(), "case"));
    let written = "writing to memory does not fail";
    let mut incomplete: Vec<(PathBuf, PartState)> = Vec::new();
    for directory in &arguments.sources {
        let collection = Collection::read(directory, &sweep.output, inspection(false))?;
        let states = states(plan, &collection, &collection.held())?.into_iter().filter(|state| state.missing > 0);
        incomplete.extend(states.map(|state| (directory.clone(), state)));
    }
    let command = |directory: &Path, part: Option<Part>| -> Result<String, CliError> {
        let file = sweep_file(directory)?;
        let shard = part.map_or_else(String::new, |part| format!(" --shard {part}"));
        let (file, directory) = (quoted(file.as_os_str()), quoted(directory.as_os_str()));
        Ok(format!("stribeck run {file} -o {directory}{shard}"))
    };
    if incomplete.is_empty() {
        write!(text, "; this solves them and publishes:\n    {}", command(target, None)?).expect(written);
        return Ok(text);
    }
    write!(text, ", in {}:", count(incomplete.len() as u64, "part")).expect(written);
    for (directory, PartState { part, missing, cases, .. }) in incomplete.iter().take(LISTED) {
        let command = command(directory, Some(*part))?;
        write!(text, "\n  part {part} lacks {missing} of {}; this finishes it:\n    {command}", count(*cases, "case"))
            .expect(written);
    }
    if incomplete.len() > LISTED {
        write!(text, "\n  and {} more parts", incomplete.len() - LISTED).expect(written);
    }
    Ok(text + "\nthen merge again")
}
