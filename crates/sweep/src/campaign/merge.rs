//! Merging what the parts and other runs of a sweep have solved, and publishing it.

use std::path::{Path, PathBuf};

use super::open_store::open_store;
use super::parts::part_states;
use super::publication::publish;
use super::sweep_directory::{part_directories, read_copy};
use super::{CampaignError, Event, MergedCatalog, Observer, PartState, Pending, SweepDirectory, available_threads};
use crate::engine::solver_threads;
use crate::store::{Catalog, Ending, Inspection, Joined, Published, Store};
use crate::{Column, Method, Plan, Sweep, Values};
use stribeck_solver::viscoelastic_error_scale;

/// What a merge did.
#[derive(Clone, Debug)]
pub struct MergeReport {
    /// What was taken over.
    pub joined: Joined,
    /// How the merge ended.
    pub outcome: MergeOutcome,
}

/// How a merge ended.
#[derive(Clone, Debug)]
pub enum MergeOutcome {
    /// No case is missing, and the sweep is published.
    Published(Published),
    /// Cases are missing, and nothing is published.
    Incomplete(Missing),
}

/// What a merged sweep lacks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The number of cases that are missing.
    pub cases: u64,
    /// The parts that lack cases, in the order of the directories they are in.
    pub parts: Vec<IncompletePart>,
}

/// A part that lacks cases.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IncompletePart {
    /// The results directory that the part belongs to.
    pub directory: PathBuf,
    /// How far the part is.
    pub state: PartState,
}

/// Merges results directories of one sweep, their parts included, into `target`, and publishes the sweep if no case is
/// missing.
///
/// Shards are linked, or copied from another file system, so that the sources may be deleted afterwards. `target` may
/// be one of the sources. A merge that was interrupted is started again.
///
/// # Errors
/// [`CampaignError::OtherSweep`] if the directories are not of one sweep (nothing is written then),
/// [`StoreError::Disagreement`](crate::store::StoreError::Disagreement) if a case is there twice with numbers that
/// differ by more than the tolerance, others if a file cannot be read or written.
pub fn merge(sources: &[PathBuf], target: &Path, observe: &mut Observer<'_>) -> Result<MergeReport, CampaignError> {
    let (sweep, directories) = one_sweep(sources)?;
    let plan = Plan::new(&sweep);
    let mut store = open_store(target, &sweep, &plan, observe)?;
    store.begin(&sweep.name, 0, 0)?;
    let others = directories.into_iter().filter(|directory| !same_place(directory, target));
    let joined = join_all(others, &sweep, &mut store, observe)?;
    store.end(Ending::Completed)?;
    let missing = Pending::survey(&sweep, &plan, None, &MergedCatalog::new(vec![&store])).to_do();
    let outcome = if missing > 0 {
        MergeOutcome::Incomplete(Missing { cases: missing, parts: incomplete_parts(sources, &sweep, &plan)? })
    } else {
        observe(Event::Publishing);
        let threads = solver_threads(available_threads())?;
        MergeOutcome::Published(threads.install(|| publish(&sweep, &plan, &mut store))?)
    };
    Ok(MergeReport { joined, outcome })
}

/// Takes over what directories hold, one after the other, so that memory has the cases of one at a time beside those
/// that are joined.
pub(super) fn join_all(
    directories: impl IntoIterator<Item = PathBuf>,
    sweep: &Sweep,
    store: &mut Store,
    observe: &mut Observer<'_>,
) -> Result<Joined, CampaignError> {
    let mut all = Joined::default();
    for directory in directories {
        let catalog = Catalog::read(&directory, sweep, Inspection::Bytes)?;
        catalog.warnings().iter().for_each(|warning| observe(Event::Damaged(warning)));
        let Joined { shards, cases, twice } = store.join(&catalog, &|here, there| agree(sweep, here, there))?;
        all = Joined { shards: all.shards + shards, cases: all.cases + cases, twice: all.twice + twice };
    }
    Ok(all)
}

/// The sweep that all directories are of, and all that hold results of it: the directories and their parts.
///
/// A directory that has parts may hold an earlier state of the sweep beside them: the parts say what it has become.
fn one_sweep(directories: &[PathBuf]) -> Result<(Sweep, Vec<PathBuf>), CampaignError> {
    let (mut sources, mut files) = (Vec::new(), Vec::new());
    for directory in directories {
        let parts = part_directories(directory)?;
        // A part that has only just begun has no sweep file yet, and nothing to be joined.
        let parts: Vec<PathBuf> = parts.into_iter().filter(|part| part.join("sweep.toml").exists()).collect();
        if parts.is_empty() {
            files.push(directory.join("sweep.toml"));
        }
        if parts.is_empty() || directory.join("sweep.toml").exists() {
            sources.push(directory.clone());
        }
        files.extend(parts.iter().map(|part| part.join("sweep.toml")));
        sources.extend(parts);
    }
    let Some((first, others)) = files.split_first() else { return Err(CampaignError::NothingToMerge) };
    let sweep = read_copy(first)?;
    for other in others {
        if read_copy(other)?.text != sweep.text {
            return Err(CampaignError::OtherSweep { first: first.clone(), other: other.clone() });
        }
    }
    // The title of a sweep without one is the name of its file, which is not that of the copies in results directories.
    for home in files.iter().filter_map(|file| file.parent()) {
        if let Some(name) = Catalog::name_of_sweep(home)? {
            return Ok((Sweep::parse(&name, &sweep.text)?, sources));
        }
    }
    Ok((sweep, sources))
}

fn same_place(a: &Path, b: &Path) -> bool {
    a == b || matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}

/// Whether two solutions of one case agree within what the solver was asked for. The last bits depend on the processor.
fn agree(sweep: &Sweep, here: &Values, there: &Values) -> bool {
    let tolerance = match sweep.solver.method {
        Method::Collocation => sweep.solver.tolerance,
        // A residual, not an error: friction and film follow it with a factor of some hundreds.
        Method::Relaxation => 1e3 * sweep.solver.relaxation.tolerance,
    };
    [Column::MuV, Column::MuH, Column::C].into_iter().all(|column| {
        let (a, b) = (here[column], there[column]);
        let scale = if column == Column::MuV { viscoelastic_error_scale(a, here[Column::MuTot]) } else { a.abs() };
        (a - b).abs() <= tolerance * scale
    })
}

fn incomplete_parts(directories: &[PathBuf], sweep: &Sweep, plan: &Plan) -> Result<Vec<IncompletePart>, CampaignError> {
    let mut incomplete = Vec::new();
    for directory in directories {
        let stored = SweepDirectory::read(directory, sweep, Inspection::Bytes)?;
        let states = part_states(plan, &stored, &stored.merged())?.into_iter().filter(|state| state.missing > 0);
        incomplete.extend(states.map(|state| IncompletePart { directory: directory.clone(), state }));
    }
    Ok(incomplete)
}
